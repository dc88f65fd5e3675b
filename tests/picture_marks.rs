//! Marks of a figure beyond rays and words: normals, extensions, arrowheads, colors that add up, solid bodies.

#![allow(clippy::unwrap_used, clippy::float_cmp, reason = "a test stops at the first surprise")]

mod support;

use roxmltree::{Document, Node};
use snellius::diagram::draw;
use snellius::drawing::Drawing;
use snellius::render;
use support::run_text;

fn figure(text: &str) -> Drawing {
    let run = run_text(text);
    draw(&run.scene, &run.system, &run.trace.tree)
}

fn svg(text: &str) -> String {
    render::svg(&figure(text))
}

fn of_class<'a, 'b>(document: &'a Document<'b>, class: &str) -> Vec<Node<'a, 'b>> {
    let has = |node: &Node<'_, '_>| node.attribute("class").is_some_and(|all| all.split(' ').any(|one| one == class));
    document.descendants().filter(has).collect()
}

/// All numbers of a path.
fn numbers(node: &Node<'_, '_>) -> Vec<f64> {
    let numbers = node.attribute("d").unwrap().replace(['M', 'L', 'Z'], " ");
    numbers.split_whitespace().map(|number| number.parse().unwrap()).collect()
}

/// The two ends of a straight path.
fn ends(node: &Node<'_, '_>) -> [f64; 4] {
    numbers(node).try_into().unwrap()
}

fn length([x0, y0, x1, y1]: [f64; 4]) -> f64 {
    ((x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0)).sqrt()
}

fn power(node: &Node<'_, '_>) -> f64 {
    node.attribute("data-power").unwrap().parse().unwrap()
}

/// How many normals a slab shows that a ray meets at some degrees from the perpendicular.
fn normals_at(degrees: f64) -> usize {
    let text = svg(&format!(
        r#"(
            bodies: [(shape: Rectangle(20, 40), medium: Index(1.5))],
            sources: [(light: Ray(from: (-30, 0), direction: Angle({degrees:?})))],
            trace: (secondary_rays: TransmittedOnly),
        )"#
    ));
    of_class(&Document::parse(&text).unwrap(), "normal").len()
}

#[test]
fn no_normal_lies_along_its_ray() {
    assert_eq!(normals_at(0.0), 0);
    assert_eq!(normals_at(0.05), 0);
    assert_eq!(normals_at(5.0), 2);
}

/// Extensions of a scene, pixels, and the pixel place of a scene point in a view of 96 × 54.
fn extensions(bodies: &str, sources: &str) -> (Vec<[f64; 4]>, impl Fn(f64, f64) -> [f64; 2] + use<>) {
    let text = svg(&format!(
        r#"(
            bodies: [{bodies}, (name: "mark", shape: Flat(from: (-40, -20), to: (40, 20)), at: (0, 1000), surface: Absorber)],
            sources: [{sources}],
            trace: (secondary_rays: TransmittedOnly),
            diagram: (view: Box((-48, -20), (48, 20)), extensions: true, normals: false),
        )"#
    ));
    let document = Document::parse(&text).unwrap();
    let found = of_class(&document, "extension").iter().map(ends).collect();
    let mark = of_class(&document, "absorber").iter().map(ends).next().unwrap();
    let scale = (mark[2] - mark[0]) / 80.0;
    let (x, y) = (0.5 * (mark[0] + mark[2]), 0.5 * (mark[1] + mark[3]) + 1000.0 * scale);
    (found, move |px, py| [x + px * scale, y - py * scale])
}

fn near(p: &[f64], q: [f64; 2]) -> bool {
    (p[0] - q[0]).abs() < 0.2 && (p[1] - q[1]).abs() < 0.2
}

const MIRROR: &str = "(shape: Flat(from: (0, -18), to: (0, 18)), surface: Mirror)";
const FAN: &str = "(light: Fan(from: (-20, 4), direction: Angle(0), spread: 30, rays: 4))";

#[test]
fn reflected_rays_extend_to_the_image() {
    let (found, place) = extensions(MIRROR, FAN);
    assert_eq!(found.len(), 4);
    for line in &found {
        assert!(near(&line[2..], place(20.0, 4.0)), "{line:?}");
        assert!((line[0] - place(0.0, 0.0)[0]).abs() < 0.2, "from the mirror: {line:?}");
    }
}

#[test]
fn rays_of_several_sources_from_one_point_share_their_image() {
    let lens = "(shape: Flat(from: (0, -18), to: (0, 18)), surface: ThinLens(focal_length: 20))";
    let ray = |to: f64| format!("(light: Ray(from: (-10, 4), direction: Towards((0, {to:?}))))");
    let (found, place) = extensions(lens, &[ray(4.0), ray(0.0), ray(8.0)].join(","));
    assert_eq!(found.len(), 3);
    assert!(found.iter().all(|line| near(&line[2..], place(-20.0, 8.0))), "{found:?}");
}

#[test]
fn a_turned_ray_shows_its_deviation() {
    let prism = "(shape: Prism(apex_angle: 60, side: 30), medium: Index(1.5))";
    let (found, place) = extensions(prism, "(light: Ray(from: (-40, -10), direction: Towards((-7.5, 4.33))))");
    let [forward, back] = found.as_slice() else { panic!("{found:?}") };
    // The incoming ray goes on through the point where the outgoing one seems to start.
    let along = [forward[2] - forward[0], forward[3] - forward[1]];
    let crossing = [back[2] - forward[0], back[3] - forward[1]];
    assert!((along[0] * crossing[1] - along[1] * crossing[0]).abs() < 0.02 * length([0.0, 0.0, along[0], along[1]]));
    assert!(forward[2] > back[2] + 100.0 && near(&forward[..2], place(-7.5, 4.33)));
}

#[test]
fn a_seen_ray_leads_back_beside_its_source() {
    let bodies = r#"(shape: Flat(from: (-20, -6), to: (20, -6)), surface: Mirror),
        (shape: Flat(from: (30, -2), to: (30, 6)), surface: Screen)"#;
    let (found, place) = extensions(bodies, "(light: Ray(from: (-30, 3), direction: Towards((0, -6))))");
    let [line] = found.as_slice() else { panic!("{found:?}") };
    assert!(near(&line[2..], place(-30.0, -15.0)), "{line:?}");
}

#[test]
fn what_is_not_turned_or_gathers_is_not_extended() {
    for (bodies, sources) in [
        ("(shape: Rectangle(10, 30), medium: Index(1.5))", "(light: Ray(from: (-40, 0), direction: Angle(0)))"),
        ("(shape: Disk(5), at: (0, 15), medium: Index(1.5))", "(light: Ray(from: (-40, 0), direction: Angle(0)))"),
        (
            "(shape: Flat(from: (0, -18), to: (0, 18)), surface: ThinLens(focal_length: 20))",
            "(light: Beam(center: (-40, 0), direction: Angle(0), width: 20, rays: 5))",
        ),
    ] {
        assert_eq!(extensions(bodies, sources).0, Vec::<[f64; 4]>::new(), "{bodies}");
    }
    let without = svg(&format!("(bodies: [{MIRROR}], sources: [{FAN}])"));
    assert!(!without.contains("extension"), "off by default");
}

#[test]
fn the_image_of_a_plane_mirror_is_in_view() {
    let far = "(light: Fan(from: (-90, 4), direction: Angle(0), spread: 6, rays: 4))";
    let text = svg(&format!("(bodies: [{MIRROR}], sources: [{far}], diagram: (extensions: true))"));
    let document = Document::parse(&text).unwrap();
    let lines: Vec<_> = of_class(&document, "extension").iter().map(ends).collect();
    assert!(lines.len() == 4 && lines.iter().all(|line| near(&line[2..], [lines[0][2], lines[0][3]])), "{lines:?}");
}

/// White light through a prism.
fn white(theme: &str) -> String {
    format!(
        r#"(
            bodies: [(shape: Prism(apex_angle: 60, side: 60), medium: Catalog("N-SF11"))],
            sources: [(light: Ray(from: (-75, -30.5), direction: Towards((-15, 8.66))), spectrum: White(samples: 60))],
            trace: (secondary_rays: TransmittedOnly),
            diagram: (view: Box((-75, -30), (85, 36)), theme: {theme}, normals: false),
        )"#
    )
}

#[test]
fn on_dark_colors_add_up_to_white() {
    let text = svg(&white("Dark"));
    let document = Document::parse(&text).unwrap();
    let groups = of_class(&document, "spectrum");
    assert_eq!(groups.len(), 2, "in the prism and behind it");
    for group in groups {
        assert_eq!(group.attribute("style"), Some("isolation:isolate"));
        let rays: Vec<_> = group.children().filter(Node::is_element).collect();
        // Behind the prism all are apart, in it neighbors coincide.
        let behind = rays[0].attribute("data-address").is_some_and(|address| address.ends_with(":tt"));
        assert!(if behind { rays.len() == 60 } else { (8..60).contains(&rays.len()) }, "{}", rays.len());
        assert!((rays.iter().map(power).sum::<f64>() - 1.0).abs() < 1e-9, "none is lost");
        assert!(rays.iter().all(|ray| ray.attribute("style") == Some("mix-blend-mode:screen")));
        assert!(rays.iter().all(|ray| ray.attribute("data-address").is_some()));
    }
    assert!(!svg(&white("Light")).contains("mix-blend-mode"));
}

#[test]
fn very_many_lines_add_up_in_shared_paths() {
    let beam = "Beam(center: (-45, -10.5), direction: Towards((-15, 8.66)), width: 6, rays: 40)";
    let scene = white("Dark").replace("Ray(from: (-75, -30.5), direction: Towards((-15, 8.66)))", beam);
    let text = svg(&scene);
    let document = Document::parse(&text).unwrap();
    let groups = of_class(&document, "spectrum");
    assert!(!groups.is_empty() && groups.len() <= 25, "{}", groups.len());
    let rays: Vec<_> = groups.iter().flat_map(|group| group.children().filter(Node::is_element)).collect();
    assert!(rays.iter().all(|ray| ray.attribute("style").is_some() && ray.attribute("data-address").is_none()));
}

#[test]
fn the_png_adds_colors_up_too() {
    let scene = white("Dark");
    let text = svg(&scene);
    let document = Document::parse(&text).unwrap();
    let picture = tiny_skia::Pixmap::decode_png(&render::png(&figure(&scene), 2.0).unwrap()).unwrap();
    let inside = of_class(&document, "spectrum")[0].first_element_child().unwrap();
    let [x0, y0, x1, y1] = ends(&inside);
    // Just behind the entry all lines run within a pixel.
    let (x, y) = (x0 + 0.06 * (x1 - x0), y0 + 0.06 * (y1 - y0));
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a place in the picture")]
    let pixels = (-3..=3).map(|dy| picture.pixel((2.0 * x) as u32, (2.0 * y + f64::from(dy)) as u32).unwrap());
    let whitest = pixels.map(|p| p.red().min(p.green()).min(p.blue())).max().unwrap();
    assert!(whitest > 230, "{whitest}");
}

#[test]
fn on_light_ink_covers_lines_until_they_part() {
    let text = svg(&white("Light"));
    let document = Document::parse(&text).unwrap();
    // Behind the prism they are apart from the beginning.
    let [inside] = of_class(&document, "together").try_into().unwrap();
    assert_eq!(inside.attribute("stroke"), Some("#1f2933"));
    let first = inside.parent().unwrap().first_element_child().unwrap();
    let ([a, b, c, d], [x0, y0, x1, y1]) = (ends(&inside), ends(&first));
    assert!(length([x0, y0, a, b]) < 1.0, "it begins where the light enters");
    let share = length([a, b, c, d]) / length([x0, y0, x1, y1]);
    assert!((0.2..0.8).contains(&share), "{share}");
    assert!(!svg(&white("Dark")).contains("together"));
}

#[test]
fn weak_spectra_stay_weak_however_many_lines_overlap() {
    let text = svg(&white("Dark").replace("trace: (secondary_rays: TransmittedOnly),", ""));
    let document = Document::parse(&text).unwrap();
    let groups = of_class(&document, "spectrum");
    let faint = groups.iter().filter_map(|group| group.attribute("opacity")).map(|o| o.parse::<f64>().unwrap());
    assert!(faint.fold(1.0, f64::min) < 0.7);
}

#[test]
fn an_arrowhead_has_the_color_of_what_the_eye_sees() {
    let arrows = |scene: &str| {
        let text = svg(scene);
        let document = Document::parse(&text).unwrap();
        let fills = of_class(&document, "arrow").into_iter().map(|a| a.attribute("fill").unwrap().to_owned());
        fills.collect::<Vec<_>>()
    };
    // Weakest first: the fan behind the prism is wide open, the light before it is one line.
    let found = arrows(&white("Dark"));
    assert!(found.contains(&"#ffffff".to_owned()) && found.iter().any(|fill| fill != "#ffffff"), "{found:?}");
}

#[test]
fn light_that_runs_back_has_its_arrowhead_elsewhere() {
    let text = svg(r#"(
            bodies: [(shape: Flat(from: (0, -18), to: (0, 18)), surface: Mirror)],
            sources: [(light: Ray(from: (-60, 0), direction: Angle(0)))],
        )"#);
    let document = Document::parse(&text).unwrap();
    let tips: Vec<f64> = of_class(&document, "arrow").iter().map(|arrow| numbers(arrow)[0]).collect();
    assert!(tips.len() == 2 && (tips[0] - tips[1]).abs() >= 40.0, "{tips:?}");
}

#[test]
fn what_light_cannot_get_into_looks_solid() {
    let solid = |surface: &str, from: &str| {
        let text = svg(&format!(
            "(bodies: [(shape: Disk(10), surface: {surface})], sources: [(light: Ray(from: {from}, direction: Angle(3)))])"
        ));
        of_class(&Document::parse(&text).unwrap(), "opaque").len()
    };
    for surface in ["Absorber", "Screen", "Mirror"] {
        assert_eq!((solid(surface, "(-30, 1)"), solid(surface, "(1, 1)")), (1, 0), "{surface}");
    }
}

/// Words of the labels of a scene and their middles.
fn labels(bodies: &str) -> Vec<(String, [f64; 2])> {
    let text = svg(&format!("(bodies: [{bodies}])"));
    let document = Document::parse(&text).unwrap();
    let place = |node: &Node<'_, '_>, name| node.attribute(name).unwrap().parse().unwrap();
    let nodes = of_class(&document, "label");
    nodes.iter().map(|node| (node.text().unwrap().to_owned(), [place(node, "x"), place(node, "y")])).collect()
}

#[test]
fn an_empty_label_silences_a_name() {
    let found = labels(
        r#"(name: "a", shape: Disk(5), medium: Index(1.5)), (name: "b", label: "", shape: Disk(5), at: (20, 0), medium: Index(1.5))"#,
    );
    assert_eq!(found.iter().map(|(words, _)| words.as_str()).collect::<Vec<_>>(), ["a"]);
}

#[test]
fn a_medium_is_told_with_its_index_at_one_wavelength() {
    let words = |body: &str, spectrum: &str| {
        let source = format!("(light: Ray(from: (-9, 30), direction: Angle(0)), spectrum: {spectrum})");
        let text = svg(&format!("(bodies: [({body}, shape: Rectangle(60, 40))], sources: [{source}])"));
        let document = Document::parse(&text).unwrap();
        of_class(&document, "label").first().map(|node| node.text().unwrap().replace('\u{a0}', " "))
    };
    let words = |body: &str, spectrum: &str| words(body, spectrum).unwrap_or_default();
    let bk7 = "label: \"glass\", medium: Catalog(\"N-BK7\")";
    assert_eq!(words(bk7, "Line(587.5618)"), "glass, n = 1.517");
    assert_eq!(words(bk7, "Line(486.1327)"), "glass, n = 1.522");
    assert_eq!(words(bk7, "Lines([486.1327, 587.5618])"), "glass");
    assert_eq!(words("medium: Index(1.5)", "Line(587.5618)"), "n = 1.5");
    assert_eq!(words("label: \"n = 3/2\", medium: Index(1.5)", "Line(587.5618)"), "n = 3/2");
    assert_eq!(words("label: \"air\", medium: Index(1)", "Line(587.5618)"), "air");
    assert_eq!(words("label: \"\", medium: Index(1.5)", "Line(587.5618)"), "");
}

#[test]
fn a_label_stands_nearer_to_its_body_than_to_another() {
    let bar = |name: &str, y: f64| {
        format!(r#"(name: "{name}", shape: Flat(from: (-10, {y:?}), to: (10, {y:?})), surface: Mirror)"#)
    };
    let found = labels(&[bar("upper", 2.0), bar("lower", 0.0), bar("foot", -9.0)].join(","));
    let [(_, upper), (_, lower), _] = found.as_slice() else { panic!("{found:?}") };
    assert!(upper[1] < lower[1], "{found:?}");
}

#[test]
fn white_light_is_extended_in_ink() {
    let text = "(
        bodies: [(shape: Flat(from: (0, -20), to: (0, 20)), surface: ThinLens(focal_length: -40))],
        sources: [(light: Beam(center: (-60, 0), direction: Angle(0), width: 20, rays: 3), spectrum: White(samples: 5))],
        diagram: (extensions: true),
    )";
    let svg = svg(text);
    let document = Document::parse(&svg).unwrap();
    let ray = of_class(&document, "ray")[0].attribute("stroke").unwrap().to_owned();
    let extensions = of_class(&document, "extension");
    assert_eq!(extensions.len(), 3);
    assert!(extensions.iter().all(|extension| extension.attribute("stroke") == Some(ray.as_str())));
}

#[test]
fn a_disk_smaller_than_the_rounding_of_its_place_is_drawn_somehow() {
    for radius in ["1", "3.3", "1e-8"] {
        for place in ["(1e16, 0)", "(1e16, -3e15)"] {
            let disk = format!("(shape: Disk({radius}), at: {place}, rotate: 30, medium: Index(1.5))");
            let svg = svg(&format!("(bodies: [{disk}, (shape: Disk(2), medium: Index(1.5))])"));
            assert!(Document::parse(&svg).is_ok() && !svg.contains("NaN"));
        }
    }
}

#[test]
fn sources_have_symbols_where_their_rays_start() {
    let source = |light: &str| {
        let drawing = figure(&format!("(sources: [(light: {light})], diagram: (view: Box((-40, -20), (40, 20))))"));
        let layer = drawing.items.iter().find_map(|item| match item {
            snellius::drawing::Item::Group(group) if group.class == "sources" => Some(group.items.clone()),
            _ => None,
        });
        let shapes = layer.unwrap_or_default();
        let filled = |item: &snellius::drawing::Item| match item {
            snellius::drawing::Item::Shape(shape) => shape.fill.is_some(),
            _ => panic!("{item:?}"),
        };
        shapes.iter().map(filled).collect::<Vec<_>>()
    };
    let (dot, bar) = (vec![true], vec![false]);
    assert_eq!(source("Ray(from: (0, 0), direction: Angle(10))"), dot);
    assert_eq!(source("Fan(from: (0, 0), direction: Angle(10), spread: 20, rays: 3)"), dot);
    assert_eq!(source("Beam(center: (0, 0), direction: Angle(10), width: 9, rays: 3)"), bar);
    assert_eq!(source("Ray(from: (-90, 0), direction: Angle(0))"), [false; 0], "not in view");
}

/// Light that leaves a tank through two of its faces has no common image.
#[test]
fn rays_through_different_faces_are_not_drawn_back_to_one_point() {
    let lines = |light: &str| {
        let water = "(shape: Rectangle(40, 40), medium: Index(1.333))";
        let text = format!(
            "(bodies: [{water}], sources: [(light: {light})], trace: (secondary_rays: TransmittedOnly),
            diagram: (extensions: true))"
        );
        svg(&text).matches("class=\"extension\"").count()
    };
    let through_the_top = lines("Fan(from: (0, 10), direction: Angle(90), spread: 20, rays: 2)");
    assert_eq!(through_the_top, 2, "both to the image");
    // One ray through the top, one through the side, each less than critical there.
    let run = run_text(
        "(bodies: [(shape: Rectangle(40, 40), medium: Index(1.333))], trace: (secondary_rays: TransmittedOnly),
        sources: [(light: Fan(from: (10, 10), direction: Angle(45), spread: 80, rays: 2))], diagram: (extensions: true))",
    );
    let hits: Vec<_> = run.trace.tree.rays.iter().map(|ray| ray.segments[0].hit.unwrap().normal).collect();
    assert!(hits[0].dot(hits[1]).abs() < 1e-9, "two faces");
    let meeting: Vec<String> = {
        let document = render::svg(&draw(&run.scene, &run.system, &run.trace.tree));
        let document = Document::parse(&document).unwrap();
        let is_it = |node: &Node<'_, '_>| node.attribute("class") == Some("extension");
        document.descendants().filter(is_it).map(|node| node.attribute("d").unwrap().to_owned()).collect()
    };
    let ends: Vec<&str> = meeting.iter().map(|d| d.rsplit('L').next().unwrap()).collect();
    let distinct: std::collections::BTreeSet<_> = ends.iter().collect();
    assert_eq!(distinct.len(), ends.len(), "no common end: {meeting:?}");
}
