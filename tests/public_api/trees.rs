//! Ray trees of other scenes, and trees edited to nonsense.

use std::sync::LazyLock;

use glam::DVec2;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use snellius::analysis::{
    Axis, Bundle, images, irradiance, least_deviation, object_images, paraxial, paraxial_of, turning_degrees,
};
use snellius::diagram::{Margins, draw, draw_counted, draw_within, margins, problems};
use snellius::explain::{Part, brightest, explain, find, latex, markdown, text};
use snellius::light::{Power, Wavelength};
use snellius::scene::{Body, Direction, Light, Medium, Shape, Source, View};
use snellius::trace::{Crossing, Ray, Search};
use snellius::{
    Ending, OpticalSystem, RayTree, Scene, Segment, SegmentId, Summary, Trace, TracedRay, Via, Visitor, analysis,
    compile, render, report, retrace, summarize, trace, visit,
};

use crate::config;
use crate::drawings::check_svg;
use crate::hostile::{count, number, point, words};

const ALL: &str = "diagram: (size: (640, 400), deviations: [(\"0.0:\", \"0.0:t\"), (\"0.1:\", \"0.1:tt\")],
    extensions: true, protractor: true, wavefronts: 5, focal_points: true, principal_planes: true, grid: true,
    scale_bar: true)";

/// One scene for each part of the library that reads trees in its own way.
const SCENES: [&str; 6] = [
    "(bodies: [(shape: Prism(apex_angle: 60, side: 30), medium: Catalog(\"N-BK7\"))],
      sources: [(light: Ray(from: (-30, -4), direction: Angle(15)), spectrum: White(samples: 5)),
                (light: Fan(from: (-30, 3), direction: Angle(0), spread: 4, rays: 3))], ALL)",
    "(bodies: [(shape: Lens(radii: (50, -50), thickness: 6, diameter: 30), medium: Index(1.5), name: \"lens\"),
               (shape: Flat(from: (90, -30), to: (90, 30)), surface: Screen, name: \"wall\")],
      sources: [(light: Object(from: (-100, 0), to: (-100, 8)), name: \"arrow\"),
                (light: Beam(center: (-20, 0), direction: Angle(0), width: 20, rays: 40), spectrum: Lines([480, 650]))],
      ALL)",
    "(bodies: [(shape: Rectangle(40, 30), surface: Mirror)],
      sources: [(light: Ray(from: (1, 2), direction: Angle(31)))], trace: (max_depth: 60), ALL)",
    "(bodies: [(shape: Flat(from: (0, -20), to: (0, 20)), surface: ThinLens(focal_length: 30)),
               (shape: Arc(from: (60, -20), through: (66, 0), to: (60, 20)), surface: Mirror),
               (shape: Disk(4), at: (30, 0), surface: Screen),
               (shape: Flat(from: (10, -20), to: (20, 20)), surface: BeamSplitter(reflect: 0.5, transmit: 0.4))],
      sources: [(light: Point(at: (-40, 1), rays: 30)), (light: Object(from: (-50, 0), to: (-50, 5)))], ALL)",
    "(bodies: [(shape: HalfDisk(20), medium: Index(1.5), rotate: -90), (shape: Stop(opening: 4, height: 30), at: (0, 30))],
      sources: [(light: Fan(from: (0, -30), direction: Angle(90), spread: 70, rays: 9))],
      trace: (secondary_rays: Fixed(kr: 0.3, kt: 0.5), max_segments: 20), ALL)",
    "(ALL)",
];

struct Made {
    scene: Scene,
    system: OpticalSystem,
    trace: Trace,
}

static MADE: LazyLock<Vec<Made>> = LazyLock::new(|| {
    let made = SCENES.map(|text| {
        let scene = Scene::from_ron(&text.replace("ALL", ALL)).unwrap_or_else(|problems| panic!("{problems}"));
        let system = compile(&scene).unwrap().system;
        Made { trace: trace(&system), scene, system }
    });
    made.into()
});

/// Everything that takes a scene, a system or a tree, with these three.
pub(crate) fn use_all(scene: &Scene, system: &OpticalSystem, tree: &RayTree) {
    check_svg(&render::svg(&draw(scene, system, tree)));
    let _any = (draw_counted(scene, system, tree), margins(scene, system, tree), problems(scene, tree));
    let _any = (analysis::problems(scene, system, Some(tree)), analysis::unmet_bodies(system, Some(tree)));
    let traced = with_tree(tree);
    read_back(&report::json(system, &traced));
    read_back(&report::summary_json(system, &traced.summary));
    let _any = (report::text(system, &traced), report::csv(system, tree));
    explain_all(scene, system, tree);
    analyze_all(system, tree);
}

fn read_back(json: &str) {
    serde_json::from_str::<serde_json::Value>(json).unwrap();
}

fn with_tree(tree: &RayTree) -> Trace {
    let mut traced = Trace::default();
    for ray in &tree.rays {
        ray.segments.iter().for_each(|segment| traced.summary.segment(ray, *segment));
    }
    traced.tree = tree.clone();
    traced
}

fn explain_all(scene: &Scene, system: &OpticalSystem, tree: &RayTree) {
    for (ray, end) in brightest(tree).into_iter().take(3) {
        let address = ray.address(end);
        let _any = find(tree, &address).map(|(ray, id)| ray.address(id));
        let explained = explain(scene, system, ray, end);
        for explanation in explained.iter().filter(|explained| explained.steps.len() < 20) {
            let _any = (explanation.address_behind(usize::MAX), explanation.deviation_degrees(DVec2::NAN));
        }
        let all = explained.as_slice();
        let _any = (text(all, Part::Worked), markdown(all, Part::Key), latex(all, Part::Worksheet));
    }
    for ray in tree.rays.iter().take(4) {
        for id in [0, 1, 7, u32::MAX].map(SegmentId) {
            let _any = (ray.address(id), turning_degrees(ray, id), explain(scene, system, ray, id));
        }
    }
}

fn analyze_all(system: &OpticalSystem, tree: &RayTree) {
    for source in [0, 1, usize::MAX] {
        let bundle = Bundle::of(tree, source, "t");
        let _any = (bundle.focus(), bundle.least_confusion(), bundle.marginal().direction(), images(tree, source));
    }
    for screen in irradiance(system, tree) {
        let _any: Vec<_> = screen.curves.iter().flat_map(|curve| screen.parts(curve)).collect();
    }
    let _any = object_images(system, tree);
}

/// One nonsense for one segment.
#[derive(Clone, Debug)]
struct Edit {
    ray: Index,
    segment: Index,
    kind: u8,
    number: u32,
    x: f64,
    p: DVec2,
}

fn edits() -> impl Strategy<Value = Vec<Edit>> {
    let places = (any::<Index>(), any::<Index>());
    let edit = (places, 0..18_u8, count(), number(), point());
    vec(edit.prop_map(|((ray, segment), kind, number, x, p)| Edit { ray, segment, kind, number, x, p }), 1..12)
}

fn edit(tree: &mut RayTree, edit: &Edit) {
    if tree.rays.is_empty() {
        return;
    }
    let ray = edit.ray.get(&tree.rays).clone();
    let ray = tree.rays.iter_mut().find(|one| (one.source, one.ray) == (ray.source, ray.ray)).unwrap();
    let far = usize::try_from(edit.number).unwrap();
    let far = if far > 100 { usize::MAX } else { far };
    match edit.kind {
        0 => ray.source = far,
        1 => ray.ray = far,
        2 => ray.power = edit.x,
        3 => ray.wavelength = Wavelength::from_nanometers(edit.x).unwrap_or(Wavelength::D),
        4 => ray.segments.clear(),
        5 => ray.segments.reverse(),
        6 => ray.segments.extend_from_within(..),
        _ if ray.segments.is_empty() => {}
        kind => {
            let place = edit.segment.index(ray.segments.len());
            edit_segment(&mut ray.segments[place], kind, far, edit);
        }
    }
}

fn edit_segment(segment: &mut Segment, kind: u8, far: usize, Edit { number, x, p, .. }: &Edit) {
    match kind {
        7 => segment.parent = Some(SegmentId(*number)),
        8 => segment.parent = Some(segment.id),
        9 => segment.id = SegmentId(*number),
        10 => segment.via = if *x > 0.0 { Via::Source } else { Via::TotalInternalReflection },
        11 => (segment.from, segment.direction) = (*p, *p),
        12 => segment.to = (*x > 0.0).then_some(*p),
        13 => (segment.power, segment.medium_index, segment.optical_path) = (Power { s: p.x, p: p.y }, *x, *x),
        14 => segment.hit = None,
        15 => segment.ending = if *x > 0.0 { Ending::Detected } else { Ending::Escaped },
        _ => {
            if let Some(hit) = &mut segment.hit {
                (hit.body, hit.normal, hit.position) = (far, *p, Some(*x));
                (hit.n_i, hit.n_t, hit.cos_i, hit.sin_t) = (p.x, (*x > 0.0).then_some(p.y), *x, Some(p.y));
            }
        }
    }
}

fn which() -> impl Strategy<Value = usize> {
    0..SCENES.len()
}

proptest! {
    #![proptest_config(config(120))]

    #[test]
    fn results_of_different_scenes_do_no_harm(a in which(), b in which(), c in which()) {
        use_all(&MADE[a].scene, &MADE[b].system, &MADE[c].trace.tree);
    }

    #[test]
    fn trees_edited_to_nonsense_do_no_harm(a in which(), b in which(), edits in edits()) {
        let mut tree = MADE[a].trace.tree.clone();
        edits.iter().for_each(|one| edit(&mut tree, one));
        use_all(&MADE[b].scene, &MADE[a].system, &tree);
    }

    #[test]
    fn a_figure_of_any_settings(a in which(), settings in crate::scenes::scene()) {
        let (Made { system, trace, .. }, mut scene) = (&MADE[a], settings);
        use_all(&scene, system, &trace.tree);
        scene.diagram.size = [900, 500];
        let _any = draw(&scene, system, &trace.tree);
    }

    #[test]
    fn figures_have_any_margins(a in which(), top in number(), foot in number()) {
        let Made { scene, system, trace } = &MADE[a];
        let mut margins = Margins::default();
        (margins.top, margins.foot) = (top, foot);
        check_svg(&render::svg(&draw_within(scene, system, &trace.tree, margins.max(Margins::default())).0));
        check_svg(&render::svg(&draw_within(scene, system, &trace.tree, margins).0));
    }

    #[test]
    fn addresses_of_any_form(
        a in which(),
        address in prop_oneof![".{0,100}", words(), "[0-2][.][0-9]@?[0-9e.]*:[tri]*", "[0-9]{0,4}[θ₁]{60}@?[0-9]*:?"],
    ) {
        let _found = find(&MADE[a].trace.tree, &address);
        let _bundle = Bundle::of(&MADE[a].trace.tree, 0, &address).focus();
    }

    #[test]
    fn axes_and_lines_of_any_numbers(a in which(), from in point(), direction in point(), at in crate::hostile::wavelength()) {
        let Made { system, .. } = &MADE[a];
        let axis = Axis { from, direction };
        let _any = (paraxial(system, axis, at), paraxial_of(system, &[0, usize::MAX], axis, at));
        let _any = least_deviation(system, 0, "tt", at);
        let foreign = MADE[1].system.interfaces()[0].left;
        let _any = MADE.iter().map(|made| made.system.index(foreign, at)).sum::<f64>();
    }

    #[test]
    fn rays_from_anywhere_meet_something_or_nothing(a in which(), b in which(), from in point(), direction in point()) {
        let Made { system, .. } = &MADE[a];
        let mut search = Search::new(system);
        for start in MADE[b].system.sources().iter().flat_map(|source| &source.starts) {
            for on in [start.start, snellius::system::Start::On { interface: usize::MAX, left: true }] {
                let ray = Ray { from, direction, medium: start.medium, start: on };
                if let Some(Crossing { interface, .. }) = search.nearest(&ray) {
                    prop_assert!(interface < system.interfaces().len());
                }
            }
        }
    }
}

#[test]
fn an_index_of_another_system_is_none() {
    let many = &MADE[0].system;
    let glass = many.interfaces().iter().map(|one| one.left.max(one.right)).max().unwrap();
    assert!(many.index(glass, Wavelength::D) > 1.5);
    assert!(MADE[5].system.index(glass, Wavelength::D).is_nan());
}

#[test]
fn a_trace_of_another_scene_lends_its_memory_only() {
    for made in MADE.iter() {
        let mut traced = MADE[1].trace.clone();
        retrace(&made.system, &mut traced);
        assert_eq!(traced, made.trace);
        let mut nonsense = Trace::default();
        nonsense.summary.rays = u64::MAX;
        retrace(&made.system, &mut nonsense);
        assert_eq!(nonsense, made.trace);
    }
}

#[test]
fn counters_at_their_end_stay_there() {
    let ray: &TracedRay = &MADE[0].trace.tree.rays[0];
    let mut summary = Summary::default();
    (summary.rays, summary.segments) = (u64::MAX, u64::MAX);
    summary.segment(ray, ray.segments[0]);
    assert_eq!((summary.rays, summary.segments), (u64::MAX, u64::MAX));
}

#[test]
fn a_visitor_that_panics_harms_no_one_else() {
    struct Panics;
    impl Visitor for Panics {
        fn segment(&mut self, _: &TracedRay, _: Segment) {
            std::panic::resume_unwind(Box::new("enough"));
        }
    }
    let Made { system, trace: traced, .. } = &MADE[0];
    std::panic::catch_unwind(|| visit(system, &mut Panics)).unwrap_err();
    let progress = |_| std::panic::resume_unwind(Box::new("enough"));
    std::panic::catch_unwind(|| snellius::trace::summarize_watched(system, &progress)).unwrap_err();
    assert_eq!(summarize(system), traced.summary);
    assert_eq!(trace(system), *traced);
}

/// Places in the figure overflow, or their squares do.
#[test]
fn a_view_too_small_for_numbers_is_drawn_at_once() {
    let mut scene = Scene::new(
        vec![Body::new(Shape::Disk { radius: 20.0 }, Medium::Index(1.5))],
        vec![Source::new(Light::Ray { from: DVec2::new(-30.0, 10.0), direction: Direction::Angle(0.0) })],
    );
    for size in [1e-30, 1e-150, 1e-160, 1e-290, 1e-300, 1e-310] {
        scene.diagram.view = View::Box(DVec2::ZERO, DVec2::splat(size));
        let system = compile(&scene).unwrap().system;
        use_all(&scene, &system, &trace(&system).tree);
    }
}

/// A mirror room: every hit has one branch, and paths are as long as the light lasts.
#[test]
fn very_long_paths_are_told_in_little_room() {
    let mut scene = MADE[2].scene.clone();
    (scene.trace.max_depth, scene.trace.max_segments) = (200_000, 100_000);
    let system = compile(&scene).unwrap().system;
    let traced = trace(&system);
    let segments = traced.tree.rays[0].segments.len();
    assert!(segments > 100_000);
    assert!(report::text(&system, &traced).len() < 1000 * segments);
}
