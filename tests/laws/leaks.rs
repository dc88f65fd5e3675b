//! No leak: rays aimed where tracers leak, eight bounces each, through single bodies, bodies cemented or touching, and
//! mirrors, anywhere and at any scale.

use glam::DVec2;
use snellius::Scene;
use snellius::compile::compile;
use snellius::numerics::Turn;
use snellius::scene::{Body, Medium, PathStep, SecondaryRays, Shape, Source, Substance, Surface};
use snellius::trace::{Ending, Segment, SegmentId, TracedRay, Via};

use crate::adversary::{AIMS, Aim, Marks};
use crate::oracle::{clearance, holds, index_at};
use crate::scenes::{self, body, towards};
use crate::support::figures::{at_most, size};
use crate::support::random::Random;
use crate::support::{Run, run_scene};

/// Rays per scene.
const BATCH: u32 = 50;

/// Where and how large the scene is.
const PLACES: [(f64, f64); 5] = [(1.0, 0.0), (1.0, 1e6), (1.0, 1e9), (1e9, 0.0), (1e-9, 0.0)];

/// Rays per family.
fn rays() -> u32 {
    size(20_000, 10_000_000)
}

fn star(random: &mut Random, convex: bool) -> Shape {
    let corners = 3 + random.below(6);
    let mut angle = 0.0;
    let mut point = || {
        angle += 360.0 / f64::from(u32::try_from(corners).unwrap()) * (0.6 + 0.4 * random.unit());
        (if convex { 2.0 } else { 0.5 + 2.0 * random.unit() }) * Turn::degrees(angle).direction()
    };
    Shape::Polygon((0..corners).map(|_| point()).collect())
}

fn stadium() -> Shape {
    let path = vec![
        PathStep::LineTo(DVec2::new(2.0, 0.0)),
        PathStep::ArcTo { through: DVec2::new(3.0, 1.0), to: DVec2::new(2.0, 2.0) },
        PathStep::LineTo(DVec2::new(0.0, 2.0)),
        PathStep::ArcTo { through: DVec2::new(-1.0, 1.0), to: DVec2::ZERO },
    ];
    Shape::Outline { start: DVec2::ZERO, path }
}

fn closed_shape(random: &mut Random) -> Shape {
    match random.below(7) {
        0 => star(random, true),
        1 => star(random, false),
        2 => Shape::Rectangle { width: 2.0, height: 1.5 },
        3 => Shape::Disk { radius: 1.5 },
        4 => Shape::HalfDisk { radius: 1.5 },
        5 => Shape::Lens { radii: [3.0, -3.0], thickness: 1.8, diameter: 3.0, facets: None },
        _ => stadium(),
    }
}

fn scaled(shape: Shape, by: f64) -> Shape {
    match shape {
        Shape::Polygon(points) => Shape::Polygon(points.into_iter().map(|p| by * p).collect()),
        Shape::Rectangle { width, height } => Shape::Rectangle { width: by * width, height: by * height },
        Shape::Disk { radius } => Shape::Disk { radius: by * radius },
        Shape::HalfDisk { radius } => Shape::HalfDisk { radius: by * radius },
        Shape::Lens { radii, thickness, diameter, facets } => {
            Shape::Lens { radii: radii.map(|r| by * r), thickness: by * thickness, diameter: by * diameter, facets }
        }
        Shape::Outline { start, path } => Shape::Outline {
            start: by * start,
            path: path
                .into_iter()
                .map(|step| match step {
                    PathStep::LineTo(to) => PathStep::LineTo(by * to),
                    PathStep::ArcTo { through, to } => PathStep::ArcTo { through: by * through, to: by * to },
                    other => panic!("how large is {other:?}?"),
                })
                .collect(),
        },
        other => other,
    }
}

fn glass(n: f64) -> Substance {
    Substance::Medium(Medium::Index(n))
}

/// The bodies scaled and turned together, then moved.
fn placed(random: &mut Random, bodies: Vec<Body>) -> Vec<Body> {
    let (scale, shift) = PLACES[random.below(PLACES.len())];
    let angle = [0.0, 90.0, 360.0 * random.unit()][random.below(3)];
    let place = |mut body: Body| {
        body.shape = scaled(body.shape, scale);
        (body.at, body.rotate) =
            (Turn::degrees(angle).apply(scale * body.at) + DVec2::new(shift, -shift), body.rotate + angle);
        body
    };
    bodies.into_iter().map(place).collect()
}

/// A closed shape turned by eighths, on places where such shapes cement and touch.
fn on_lattice(random: &mut Random, substance: Substance) -> Body {
    let shape = closed_shape(random);
    let at = DVec2::from([random.below(5), random.below(5)].map(|k| [-2.0, -1.5, 0.0, 1.5, 2.0][k]));
    body(shape, substance).placed(at, [0.0, 90.0, 180.0, 45.0][random.below(4)])
}

pub(crate) fn group(random: &mut Random) -> Vec<Body> {
    let first = body(closed_shape(random), glass(1.5));
    let others = [2.0, 1.0, 1.5].map(|n| on_lattice(random, glass(n)));
    [first].into_iter().chain(others).collect()
}

pub(crate) fn eight_bounces(bodies: Vec<Body>, sources: Vec<Source>) -> Scene {
    let secondary_rays = SecondaryRays::Fixed { kr: 0.5, kt: 0.5 };
    let mut scene = Scene::new(bodies, sources);
    (scene.trace.secondary_rays, scene.trace.max_depth, scene.trace.min_power) = (secondary_rays, 8, 0.0);
    scene
}

/// Traces adversarial rays through random scenes; fails for any that leaks, for more than a few in a wrong medium, and
/// unless each of these aims had its share.
fn hunt(family: &str, seed: u64, aims: &[Aim], bodies: impl Fn(&mut Random) -> Vec<Body>) {
    let mut random = Random(seed);
    let (mut leaks, mut strays, mut aimed) = (0, 0, [0; AIMS.len()]);
    for _ in 0..rays() / BATCH {
        let bodies = bodies(&mut random);
        let bodies = placed(&mut random, bodies);
        let marks = Marks::new(&compile(&Scene::new(bodies.clone(), Vec::new())).unwrap().system);
        let mut sources = Vec::new();
        while sources.len() < BATCH as usize {
            let Some((aim, source)) = marks.ray(&mut random) else { continue };
            aimed[AIMS.iter().position(|known| *known == aim).unwrap()] += 1;
            sources.push(source);
        }
        let run = run_scene(eight_bounces(bodies, sources));
        let clear = clear_of_rounding(&run);
        for ray in &run.trace.tree.rays {
            if let Some(leak) = ray.segments.iter().find(|s| is_leak(ray, s)) {
                leaks += 1;
                println!("leak: {} {leak:?}", show(&run.scene, ray.source));
            } else if let Some(stray) = ray.segments.iter().find(|s| is_stray(&run, ray, s, clear)) {
                strays += 1;
                println!("stray: {} {stray:?}", show(&run.scene, ray.source));
            }
        }
    }
    for aim in aims {
        let share = f64::from(aimed[AIMS.iter().position(|known| known == aim).unwrap()]) / f64::from(rays());
        assert!(share >= 0.04, "only {share} of the rays were aimed at {aim:?}");
    }
    at_most(&format!("leaks, {family}"), f64::from(leaks), 0.0);
    // Where arcs touch, rounding decides over more than its own size.
    at_most(&format!("share of rays in a wrong medium, {family}"), f64::from(strays) / f64::from(rays()), 1e-5);
}

/// Whether light escapes from inside a medium, or runs on in another than it was sent into.
pub(crate) fn is_leak(ray: &TracedRay, segment: &Segment) -> bool {
    let escapes = segment.ending == Ending::Escaped && segment.medium_index != 1.0;
    let sent_into = |parent: SegmentId| {
        let hit = ray.segments[parent.index()].hit.unwrap();
        if segment.via == Via::Transmission { hit.n_t.unwrap() } else { hit.n_i }
    };
    escapes || segment.parent.is_some_and(|parent| sent_into(parent) != segment.medium_index)
}

/// A distance far above the rounding of a scene's places and far below its size.
fn clear_of_rounding(run: &Run) -> f64 {
    let points = run.system.interfaces().iter().map(|interface| interface.curve.a);
    let (size, reach) = points.fold((0.0_f64, 0.0_f64), |(size, reach), p| {
        (size.max(p.abs().max_element()), reach.max((p + run.system.origin()).abs().max_element()))
    });
    1e-7 * size + 1e-12 * reach
}

/// Whether a segment runs through a place of another medium, far from all outlines.
fn is_stray(run: &Run, ray: &TracedRay, segment: &Segment, clear: f64) -> bool {
    let Segment { from, to, direction, .. } = *segment;
    let probes = match (to, segment.ending) {
        (Some(to), _) => [0.5, 0.2].map(|part| from.lerp(to, part)),
        (None, Ending::Escaped) => [1e6, 1e7].map(|times| from + times * clear * direction),
        _ => return false,
    };
    let is_wrong = |p: &DVec2| {
        clearance(&run.system, *p) > clear
            && index_at(&run.system, ray.wavelength, *p, 0.25 * clear) != segment.medium_index
    };
    probes.iter().any(is_wrong)
}

/// A scene's bodies and one of its sources.
fn show(scene: &Scene, source: usize) -> String {
    let sources = vec![scene.sources[source].clone()];
    format!("{:?}", scenes::Random(Scene::new(scene.bodies.clone(), sources)))
}

#[test]
fn no_leak_from_a_single_body() {
    hunt("single bodies", 1, &[Aim::Vertex, Aim::AlongEdge, Aim::Tangent, Aim::Seam, Aim::TwoVertices], |random| {
        vec![body(closed_shape(random), glass(1.5))]
    });
}

#[test]
fn no_leak_where_bodies_are_cemented_or_touch() {
    hunt("cemented and touching bodies", 2, &AIMS, group);
}

#[test]
fn no_leak_beside_mirrors() {
    hunt("bodies and mirrors", 4, &AIMS, |random| {
        let mut bodies = group(random);
        bodies.push(on_lattice(random, Substance::Surface(Surface::Mirror)));
        bodies
    });
}

#[test]
fn no_leak_from_a_closed_mirror_box() {
    let mut random = Random(3);
    let (mut leaks, mut aimed) = (0, 0);
    while aimed < rays() {
        let walls = vec![body(closed_shape(&mut random), Substance::Surface(Surface::Mirror))];
        let walls = placed(&mut random, walls);
        let system = compile(&Scene::new(walls.clone(), Vec::new())).unwrap().system;
        let curves = &system.bodies()[0].outlines[0].curves;
        let points = curves.iter().flat_map(|curve| [curve.a, curve.midpoint()]);
        let middle = 0.5 * points.sum::<DVec2>() / f64::from(u32::try_from(curves.len()).unwrap());
        if !holds(curves, middle) {
            continue;
        }
        // From the middle at a vertex, a seam or an ulp beside: whatever the first bounce does, none may get out.
        let aim = |random: &mut Random| {
            let curve = &curves[random.below(curves.len())];
            let at = [curve.a, curve.midpoint()][random.below(2)];
            towards(middle, random.beside_point(at))
        };
        let sources: Vec<_> = (0..BATCH).map(|_| aim(&mut random)).collect();
        aimed += BATCH;
        let run = run_scene(eight_bounces(walls, sources));
        let escaped = |ray: &&TracedRay| ray.segments.iter().any(|s| s.ending == Ending::Escaped);
        for ray in run.trace.tree.rays.iter().filter(escaped) {
            leaks += 1;
            println!("leak: {} {:?}", show(&run.scene, ray.source), ray.segments);
        }
    }
    at_most("leaks, closed mirror boxes", f64::from(leaks), 0.0);
}
