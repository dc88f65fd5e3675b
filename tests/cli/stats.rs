//! `--stats`: each count is 0 in one scene and not in another.

use crate::place::{Place, SCENE};

const GLASS: &str = "(shape: Rectangle(20, 20), medium: Index(1.5))";
const RAY: &str = "(light: Ray(from: (-30, 1), direction: Angle(0)))";
const MIRROR: &str = "(shape: Flat(from: (20, 20), to: (20, -20)), surface: Mirror)";
/// Three lines of one ray.
const LINES: &str =
    "(light: Ray(from: (-30, 1), direction: Angle(5)), spectrum: Lines([486.1327, 587.5618, 656.2725]))";

fn scene(bodies: &str, source: &str, settings: &str) -> String {
    format!("(bodies: [{bodies}], sources: [{source}], {settings})")
}

/// What the line of that name says, for a command with these arguments.
fn stat(scene: &str, arguments: &[&str], name: &str) -> String {
    let place = Place::with(&[("a.ron", scene)]);
    let run = place.run(&[arguments, &["a.ron", "--stats"]].concat()).status(0);
    let stats = run.stderr();
    assert!(stats.starts_with("stats of a.ron\n"), "{stats}");
    let found = stats.lines().find_map(|line| line.trim_start().strip_prefix(name)?.strip_prefix(' '));
    found.unwrap_or_else(|| panic!("{name} in\n{stats}")).trim().to_owned()
}

fn traced(scene: &str, name: &str) -> String {
    let stat = ["text", "json", "csv", "summary"].map(|form| stat(scene, &["trace", "--format", form], name));
    assert!(stat.iter().all(|one| *one == stat[0]), "alike in every form: {stat:?}");
    stat[0].clone()
}

fn drawn(scene: &str, name: &str) -> String {
    stat(scene, &["render"], name)
}

#[test]
fn dropped_boundaries_are_counted() {
    let two = |index: &str| {
        let bodies = format!("{GLASS}, (shape: Rectangle(20, 20), at: (20, 0), medium: Index({index}))");
        traced(&scene(&bodies, RAY, ""), "dropped")
    };
    assert_eq!(two("1.6"), "0 pieces of boundary, between equal media");
    assert_eq!(two("1.5"), "1 piece of boundary, between equal media");
}

#[test]
fn hits_are_counted_with_and_without_fresnel() {
    let hits = |bodies: &str, settings: &str| traced(&scene(bodies, RAY, settings), "hits");
    let once = "trace: (max_depth: 1)";
    assert_eq!(hits(GLASS, once), "1, Fresnel's equations evaluated at 1, not at 0");
    assert_eq!(hits(MIRROR, once), "1, Fresnel's equations evaluated at 0, not at 1");
    let fixed = "trace: (max_depth: 1, secondary_rays: Fixed(kr: 0.1, kt: 0.9))";
    assert_eq!(hits(GLASS, fixed), "1, Fresnel's equations evaluated at 0, not at 1");
    // In through the left face, totally reflected at the slanted one, out through the one below.
    let prism = "(shape: Polygon([(0, -10), (20, -10), (0, 10)]), medium: Index(1.5))";
    let brief = "trace: (min_power: 0.5)";
    assert_eq!(hits(prism, brief), "3, Fresnel's equations evaluated at 2, not at 1");
}

#[test]
fn cut_branches_are_counted_with_their_power() {
    let shares = "secondary_rays: Fixed(kr: 0.25, kt: 0.75)";
    let cut = |limit: &str, name: &str| {
        let trace = format!("trace: ({shares}, {limit})");
        traced(&scene(GLASS, RAY, &trace), name)
    };
    let none = "0 segments, 0.0000 % of the power";
    assert_eq!(cut("min_power: 0.26", "cut_min_power"), "2 segments, 43.7500 % of the power");
    assert_eq!(cut("min_power: 0.26", "cut_max_depth"), none);
    assert_eq!(cut("max_depth: 1", "cut_max_depth"), "2 segments, 100.0000 % of the power");
    assert_eq!(cut("max_depth: 1", "cut_max_segments"), none);
    assert_eq!(cut("max_segments: 2", "cut_max_segments"), "3 segments, 100.0000 % of the power");
    assert_eq!(cut("max_segments: 2", "cut_min_power"), none);
}

#[test]
fn segments_that_another_line_spares_are_counted() {
    let spared = |medium: &str| {
        let body = format!("(shape: Rectangle(20, 20), medium: {medium})");
        traced(&scene(&body, LINES, "trace: (secondary_rays: TransmittedOnly)"), "spared")
    };
    assert_eq!(spared("Index(1.5)"), "6 segments, copied from another spectral line that goes the same way");
    assert_eq!(spared("Catalog(\"N-BK7\")"), "0 segments, copied from another spectral line that goes the same way");
}

#[test]
fn nodes_are_counted_where_there_is_a_tree() {
    let walls = |number: u32| {
        let wall = |k| format!("(shape: Rectangle(0.5, 9), at: ({k}, 0), medium: Index(1.1))");
        let bodies: Vec<_> = (0..number).map(wall).collect();
        traced(&scene(&bodies.join(", "), RAY, "trace: (max_depth: 99, secondary_rays: TransmittedOnly)"), "search")
    };
    assert_eq!(walls(3), "without a search tree, which so few interfaces do not need");
    let many = walls(30);
    let words: Vec<_> = many.split(' ').collect();
    assert!(words[0].parse::<u64>().unwrap() > 0 && words[7].parse::<f64>().unwrap() > 0.0, "{many}");
    assert!(many.ends_with(" a followed segment"), "{many}");
}

#[test]
fn stats_tell_whether_the_tree_was_stored_and_a_figure_drawn() {
    for form in ["text", "json", "csv"] {
        assert_eq!(stat(SCENE, &["trace", "--format", form], "ray tree"), "stored");
    }
    assert_eq!(stat(SCENE, &["trace", "--format", "summary"], "ray tree"), "not stored, only its sums");
    assert_eq!(stat(SCENE, &["explain"], "ray tree"), "stored");
    assert_eq!(drawn(SCENE, "ray tree"), "stored");
    assert_eq!(traced(SCENE, "drawn"), "nothing");
    assert!(!drawn(SCENE, "drawn").starts_with('0'), "{}", drawn(SCENE, "drawn"));
}

#[test]
fn segments_that_are_not_drawn_are_counted() {
    let skipped = |diagram: &str| {
        let settings = format!("trace: (secondary_rays: Fixed(kr: 0.1, kt: 0.9), max_depth: 1), diagram: ({diagram})");
        drawn(&scene(GLASS, RAY, &settings), "not drawn")
    };
    assert_eq!(skipped(""), "0 segments outside the view, 0 below faintest");
    assert_eq!(skipped("faintest: 0.5"), "0 segments outside the view, 1 below faintest");
    let elsewhere = skipped("view: Box((100, 100), (140, 120))");
    assert_eq!(elsewhere, "3 segments outside the view, 0 below faintest");
}

#[test]
fn marks_and_the_font_are_told() {
    let bare = "diagram: (labels: false, arrows: false, normals: false, angles: false, legend: false)";
    assert!(drawn(&scene(GLASS, RAY, bare), "drawn").ends_with(" segments, 0 marks"));
    assert_eq!(drawn(&scene(GLASS, RAY, bare), "font"), "not loaded");
    let marks = drawn(SCENE, "drawn");
    assert!(marks.ends_with(" marks") && !marks.ends_with(" 0 marks"), "{marks}");
    assert_eq!(drawn(SCENE, "font"), "used");
}

#[test]
fn stats_have_the_time_of_every_phase() {
    for (arguments, phases) in [
        (&["trace"][..], &["reading", "loading", "compiling", "tracing", "writing"][..]),
        (&["render", "--format", "svg,png"], &["compiling", "tracing", "drawing", "writing svg", "writing png"]),
    ] {
        for phase in phases {
            let time = stat(SCENE, arguments, phase);
            assert!(time.strip_suffix(" ms").unwrap().parse::<f64>().unwrap() >= 0.0, "{time}");
        }
    }
}
