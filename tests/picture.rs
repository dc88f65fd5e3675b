//! Figures from scene text: what the SVG holds, that the PNG shows it, and that no scene breaks either.

#![allow(clippy::unwrap_used, clippy::float_cmp, reason = "a test stops at the first surprise")]

mod support;

use std::collections::BTreeSet;

use roxmltree::{Document, Node};
use snellius::diagram::{draw, draw_counted};
use snellius::drawing::Drawing;
use snellius::render;
use support::run_text;

const PRISM: &str = r#"(
    title: "Prism <1> & \"more\"",
    caption: "Nothing leaves the hypotenuse.",
    bodies: [(name: "a<b", shape: Polygon([(0, 0), (40, 0), (0, 40)]), medium: Catalog("N-BK7"))],
    sources: [(light: Ray(from: (-30, 10), direction: Angle(0)))],
)"#;

fn figure(text: &str) -> Drawing {
    let run = run_text(text);
    draw(&run.scene, &run.system, &run.trace.tree)
}

fn svg(text: &str) -> String {
    render::svg(&figure(text))
}

/// A scene of a prism in white light with further settings.
fn white(diagram: &str) -> String {
    format!(
        r#"(
            bodies: [(shape: Prism(apex_angle: 60, side: 40), medium: Catalog("F2"))],
            sources: [(light: Ray(from: (-50, -18), direction: Towards((-12, 0))), spectrum: White(samples: 5))],
            diagram: ({diagram}),
        )"#
    )
}

fn of_class<'a, 'b>(document: &'a Document<'b>, class: &str) -> Vec<Node<'a, 'b>> {
    let has = |node: &Node<'_, '_>| node.attribute("class").is_some_and(|all| all.split(' ').any(|one| one == class));
    document.descendants().filter(has).collect()
}

fn power(node: &Node<'_, '_>) -> f64 {
    node.attribute("data-power").unwrap().parse().unwrap()
}

/// The two ends of a straight path.
fn ends(node: &Node<'_, '_>) -> [f64; 4] {
    let numbers = node.attribute("d").unwrap().replace(['M', 'L'], " ");
    let numbers: Vec<f64> = numbers.split_whitespace().map(|number| number.parse().unwrap()).collect();
    numbers.try_into().unwrap()
}

fn length([x0, y0, x1, y1]: [f64; 4]) -> f64 {
    ((x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0)).sqrt()
}

#[test]
fn the_first_figure_holds_what_is_promised() {
    let text = svg(PRISM);
    let document = Document::parse(&text).unwrap();
    let find = |name| document.descendants().find(|node| node.has_tag_name(name)).unwrap();
    assert_eq!(find("title").text(), Some("Prism <1> & \"more\""));
    assert_eq!(find("desc").text(), Some("Nothing leaves the hypotenuse."));
    assert_eq!(of_class(&document, "body")[0].attribute("data-body"), Some("a<b"));
    let rays = of_class(&document, "ray");
    let addresses: BTreeSet<_> = rays.iter().map(|ray| ray.attribute("data-address").unwrap()).collect();
    assert_eq!(addresses.len(), rays.len());
    for (via, address, share) in [("source", "0.0:", 1.0), ("total_internal_reflection", "0.0:ti", 0.957_8)] {
        let ray = rays.iter().find(|ray| ray.attribute("data-address") == Some(address)).unwrap();
        assert!(ray.attribute("class").unwrap().split(' ').any(|class| class == via));
        assert!((power(ray) - share).abs() < 1e-3);
    }
    assert!(!of_class(&document, "normal").is_empty());
    assert!(of_class(&document, "arrow").len() >= 4);
}

#[test]
fn switches_remove_marks() {
    let off = PRISM.replace("sources:", "diagram: (normals: false, arrows: false, labels: false), sources:");
    let text = svg(&off);
    let document = Document::parse(&text).unwrap();
    for class in ["normal", "arrow", "label"] {
        assert!(of_class(&document, class).is_empty(), "{class}");
    }
    let more = PRISM.replace("sources:", "diagram: (grid: true, scale_bar: true), sources:");
    let text = svg(&more);
    let document = Document::parse(&text).unwrap();
    assert_eq!((of_class(&document, "grid").len(), of_class(&document, "scale-bar").len()), (1, 1));
}

#[test]
fn coincident_lines_are_one_until_they_part() {
    for (theme, color) in [("Light", "#1f2933"), ("Dark", "#ffffff")] {
        let text = svg(&white(&format!("theme: {theme}")));
        let document = Document::parse(&text).unwrap();
        let rays = of_class(&document, "ray");
        let at_source: Vec<_> =
            rays.iter().filter(|ray| ray.attribute("data-address").unwrap().ends_with(':')).collect();
        let [source] = at_source.as_slice() else { panic!("{at_source:?}") };
        assert_eq!(source.attribute("data-address"), Some("0.0@420:"));
        assert_eq!(source.attribute("stroke"), Some(color));
        assert!((power(source) - 1.0).abs() < 1e-12);
        let out: Vec<_> = rays.iter().filter(|ray| ray.attribute("data-address").unwrap().ends_with(":tt")).collect();
        assert_eq!(out.len(), 5);
        let colors: BTreeSet<_> = out.iter().map(|ray| ray.attribute("stroke")).collect();
        assert_eq!(colors.len(), 5);
    }
}

#[test]
fn a_source_may_choose_its_color() {
    let text = PRISM.replace("sources: [(", "sources: [(color: \"#123456\", ");
    assert!(svg(&text).contains("stroke=\"#123456\""));
}

#[test]
fn branches_below_faintest_are_not_drawn() {
    let shares = |faintest: &str| {
        let text = svg(&PRISM.replace("sources:", &format!("diagram: (faintest: {faintest}), sources:")));
        let document = Document::parse(&text).unwrap();
        of_class(&document, "ray").iter().map(power).collect::<Vec<_>>()
    };
    let (all, strong) = (shares("0"), shares("0.5"));
    assert!(all.iter().any(|share| *share < 0.01) && all.len() > strong.len());
    assert!(strong.len() == 4 && strong.iter().all(|share| *share >= 0.5));
}

#[test]
fn what_was_not_followed_is_a_stub() {
    let cut = PRISM.replace("sources:", "trace: (max_depth: 1), sources:");
    let text = svg(&cut);
    let document = Document::parse(&text).unwrap();
    let rays = of_class(&document, "ray");
    let stub = rays.iter().find(|ray| ray.attribute("data-address") == Some("0.0:t")).unwrap();
    assert!((length(ends(stub)) - 14.0).abs() < 0.1);
}

#[test]
fn escaped_rays_reach_the_frame_and_nothing_leaves_it() {
    let text = svg(&PRISM.replace("    sources:", "    diagram: (legend: false),\n    sources:"));
    let document = Document::parse(&text).unwrap();
    let rays = of_class(&document, "ray");
    let out = rays.iter().find(|ray| ray.attribute("data-address") == Some("0.0:tit")).unwrap();
    let [_, _, _, bottom] = ends(out);
    assert!(bottom > 500.0, "{bottom}");
    for ray in &rays {
        let [x0, y0, x1, y1] = ends(ray);
        assert!(
            [x0, x1].iter().all(|x| (0.0..=960.0).contains(x)) && [y0, y1].iter().all(|y| (0.0..=540.0).contains(y))
        );
    }
}

#[test]
fn a_box_is_shown_whole_with_one_scale() {
    let boxed = PRISM.replace("sources:", "diagram: (view: Box((-40, -10), (60, 50))), sources:");
    let text = svg(&boxed);
    let document = Document::parse(&text).unwrap();
    let body = of_class(&document, "body")[0].first_element_child().unwrap();
    let numbers = body.attribute("d").unwrap().replace(['M', 'L', 'Z'], " ");
    let at: Vec<f64> = numbers.split_whitespace().map(|number| number.parse().unwrap()).collect();
    let [x0, y0, x1, y1, x2, y2] = at.try_into().unwrap();
    assert!((x1 - x0 - (y0 - y2)).abs() < 0.011 && y1 == y0 && x2 == x0, "{numbers}");
    let scale = (x1 - x0) / 40.0;
    assert!(x0 - 40.0 * scale > 0.0 && x0 + 60.0 * scale < 960.0);
    assert!(y0 + 10.0 * scale < 540.0 && y0 - 50.0 * scale > 68.0);
}

#[test]
fn the_focus_of_a_lens_is_in_view() {
    let text = svg(r#"(
            bodies: [(shape: Lens(radii: (50, -50), thickness: 6, diameter: 30), medium: Index(1.5))],
            sources: [(light: Beam(center: (-20, 0), direction: Angle(0), width: 20, rays: 5))],
        )"#);
    let document = Document::parse(&text).unwrap();
    let rays = of_class(&document, "ray");
    let find = |address: &str| ends(rays.iter().find(|ray| ray.attribute("data-address") == Some(address)).unwrap());
    let (top, bottom) = (find("0.4:tt"), find("0.0:tt"));
    assert!(top[1] < bottom[1] && top[3] > bottom[3], "they have crossed: {top:?} {bottom:?}");
}

#[test]
fn every_surface_has_its_sign() {
    let text = svg(r#"(
            bodies: [
                (shape: Flat(from: (0, -5), to: (0, 5)), surface: ThinLens(focal_length: -20)),
                (shape: Flat(from: (10, -5), to: (14, 5)), surface: BeamSplitter(reflect: 0.5, transmit: 0.5)),
                (shape: Stop(opening: 4, height: 10), at: (20, 0)),
                (shape: Arc(from: (30, -5), through: (32, 0), to: (30, 5)), surface: Mirror),
                (shape: Flat(from: (-30, -5), to: (-30, 5)), surface: Screen, name: "wall"),
            ],
            sources: [(light: Ray(from: (-10, 0.5), direction: Angle(0)))],
        )"#);
    let document = Document::parse(&text).unwrap();
    for class in ["thin-lens", "beam-splitter", "absorber", "mirror", "mirror-back", "screen"] {
        assert!(!of_class(&document, class).is_empty(), "{class}");
    }
    let names: Vec<_> = of_class(&document, "body").iter().map(|body| body.attribute("data-body").unwrap()).collect();
    assert_eq!(names, ["#0", "#1", "#2", "#3", "wall"]);
}

#[test]
fn very_many_rays_share_paths() {
    let text = svg(r#"(
            bodies: [(shape: Disk(10), medium: Index(1.5))],
            sources: [(light: Beam(center: (-40, 0), direction: Angle(0), width: 19, rays: 900))],
        )"#);
    let document = Document::parse(&text).unwrap();
    let rays = of_class(&document, "ray");
    assert!(rays.len() < 200, "{}", rays.len());
    assert!(rays.iter().all(|ray| ray.attribute("data-address").is_none()));
    let pieces: usize = rays.iter().map(|ray| ray.attribute("d").unwrap().matches('M').count()).sum();
    assert!(pieces > 2000);
    assert!(text.len() <= 80 * pieces, "{} bytes for {pieces} segments", text.len());
}

#[test]
fn the_same_scene_gives_the_same_bytes() {
    assert_eq!(svg(PRISM), svg(PRISM));
    let png = || render::png(&figure(PRISM), 1.0).unwrap();
    assert_eq!(png(), png());
}

#[test]
fn the_png_shows_the_title() {
    for (scale, factor) in [(1, 1.0), (2, 2.0)] {
        let picture = tiny_skia::Pixmap::decode_png(&render::png(&figure(PRISM), factor).unwrap()).unwrap();
        assert_eq!((picture.width(), picture.height()), (960 * scale, 540 * scale));
        let red = |x: u32, y: u32| picture.pixel(x * scale, y * scale).unwrap().red();
        let title = (32..250).flat_map(|x| (28..46).map(move |y| (x, y)));
        assert!(title.filter(|(x, y)| red(*x, *y) < 90).count() > 300, "the title is there");
        assert!((260..900).all(|x| red(x, 35) == 255), "and ends");
    }
}

#[test]
fn no_scale_place_or_size_breaks_a_figure() {
    for (scale, at) in [(1e-12, 0.0), (1.0, 1e12), (1e12, 1.0), (1e-3, -1e6), (1e12, -1e12), (1e-12, 1e-9)] {
        for size in ["(960, 540)", "(16, 16)", "(40, 4000)"] {
            let [r, x, y] = [10.0 * scale, at - 40.0 * scale, at + 3.0 * scale];
            let text = svg(&format!(
                r#"(
                    title: "A title of several words", caption: "And a caption",
                    bodies: [(name: "disk", shape: Disk({r:?}), at: ({at:?}, {at:?}), medium: Index(1.5))],
                    sources: [(light: Ray(from: ({x:?}, {y:?}), direction: Angle(0)))],
                    diagram: (size: {size}, grid: true, scale_bar: true),
                )"#
            ));
            check(&text);
        }
    }
}

#[test]
fn empty_scenes_and_views_have_figures() {
    for text in [
        "()",
        "(notes: [(at: (1e12, -1e12), text: \"here\")])",
        "(sources: [(light: Ray(from: (5, 5), direction: Angle(10)))])",
        "(bodies: [(shape: Disk(1), medium: Index(1.5))])",
        "(bodies: [(shape: Disk(1e9), at: (0, -1e9), medium: Index(1.5))], diagram: (view: Box((-1, -1), (1, 1)), grid: true))",
        "(bodies: [(shape: Disk(1), medium: Index(1.5))], diagram: (view: Box((1e9, 1e9), (2e9, 2e9))))",
    ] {
        check(&svg(text));
        render::png(&figure(text), 0.5).unwrap();
    }
}

/// Well-formed, and every number in it finite and without −0.
fn check(text: &str) {
    let document = Document::parse(text).unwrap();
    for node in document.descendants() {
        for name in ["d", "x", "y", "width", "height", "font-size", "stroke-width"] {
            let numbers = node.attribute(name).unwrap_or("").replace(['M', 'L', 'A', 'Z'], " ");
            for number in numbers.split_whitespace() {
                let value: f64 = number.parse().unwrap_or_else(|_| panic!("{number} in {text}"));
                assert!(value.abs() <= 1e6 && !number.starts_with("-0 ") && number != "-0", "{number} in {text}");
            }
        }
    }
}

#[test]
fn what_is_drawn_and_spared_is_counted() {
    let counted = |text: &str| {
        let run = run_text(text);
        let all: usize = run.trace.tree.rays.iter().map(|ray| ray.segments.len()).sum();
        (draw_counted(&run.scene, &run.system, &run.trace.tree).1, all)
    };
    let boxed = "view: Box((-20, -30), (0, -10)), faintest: 0.05";
    for text in [white(""), white(boxed), white("faintest: 0"), PRISM.to_owned()] {
        let (counts, all) = counted(&text);
        assert_eq!(counts.segments_drawn + counts.segments_outside_view + counts.segments_below_faintest, all);
    }
    let (whole, _) = counted(&white("faintest: 0, angles: false, legend: false"));
    assert_eq!((whole.segments_outside_view, whole.segments_below_faintest), (0, 0));
    let (cut, _) = counted(&white(boxed));
    assert!(cut.segments_outside_view > 0 && cut.segments_below_faintest > 0 && cut.segments_drawn > 0);
    assert!(whole.marks_drawn > 0 && !whole.font_used, "{whole:?}");
    let (bare, _) = counted(&white("normals: false, arrows: false, angles: false"));
    assert_eq!(bare.marks_drawn, 0);
    assert!(counted(PRISM).0.font_used);
}

#[test]
fn paths_of_any_depth_are_drawn() {
    // Written out, the letters of all these paths would take 5 GB.
    let text = svg(r#"(
        bodies: [
            (shape: Flat(from: (0, -5), to: (0, 5)), surface: Mirror),
            (shape: Flat(from: (9, -5), to: (9, 5)), surface: Mirror),
        ],
        sources: [(light: Ray(from: (1, 0), direction: Angle(0)), spectrum: Lines([500, 600]))],
        trace: (max_depth: 100000),
        diagram: (extensions: true),
    )"#);
    check(&text);
    assert!(text.contains("class=\"ray reflection\""));
}
