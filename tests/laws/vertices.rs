//! Rays exactly through vertices do what the rays an ulp beside do: which of the two, the scene format says under "Corners,
//! edges and tangents".

use glam::DVec2;
use snellius::geometry::Curve;

use crate::properties::check;
use crate::support::{Run, run_text};

/// Where the vertex lies. Its neighbors in f64 are an ulp of 2 off.
const VERTEX: DVec2 = DVec2::new(3.0, 2.0);

/// Bodies that have a vertex there, by what it is.
const SCENES: [(&str, &str); 12] = [
    ("a convex corner", "(shape: Polygon([(3, 2), (9, -1), (8, 6)]), medium: Index(1.5))"),
    ("a convex corner that points up", "(shape: Polygon([(3, 2), (-1, -5), (6, -4)]), medium: Index(1.5))"),
    ("a right angle", "(shape: Polygon([(3, 2), (8, 2), (8, 7), (3, 7)]), medium: Index(1.5))"),
    ("a reflex corner", "(shape: Polygon([(3, 2), (9, 7), (-5, 8), (-6, -4), (9, -5)]), medium: Index(1.5))"),
    (
        "a reflex right angle",
        "(shape: Polygon([(3, 2), (3, 8), (-4, 8), (-4, -5), (9, -5), (9, 2)]), medium: Index(1.5))",
    ),
    (
        "a seam of an edge and an arc",
        "(shape: Outline(start: (3, 2), path: [ArcTo(through: (6, 5), to: (3, 8)), LineTo((-4, 6))]), medium: Index(1.5))",
    ),
    ("a seam of a half disk", "(shape: HalfDisk(3), at: (3, -1), medium: Index(1.5))"),
    (
        "touching vertices",
        "(shape: Polygon([(3, 2), (9, -1), (8, 6)]), medium: Index(1.5)), \
         (shape: Polygon([(3, 2), (-4, 5), (-5, -2)]), medium: Index(1.7))",
    ),
    (
        "a cemented corner",
        "(shape: Polygon([(3, 2), (9, -1), (8, 6)]), medium: Index(1.5)), \
         (shape: Polygon([(3, 2), (8, 6), (1, 9)]), medium: Index(1.7))",
    ),
    (
        "a corner on a face",
        "(shape: Polygon([(3, -5), (3, 9), (-4, 9), (-4, -5)]), medium: Index(1.5)), \
         (shape: Polygon([(3, 2), (9, -1), (8, 6)]), medium: Index(1.7))",
    ),
    (
        "a corner of three",
        "(shape: Polygon([(3, 2), (9, -1), (8, 6)]), medium: Index(1.5)), \
         (shape: Polygon([(3, 2), (8, 6), (-3, 7)]), medium: Index(1.7)), \
         (shape: Polygon([(3, 2), (-3, 7), (-6, -4), (9, -1)]), medium: Index(1.3))",
    ),
    (
        "a crossing of faces",
        "(shape: Polygon([(3, -5), (3, 9), (-4, 9), (-4, -5)]), medium: Index(1.5)), \
         (shape: Polygon([(-5, 2), (11, 2), (11, 8), (-5, 8)]), medium: Index(1.7))",
    ),
];

/// Directions in which a ray runs through the vertex exactly.
const HEADINGS: [(f64, f64); 8] =
    [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (-1.0, 1.0), (-1.0, 0.0), (-1.0, -1.0), (0.0, -1.0), (1.0, -1.0)];

/// A ray towards the vertex, moved to its left by so many ulp.
fn run(bodies: &str, heading: DVec2, ulps: f64) -> Run {
    let aside = ulps * 2.0 * f64::EPSILON * heading.perp();
    let (from, to) = (VERTEX - 16.0 * heading + 8.0 * aside, VERTEX + 16.0 * heading + 8.0 * aside);
    assert_eq!(to - from, 32.0 * heading, "the same direction");
    run_text(&format!(
        "(bodies: [{bodies}], sources: [(light: Ray(from: ({:?}, {:?}), direction: Towards(({:?}, {:?}))))], \
         trace: (secondary_rays: TransmittedOnly, min_power: 0, max_depth: 8))",
        from.x, from.y, to.x, to.y
    ))
}

/// What the ray meets in turn: the medium it runs in, and the body it hits.
fn course(run: &Run) -> Vec<(f64, Option<usize>)> {
    run.trace.tree.rays[0].segments.iter().map(|s| (s.medium_index, s.hit.map(|hit| hit.body))).collect()
}

/// For each boundary that ends at the vertex, the side to which it leaves: positive left, 0 straight along the ray. An arc
/// along the ray leaves to where it bends.
fn leaving_sides(run: &Run, heading: DVec2) -> Vec<f64> {
    let origin = run.system.origin();
    let curves = run.system.interfaces().iter().map(|interface| interface.curve);
    let leaving = curves.flat_map(|curve| [curve, curve.reversed()]).filter(|curve| curve.a + origin == VERTEX);
    let side = |curve: Curve| {
        let tangent = curve.tangent_at(curve.a);
        let turn = heading.perp_dot(tangent);
        if turn.abs() < 1e-12 { curve.curvature * heading.dot(tangent) } else { turn }
    };
    leaving.map(side).collect()
}

#[test]
fn a_ray_through_a_vertex_does_what_a_ray_beside_it_does() {
    for (what, bodies) in SCENES {
        for heading in HEADINGS.map(DVec2::from) {
            let [left, exact, right] = [1.0, 0.0, -1.0].map(|ulps| run(bodies, heading, ulps));
            [&left, &exact, &right].into_iter().for_each(check);
            let sides = leaving_sides(&exact, heading);
            assert!(sides.len() >= 2, "{what} has no vertex there");
            // A corner that is only touched is passed by; else it counts as lying on the right.
            let (beside, side) = if sides.iter().all(|side| *side > 0.0) { (right, "right") } else { (left, "left") };
            assert_eq!(course(&exact), course(&beside), "{what} along {heading}: not as on the {side}");
        }
    }
}

#[test]
fn a_ray_at_the_end_of_an_open_line_meets_it() {
    let stops = "(shape: Flat(from: (3, 2), to: (4, 9)), surface: Absorber)";
    for heading in HEADINGS.map(DVec2::from) {
        let [left, exact, right] = [1.0, 0.0, -1.0].map(|ulps| run(stops, heading, ulps));
        let turn = heading.perp_dot(DVec2::new(1.0, 7.0));
        let beside = if turn > 0.0 { left } else { right };
        assert_eq!(course(&exact), course(&beside), "along {heading}");
        assert_eq!(course(&exact), [(1.0, Some(0))], "along {heading}");
    }
}
