//! Whole Fresnel trees of a prism, branch by branch.

use std::collections::BTreeMap;

use serde_json::Value;
use snellius::trace::{Ending, Segment, Trace};

use crate::truth::{TOLERANCE, close, close_points, entries, list, path_of, point, text, traced, value};

/// Smallest share of the source's power that the trees hold.
const CUTOFF: &str = "1e-4";

/// Trees by name, with the polarization of their source. All are exact: a tree of unpolarized light carries its s and its
/// p power apart.
const TREES: [(&str, &str); 6] = [
    ("equilateral_min_deviation_n1.5168_pol_s", "S"),
    ("equilateral_min_deviation_n1.5168_pol_p", "P"),
    ("equilateral_min_deviation_n1.5168_pol_sp", "Unpolarized"),
    ("right_angle_45_TIR_n1.5168_pol_s", "S"),
    ("right_angle_45_TIR_n1.5168_pol_p", "P"),
    ("right_angle_45_TIR_n1.5168_pol_sp", "Unpolarized"),
];

struct Tree {
    name: &'static str,
    entry: Value,
    /// Its segments by path.
    segments: BTreeMap<String, Value>,
    trace: Trace,
    /// Largest absolute coordinate of the prism.
    size: f64,
}

fn trees() -> Vec<Tree> {
    let mut entries = entries("prism_ray_trees.json", TREES.len());
    let tree = |(name, polarization)| {
        let entry = entries.remove(name).unwrap();
        assert_eq!(text(&entry, "cutoff_power"), Some(CUTOFF));
        let corners: Vec<_> =
            list(&entry, "polygon_ccw").iter().flat_map(|corner| corner.as_array().unwrap()).collect();
        let size = corners.iter().map(|c| c.as_str().unwrap().parse::<f64>().unwrap().abs()).fold(0.0, f64::max);
        let (segments, trace) = (by_path(list(&entry, "segments")), traced(&scene(&entry, polarization)));
        Tree { name, segments, trace, size, entry }
    };
    TREES.map(tree).into()
}

/// A scene of a tree's prism, and of a ray at the point where its source segment ends.
fn scene(entry: &Value, polarization: &str) -> String {
    let corner = |corner: &Value| format!("({}, {})", corner[0].as_str().unwrap(), corner[1].as_str().unwrap());
    let corners = list(entry, "polygon_ccw").iter().map(corner).collect::<Vec<_>>().join(", ");
    let [n, max_depth] = [text(entry, "n").unwrap(), &entry["max_depth"].to_string()];
    let [x0, y0, x1, y1] = ["x0", "y0", "x1", "y1"].map(|key| text(&entry["segments"][0], key).unwrap());
    format!(
        "(
            title: \"A prism\",
            bodies: [(shape: Polygon([{corners}]), medium: Index({n}))],
            sources: [(
                light: Ray(from: ({x0}, {y0}), direction: Towards(({x1}, {y1}))),
                polarization: {polarization},
            )],
            trace: (max_depth: {max_depth}, min_power: {CUTOFF}),
        )"
    )
}

/// The segments of a tree by the letters of their addresses.
fn by_path(segments: &[Value]) -> BTreeMap<String, Value> {
    let mut paths: Vec<String> = Vec::new();
    for segment in segments {
        let letter = match text(segment, "kind").unwrap() {
            "source" => "",
            "transmitted" => "t",
            "reflected" => "r",
            "TIR" => "i",
            kind => panic!("a segment of kind {kind:?}"),
        };
        let parent = segment["parent"].as_u64().map_or("", |id| paths[usize::try_from(id).unwrap()].as_str());
        paths.push(format!("{parent}{letter}"));
    }
    paths.into_iter().zip(segments.iter().cloned()).collect()
}

impl Tree {
    /// The branches that were followed, by path, in the order of the trace.
    fn followed(&self) -> Vec<(String, &Segment)> {
        let ray = &self.trace.tree.rays[0];
        let followed = ray.segments.iter().filter(|segment| !is_cut(segment));
        followed.map(|segment| (path_of(ray, segment), segment)).collect()
    }

    /// Every branch with its segment of the table and a word on where it is.
    fn pairs(&self) -> Vec<(&Segment, &Value, String)> {
        let pair = |(path, segment)| (segment, &self.segments[&path], format!("{}:{path}", self.name));
        self.followed().into_iter().map(pair).collect()
    }
}

fn is_cut(segment: &Segment) -> bool {
    matches!(segment.ending, Ending::CutMinPower | Ending::CutMaxDepth | Ending::CutMaxSegments)
}

#[test]
fn trees_have_the_same_branches_transmitted_before_reflected() {
    for tree in trees() {
        let mut expected: Vec<_> = tree.segments.keys().cloned().collect();
        expected.sort_by_key(|path| path.replace('t', "a"));
        let found: Vec<_> = tree.followed().into_iter().map(|(path, _)| path).collect();
        assert_eq!(found, expected, "{}", tree.name);
    }
}

#[test]
fn branches_that_a_tree_leaves_out_are_weak() {
    for tree in trees() {
        let cut: Vec<_> = tree.trace.tree.rays[0].segments.iter().filter(|segment| is_cut(segment)).collect();
        assert!(!cut.is_empty(), "{}", tree.name);
        for segment in cut {
            assert!(segment.ending == Ending::CutMinPower && segment.power.total() < 1e-4, "{}", tree.name);
        }
    }
}

#[test]
fn places_and_directions() {
    for tree in trees() {
        for (segment, expected, what) in tree.pairs() {
            close_points(segment.from, point(expected, "x0", "y0"), TOLERANCE * tree.size, &what);
            close_points(segment.direction, point(expected, "dx", "dy"), TOLERANCE, &what);
            assert_eq!(segment.to.is_some(), text(expected, "x1").is_some(), "{what}");
            if let Some(to) = segment.to {
                close_points(to, point(expected, "x1", "y1"), TOLERANCE * tree.size, &what);
            }
        }
    }
}

#[test]
fn powers() {
    for tree in trees() {
        for (segment, expected, what) in tree.pairs() {
            close(segment.power.total(), value(expected, "power"), TOLERANCE, &what);
        }
        let escaped = tree.trace.summary.balance.escaped.value();
        close(escaped, value(&tree.entry, "escaped_power"), TOLERANCE, tree.name);
    }
}

#[test]
fn angles_and_reflectance_at_every_hit() {
    for tree in trees() {
        for (segment, expected, what) in tree.pairs() {
            let Some(hit) = segment.hit else {
                assert_eq!((segment.ending, text(expected, "event")), (Ending::Escaped, Some("escape")), "{what}");
                continue;
            };
            close(hit.theta_i_degrees(), value(expected, "theta_i_deg"), TOLERANCE, &what);
            if text(expected, "event") == Some("TIR") {
                assert!(hit.total_internal_reflection && hit.theta_t_degrees().is_none(), "{what}");
                close(hit.reflected_share(segment.power), 1.0, TOLERANCE, &what);
            } else {
                close(hit.theta_t_degrees().unwrap(), value(expected, "theta_t_deg"), TOLERANCE, &what);
                close(hit.reflected_share(segment.power), value(expected, "R"), TOLERANCE, &what);
            }
        }
    }
}

#[test]
fn branches_know_their_medium() {
    for tree in trees() {
        for (segment, expected, what) in tree.pairs() {
            let n = if expected["inside"].as_bool().unwrap() { value(&tree.entry, "n") } else { 1.0 };
            close(segment.medium_index, n, 0.0, &what);
        }
    }
}
