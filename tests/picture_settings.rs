//! What an author chooses, in the figure: theme, colors, size, labels and notes; and how power shows.

#![allow(clippy::unwrap_used, clippy::float_cmp, reason = "a test stops at the first surprise")]

mod support;

use std::collections::{BTreeMap, BTreeSet};

use roxmltree::{Document, Node};
use snellius::diagram::draw;
use snellius::drawing::Drawing;
use snellius::render;
use support::run_text;

fn figure(text: &str) -> Drawing {
    let run = run_text(text);
    draw(&run.scene, &run.system, &run.trace.tree)
}

/// The attributes of an element and its text.
type Mark = BTreeMap<String, String>;

/// All paths and texts of a class, or inside of a group of it.
fn marks(scene: &str, class: &str) -> Vec<Mark> {
    let text = render::svg(&figure(scene));
    let document = Document::parse(&text).unwrap();
    let has = |node: Node<'_, '_>| node.attribute("class").is_some_and(|all| all.split(' ').any(|one| one == class));
    let nodes = document.descendants().filter(|node| node.has_tag_name("path") || node.has_tag_name("text"));
    let nodes = nodes.filter(|node| node.ancestors().any(has));
    let mark = |node: Node<'_, '_>| {
        let attributes = node.attributes().map(|a| (a.name().to_owned(), a.value().to_owned()));
        attributes.chain([("text".to_owned(), node.text().unwrap_or("").to_owned())]).collect()
    };
    nodes.map(mark).collect()
}

/// Rays by their address.
fn rays(scene: &str) -> BTreeMap<String, Mark> {
    marks(scene, "ray").into_iter().map(|mark| (mark["data-address"].clone(), mark)).collect()
}

fn number(mark: &Mark, name: &str) -> f64 {
    mark.get(name).map_or(1.0, |value| value.parse().unwrap())
}

fn numbers(mark: &Mark) -> Vec<f64> {
    let numbers = mark["d"].replace(['M', 'L', 'Z'], " ");
    numbers.split_whitespace().map(|number| number.parse().unwrap()).collect()
}

/// Red, green and blue of a CSS color.
fn channels(css: &str) -> [u8; 3] {
    [1, 3, 5].map(|at| u8::from_str_radix(&css[at..at + 2], 16).unwrap())
}

/// A ray into a right-angle prism of glass, totally reflected at the hypotenuse.
fn prism(source: &str, diagram: &str) -> String {
    format!(
        r#"(
            bodies: [(shape: Polygon([(0, 0), (40, 0), (0, 40)]), medium: Index(1.5))],
            sources: [(light: Ray(from: (-30, 10), direction: Angle(0)), {source})],
            diagram: ({diagram}),
        )"#
    )
}

/// A ray of several lines through a prism that fans them out.
fn lines(lines: &str, diagram: &str) -> String {
    format!(
        r#"(
            bodies: [(shape: Prism(apex_angle: 60, side: 40), medium: Catalog("F2"))],
            sources: [(light: Ray(from: (-50, -18), direction: Towards((-12, 0))), spectrum: Lines({lines}))],
            trace: (secondary_rays: TransmittedOnly),
            diagram: ({diagram}),
        )"#
    )
}

#[test]
fn print_is_black_on_white_and_gray() {
    let scene = |theme: &str| prism("", &format!("theme: {theme}"));
    let look = |theme: &str| {
        let body = marks(&scene(theme), "body").into_iter().find(|mark| mark["fill"] != "none").unwrap();
        (rays(&scene(theme))["0.0:"]["stroke"].clone(), channels(&body["fill"]))
    };
    let (ray, [r, g, b]) = look("Print");
    assert!(ray == "#000000" && r == g && g == b && r < 255, "{ray} {r} {g} {b}");
    for theme in ["Light", "Dark"] {
        let (ray, [r, _, b]) = look(theme);
        assert!(ray != "#000000" && r < b, "{theme}");
    }
    assert_eq!(figure(&scene("Print")).background.map(|c| c.0), Some([255, 255, 255]));
    assert!(figure(&scene("Dark")).background.is_some_and(|c| c.0[0] < 64));
}

#[test]
fn in_print_dashes_tell_a_few_lines_apart() {
    let dashes = |nm: &str, theme: &str| {
        let rays = rays(&lines(nm, &format!("theme: {theme}")));
        assert_eq!(rays.iter().find(|(at, _)| at.ends_with(':')).unwrap().1.get("stroke-dasharray"), None, "white");
        let out = rays.iter().filter(|(address, _)| address.ends_with(":tt"));
        out.map(|(_, ray)| ray.get("stroke-dasharray").cloned()).collect::<BTreeSet<_>>().len()
    };
    assert_eq!(dashes("[420, 486, 656]", "Print"), 3);
    assert_eq!(dashes("[420, 450, 486, 530, 588, 656]", "Print"), 6);
    assert_eq!(dashes("[420, 450, 486, 530, 588, 620, 656]", "Print"), 1, "too many to tell apart");
    assert_eq!(dashes("[420, 486, 656]", "Light"), 1);
}

#[test]
fn the_authors_colors_suit_every_ground() {
    let scene = |theme: &str| {
        format!(
            r##"(
                bodies: [(shape: Rectangle(10, 40), medium: Index(1.5), color: "#e4cda4")],
                sources: [
                    (light: Ray(from: (-30, 10), direction: Angle(0)), color: "#1565a8"),
                    (light: Ray(from: (-30, 0), direction: Angle(0)), color: "#c8202f"),
                    (light: Ray(from: (-30, -10), direction: Angle(0))),
                ],
                diagram: (theme: {theme}),
            )"##
        )
    };
    let fill = |theme: &str| {
        let body = marks(&scene(theme), "body").into_iter().find(|mark| mark["fill"] != "none").unwrap();
        channels(&body["fill"])
    };
    let strokes = |theme: &str| {
        let rays = rays(&scene(theme));
        ["0.0:", "1.0:", "2.0:"].map(|address| rays[address]["stroke"].clone())
    };
    assert_eq!(strokes("Light"), ["#1565a8", "#c8202f", "#c8202f"]);
    assert_eq!(fill("Light"), [0xe4, 0xcd, 0xa4]);
    let sum = |channels: [u8; 3]| channels.into_iter().map(u32::from).sum::<u32>();
    let lifted = strokes("Dark").map(|color| channels(&color));
    assert!(sum(lifted[0]) > sum([0x15, 0x65, 0xa8]) && lifted[0][2] > lifted[0][0], "{lifted:?}: lighter, and blue");
    let dark = fill("Dark");
    assert!(dark.into_iter().max().unwrap() < 96 && dark[0] > dark[2], "{dark:?}: deep, and sand");
    assert_eq!(strokes("Print"), ["#000000"; 3].map(str::to_owned));
    let dashes: BTreeSet<_> = rays(&scene("Print"))
        .into_iter()
        .filter(|(address, _)| address.ends_with(':'))
        .map(|(_, ray)| ray.get("stroke-dasharray").cloned())
        .collect();
    assert_eq!(dashes.len(), 3, "{dashes:?}");
    let [r, g, b] = fill("Print");
    assert!(r == g && g == b, "gray");
}

#[test]
fn color_may_tell_the_power() {
    for (theme, strong) in [("Light", "#a00c2c"), ("Dark", "#ffd866"), ("Print", "#000000")] {
        let rays = rays(&prism("", &format!("color: Power, theme: {theme}")));
        let color = |address: &str| &rays[address]["stroke"];
        assert_eq!(color("0.0:"), strong);
        // 100 %, 96 %, 92 % and 4 %; total reflection changes nothing.
        let shares: BTreeSet<_> = ["0.0:", "0.0:t", "0.0:tit", "0.0:r"].map(color).into();
        assert_eq!((shares.len(), color("0.0:t")), (4, color("0.0:ti")), "{theme}");
        let far = |address| channels(color(address)).iter().zip(channels(strong)).map(|(a, b)| a.abs_diff(b)).max();
        assert!(far("0.0:r") > far("0.0:tit") && far("0.0:tit") > far("0.0:t"), "{theme}");
    }
}

#[test]
fn color_may_tell_the_wavelength_of_a_single_line() {
    let color = |nm: f64, setting: &str| {
        let rays = rays(&prism(&format!("spectrum: Line({nm:?})"), &format!("color: {setting}")));
        rays["0.0:"]["stroke"].clone()
    };
    assert_eq!(color(632.8, "Auto"), "#c8202f");
    assert_eq!(color(470.0, "Auto"), "#c8202f");
    let ([r, _, b], [s, _, c]) = (channels(&color(632.8, "Wavelength")), channels(&color(470.0, "Wavelength")));
    assert!(r > b && s < c, "red {r} {b}, blue {s} {c}");
}

#[test]
fn color_may_tell_how_light_came_about() {
    for theme in ["Light", "Dark", "Print"] {
        let rays = rays(&prism("", &format!("color: Via, theme: {theme}")));
        let color = |address: &str| rays[address]["stroke"].as_str();
        let colors: BTreeSet<_> = ["0.0:t", "0.0:r", "0.0:ti"].map(color).into();
        assert!(colors.len() == 3 && color("0.0:t") == color("0.0:tit"), "{theme}: {colors:?}");
    }
    let print = rays(&prism("", "color: Via, theme: Print"));
    let dashes: BTreeSet<_> =
        ["0.0:", "0.0:t", "0.0:r", "0.0:ti"].map(|address| print[address].get("stroke-dasharray").cloned()).into();
    assert_eq!(dashes.len(), 4, "told apart without color and gray: {dashes:?}");
    let rays = rays(&prism("", "color: Via"));
    let color = |address: &str| rays[address]["stroke"].as_str();
    assert_eq!(["0.0:", "0.0:t", "0.0:r", "0.0:ti"].map(color), ["#c8202f", "#1565a8", "#a84b00", "#8a1c7c"]);
}

#[test]
fn the_figure_has_the_size_asked_for() {
    let drawing = figure(&prism("", "size: (640, 300)"));
    assert_eq!(drawing.size, [640, 300]);
    let text = render::svg(&drawing);
    let document = Document::parse(&text).unwrap();
    let root = document.root_element();
    assert_eq!((root.attribute("width"), root.attribute("height")), (Some("640"), Some("300")));
    assert_eq!(root.attribute("viewBox"), Some("0 0 640 300"));
    let picture = tiny_skia::Pixmap::decode_png(&render::png(&drawing, 2.0).unwrap()).unwrap();
    assert_eq!((picture.width(), picture.height()), (1280, 600));
}

#[test]
fn data_power_is_the_power_and_not_the_share() {
    let rays = rays(&prism("power: 5", ""));
    assert_eq!(number(&rays["0.0:"], "data-power"), 5.0);
    assert!((number(&rays["0.0:r"], "data-power") - 0.2).abs() < 1e-12);
}

#[test]
fn weak_rays_are_fainter_and_thinner() {
    let rays = rays(&prism("", ""));
    for (weak, strong) in [("0.0:r", "0.0:tit"), ("0.0:tit", "0.0:t"), ("0.0:t", "0.0:")] {
        let [weak, strong] = [&rays[weak], &rays[strong]];
        for name in ["stroke-width", "stroke-opacity"] {
            assert!(number(weak, name) < number(strong, name), "{name}: {weak:?} {strong:?}");
        }
    }
    assert!(number(&rays["0.0:r"], "stroke-opacity") < 0.4 && number(&rays["0.0:"], "stroke-opacity") == 1.0);
}

#[test]
fn normals_are_dashed() {
    let normals = marks(&prism("", ""), "normal");
    assert!(!normals.is_empty());
    for normal in normals {
        assert_eq!(normal["stroke-dasharray"], "5 4");
    }
}

#[test]
fn a_body_may_choose_its_color() {
    let scene = r##"(
        bodies: [
            (color: "#80c040", shape: Disk(5), medium: Index(1.5)),
            (color: "#4060c0", shape: Flat(from: (20, -5), to: (20, 5)), surface: Mirror),
        ],
    )"##;
    let fill = |mark: &Mark| mark["fill"] == "#80c040";
    assert!(marks(scene, "body").iter().any(fill));
    assert!(marks(scene, "mirror").iter().all(|mark| mark["stroke"] == "#4060c0"));
    let edge = channels(&marks(scene, "interface")[0]["stroke"]);
    assert!(edge[1] > edge[0] && edge[1] > edge[2], "the same hue, deeper: {edge:?}");
}

#[test]
fn a_label_stands_for_the_name() {
    let words = |fields: &str| {
        let scene = format!("(bodies: [({fields} shape: Disk(5), medium: Index(1.5))])");
        marks(&scene, "label").into_iter().map(|mark| mark["text"].clone()).collect::<Vec<_>>()
    };
    assert_eq!(words(r#"name: "lens", label: "flint","#), ["flint"]);
    assert_eq!(words(r#"label: "flint","#), ["flint"]);
    assert_eq!(words(r#"name: "lens","#), ["lens"]);
}

#[test]
fn notes_stand_at_their_places() {
    let scene = r#"(
        notes: [(at: (-10, 0), text: "eye"), (at: (10, 5), text: "two\nlines")],
        bodies: [(shape: Flat(from: (-10, -10), to: (10, -10)), surface: Absorber)],
        diagram: (view: Box((-40, -20), (40, 20))),
    )"#;
    let notes = marks(scene, "note");
    assert_eq!(notes.iter().map(|note| note["text"].as_str()).collect::<Vec<_>>(), ["eye", "two", "lines"]);
    let [left, bar, right, _] = numbers(&marks(scene, "absorber")[0]).try_into().unwrap();
    let scale = (right - left) / 20.0;
    let at = |note: &Mark| [number(note, "x"), number(note, "y")];
    let near = |[x, y]: [f64; 2], [u, v]: [f64; 2]| (x - u).abs() < 0.1 && (y - v).abs() < 8.0;
    assert!(near(at(&notes[0]), [left, bar - 10.0 * scale]), "{notes:?}");
    assert!(near(at(&notes[1]), [right, bar - 15.0 * scale - 4.0]), "{notes:?}");
    assert_eq!(at(&notes[2])[1] - at(&notes[1])[1], 17.0);
}

#[test]
fn heads_point_outward_where_light_gathers_and_inward_where_it_parts() {
    /// How far the barbs stick out beyond the lens, pixels.
    fn beyond(focal_length: f64) -> f64 {
        let lens =
            format!("(shape: Flat(from: (0, -5), to: (0, 5)), surface: ThinLens(focal_length: {focal_length:?}))");
        let marks = marks(&format!("(bodies: [{lens}])"), "thin-lens");
        let span = |mark: &Mark| {
            let y: Vec<f64> = numbers(mark).into_iter().skip(1).step_by(2).collect();
            (y.iter().copied().fold(f64::INFINITY, f64::min), y.iter().copied().fold(0.0, f64::max))
        };
        let [(top, bottom), (low, high)] = [span(&marks[0]), span(&marks[1])];
        assert!((top - low - (high - bottom)).abs() < 0.011, "alike at both ends");
        top - low
    }
    assert!(beyond(20.0).abs() < 0.011, "the tips are the ends");
    assert!(beyond(-20.0) > 5.0, "the tips are at the ends, the barbs beyond");
}

#[test]
fn some_lines_of_a_ray_that_coincide_are_one() {
    for (theme, white) in [("Light", "#1f2933"), ("Dark", "#ffffff"), ("Print", "#000000")] {
        let doublet = rays(&lines("[587.5618, 587.6, 420]", &format!("theme: {theme}")));
        let single = rays(&lines("[587.5618, 420]", &format!("theme: {theme}")));
        let places: BTreeSet<_> = doublet.values().map(|ray| &ray["d"]).collect();
        assert_eq!(places.len(), doublet.len(), "nothing is drawn twice");
        let addresses: Vec<_> = doublet.keys().map(String::as_str).collect();
        let expected = ["0.0@420:t", "0.0@420:tt", "0.0@587.5618:", "0.0@587.5618:t", "0.0@587.5618:tt"];
        assert_eq!(addresses, expected);
        for (address, share) in [("0.0@587.5618:", 1.0), ("0.0@587.5618:tt", 2.0 / 3.0), ("0.0@420:tt", 1.0 / 3.0)] {
            assert!((number(&doublet[address], "data-power") - share).abs() < 1e-12, "{address}");
        }
        assert_eq!(doublet["0.0@587.5618:"]["stroke"], white);
        let [both, one] = [&doublet, &single].map(|rays| channels(&rays["0.0@587.5618:tt"]["stroke"]));
        let apart = both.iter().zip(one).map(|(a, b)| a.abs_diff(b)).max();
        assert!(apart < Some(4), "a doublet keeps its hue: {both:?} {one:?}");
    }
}

#[test]
fn some_lines_add_up_to_their_color() {
    let scene = |theme: &str| lines("[436, 546, 546.01, 700]", &format!("theme: {theme}"));
    let green = channels(&rays(&scene("Dark"))["0.0@546:tt"]["stroke"]);
    assert!(green[1] > green[0] && green[1] > green[2], "{green:?}");
    let printed = channels(&rays(&scene("Light"))["0.0@546:tt"]["stroke"]);
    assert!(printed[1] < green[1] && printed[1] > printed[2], "readable on white: {printed:?}");
}

/// Every label in the figure.
fn labels(scene: &str) -> Vec<String> {
    marks(scene, "label").into_iter().map(|mark| mark["text"].replace('\u{a0}', " ")).collect()
}

#[test]
fn media_are_labelled_with_name_and_index() {
    let scene = |surroundings: &str, body: &str| {
        format!(
            "(surroundings: {surroundings}, bodies: [(shape: {body}, medium: Catalog(\"N-BK7\"), name: \"glass\")],
            sources: [(light: Ray(from: (-60, 5), direction: Angle(0)))])"
        )
    };
    assert_eq!(labels(&scene("Index(1)", "Rectangle(60, 60)")), ["glass, n = 1.517"]);
    assert_eq!(labels(&scene("Catalog(\"air\")", "Rectangle(2, 40)")), ["glass, n = 1.517"], "beside a thin one");
    assert_eq!(labels(&scene("Catalog(\"water\")", "Rectangle(60, 60)")), ["glass, n = 1.517", "water, n = 1.333"]);
    assert_eq!(labels(&scene("Index(1.4)", "Rectangle(60, 60)"))[1], "n = 1.4");
    let gas = scene("Index(1)", "Rectangle(60, 60)").replace("Catalog(\"N-BK7\")", "Index(1.00029)");
    assert_eq!(labels(&gas), ["glass, n = 1.00029"], "three decimals would say that it is empty");
}
