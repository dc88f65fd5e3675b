use glam::DVec2;

use crate::compile::compile;
use crate::geometry::Curve;
use crate::scene::{Body, Direction, Light, Medium, Polarization, Scene, Shape, Source, Spectrum, Substance, Surface};
use crate::system::Start;
use crate::trace::{Ending, Ray, Search, Trace, Via, retrace, trace};

fn body(shape: Shape, substance: Substance) -> Body {
    Body { name: None, label: None, color: None, shape, at: DVec2::ZERO, rotate: 0.0, substance }
}

fn glass(shape: Shape) -> Body {
    body(shape, Substance::Medium(Medium::Index(1.5)))
}

fn ray(from: (f64, f64), angle: f64) -> Source {
    Source {
        name: None,
        color: None,
        light: Light::Ray { from: from.into(), direction: Direction::Angle(angle) },
        spectrum: Spectrum::Line(587.5618),
        power: 1.0,
        polarization: Polarization::Unpolarized,
    }
}

fn traced(bodies: Vec<Body>, source: Source) -> Trace {
    let scene = Scene { bodies, sources: vec![source], ..Scene::default() };
    let trace = trace(&compile(&scene).unwrap().system);
    assert!(trace.summary.balance.residual().abs() < 1e-15);
    trace
}

/// The addresses of followed segments' paths.
fn paths(trace: &Trace) -> Vec<String> {
    let ray = &trace.tree.rays[0];
    ray.segments.iter().map(|segment| ray.address(segment.id)).collect()
}

#[test]
fn a_right_angle_prism_turns_light_by_total_internal_reflection() {
    let points = [(0.0, 0.0), (40.0, 0.0), (0.0, 40.0)].map(DVec2::from).to_vec();
    let trace = traced(vec![glass(Shape::Polygon(points))], ray((-30.0, 10.0), 0.0));
    let segments = &trace.tree.rays[0].segments;
    assert_eq!(paths(&trace)[..3], ["0.0:", "0.0:t", "0.0:ti"]);
    assert_eq!(segments[1].to, Some(DVec2::new(30.0, 10.0)));
    let hit = segments[1].hit.unwrap();
    assert!((hit.theta_i_degrees() - 45.0).abs() < 1e-13 && hit.theta_t_degrees().is_none());
    assert_eq!(segments[2].via, Via::TotalInternalReflection);
    assert!((segments[2].direction - DVec2::NEG_Y).length() < 1e-15);
}

#[test]
fn a_ray_through_the_center_of_a_disk_goes_straight() {
    let trace = traced(vec![glass(Shape::Disk { radius: 2.0 })], ray((-5.0, 0.0), 0.0));
    let segments = &trace.tree.rays[0].segments;
    assert_eq!(segments[0].to, Some(DVec2::new(-2.0, 0.0)));
    assert_eq!(segments[1].to, Some(DVec2::new(2.0, 0.0)));
    assert_eq!(segments[2].ending, Ending::Escaped);
    assert_eq!(segments[2].optical_path, 3.0 + 6.0);
}

#[test]
fn the_later_of_two_overlapping_bodies_fills_the_overlap() {
    let first = glass(Shape::Rectangle { width: 4.0, height: 4.0 });
    let second = Body { at: DVec2::new(2.0, 0.0), substance: Substance::Medium(Medium::Index(2.0)), ..first.clone() };
    let trace = traced(vec![first, second], ray((-5.0, 0.5), 0.0));
    let ends: Vec<_> =
        trace.tree.rays[0].segments.iter().take(4).map(|s| (s.medium_index, s.to.map(|p| p.x))).collect();
    assert_eq!(ends, [(1.0, Some(-2.0)), (1.5, Some(0.0)), (2.0, Some(4.0)), (1.0, None)]);
}

#[test]
fn cemented_faces_are_one_boundary_and_equal_media_none() {
    let first = glass(Shape::Rectangle { width: 4.0, height: 4.0 });
    let second = Body { at: DVec2::new(4.0, 0.0), rotate: 90.0, ..first.clone() };
    let scene = Scene { bodies: vec![first, second], ..Scene::default() };
    let system = compile(&scene).unwrap().system;
    assert_eq!(system.dropped_boundaries(), 1);
    assert_eq!(system.interfaces().len(), 6);
}

#[test]
fn a_mirror_laid_on_a_face_silvers_the_stretch_that_it_covers() {
    let mirror = Shape::Flat { from: DVec2::new(2.0, -1.0), to: DVec2::new(2.0, 1.0) };
    let bodies =
        vec![glass(Shape::Rectangle { width: 4.0, height: 4.0 }), body(mirror, Substance::Surface(Surface::Mirror))];
    let on_mirror = traced(bodies.clone(), ray((-5.0, 0.0), 0.0));
    let hit = on_mirror.tree.rays[0].segments[1].hit.unwrap();
    assert_eq!((hit.body, hit.reflectance.s, hit.n_t), (1, 1.0, None));
    let beside = traced(bodies, ray((-5.0, 1.5), 0.0));
    let hit = beside.tree.rays[0].segments[1].hit.unwrap();
    assert_eq!((hit.body, hit.n_t), (0, Some(1.0)));
}

#[test]
fn light_in_a_closed_mirror_box_ends_by_depth() {
    let walls = body(Shape::Rectangle { width: 4.0, height: 3.0 }, Substance::Surface(Surface::Mirror));
    let trace = traced(vec![walls], ray((0.1, 0.2), 33.0));
    let segments = &trace.tree.rays[0].segments;
    assert_eq!(segments.len(), 33);
    assert_eq!(segments[32].ending, Ending::CutMaxDepth);
    assert!(segments.iter().all(|s| s.from.x.abs() <= 2.0 && s.from.y.abs() <= 1.5));
}

#[test]
fn a_start_on_a_face_belongs_to_the_side_it_heads_into() {
    let square = || vec![glass(Shape::Rectangle { width: 4.0, height: 4.0 })];
    for (from, angle, index) in [
        ((-2.0, 0.0), 0.0, 1.5),
        ((-2.0, 0.0), 180.0, 1.0),
        ((-2.0, 0.0), 90.0, 1.0),
        ((-2.0, 0.0), -90.0, 1.5),
        ((-2.0, -2.0), 45.0, 1.5),
        ((-2.0, -2.0), 225.0, 1.0),
        ((-2.0, -2.0), 0.0, 1.5),
        ((-2.0, -2.0), 90.0, 1.0),
    ] {
        let trace = traced(square(), ray(from, angle));
        let first = trace.tree.rays[0].segments[0];
        assert_eq!(first.medium_index, index, "from {from:?} at {angle}°");
        assert!(first.to.is_none_or(|to| to.distance(first.from) > 1.0), "from {from:?} at {angle}°");
    }
}

#[test]
fn both_halves_of_a_half_disk_meet_at_their_seams_without_a_leak() {
    let half = || vec![glass(Shape::HalfDisk { radius: 1.0 })];
    for k in 0..720 {
        let angle = 0.5 * f64::from(k) + 0.03;
        let trace = traced(half(), ray((0.3, 0.1), angle));
        for segment in &trace.tree.rays[0].segments {
            let escaped_from_glass = segment.ending == Ending::Escaped && segment.medium_index != 1.0;
            assert!(!escaped_from_glass, "leak at {angle}°: {segment:?}");
        }
    }
}

#[test]
fn a_silvered_ball_returns_the_ray_through_the_seam_of_its_silver() {
    let [top, right, bottom] = [(0.0, 20.0), (20.0, 0.0), (0.0, -20.0)].map(DVec2::from);
    for (from, to) in [(top, bottom), (bottom, top)] {
        let silver = Shape::Arc { from, through: right, to };
        let bodies = vec![glass(Shape::Disk { radius: 20.0 }), body(silver, Substance::Surface(Surface::Mirror))];
        let trace = traced(bodies, ray((-70.0, 0.0), 0.0));
        assert_eq!(paths(&trace)[..4], ["0.0:", "0.0:t", "0.0:tr", "0.0:trt"]);
        assert_eq!(trace.tree.rays[0].segments[3].direction, DVec2::NEG_X);
    }
}

#[test]
fn light_that_touches_a_mirror_goes_on() {
    let disk = || vec![body(Shape::Disk { radius: 10.0 }, Substance::Surface(Surface::Mirror))];
    for (from, angle) in [
        ((-40.0, 10.0), 0.0),
        ((-40.0, -10.0), 0.0),
        ((40.0, 10.0), 180.0),
        ((10.0, -40.0), 90.0),
        ((-10.0, -40.0), 90.0),
        ((10.0, 40.0), -90.0),
    ] {
        let trace = traced(disk(), ray(from, angle));
        let last = trace.tree.rays[0].segments.last().unwrap();
        assert_eq!((last.ending, last.direction), (Ending::Escaped, trace.tree.rays[0].segments[0].direction));
        assert!(trace.tree.rays[0].segments.len() <= 2, "from {from:?} at {angle}°");
    }
}

#[test]
fn both_ends_of_a_stop_stop_what_meets_them() {
    for y in [-20.0, -5.0, 5.0, 20.0] {
        for (x, angle) in [(-40.0, 0.0), (40.0, 180.0)] {
            let stop = body(Shape::Stop { opening: 10.0, height: 40.0 }, Substance::Surface(Surface::Absorber));
            let trace = traced(vec![stop], ray((x, y), angle));
            assert_eq!(trace.tree.rays[0].segments[0].ending, Ending::Absorbed, "y = {y} from x = {x}");
        }
    }
}

#[test]
fn a_corner_that_light_only_touches_is_passed_by_on_either_side() {
    let diamond = [(2.0, 0.0), (0.0, 2.0), (-2.0, 0.0), (0.0, -2.0)].map(DVec2::from).to_vec();
    for (from, angle) in [((-9.0, 2.0), 0.0), ((-9.0, -2.0), 0.0), ((9.0, 2.0), 180.0), ((2.0, -9.0), 90.0)] {
        let trace = traced(vec![glass(Shape::Polygon(diamond.clone()))], ray(from, angle));
        assert_eq!(trace.tree.rays[0].segments[0].ending, Ending::Escaped, "from {from:?} at {angle}°");
    }
}

#[test]
fn tracing_again_gives_the_same_in_the_same_memory() {
    let system = |sides: u32, rays: u32| {
        let body = glass(Shape::RegularPolygon { sides, radius: 10.0 });
        let fan = Light::Fan { from: (-30.0, 1.0).into(), direction: Direction::Angle(0.0), spread: 20.0, rays };
        let source = Source { light: fan, ..ray((0.0, 0.0), 0.0) };
        compile(&Scene { bodies: vec![body], sources: vec![source], ..Scene::default() }).unwrap().system
    };
    let mut again = Trace::default();
    for (sides, rays) in [(3, 5), (6, 40), (6, 40), (4, 9), (3, 5)] {
        let system = system(sides, rays);
        retrace(&system, &mut again);
        assert_eq!(again, trace(&system));
        let memory = |trace: &Trace| trace.tree.rays.iter().map(|ray| ray.segments.as_ptr()).collect::<Vec<_>>();
        let before = memory(&again);
        retrace(&system, &mut again);
        assert_eq!(memory(&again), before);
    }
}

#[test]
fn a_line_passes_a_piece_of_an_arc_by_whose_chord_is_rounding() {
    let mirror = body(Shape::Disk { radius: 40.0 }, Substance::Surface(Surface::Mirror));
    let mut system = compile(&Scene { bodies: vec![mirror], ..Scene::default() }).unwrap().system;
    system.interfaces.truncate(1);
    system.cells.few.truncate(1);
    let a = DVec2::new(-40.0, 0.0);
    let ray =
        Ray { from: DVec2::new(-60.0, 20.0), direction: DVec2::X, medium: system.surroundings(), start: Start::Free };
    for chord in [-7e-15, 7e-15] {
        let b = a + DVec2::new(0.0, chord);
        system.interfaces[0].curve = Curve { a, b, m: a, n: DVec2::X, curvature: 1.0 / 40.0 };
        for skips_nothing in [false, true] {
            let mut search = Search::new(&system);
            search.skips_nothing = skips_nothing;
            assert_eq!(search.nearest(&ray), None, "chord {chord}, {skips_nothing}");
        }
    }
}
