//! Rays aimed where tracers leak: at vertices and an ulp beside, along edges, at seams between arc and edge, at tangents, at
//! corners where several bodies meet. Eight bounces each.

use glam::DVec2;
use snellius::Scene;
use snellius::compile::compile;
use snellius::geometry::Curve;
use snellius::numerics::Turn;
use snellius::scene::{
    Body, Direction, Light, Medium, PathStep, SecondaryRays, Shape, Source, Substance, Surface, TraceSettings,
};
use snellius::trace::Ending;

use crate::oracle::holds;
use crate::scenes::{self, body, source, towards};
use crate::support::random::Random;
use crate::support::run_scene;
use crate::times;

/// Rays per test.
const RAYS: u32 = 20_000;
/// Rays per scene.
const BATCH: u32 = 50;

/// Where and how large the scene is.
const PLACES: [(f64, f64); 5] = [(1.0, 0.0), (1.0, 1e6), (1.0, 1e9), (1e9, 0.0), (1e-9, 0.0)];

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
                })
                .collect(),
        },
        other => other,
    }
}

/// Starts and headings at and about the ends of curves, along edges and tangents, and in between.
fn adversary(random: &mut Random, curves: &[Curve]) -> Option<Source> {
    let (first, second) = (curves[random.below(curves.len())], curves[random.below(curves.len())]);
    let inside = first.a.lerp(second.b, 0.2 + 0.6 * random.unit());
    let from = match random.below(5) {
        0 => random.beside_point(first.a),
        1 => first.a.lerp(first.b, 1e-9 * random.unit()),
        2 => first.a.lerp(first.b, random.unit()),
        _ => inside,
    };
    let light = match random.below(6) {
        0 => return along(from, second.tangent_at(second.a)),
        1 => return along(first.a, first.tangent_at(first.a)),
        2 => Light::Ray { from: first.a, direction: Direction::Towards(random.beside_point(first.b)) },
        3 => Light::Ray { from, direction: Direction::Angle(360.0 * random.unit()) },
        _ => Light::Ray { from, direction: Direction::Towards(random.beside_point(second.b)) },
    };
    let moves = !matches!(light, Light::Ray { from, direction: Direction::Towards(to) } if from == to);
    moves.then(|| source(light))
}

fn along(from: DVec2, direction: DVec2) -> Option<Source> {
    let to = from + direction;
    (from != to).then(|| towards(from, to))
}

fn curves(bodies: &[Body]) -> Vec<Curve> {
    let system = compile(&Scene { bodies: bodies.to_vec(), ..Scene::default() }).unwrap().system;
    system.bodies().iter().flat_map(|body| &body.outlines).flat_map(|outline| outline.curves.clone()).collect()
}

fn eight_bounces(bodies: Vec<Body>, sources: Vec<Source>) -> Scene {
    let secondary_rays = SecondaryRays::Fixed { kr: 0.5, kt: 0.5 };
    let trace = TraceSettings { secondary_rays, max_depth: 8, min_power: 0.0, ..TraceSettings::default() };
    Scene { bodies, sources, trace, ..Scene::default() }
}

/// Traces adversarial rays through random scenes and counts those that leak.
fn leaks(seed: u64, bodies: impl Fn(&mut Random) -> Vec<Body>) -> usize {
    let mut random = Random(seed);
    let mut leaks = 0;
    for _ in 0..RAYS * times() / BATCH {
        let bodies = bodies(&mut random);
        let curves = curves(&bodies);
        let sources: Vec<_> = (0..BATCH).filter_map(|_| adversary(&mut random, &curves)).collect();
        let run = run_scene(eight_bounces(bodies, sources));
        for ray in &run.trace.tree.rays {
            let leak = ray.segments.iter().find(|s| s.ending == Ending::Escaped && s.medium_index != 1.0);
            if let Some(leak) = leak {
                leaks += 1;
                println!("{} {leak:?}", show(&run.scene, ray.source));
            }
        }
    }
    leaks
}

/// A scene's bodies and one of its sources.
fn show(scene: &Scene, source: usize) -> String {
    let sources = vec![scene.sources[source].clone()];
    format!("{:?}", scenes::Random(Scene { sources, bodies: scene.bodies.clone(), ..Scene::default() }))
}

fn placed(random: &mut Random, shape: Shape) -> Body {
    let (scale, shift) = PLACES[random.below(PLACES.len())];
    let rotate = [0.0, 90.0, 360.0 * random.unit()][random.below(3)];
    let glass = Substance::Medium(Medium::Index(1.5));
    Body { at: DVec2::new(shift, -shift), rotate, ..body(scaled(shape, scale), glass) }
}

#[test]
fn no_leak_from_a_single_body() {
    let leaks = leaks(1, |random| {
        let shape = closed_shape(random);
        vec![placed(random, shape)]
    });
    assert_eq!(leaks, 0);
}

#[test]
fn no_leak_where_bodies_are_cemented_or_touch() {
    let leaks = leaks(2, |random| {
        let first = Body { at: DVec2::ZERO, ..body(closed_shape(random), Substance::Medium(Medium::Index(1.5))) };
        let lattice = |random: &mut Random| {
            DVec2::from([random.below(5), random.below(5)].map(|k| [-2.0, -1.5, 0.0, 1.5, 2.0][k]))
        };
        let mut next = |n: f64| {
            let rotate = [0.0, 90.0, 180.0, 45.0][random.below(4)];
            Body { at: lattice(random), rotate, ..body(closed_shape(random), Substance::Medium(Medium::Index(n))) }
        };
        vec![first, next(2.0), next(1.0), next(1.5)]
    });
    assert_eq!(leaks, 0);
}

#[test]
fn no_leak_from_a_closed_mirror_box() {
    let mut random = Random(3);
    let mut leaks = 0;
    for _ in 0..RAYS * times() / BATCH {
        let shape = closed_shape(&mut random);
        let walls = Body { substance: Substance::Surface(Surface::Mirror), ..placed(&mut random, shape) };
        let curves = curves(std::slice::from_ref(&walls));
        let points = curves.iter().flat_map(|curve| [curve.a, curve.midpoint()]);
        let middle = 0.5 * points.sum::<DVec2>() / f64::from(u32::try_from(curves.len()).unwrap());
        if !holds(&curves, middle) {
            continue;
        }
        // From the middle at a vertex, a seam or an ulp beside: whatever the first bounce does, none may get out.
        let aim = |random: &mut Random| {
            let curve = &curves[random.below(curves.len())];
            towards(middle, random.beside_point(curve.a))
        };
        let sources: Vec<_> = (0..BATCH).map(|_| aim(&mut random)).collect();
        let run = run_scene(eight_bounces(vec![walls], sources));
        let escaped = |ray: &&snellius::trace::TracedRay| ray.segments.iter().any(|s| s.ending == Ending::Escaped);
        for ray in run.trace.tree.rays.iter().filter(escaped) {
            leaks += 1;
            println!("{} {:?}", show(&run.scene, ray.source), ray.segments);
        }
    }
    assert_eq!(leaks, 0);
}
