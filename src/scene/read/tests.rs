use glam::DVec2;

use crate::scene::*;

fn at(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

fn body(shape: Shape, substance: Substance) -> Body {
    Body { name: None, label: None, color: None, shape, at: DVec2::ZERO, rotate: 0.0, substance }
}

fn source(light: Light) -> Source {
    Source {
        name: None,
        color: None,
        light,
        spectrum: Spectrum::Line(587.5618),
        power: 1.0,
        polarization: Polarization::Unpolarized,
    }
}

fn loaded(text: &str) -> Scene {
    Scene::from_ron(text).unwrap_or_else(|problems| panic!("{problems}"))
}

const PRISM: &str = r#"(
    title: "Total internal reflection in a right-angle prism",
    caption: "Light meets the hypotenuse at 45°. That is past the critical angle of BK7, 41.2°: nothing leaves.",
    bodies: [
        (name: "prism", shape: Polygon([(0, 0), (40, 0), (0, 40)]), medium: Catalog("N-BK7")),
    ],
    sources: [(light: Ray(from: (-30, 10), direction: Angle(0)))],
    diagram: (normals: true, angles: true),
)
"#;

const TOUR: &str = r#"(   // a tour of the vocabulary
    title: "Tour",
    surroundings: Index(1.0),                       // the default
    bodies: [
        (shape: Prism(apex_angle: 60, side: 30), at: (80, 40), rotate: 15, medium: Index(1.5), label: "flint"),
        (shape: Lens(radii: (50, -50), thickness: 6, diameter: 30), at: (140, 0), medium: Catalog("N-BK7")),
        (shape: Flat(from: (200, -20), to: (200, 20)), surface: Screen, name: "wall"),
        (shape: Arc(from: (220, -20), through: (225, 0), to: (220, 20)), surface: Mirror),
    ],
    sources: [
        (name: "lamp", light: Beam(center: (-30, 1), direction: Towards((0, 1)), width: 20, rays: 6), spectrum: Line(632.8)),
        (light: Fan(from: (-30, 3), direction: Angle(0), spread: 30, rays: 8), spectrum: White(samples: 24), power: 2),
    ],
    trace: (secondary_rays: Fresnel, max_depth: 32, min_power: 1e-3),
    notes: [(at: (10, 40), text: "eye")],
)
"#;

#[test]
fn the_first_example_of_the_format() {
    let triangle = Shape::Polygon(vec![at(0.0, 0.0), at(40.0, 0.0), at(0.0, 40.0)]);
    let prism = body(triangle, Substance::Medium(Medium::Catalog("N-BK7".into())));
    let expected = Scene {
        title: "Total internal reflection in a right-angle prism".into(),
        caption: "Light meets the hypotenuse at 45°. That is past the critical angle of BK7, 41.2°: nothing leaves."
            .into(),
        bodies: vec![Body { name: Some("prism".into()), ..prism }],
        sources: vec![source(Light::Ray { from: at(-30.0, 10.0), direction: Direction::Angle(0.0) })],
        diagram: DiagramSettings { normals: true, angles: true, ..DiagramSettings::default() },
        ..Scene::default()
    };
    assert_eq!(loaded(PRISM), expected);
}

fn tour_bodies() -> Vec<Body> {
    let bk7 = || Substance::Medium(Medium::Catalog("N-BK7".into()));
    let prism = body(Shape::Prism { apex_angle: 60.0, side: 30.0 }, Substance::Medium(Medium::Index(1.5)));
    let lens = Shape::Lens { radii: [50.0, -50.0], thickness: 6.0, diameter: 30.0, facets: None };
    let wall = body(Shape::Flat { from: at(200.0, -20.0), to: at(200.0, 20.0) }, Substance::Surface(Surface::Screen));
    let arc = Shape::Arc { from: at(220.0, -20.0), through: at(225.0, 0.0), to: at(220.0, 20.0) };
    vec![
        Body { at: at(80.0, 40.0), rotate: 15.0, label: Some("flint".into()), ..prism },
        Body { at: at(140.0, 0.0), ..body(lens, bk7()) },
        Body { name: Some("wall".into()), ..wall },
        body(arc, Substance::Surface(Surface::Mirror)),
    ]
}

fn tour_sources() -> Vec<Source> {
    let beam =
        Light::Beam { center: at(-30.0, 1.0), direction: Direction::Towards(at(0.0, 1.0)), width: 20.0, rays: 6 };
    let fan = Light::Fan { from: at(-30.0, 3.0), direction: Direction::Angle(0.0), spread: 30.0, rays: 8 };
    vec![
        Source { name: Some("lamp".into()), spectrum: Spectrum::Line(632.8), ..source(beam) },
        Source { spectrum: Spectrum::White { samples: 24 }, power: 2.0, ..source(fan) },
    ]
}

#[test]
fn the_second_example_of_the_format() {
    let expected = Scene {
        title: "Tour".into(),
        bodies: tour_bodies(),
        sources: tour_sources(),
        trace: TraceSettings { max_depth: 32, min_power: 1e-3, ..TraceSettings::default() },
        notes: vec![Note { at: at(10.0, 40.0), text: "eye".into() }],
        ..Scene::default()
    };
    assert_eq!(loaded(TOUR), expected);
}

#[test]
fn every_shape_can_be_written() {
    let shapes =
        |text: &str| loaded(&format!("(bodies: [{text}])")).bodies.into_iter().map(|b| b.shape).collect::<Vec<_>>();
    let text = r"
        (shape: Rectangle(3, 2), surface: Mirror), (shape: RegularPolygon(6, 2), surface: Mirror),
        (shape: RightAnglePrism(5), surface: Mirror), (shape: Disk(4), surface: Mirror),
        (shape: HalfDisk(3,), surface: Mirror), (shape: Stop(opening: 4, height: 10)),
        (shape: Lens(radii: (inf, -50), thickness: 6, diameter: 30, facets: Some(3)), surface: Mirror),
        (shape: Outline(start: (0, 0), path: [LineTo((4, 0)), ArcTo(through: (5, 1), to: (4, 2))]), surface: Mirror),
        (shape: LensGroup(diameter: 20, surfaces: [(radius: 60, thickness: 6, medium: Index(1.5)), (radius: -inf)])),
    ";
    let elements = vec![
        Element { radius: 60.0, thickness: Some(6.0), medium: Some(Medium::Index(1.5)) },
        Element { radius: f64::NEG_INFINITY, thickness: None, medium: None },
    ];
    let path = vec![PathStep::LineTo(at(4.0, 0.0)), PathStep::ArcTo { through: at(5.0, 1.0), to: at(4.0, 2.0) }];
    let expected = vec![
        Shape::Rectangle { width: 3.0, height: 2.0 },
        Shape::RegularPolygon { sides: 6, radius: 2.0 },
        Shape::RightAnglePrism { leg: 5.0 },
        Shape::Disk { radius: 4.0 },
        Shape::HalfDisk { radius: 3.0 },
        Shape::Stop { opening: 4.0, height: 10.0 },
        Shape::Lens { radii: [f64::INFINITY, -50.0], thickness: 6.0, diameter: 30.0, facets: Some(3) },
        Shape::Outline { start: at(0.0, 0.0), path },
        Shape::LensGroup { diameter: 20.0, surfaces: elements },
    ];
    assert_eq!(shapes(text), expected);
}

#[test]
fn a_stop_without_surface_absorbs() {
    let scene = loaded("(bodies: [(shape: Stop(opening: 4, height: 10))])");
    assert_eq!(scene.bodies[0].substance, Substance::Surface(Surface::Absorber));
}

#[test]
fn every_medium_surface_light_and_setting_can_be_written() {
    let scene = loaded(
        r##"(
        surroundings: Sellmeier(b: [1.0, 0.2, 1.0], c: [0.006, 0.02, 103.0]),
        bodies: [
            (shape: Disk(1), medium: Speed(2e8), color: "#f80", name: Some("a"), label: None),
            (shape: Disk(1), medium: Cauchy([1.5, 0.004])),
            (shape: Flat(from: (0, 0), to: (0, 1)), surface: BeamSplitter(reflect: 0.5, transmit: 0.25)),
            (shape: Flat(from: (0, 0), to: (0, 1)), surface: ThinLens(focal_length: -20)),
            (shape: Disk(1), surface: Absorber),
        ],
        sources: [(light: Point(at: (50, 0), rays: 1e1), spectrum: Lines([500, 600]), polarization: S, color: "red")],
        trace: (secondary_rays: Fixed(kr: 0.2, kt: 0.7), max_segments: 1e6),
        diagram: (size: (640, 480), view: Box((0, 0), (4, 3)), theme: Dark, color: Via, faintest: 0.1, grid: true),
    )"##,
    );
    assert_eq!(scene.surroundings, Medium::Sellmeier { b: [1.0, 0.2, 1.0], c: [0.006, 0.02, 103.0] });
    let substances: Vec<Substance> = scene.bodies.iter().map(|body| body.substance.clone()).collect();
    let expected = vec![
        Substance::Medium(Medium::Speed(2e8)),
        Substance::Medium(Medium::Cauchy(vec![1.5, 0.004])),
        Substance::Surface(Surface::BeamSplitter { reflect: 0.5, transmit: 0.25 }),
        Substance::Surface(Surface::ThinLens { focal_length: -20.0 }),
        Substance::Surface(Surface::Absorber),
    ];
    assert_eq!(substances, expected);
    assert_eq!((scene.bodies[0].color, scene.bodies[0].label.as_ref()), (Some([255, 136, 0]), None));
    assert_eq!(scene.sources[0].light, Light::Point { at: at(50.0, 0.0), rays: 10 });
    assert_eq!(scene.sources[0].polarization, Polarization::S);
    assert_eq!(scene.trace.secondary_rays, SecondaryRays::Fixed { kr: 0.2, kt: 0.7 });
    assert_eq!(scene.trace.max_segments, 1_000_000);
    assert_eq!(scene.diagram.view, View::Box(at(0.0, 0.0), at(4.0, 3.0)));
    assert_eq!((scene.diagram.theme, scene.diagram.color), (Theme::Dark, RayColor::Via));
}

#[test]
fn a_mark_at_the_beginning_and_windows_lines_change_nothing() {
    let text = format!("\u{feff}{}", TOUR.replace('\n', "\r\n"));
    assert_eq!(loaded(&text), loaded(TOUR));
}

#[test]
fn every_value_has_its_place() {
    let places = load(TOUR).unwrap().places;
    for (path, written) in [
        ("bodies[1].shape.radii[1]", "-50"),
        ("bodies[3].shape.through", "(225, 0)"),
        ("bodies[0].medium.n", "1.5"),
        ("sources[0].light.direction.point", "(0, 1)"),
        ("sources[1].spectrum.samples", "24"),
        ("trace.secondary_rays", "Fresnel"),
        ("notes[0].text", "\"eye\""),
    ] {
        assert_eq!(places.span(path).map(|span| &TOUR[span]), Some(written), "{path}");
    }
}

#[test]
fn comments_are_no_part_of_a_value() {
    let text = "(bodies: [( // first\n shape: /* ( */ Disk( /* r */ 4 /* mm */ ) // disk\n, medium: Index(1.5))])";
    let places = load(text).unwrap().places;
    assert_eq!(places.span("bodies[0].shape").map(|span| &text[span]), Some("Disk( /* r */ 4 /* mm */ )"));
    assert_eq!(places.span("bodies[0].shape.radius").map(|span| &text[span]), Some("4"));
}
