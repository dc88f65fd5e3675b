//! The reference of the scene file names every word, default and limit.

use std::collections::BTreeSet;

use snellius::Scene;
use snellius::scene::{self, DiagramSettings, Limit, Source, Spectrum, TraceSettings};

use crate::page::{Page, words};

const SCENE_FORMAT: &str = "docs/scene-format.md";

/// The names that the loader takes at a place: it lists them when it meets another one.
fn valid_names(probe: &str) -> Vec<String> {
    let problems = scene::load(probe).expect_err(probe);
    let list = problems.iter().find_map(|problem| problem.help.split_once("alid here: "));
    let (_, list) = list.unwrap_or_else(|| panic!("{probe}: {problems:?}"));
    words(list)
}

#[test]
fn the_reference_names_and_shows_every_word_of_the_format() {
    let page = Page::read(SCENE_FORMAT);
    let explained = page.code_words();
    let shown: BTreeSet<String> =
        page.blocks.iter().filter(|block| block.mark.starts_with("ron")).flat_map(|block| words(&block.text)).collect();
    let shapes =
        ["Lens(x: 0)", "Prism(x: 0)", "Outline(x: 0)", "LensGroup(x: 0)", "Flat(x: 0)", "Arc(x: 0)", "Stop(x: 0)"];
    let lights =
        ["Ray(x: 0)", "Beam(x: 0)", "Fan(x: 0)", "Point(x: 0)", "Object(x: 0)", "Ray(from: (0, 0), direction: X)"];
    let mut probes: Vec<String> = [
        "(x: 0)",
        "(surroundings: X)",
        "(surroundings: Sellmeier(x: 0))",
        "(bodies: [(x: 0)])",
        "(bodies: [(shape: X)])",
        "(bodies: [(shape: Outline(start: (0, 0), path: [X]))])",
        "(bodies: [(shape: Outline(start: (0, 0), path: [ArcTo(x: 0)]))])",
        "(bodies: [(shape: LensGroup(diameter: 1, surfaces: [(x: 0)]))])",
        "(bodies: [(surface: X)])",
        "(bodies: [(surface: BeamSplitter(x: 0))])",
        "(bodies: [(surface: ThinLens(x: 0))])",
        "(sources: [(x: 0)])",
        "(sources: [(light: X)])",
        "(sources: [(spectrum: X)])",
        "(sources: [(spectrum: White(x: 0))])",
        "(sources: [(polarization: X)])",
        "(trace: (x: 0))",
        "(trace: (secondary_rays: X))",
        "(trace: (secondary_rays: Fixed(x: 0)))",
        "(diagram: (x: 0))",
        "(diagram: (view: X))",
        "(diagram: (theme: X))",
        "(diagram: (color: X))",
        "(notes: [(x: 0)])",
    ]
    .map(str::to_owned)
    .to_vec();
    probes.extend(shapes.map(|shape| format!("(bodies: [(shape: {shape})])")));
    probes.extend(lights.map(|light| format!("(sources: [(light: {light})])")));
    for probe in probes {
        for name in valid_names(&probe) {
            assert!(explained.contains(&name), "`{name}` is not explained: {probe}");
            assert!(shown.contains(&name), "`{name}` is in no example: {probe}");
        }
    }
}

#[test]
fn the_reference_names_every_color() {
    let page = Page::read(SCENE_FORMAT);
    let problems = scene::load(r#"(bodies: [(shape: Disk(1), medium: Index(1), color: "x")])"#).unwrap_err();
    let help = &problems[0].help;
    let names: Vec<&str> = help.split('`').skip(1).step_by(2).collect();
    assert!(names.len() > 10, "{help}");
    for name in names {
        assert!(page.prose.contains(&format!("`{name}`")), "{name}");
    }
}

#[test]
fn the_reference_writes_out_every_default() {
    let page = Page::read(SCENE_FORMAT);
    let block = page.marked("ron").find(|block| block.text.starts_with("// every default")).unwrap();
    let scene = Scene::from_ron(&block.text).unwrap();
    assert_eq!(scene.trace, TraceSettings::default());
    assert_eq!(scene.diagram, DiagramSettings::default());
    assert_eq!(scene.surroundings, Scene::default().surroundings);
    let bare = "(bodies: [(shape: Rectangle(40, 20), medium: Index(1.5))],
        sources: [(light: Ray(from: (-30, 30), direction: Towards((-10, 10))))])";
    assert_eq!(scene, Scene::from_ron(bare).unwrap());
    let Source { spectrum, .. } = &scene.sources[0];
    assert_eq!(*spectrum, Spectrum::default());
    for setting in words(block.text.split_once("trace:").unwrap().1).into_iter().filter(|word| word.contains('_')) {
        assert!(page.prose.contains(&format!("| `{setting}` |")), "{setting} has no row");
    }
}

#[test]
fn the_reference_names_every_limit() {
    let page = Page::read(SCENE_FORMAT);
    let limits = page.section("Limits");
    for limit in Limit::ALL {
        let row = format!("| `{}` | {} |", limit.name(), grouped(limit.usual()));
        assert!(limits.contains(&row), "{row}");
    }
    assert!(limits.contains(&format!("| {} ", grouped(snellius::compile::MAX_COMPARISONS))));
    for limit in [scene::MAX_LENGTH, scene::MIN_LENGTH] {
        assert!(limits.contains(&format!("{limit:e}")), "{limit:e}");
    }
    assert!(page.section("Trace").contains(&grouped(Limit::Segments.usual())));
    assert!(page.section("Diagram").contains(&format!("{} to {}", scene::MIN_PIXELS, scene::MAX_PIXELS)));
}

/// A number with a space between its thousands.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let first = digits.len() % 3;
    let (head, tail) = digits.split_at(first);
    let tail: Vec<&str> = (0..tail.len() / 3).map(|k| &tail[3 * k..3 * k + 3]).collect();
    format!("{head} {}", tail.join(" ")).trim().to_owned()
}
