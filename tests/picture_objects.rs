//! Objects, images, axes, focal points and principal planes in the figure.

#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

mod support;

use std::collections::BTreeMap;

use glam::DVec2;
use roxmltree::{Document, Node};
use snellius::diagram::draw;
use snellius::render;
use support::{Run, run_text, segment};

type Mark = BTreeMap<String, String>;

fn svg(run: &Run) -> String {
    render::svg(&draw(&run.scene, &run.system, &run.trace.tree))
}

/// All paths and texts of a class.
fn marks(scene: &str, class: &str) -> Vec<Mark> {
    let text = svg(&run_text(scene));
    let document = Document::parse(&text).unwrap();
    let has = |node: &Node<'_, '_>| node.attribute("class").is_some_and(|all| all.split(' ').any(|one| one == class));
    let nodes = document.descendants().filter(|node| !node.has_tag_name("g") && has(node));
    let mark = |node: Node<'_, '_>| {
        let words: String = node.descendants().filter(|part| part.is_text()).filter_map(|part| part.text()).collect();
        let attributes = node.attributes().map(|a| (a.name().to_owned(), a.value().to_owned()));
        attributes.chain([("words".to_owned(), words)]).collect()
    };
    nodes.map(mark).collect()
}

fn words(scene: &str, class: &str) -> Vec<String> {
    marks(scene, class).into_iter().map(|mark| mark["words"].clone()).collect()
}

/// The numbers of a path.
fn numbers(mark: &Mark) -> Vec<f64> {
    let separate = |c: char| if c.is_ascii_alphabetic() || c == ',' { ' ' } else { c };
    mark["d"].chars().map(separate).collect::<String>().split_whitespace().map(|n| n.parse().unwrap()).collect()
}

/// Both ends of a line.
fn ends(mark: &Mark) -> [DVec2; 2] {
    let n = numbers(mark);
    assert_eq!(n.len(), 4, "{mark:?}");
    [DVec2::new(n[0], n[1]), DVec2::new(n[2], n[3])]
}

/// Where scene points stand in a figure, by two ends of the ray `0.0:`.
fn placed(scene: &str) -> impl Fn(DVec2) -> DVec2 {
    let ray = marks(scene, "ray").into_iter().find(|mark| mark["data-address"] == "0.0:").unwrap();
    let run = run_text(scene);
    let first = *segment(&run.trace.tree.rays[0], "");
    let [a, b] = ends(&ray);
    let scale = (b - a).length() / (first.to.unwrap() - first.from).length();
    move |p| a + DVec2::new(p.x - first.from.x, first.from.y - p.y) * scale
}

const LENS: &str = r#"(name: "lens", shape: Flat(from: (0, -30), to: (0, 30)), surface: ThinLens(focal_length: 40))"#;
const THICK: &str = r#"(name: "lens", shape: Lens(radii: (40, -55), thickness: 16, diameter: 30), medium: Index(1.5))"#;
const MIRROR: &str = "(shape: Arc(from: (-5, -27), through: (0, 0), to: (-5, 27)), surface: Mirror)";

fn scene(bodies: &str, object: &str, source: &str, diagram: &str) -> String {
    format!(
        "(bodies: [{bodies}], sources: [(light: Object({object}), {source})],
          trace: (secondary_rays: TransmittedOnly), diagram: ({diagram}))"
    )
}

const REAL: &str = "from: (-60, 0), to: (-60, 12)";
const VIRTUAL: &str = "from: (-20, 0), to: (-20, 8)";

#[test]
fn an_object_is_an_arrow_and_so_is_its_image() {
    let text = scene(LENS, REAL, r#"color: "green""#, "");
    let place = placed(&text);
    for (class, foot, tip) in [("object", (-60.0, 0.0), (-60.0, 12.0)), ("image", (120.0, 0.0), (120.0, -24.0))] {
        let marks = marks(&text, class);
        assert_eq!(marks.len(), 2, "shaft and head: {marks:?}");
        let [foot, tip] = [foot, tip].map(|(x, y)| place(DVec2::new(x, y)));
        assert!(ends(&marks[0])[0].distance(foot) < 0.02, "{:?} is not {foot}", ends(&marks[0]));
        let head = numbers(&marks[1]);
        assert!(DVec2::new(head[0], head[1]).distance(tip) < 0.02, "{head:?} is not {tip}");
        assert_eq!((marks[0]["stroke"].as_str(), marks[1]["fill"].as_str()), ("#008000", "#008000"));
        assert_eq!(marks[0].get("stroke-dasharray"), None);
    }
    assert!(marks(&text, "source").iter().all(|mark| mark["class"] != "source"), "no dot");
}

#[test]
fn a_virtual_image_is_dashed_and_its_rays_are_drawn_back_to_it() {
    let text = scene(LENS, VIRTUAL, "", "extensions: true");
    assert!(marks(&text, "virtual")[0].contains_key("stroke-dasharray"));
    let tip = placed(&text)(DVec2::new(-40.0, 16.0));
    let back = marks(&text, "extension");
    assert_eq!(back.len(), 3, "each once");
    for line in back {
        let [from, to] = ends(&line);
        assert!(to.distance(tip) < 0.03 && from.distance(tip) > 50.0, "{from} {to} {tip}");
    }
    assert_eq!(marks(&scene(LENS, REAL, "", ""), "extension").len(), 0);
    let white = scene(LENS, VIRTUAL, "spectrum: White(samples: 5)", "");
    let ray = &marks(&white, "transmission")[0]["stroke"];
    assert!(marks(&white, "extension").iter().all(|line| line["stroke"] == *ray), "in the color of the light");
}

#[test]
fn words_are_there_where_the_author_names_the_object() {
    let named = |object: &str, diagram: &str| {
        let mut words = words(&scene(LENS, object, r#"name: "candle""#, diagram), "label");
        words.retain(|word| word != "lens");
        words
    };
    assert_eq!(named(REAL, ""), ["candle", "image"]);
    assert_eq!(named(VIRTUAL, ""), ["candle", "virtual image"]);
    assert!(named(REAL, "labels: false").is_empty());
    assert_eq!(words(&scene(LENS, REAL, "", ""), "label"), ["lens"]);
    let two = format!(
        "{LENS}, (label: \"\", shape: Flat(from: (170, -60), to: (170, 60)), surface: ThinLens(focal_length: 30))"
    );
    let all = words(&scene(&two, REAL, r#"name: "candle""#, ""), "label");
    assert!(["candle", "intermediate image", "image"].iter().all(|word| all.iter().any(|one| one == word)), "{all:?}");
}

#[test]
fn at_lenses_and_round_mirrors_an_object_needs_no_normals() {
    for (bodies, marked) in
        [(LENS, false), (MIRROR, false), ("(shape: Flat(from: (0, -30), to: (0, 30)), surface: Mirror)", true)]
    {
        let text = scene(bodies, REAL, "", "");
        assert_eq!(!marks(&text, "normal").is_empty(), marked, "{bodies}");
        assert_eq!(!words(&text, "angle-value").is_empty(), marked, "{bodies}");
    }
}

#[test]
fn axes_come_and_go() {
    let lens = |x: f64, y: f64| {
        format!("(shape: Lens(radii: (40, -40), thickness: 8, diameter: 14), at: ({x:?}, {y:?}), medium: Index(1.5))")
    };
    let count =
        |bodies: &str, diagram: &str| marks(&format!("(bodies: [{bodies}], diagram: ({diagram}))"), "axis").len();
    assert_eq!(count(&lens(0.0, 0.0), ""), 1);
    assert_eq!(count(&lens(0.0, 0.0), "optical_axis: false"), 0);
    let coaxial = [lens(0.0, 0.0), lens(30.0, 0.0), lens(60.0, 0.0), lens(90.0, 0.0), lens(0.0, 20.0)].join(", ");
    assert_eq!(count(&coaxial, ""), 2, "each line once");
    let many = [lens(0.0, 0.0), lens(0.0, 20.0), lens(0.0, 40.0), lens(0.0, 60.0)].join(", ");
    assert_eq!(count(&many, ""), 0);
    assert_eq!(count("(shape: Flat(from: (0, -9), to: (0, 9)), surface: Mirror)", ""), 0);
    assert_eq!((count(MIRROR, ""), count(LENS, ""), count("(shape: Disk(4), medium: Index(1.5))", "")), (1, 1, 0));
}

/// Where two rays at a small height above and below the axis meet behind bodies in a medium.
fn focus(bodies: &str, n: f64, from: f64, degrees: f64) -> DVec2 {
    let beam = format!("Beam(center: ({from:?}, 0), direction: Angle({degrees:?}), width: 0.002, rays: 2)");
    let run = run_text(&format!(
        "(surroundings: Index({n}), bodies: [{bodies}], sources: [(light: {beam})], trace: (secondary_rays: TransmittedOnly))"
    ));
    let [a, b] = [0, 1].map(|k| *run.trace.tree.rays[k].segments.last().unwrap());
    a.from + a.direction * ((b.from - a.from).perp_dot(b.direction) / a.direction.perp_dot(b.direction))
}

#[test]
fn focal_points_stand_where_rays_near_the_axis_meet() {
    for (bodies, n) in [(LENS, 1.0), (THICK, 1.0), (MIRROR, 1.0), (THICK, 1.33)] {
        let text = scene(bodies, REAL, "", "focal_points: true, view: Box((-190, -60), (190, 60))");
        let text = text.replacen('(', &format!("(surroundings: Index({n}), "), 1);
        let dots: Vec<DVec2> = marks(&text, "focal-point").iter().map(middle).collect();
        let place = placed(&text);
        let foci = if bodies == MIRROR {
            vec![focus(MIRROR, n, -90.0, 0.0)]
        } else {
            vec![focus(bodies, n, -90.0, 0.0), focus(bodies, n, 90.0, 180.0)]
        };
        assert_eq!(dots.len(), 2, "{bodies}");
        for focus in foci {
            let there = place(focus);
            assert!(dots.iter().any(|dot| dot.distance(there) < 0.05), "{there} is none of {dots:?}: {bodies}");
        }
    }
    assert_eq!(marks(&scene(LENS, REAL, "", ""), "focal-point").len(), 0);
    let small = scene(LENS, REAL, "", "focal_points: true, view: Box((-70, -20), (30, 20))");
    assert_eq!(words(&small, "cardinal"), ["F"], "F′ is outside of the view");
}

/// The middle of what a path goes through.
fn middle(mark: &Mark) -> DVec2 {
    let parts: Vec<&str> = mark["d"].split(['M', 'A', 'L', 'Z']).filter(|part| !part.trim().is_empty()).collect();
    let points = parts.iter().map(|part| {
        let n: Vec<f64> = part.split([' ', ',']).filter(|n| !n.is_empty()).map(|n| n.parse().unwrap()).collect();
        DVec2::new(n[n.len() - 2], n[n.len() - 1])
    });
    let points: Vec<DVec2> = points.collect();
    let (low, high) = points.iter().fold((points[0], points[0]), |(low, high), p| (low.min(*p), high.max(*p)));
    0.5 * (low + high)
}

#[test]
fn an_auto_view_shows_focal_points_that_are_not_too_far() {
    let lens = |f: f64| format!("(shape: Flat(from: (0, -30), to: (0, 30)), surface: ThinLens(focal_length: {f:?}))");
    let beam = "sources: [(light: Beam(center: (-40, 0), direction: Angle(0), width: 20, rays: 3))]";
    let seen =
        |f: f64| marks(&format!("(bodies: [{}], {beam}, diagram: (focal_points: true))", lens(f)), "focal-point").len();
    assert_eq!((seen(-90.0), seen(-1000.0)), (2, 0));
}

#[test]
fn letters_tell_the_points_apart() {
    let letters =
        |bodies: &str| words(&scene(bodies, REAL, "", "focal_points: true, principal_planes: true"), "cardinal");
    assert_eq!(letters(LENS), ["F", "F′"]);
    assert_eq!(letters(MIRROR), ["F", "C"]);
    assert_eq!(letters(THICK), ["F", "F′", "H", "H′"]);
    let two = format!("{LENS}, (shape: Flat(from: (170, -60), to: (170, 60)), surface: ThinLens(focal_length: 30))");
    assert_eq!(letters(&two), ["F1", "F1′", "F2", "F2′"]);
    let common = "(shape: Flat(from: (70, -60), to: (70, 60)), surface: ThinLens(focal_length: 30))";
    assert_eq!(letters(&format!("{LENS}, {common}")), ["F1", "F1′,\u{a0}F2", "F2′"], "one point with two names");
}

#[test]
fn focal_points_are_named_along_the_light() {
    let text = |object: &str| scene(LENS, object, "", "focal_points: true");
    for (object, front) in [(REAL, -40.0), ("from: (60, 0), to: (60, 12)", 40.0)] {
        let text = text(object);
        let letter = marks(&text, "cardinal").into_iter().find(|mark| mark["words"] == "F").unwrap();
        let at = placed(&text)(DVec2::new(front, 0.0));
        let x: f64 = letter["x"].parse().unwrap();
        assert!((x - at.x).abs() < 20.0, "{x} is not {}", at.x);
    }
}

#[test]
fn principal_planes_stand_where_heights_are_kept() {
    let text = scene(THICK, REAL, "", "principal_planes: true");
    let planes: Vec<f64> = marks(&text, "principal-plane").iter().map(|mark| ends(mark)[0].x).collect();
    // Light parallel to the axis seems to turn at H′, light from the other side at H.
    let place = placed(&text);
    let turn = |from: f64, degrees: f64| {
        let run = run_text(&format!(
            "(bodies: [{THICK}], sources: [(light: Ray(from: ({from:?}, 0.001), direction: Angle({degrees:?})))],
              trace: (secondary_rays: TransmittedOnly))"
        ));
        let out = *run.trace.tree.rays[0].segments.last().unwrap();
        out.from + out.direction * ((0.001 - out.from.y) / out.direction.y)
    };
    let expected = [turn(90.0, 180.0), turn(-90.0, 0.0)].map(|p| place(p).x);
    assert_eq!(planes.len(), 2);
    for (plane, expected) in planes.iter().zip(expected) {
        assert!((plane - expected).abs() < 0.05, "{planes:?} are not {expected:?}");
    }
    assert_eq!(marks(&scene(THICK, REAL, "", ""), "principal-plane").len(), 0);
    assert_eq!(marks(&scene(LENS, REAL, "", "principal_planes: true"), "principal-plane").len(), 0, "thin");
}
