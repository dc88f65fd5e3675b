//! Scenes built in Rust from any values: a list of problems or a whole result.

use glam::DVec2;
use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;
use proptest::sample::select;
use snellius::scene::{
    Body, Direction, Element, Light, Medium, Note, PathStep, Polarization, Problem, RayColor, SecondaryRays, Shape,
    Source, Spectrum, Substance, Surface, Theme, View, facing, render_problems,
};
use snellius::{Scene, compile, trace};

use crate::config;
use crate::hostile::{count, number, point, words};
use crate::trees::use_all;

fn shape() -> impl Strategy<Value = Shape> {
    let x = proptest::array::uniform4(number());
    let p = proptest::array::uniform3(point());
    let lists = (vec(point(), 0..6), vec(element(), 0..4));
    (0..13_u8, x, p, lists, option::of(count())).prop_map(
        |(kind, x, [from, through, to], (points, surfaces), sides)| match kind {
            0 => Shape::Polygon(points),
            1 => Shape::Rectangle { width: x[0], height: x[1] },
            2 => Shape::RegularPolygon { sides: sides.unwrap_or(5), radius: x[0] },
            3 => Shape::Prism { apex_angle: x[0], side: x[1] },
            4 => Shape::RightAnglePrism { leg: x[0] },
            5 => Shape::Disk { radius: x[0] },
            6 => Shape::HalfDisk { radius: x[0] },
            7 => Shape::Lens { radii: [x[0], x[1]], thickness: x[2], diameter: x[3], facets: sides },
            8 => {
                let arc = PathStep::ArcTo { through, to };
                let lines = points.into_iter().map(PathStep::LineTo);
                Shape::Outline { start: from, path: lines.chain([arc]).collect() }
            }
            9 => Shape::LensGroup { diameter: x[0], surfaces },
            10 => Shape::Flat { from, to },
            11 => Shape::Arc { from, through, to },
            _ => Shape::Stop { opening: x[0], height: x[1] },
        },
    )
}

fn medium() -> impl Strategy<Value = Medium> {
    let x = proptest::array::uniform6(number());
    (0..6_u8, x, vec(number(), 0..4), words()).prop_map(|(kind, x, numbers, name)| match kind {
        0 => Medium::Index(x[0]),
        1 => Medium::Speed(x[0]),
        2 => Medium::Cauchy(numbers),
        3 => Medium::Sellmeier { b: [x[0], x[1], x[2]], c: [x[3], x[4], x[5]] },
        4 => Medium::Catalog(name),
        _ => Medium::Index(1.5),
    })
}

fn element() -> impl Strategy<Value = Element> {
    (number(), option::of(number()), option::of(medium()))
        .prop_map(|(radius, thickness, medium)| Element::new(radius, thickness, medium))
}

fn substance() -> impl Strategy<Value = Substance> {
    let surface = (0..5_u8, number(), number()).prop_map(|(kind, x, y)| match kind {
        0 => Surface::Mirror,
        1 => Surface::Absorber,
        2 => Surface::Screen,
        3 => Surface::BeamSplitter { reflect: x, transmit: y },
        _ => Surface::ThinLens { focal_length: x },
    });
    prop_oneof![3 => medium().prop_map(Substance::Medium), 2 => surface.prop_map(Substance::Surface),
        1 => Just(Substance::Elements)]
}

pub(crate) fn body() -> impl Strategy<Value = Body> {
    (shape(), substance(), point(), number(), option::of(words())).prop_map(|(shape, substance, at, rotate, name)| {
        let mut body = Body::new(shape, substance).placed(at, rotate);
        (body.name, body.label, body.color) = (name.clone(), name, Some([255, 0, 9]));
        body
    })
}

fn light() -> impl Strategy<Value = Light> {
    let direction = prop_oneof![number().prop_map(Direction::Angle), point().prop_map(Direction::Towards)];
    (0..5_u8, point(), direction, number(), count()).prop_map(|(kind, from, direction, x, rays)| match kind {
        0 => Light::Ray { from, direction },
        1 => Light::Beam { center: from, direction, width: x, rays },
        2 => Light::Fan { from, direction, spread: x, rays },
        3 => Light::Point { at: from, rays },
        _ => Light::Object { from, to: from + DVec2::new(x, 1.0) },
    })
}

pub(crate) fn source() -> impl Strategy<Value = Source> {
    let spectrum = (0..3_u8, vec(number(), 0..4), count()).prop_map(|(kind, lines, samples)| match kind {
        0 => Spectrum::Line(lines.first().copied().unwrap_or(550.0)),
        1 => Spectrum::Lines(lines),
        _ => Spectrum::White { samples },
    });
    (light(), spectrum, number(), option::of(words())).prop_map(|(light, spectrum, power, name)| {
        let mut source = Source::new(light);
        (source.spectrum, source.power, source.name) = (spectrum, power, name);
        source.polarization = Polarization::S;
        source
    })
}

/// What of a scene is not the light and the bodies.
fn settings() -> impl Strategy<Value = Scene> {
    let diagram = (proptest::array::uniform2(count()), option::of((point(), point())), number(), option::of(number()));
    let trace = (number(), number(), number(), count(), count());
    let theme = select(&[Theme::Light, Theme::Dark, Theme::Print][..]);
    let color = select(&[RayColor::Auto, RayColor::Wavelength, RayColor::Power, RayColor::Via][..]);
    let rest = (words(), point(), any::<[bool; 4]>(), theme, color);
    (diagram, trace, rest, medium()).prop_map(|(diagram, trace, (words, at, switches, theme, color), medium)| {
        let mut scene = Scene::default();
        (scene.title, scene.caption, scene.surroundings) = (words.clone(), words.clone(), medium);
        scene.notes = vec![Note::new(at, words.clone())];
        let (size, view, faintest, wavefronts) = diagram;
        (scene.diagram.size, scene.diagram.faintest, scene.diagram.wavefronts) = (size, faintest, wavefronts);
        scene.diagram.view = view.map_or(View::Auto, |(a, b)| View::Box(a, b));
        (scene.diagram.theme, scene.diagram.color) = (theme, color);
        scene.diagram.deviations = vec![["0.0:".into(), "0.0:t".into()], [words.clone(), words]];
        [scene.diagram.extensions, scene.diagram.protractor, scene.diagram.grid, scene.diagram.scale_bar] = switches;
        (scene.diagram.focal_points, scene.diagram.principal_planes) = (true, true);
        let (kr, kt, min_power, max_depth, max_segments) = trace;
        (scene.trace.min_power, scene.trace.max_depth) = (min_power, max_depth);
        scene.trace.max_segments = u64::from(max_segments);
        scene.trace.secondary_rays = SecondaryRays::Fixed { kr, kt };
        scene
    })
}

/// Any values anywhere.
pub(crate) fn scene() -> impl Strategy<Value = Scene> {
    (settings(), vec(body(), 0..4), vec(source(), 0..3), any::<[bool; 3]>()).prop_map(
        |(mut scene, bodies, sources, sound)| {
            (scene.bodies, scene.sources) = (bodies, sources);
            // Else one bad value among so many would hide what the others do.
            if sound[0] {
                scene.surroundings = Medium::Index(1.0);
            }
            if sound[1] {
                scene.trace = Scene::default().trace;
            }
            if sound[2] {
                scene.diagram = Scene::default().diagram;
            }
            scene
        },
    )
}

proptest! {
    #![proptest_config(config(1500))]

    #[test]
    fn scenes_of_any_values_are_refused_or_traced(mut scene in scene()) {
        scene.trace.max_segments = scene.trace.max_segments.min(2000);
        let problems = scene.validate();
        let _shown = render_problems(&problems, "some\ntext", "file");
        for body in &scene.bodies {
            let _any = body.optical_axis().map(|axis| (axis.along_light(body.at), axis.reversed()));
        }
        let _any = facing(&scene.bodies, DVec2::NAN);
        // What is sound of the scene.
        scene.bodies.retain(|body| sound(|scene| scene.bodies = vec![body.clone()]));
        scene.sources.retain(|source| sound(|scene| scene.sources = vec![source.clone()]));
        if let Ok(compiled) = compile(&scene) {
            let traced = trace(&compiled.system);
            use_all(&scene, &compiled.system, &traced.tree);
        }
    }

    #[test]
    fn problems_point_anywhere(start in count(), end in count(), text in any::<String>(), words in words()) {
        let span = usize::try_from(start).unwrap()..usize::try_from(end).unwrap();
        let problem = Problem::error(words.clone(), words.clone(), words.clone()).label(words.clone()).at(span);
        let _shown = render_problems(&[problem], &text, &words);
    }
}

/// Whether a scene with one change from the empty one has nothing wrong.
fn sound(change: impl FnOnce(&mut Scene)) -> bool {
    let mut scene = Scene::default();
    change(&mut scene);
    scene.validate().is_empty()
}

#[test]
fn a_small_number_takes_no_large_memory() {
    let white = Spectrum::White { samples: u32::MAX };
    assert_eq!(white.lines().take(3).last().map(f64::round), Some(420.0));
    assert_eq!(Spectrum::White { samples: 0 }.lines().count(), 0);

    let mut scene = Scene::default();
    let direction = Direction::Angle(0.0);
    scene.sources.push(Source::new(Light::Beam { center: DVec2::ZERO, direction, width: 1.0, rays: u32::MAX }));
    scene.sources[0].spectrum = white;
    let problems = compile(&scene).unwrap_err();
    for path in ["sources[0].light.rays", "sources[0].spectrum.samples", "sources[0].light"] {
        assert!(problems.list().iter().any(|problem| problem.path == path), "{path}: {problems}");
    }
    let many_sides = Body::new(Shape::RegularPolygon { sides: u32::MAX, radius: 1.0 }, Medium::Index(1.5));
    let problems = compile(&Scene::new(vec![many_sides], vec![])).unwrap_err();
    assert_eq!(problems.list()[0].path, "bodies[0].shape", "{problems}");
}
