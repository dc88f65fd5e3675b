//! `render --steps`, `--panels`, PDF, and characters without a glyph.

use std::fs;

use crate::place::{Place, SCENE, assert_png, assert_svg};

/// One hit, so that there are two steps.
const MIRROR: &str = r#"(
    title: "Mirror",
    bodies: [(shape: Flat(from: (0, -20), to: (0, 20)), surface: Mirror)],
    sources: [(light: Ray(from: (-30, -10), direction: Towards((0, 0))))],
)"#;

fn size(place: &Place, name: &str) -> (u32, u32) {
    let picture = tiny_skia::Pixmap::decode_png(&fs::read(place.path(name)).unwrap()).unwrap();
    (picture.width(), picture.height())
}

#[test]
fn steps_are_numbered_as_overlays_and_end_whole() {
    let place = Place::with(&[("a.ron", MIRROR)]);
    assert_eq!(place.run(&["render", "a.ron", "--steps"]).clean(), "a-1.svg\na-2.svg\n");
    place.run(&["render", "a.ron"]).clean();
    let read = |name: &str| fs::read_to_string(place.path(name)).unwrap();
    assert_eq!(read("a-2.svg"), read("a.svg"));
    assert!(read("a-1.svg").contains("0.0:\"") && !read("a-1.svg").contains("0.0:r\""));
    assert_eq!(place.run(&["render", "a.ron", "--steps", "-o", "x.y.svg"]).clean(), "x.y-1.svg\nx.y-2.svg\n");
    let png = ["render", "a.ron", "--steps", "-o", "picture", "--format", "png", "--size", "300x200", "--scale", "2"];
    assert_eq!(place.run(&png).clean(), "picture-1\npicture-2\n");
    assert_eq!([size(&place, "picture-1"), size(&place, "picture-2")], [(600, 400); 2]);
    let out = ["render", "a.ron", "--steps", "--out-dir", "out", "--format", "png,svg", "--transparent"];
    assert_eq!(place.run(&out).clean(), ["out/a-1.svg", "out/a-1.png", "out/a-2.svg", "out/a-2.png\n"].join("\n"));
    let first = tiny_skia::Pixmap::decode_png(&fs::read(place.path("out/a-1.png")).unwrap()).unwrap();
    assert_eq!(first.pixel(0, 0).unwrap().alpha(), 0);
}

#[test]
fn steps_that_cannot_be_are_refused() {
    let many = MIRROR.replace("Ray(from: (-30, -10), direction: Towards((0, 0)))", "Point(at: (-9, 0), rays: 3000)");
    let dark = "(title: \"Dark\")";
    let place = Place::with(&[("a.ron", MIRROR), ("many.ron", &many), ("dark.ron", dark), ("a-2.svg", MIRROR)]);
    place.run(&["render", "a.ron", "--steps", "-o", "-"]).refused("standard output");
    place.run(&["render", "a.ron", "--steps", "--panels"]).refused("--panels");
    let run = place.run(&["render", "many.ron", "--steps"]).status(1);
    assert!(run.stdout().is_empty() && run.stderr().starts_with("many.ron: no steps: "), "{}", run.stderr());
    assert_eq!(place.run(&["render", "dark.ron", "--steps"]).clean(), "dark-1.svg\n", "one step without light");
    let run = place.run(&["render", "a-2.svg", "--steps", "-o", "a.svg"]).status(1);
    assert!(run.stderr().contains("would overwrite the scene 'a-2.svg'"), "{}", run.stderr());
    assert_eq!(place.files(), ["a-2.svg", "a.ron", "dark-1.svg", "dark.ron", "many.ron"]);
}

#[test]
fn panels_stand_side_by_side() {
    let tall = SCENE.replace("sources:", "diagram: (size: (400, 700), theme: Dark), sources:");
    let place = Place::with(&[("a.ron", MIRROR), ("tall.ron", &tall)]);
    assert_eq!(place.run(&["render", "--panels", "a.ron", "tall.ron"]).clean(), "panels.svg\n");
    let svg = fs::read_to_string(place.path("panels.svg")).unwrap();
    assert!(svg.contains(r#"viewBox="0 0 696 700""#), "480 + 16 + 200 wide, 700 high: {}", &svg[..200]);
    assert!(svg.contains("<title>Mirror | Into glass</title>"));
    assert_eq!((svg.matches(r#"class="panel""#).count(), svg.matches(r#"class="ground""#).count()), (2, 2));
    let to = |more: &[&str]| place.run(&[&["render", "--panels", "a.ron", "a.ron"], more].concat()).clean();
    assert_eq!(to(&["-o", "x.png", "--size", "800x300", "--scale", "2"]), "x.png\n");
    assert_eq!(size(&place, "x.png"), (1600, 600));
    assert_eq!(to(&["--out-dir", "out", "--format", "svg,png"]), "out/panels.svg\nout/panels.png\n");
    assert_png(&fs::read(place.path("out/panels.png")).unwrap());
    assert_svg(&place.path("out/panels.svg"));
    to(&["-o", "clear.svg", "--transparent"]);
    assert!(!fs::read_to_string(place.path("clear.svg")).unwrap().contains("#ffffff"));
}

/// Scenes with one view have one scale and one height, however long the words above and below them are.
#[test]
fn panels_with_one_view_can_be_compared() {
    let scene = |caption: &str, legend: bool| {
        let diagram = format!("diagram: (view: Box((-30, -20), (10, 20)), legend: {legend}, color: Via), sources:");
        MIRROR.replace("title: \"Mirror\"", &format!("caption: \"{caption}\"")).replace("sources:", &diagram)
    };
    let place = Place::with(&[("a.ron", &scene("", true)), ("b.ron", &scene(&"long words ".repeat(30), false))]);
    place.run(&["render", "--panels", "a.ron", "b.ron"]).clean();
    let svg = fs::read_to_string(place.path("panels.svg")).unwrap();
    let document = roxmltree::Document::parse(&svg).unwrap();
    let mirrors: Vec<Vec<f64>> = document
        .descendants()
        .filter(|node| node.attribute("class") == Some("surface mirror"))
        .map(|node| node.attribute("d").unwrap().replace(['M', 'L'], " "))
        .map(|d| d.split_whitespace().map(|number| number.parse().unwrap()).collect())
        .collect();
    let [a, b] = mirrors.as_slice() else { panic!("{mirrors:?}") };
    assert!(
        (b[0] - a[0] - 496.0).abs() < 0.02 && (b[1] - a[1]).abs() < 0.02 && (b[3] - a[3]).abs() < 0.02,
        "{mirrors:?}"
    );
}

#[test]
fn panels_show_all_that_is_wrong_and_write_nothing() {
    let place = Place::with(&[("a.ron", MIRROR), ("bad.ron", "(title: 1)"), ("worse.ron", "(")]);
    let run = place.run(&["render", "--panels", "a.ron", "bad.ron", "worse.ron"]).status(1);
    assert!(run.stdout().is_empty() && run.stderr().contains("bad.ron:1:") && run.stderr().contains("worse.ron:1:"));
    place.run(&["render", "--panels"]).status(2);
    place.run(&["render", "--panels", "a.ron", "a.ron", "--size", "40x90"]).refused("do not fit into 24 pixels");
    place.run(&["render", "--panels", "a.ron", "-o", "a.ron", "--format", "svg"]).refused("would overwrite");
    assert_eq!(place.files(), ["a.ron", "bad.ron", "worse.ron"]);
}

#[test]
fn characters_without_a_glyph_are_told() {
    let strange = MIRROR.replace("\"Mirror\"", "\"鏡 Mirror 鏡\"");
    let place = Place::with(&[("a.ron", MIRROR), ("strange.ron", &strange)]);
    let told = |arguments: &[&str]| place.run(&[&["render"], arguments].concat()).status(0).stderr();
    let formats: &[&str] = if cfg!(feature = "pdf") { &["x.svg", "x.png", "x.pdf"] } else { &["x.svg", "x.png"] };
    for format in formats {
        let warning = told(&["strange.ron", "-o", format]);
        assert!(warning.starts_with("strange.ron: warning: ") && warning.lines().count() == 1, "{format}: {warning}");
        assert_eq!(warning.matches("'鏡' (U+93E1)").count(), 1, "{format}: {warning}");
    }
    for more in [&["--steps"][..], &["--outline-text"], &["a.ron", "--panels"]] {
        let warning = told(&[&["strange.ron"], more].concat());
        assert!(warning.starts_with("strange.ron: warning: ") && warning.lines().count() == 1, "{more:?}: {warning}");
    }
    let svg = place.run(&["render", "strange.ron", "-o", "-"]).status(0).stdout();
    assert!(svg.contains("<title>鏡 Mirror 鏡</title>"));
}

#[cfg(not(feature = "pdf"))]
#[test]
fn a_build_without_pdf_says_how_to_get_one() {
    let place = Place::with(&[("a.ron", SCENE)]);
    for arguments in [&["-o", "x.pdf"][..], &["--format", "svg,pdf"], &["--panels", "--format", "pdf"]] {
        place.run(&[&["render", "a.ron"], arguments].concat()).refused("cargo install --path . --features pdf");
    }
    assert_eq!(place.files(), ["a.ron"]);
}

#[cfg(feature = "pdf")]
#[test]
fn pdf_goes_where_other_forms_go() {
    let place = Place::with(&[("a.ron", MIRROR)]);
    assert_eq!(place.run(&["render", "a.ron", "-o", "x.PDF"]).clean(), "x.PDF\n");
    assert!(fs::read(place.path("x.PDF")).unwrap().starts_with(b"%PDF-1.7"));
    assert_eq!(place.run(&["render", "a.ron", "--steps", "--format", "pdf"]).clean(), "a-1.pdf\na-2.pdf\n");
    assert_eq!(place.run(&["render", "a.ron", "a.ron", "--panels", "--format", "pdf"]).clean(), "panels.pdf\n");
}
