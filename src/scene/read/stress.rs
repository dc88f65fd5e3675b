//! Texts that nobody would write: no panic, and every problem has a place, a fault and a cure.

use proptest::prelude::*;

use crate::scene::{load, render_problems};

const SEED: &str = r##"(title: "é \" /* ", caption: "", surroundings: Sellmeier(b: [1, 0.2, 1.0], c: [0.006, 0.02, 103.0]), bodies: [
    // comment [
    (shape: Polygon([(0, 0), (40, 0), (0, 40)]), medium: Catalog("N-BK7"), name: Some("a"), color: "#f80"),
    (shape: Outline(start: (0, 0), path: [LineTo((4, 0)), ArcTo(through: (5, 1), to: (4, 2))]), surface: Mirror, at: (80, 40)),
    (shape: LensGroup(diameter: 20, surfaces: [(radius: 60, thickness: 6, medium: Index(1.5)), (radius: -inf)])),
    (shape: Lens(radii: (inf, -50), thickness: 6, diameter: 30, facets: 3), medium: Cauchy([1.5, 0.004]), rotate: 15)],
    sources: [(light: Fan(from: (-30, 3), direction: Towards((0, 1)), spread: 30, rays: 8), spectrum: White(samples: 24))],
    trace: (secondary_rays: Fixed(kr: 0.2, kt: 0.7), max_segments: 1e6), diagram: (view: Box((0, 0), (4, 3)), theme: Dark),
    notes: [(at: (10, 40), text: r#"eye"#)])"##;

const BITS: [&str; 40] = [
    "",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ":",
    "\"",
    "'",
    "/*",
    "*/",
    "//",
    "\n",
    "\\",
    "#",
    "r#\"",
    "-",
    "+",
    ".",
    "0",
    "1e999",
    "-1",
    "NaN",
    "inf",
    "-inf",
    "None",
    "Some(",
    "true",
    "é",
    "\u{feff}",
    "\u{202e}",
    "1.5",
    "Disk(4)",
    "at: (1, 2)",
    "b\"x\"",
    "..",
    "0x1F",
    "1e-400",
];

fn check(text: &str) {
    let problems = match load(text) {
        Ok(loaded) => loaded.warnings,
        Err(problems) => problems,
    };
    for problem in &problems {
        let span = problem.span.clone().unwrap_or_else(|| panic!("no place: {problem:?}\n{text}"));
        assert!(text.get(span).is_some(), "{problem:?}\n{text}");
        assert!(!problem.message.is_empty() && !problem.help.is_empty(), "{problem:?}\n{text}");
    }
    assert_eq!(render_problems(&problems, text, "f.ron").is_empty(), problems.is_empty());
}

/// Places between characters, near a share of the text.
fn boundary(text: &str, share: f64) -> usize {
    let places: Vec<usize> = text.char_indices().map(|(at, _)| at).collect();
    let last = places.len() - 1;
    (0..=last).find(|k| *k as f64 >= share * last as f64).map_or(0, |k| places[k])
}

proptest! {
    #[test]
    fn damaged_scenes(edits in prop::collection::vec((0.0..1.0, 0usize..12, prop::sample::select(&BITS[..])), 1..4)) {
        let mut text = SEED.to_owned();
        for (share, cut, bit) in edits {
            let start = boundary(&text, share);
            let end = (start + cut..=text.len()).find(|end| text.is_char_boundary(*end)).unwrap_or(text.len());
            text.replace_range(start..end, bit);
        }
        check(&text);
    }

    #[test]
    fn scenes_of_anything(bits in prop::collection::vec(prop::sample::select(&BITS[..]), 0..30)) {
        check(&bits.concat());
    }

    #[test]
    fn every_number_of_every_shape(numbers in prop::collection::vec(prop::num::f64::ANY, 8)) {
        let n: Vec<String> = numbers.iter().map(|n| n.to_string()).collect();
        let (a, b, c, d) = (&n[0], &n[1], &n[2], &n[3]);
        check(&format!("(bodies: [(shape: Lens(radii: ({a}, {b}), thickness: {c}, diameter: {d}), medium: Index({a})),
            (shape: Outline(start: ({a}, {b}), path: [ArcTo(through: ({c}, {d}), to: ({d}, {a})), LineTo(({b}, {c}))]), surface: Mirror),
            (shape: Polygon([({a}, {b}), ({c}, {d}), ({d}, {a}), ({b}, {c})]), medium: Speed({d})),
            (shape: Prism(apex_angle: {a}, side: {b}), medium: Cauchy([{c}, {d}]))],
            sources: [(light: Fan(from: ({a}, {b}), direction: Angle({c}), spread: {d}, rays: 3), spectrum: Lines([{}, {}]))],
            trace: (min_power: {}), diagram: (faintest: {}))", n[4], n[5], n[6], n[7]));
    }
}

#[test]
fn a_polygon_of_a_hundred_thousand_points_is_read_in_time() {
    let points: String = (0..100_000).map(|k| format!("({k}, {}),", if k % 2 == 0 { 0.5 } else { 1.0 })).collect();
    let text = format!("(bodies: [(shape: Polygon([{points} (5e4, 1e9)]), medium: Index(1.5))])");
    let begun = std::time::Instant::now();
    assert_eq!(load(&text).map(|loaded| loaded.scene.bodies.len()), Ok(1));
    assert!(begun.elapsed().as_secs() < 20, "{:?}", begun.elapsed());
}
