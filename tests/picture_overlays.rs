//! What is laid over the rays on request: deviations, protractors, wavefronts.

#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

mod support;

use glam::DVec2;
use snellius::diagram::{self, draw};
use snellius::drawing::{Drawing, Item, Path, PathStep};
use snellius::glam;
use support::run_text;

fn scene(bodies: &str, light: &str, diagram: &str) -> String {
    format!("(bodies: [{bodies}], sources: [(light: {light})], diagram: (view: Box((-60, -35), (60, 35)), {diagram}))")
}

fn figure(text: &str) -> Drawing {
    let run = run_text(text);
    draw(&run.scene, &run.system, &run.trace.tree)
}

const PRISM: &str = r#"(shape: Prism(apex_angle: 60, side: 40), medium: Index(1.5))"#;
const INTO_PRISM: &str = "Ray(from: (-50, -18), direction: Towards((-12, 0)))";

/// The items of a layer, groups in it opened.
fn layer<'a>(drawing: &'a Drawing, class: &str) -> Vec<&'a Item> {
    let is_it = |item: &&Item| matches!(item, Item::Group(group) if group.class == class);
    drawing.items.iter().filter(is_it).flat_map(open).collect()
}

fn open(item: &Item) -> Vec<&Item> {
    match item {
        Item::Group(group) => group.items.iter().flat_map(open).collect(),
        _ => vec![item],
    }
}

fn words(items: &[&Item]) -> Vec<String> {
    let text = |item: &&Item| match item {
        Item::Text(text) => Some(text.spans.iter().map(|span| span.text.as_str()).collect()),
        _ => None,
    };
    items.iter().filter_map(text).collect()
}

fn paths<'a>(items: &[&'a Item]) -> Vec<&'a Path> {
    items.iter().filter_map(|item| if let Item::Shape(shape) = item { Some(&shape.path) } else { None }).collect()
}

/// The straight pieces of a path that are by themselves.
fn lines(path: &Path) -> Vec<[DVec2; 2]> {
    let pairs = path.steps().windows(2);
    let line = |pair: &[PathStep]| match pair {
        [PathStep::MoveTo(a), PathStep::LineTo(b)] => Some([*a, *b]),
        _ => None,
    };
    pairs.filter_map(line).collect()
}

#[test]
fn a_deviation_is_the_angle_between_two_branches() {
    let text = scene(PRISM, INTO_PRISM, r#"deviations: [("0.0:", "0.0:tt")]"#);
    let run = run_text(&text);
    let drawing = draw(&run.scene, &run.system, &run.trace.tree);
    let marks = layer(&drawing, "deviations");
    let segments = &run.trace.tree.rays[0].segments;
    let [a, b] = [segments[0].direction, segments[2].direction];
    let degrees = snellius::numerics::atan2_degrees(a.perp_dot(b).abs(), a.dot(b));
    assert!(degrees > 30.0);
    assert_eq!(words(&marks), [format!("δ\u{a0}=\u{a0}{degrees:.1}°")]);

    let flipped = |d: DVec2| DVec2::new(d.x, -d.y);
    let dashed: Vec<[DVec2; 2]> =
        paths(&marks).into_iter().filter(|path| path.steps().len() == 2).flat_map(lines).collect();
    let [on, back] = dashed[..] else { panic!("two lines: {dashed:?}") };
    assert!((on[1] - on[0]).normalize().abs_diff_eq(flipped(a), 1e-3), "on along the first");
    assert!((back[1] - back[0]).normalize().abs_diff_eq(flipped(b), 1e-3), "back along the second");
    // The arc about the meeting point goes from one to the other.
    let arc = paths(&marks).into_iter().find(|path| matches!(path.steps(), [_, PathStep::ArcTo { .. }])).unwrap();
    let [PathStep::MoveTo(from), PathStep::ArcTo { to, radius, .. }] = arc.steps() else { panic!("{arc:?}") };
    assert!((*from - back[0] - *radius * flipped(a)).length() < 0.02, "{from}");
    assert!((*to - back[0] - *radius * flipped(b)).length() < 0.02, "{to}");
}

#[test]
fn deviations_are_numbered_where_there_are_several() {
    let mirror = "(shape: Flat(from: (-20, -20), to: (20, 20)), surface: Mirror)";
    let light = "Ray(from: (-40, 0), direction: Angle(0))";
    let one = figure(&scene(mirror, light, r#"deviations: [("0.0:", "0.0:r")]"#));
    assert_eq!(words(&layer(&one, "deviations")), ["δ\u{a0}=\u{a0}90.0°"]);
    let square = paths(&layer(&one, "deviations")).into_iter().find(|path| path.steps().len() == 3).unwrap().clone();
    let [PathStep::MoveTo(a), PathStep::LineTo(b), PathStep::LineTo(c)] = square.steps() else { panic!("{square:?}") };
    assert!((*b - *a).dot(*c - *b).abs() < 0.1, "a right angle has a square");

    let two = figure(&scene(mirror, light, r#"deviations: [("0.0:", "0.0:r"), ("0.0:", "0.0:")]"#));
    let mut values = words(&layer(&two, "deviations"));
    values.sort();
    assert_eq!(values, ["δ1\u{a0}=\u{a0}90.0°", "δ2\u{a0}=\u{a0}0.0°"]);
    assert!(layer(&figure(&scene(mirror, light, "")), "deviations").is_empty());
}

#[test]
fn a_deviation_without_room_stands_below() {
    let text = scene(PRISM, INTO_PRISM, r#"size: (60, 60), deviations: [("0.0:", "0.0:tt")]"#);
    let drawing = figure(&text);
    assert!(words(&layer(&drawing, "deviations")).is_empty());
    assert!(words(&layer(&drawing, "key")).iter().any(|words| words.starts_with("δ\u{a0}=\u{a0}3")));
}

#[test]
fn a_deviation_out_of_view_stands_below() {
    let text = scene(PRISM, INTO_PRISM, r#"deviations: [("0.0:", "0.0:tt")]"#);
    let text = text.replace("Box((-60, -35), (60, 35))", "Box((-50, -35), (-40, -20))");
    let drawing = figure(&text);
    assert!(layer(&drawing, "deviations").is_empty());
    assert!(words(&layer(&drawing, "key")).iter().any(|words| words.starts_with("δ\u{a0}=\u{a0}3")));
}

#[test]
fn a_deviation_of_no_branch_is_told() {
    let text = scene(PRISM, INTO_PRISM, r#"deviations: [("0.0:", "0.0:tt"), ("0.0:", "0.0:tx")]"#);
    let run = run_text(&text);
    let problems = diagram::problems(&run.scene, &run.trace.tree);
    let [problem] = &problems[..] else { panic!("{problems:?}") };
    assert_eq!(problem.path, "diagram.deviations[1][1]");
    assert!(problem.message.contains("\"0.0:tx\"") && problem.help.contains("\"0.0:tt\""), "{problem:?}");
    let drawing = draw(&run.scene, &run.system, &run.trace.tree);
    assert_eq!(words(&layer(&drawing, "deviations")).len(), 1);
}

/// Middles of the marks across rays: pieces of twice the half length of one, pixels.
fn ticks(drawing: &Drawing) -> Vec<DVec2> {
    let all = paths(&layer(drawing, "wavefronts")).into_iter().flat_map(lines);
    all.filter(|[a, b]| ((*b - *a).length() - 8.0).abs() < 0.03).map(|[a, b]| 0.5 * (a + b)).collect()
}

#[test]
fn wavefronts_stand_at_equal_optical_paths() {
    let slab = "(shape: Rectangle(50, 60), medium: Index(1.6))";
    let drawing = figure(&scene(slab, "Ray(from: (-60, 0), direction: Angle(0))", "wavefronts: 8, faintest: 0.5"));
    let mut places: Vec<f64> = ticks(&drawing).iter().map(|p| p.x).collect();
    places.sort_by(f64::total_cmp);
    let steps: Vec<f64> = places.windows(2).map(|pair| pair[1] - pair[0]).collect();
    // 35 mm of air from the source: 4 steps of 8 mm; in glass 50 mm of 1.6 are 80 mm, 10 steps of 5 mm; then air again.
    let air = steps[0];
    let of = |share: f64| steps.iter().filter(|step| (**step - share * air).abs() < 0.05).count();
    assert!(of(1.0) >= 6, "{steps:?}");
    assert_eq!(of(1.0 / 1.6), 9, "{steps:?}");
}

#[test]
fn wavefronts_of_a_point_are_circles() {
    let drawing = figure(&scene("", "Point(at: (0, 0), rays: 24)", "wavefronts: 10"));
    let dot = paths(&layer(&drawing, "sources"))[0].clone();
    let [PathStep::MoveTo(left), PathStep::ArcTo { to: right, .. }, ..] = dot.steps() else { panic!("{dot:?}") };
    let center = 0.5 * (*left + *right);
    let radii: Vec<f64> = ticks(&drawing).iter().map(|p| (*p - center).length()).collect();
    let smallest = radii.iter().copied().filter(|r| *r > 1.0).fold(f64::INFINITY, f64::min);
    let near = |k: f64| radii.iter().filter(|r| (**r - k * smallest).abs() < 0.1).count();
    assert_eq!((near(1.0), near(2.0), near(3.0)), (24, 24, 24), "all round");
    // Every one is joined to its two neighbors: chords of 15 degrees.
    let chord = 2.0 * smallest * snellius::numerics::sin((7.5_f64).to_radians());
    let all: Vec<[DVec2; 2]> = paths(&layer(&drawing, "wavefronts")).into_iter().flat_map(lines).collect();
    let chords = all.iter().filter(|[a, b]| ((*b - *a).length() - chord).abs() < 0.05).count();
    assert_eq!(chords, 24);
}

#[test]
fn no_wavefronts_behind_an_ideal_lens_nor_in_a_crowd() {
    let lens = "(shape: Flat(from: (0, -30), to: (0, 30)), surface: ThinLens(focal_length: 40))";
    let light = "Beam(center: (-50, 0), direction: Angle(0), width: 40, rays: 5)";
    let drawing = figure(&scene(lens, light, "wavefronts: 10"));
    let middle = 0.5 * f64::from(drawing.size[0]);
    let marks = ticks(&drawing);
    assert!(marks.len() >= 20 && marks.iter().all(|p| p.x < middle + 0.5), "{marks:?}");
    assert!(layer(&figure(&scene(lens, light, "")), "wavefronts").is_empty());
    assert!(paths(&layer(&figure(&scene(lens, light, "wavefronts: 0.001")), "wavefronts")).is_empty());
}

#[test]
fn protractors_count_from_the_normal() {
    let slab = "(shape: Rectangle(100, 30), at: (0, -15), medium: Index(1.5))";
    let light = "Ray(from: (-30, 30), direction: Towards((0, 0)))";
    let drawing = figure(&scene(slab, light, "protractor: true, faintest: 0.1, angles: false, normals: false"));
    let marks = layer(&drawing, "protractors");
    let ticks = paths(&marks).into_iter().map(|path| lines(path).len()).max().unwrap();
    assert_eq!(ticks, 72, "one every 5 degrees");
    let words = words(&marks);
    let count = |degrees: &str| words.iter().filter(|word| *word == degrees).count();
    assert!(words.len() >= 10 && count("0°") <= 2 && count("90°") <= 2, "{words:?}");
    assert!(count("30°") >= 3 && count("60°") >= 3 && count("0°") >= 1, "{words:?}");
    assert!(layer(&figure(&scene(slab, light, "")), "protractors").is_empty());
}
