//! Hits lie on what they hit, in 237-bit arithmetic: the rounded point is put back on its edge or arc.

use std::cell::Cell;

use glam::DVec2;
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use snellius::Scene;
use snellius::compile::compile;
use snellius::geometry::Curve;

use crate::adversary::Marks;
use crate::leaks::{eight_bounces, group};
use crate::scenes::{Random, free_scenes, lattice_scenes, turned};
use crate::support::figures::{at_least, at_most, size};
use crate::support::wide::{Wide2, narrow, wide};
use crate::support::{Run, run_scene, run_text};
use crate::{U, config, support};

/// Distance of a point from a curve: from its line or circle between the normals at the curve's ends, else from the nearer
/// end.
fn distance(curve: &Curve, p: Wide2) -> f64 {
    let [a, b, m, n] = [curve.a, curve.b, curve.m, curve.n].map(Wide2::from);
    let curvature = wide(curve.curvature);
    let tangent = |end: Wide2| -(n + curvature * (m - end)).perp();
    let is_between = tangent(a).dot(p - a) >= wide(0.0) && tangent(b).dot(p - b) <= wide(0.0);
    let off = if curve.is_straight() {
        n.dot(p - m) / n.length()
    } else {
        let center = m + (wide(1.0) / curvature) * n;
        (p - center).length() - n.length() / curvature.abs()
    };
    let to_ends = narrow((p - a).length()).min(narrow((p - b).length()));
    if is_between { to_ends.min(narrow(off.abs())) } else { to_ends }
}

/// Largest absolute coordinate of the interfaces, relative to the origin.
fn reach(run: &Run) -> f64 {
    let ends = run.system.interfaces().iter().flat_map(|interface| [interface.curve.a, interface.curve.b]);
    ends.map(|p| p.abs().max_element()).fold(0.0, f64::max)
}

/// Hits of a scene about the coordinate origin, and the worst distance of one from its body's interfaces, in ulp of the
/// scene's size. Elsewhere the trace rounds its points into the scene's coordinates.
fn worst_hit(run: &Run) -> (u32, f64) {
    let ulp = 2.0 * U * reach(run);
    let (mut hits, mut worst) = (0, 0.0_f64);
    if run.system.origin() != DVec2::ZERO {
        return (hits, worst);
    }
    for segment in run.trace.tree.rays.iter().flat_map(|ray| &ray.segments) {
        let (Some(to), Some(hit)) = (segment.to, segment.hit) else { continue };
        let own = run.system.interfaces().iter().filter(|interface| interface.body == hit.body);
        let off = own.map(|interface| distance(&interface.curve, to.into())).fold(f64::INFINITY, f64::min) / ulp;
        hits += 1;
        worst = worst.max(off);
        assert!(off <= 4.0, "{off} ulp: {:?} {segment:?}", Random(run.scene.clone()));
    }
    (hits, worst)
}

/// The worst hit of all scenes that a strategy makes.
fn hunt(family: &str, scenes: &impl Strategy<Value = Random>) {
    let (hits, worst) = (Cell::new(0), Cell::new(0.0_f64));
    let hold = |Random(scene)| {
        let (more, off) = worst_hit(&run_scene(scene));
        hits.set(hits.get() + more);
        worst.set(worst.get().max(off));
        Ok(())
    };
    TestRunner::new(config(400)).run(scenes, hold).unwrap();
    report(family, hits.get(), worst.get());
}

fn report(family: &str, hits: u32, worst: f64) {
    at_least(&format!("hits held against their curves, {family}"), f64::from(hits), 1000.0);
    at_most(&format!("distance of a hit from its curve in ulp of the scene's size, {family}"), worst, 4.0);
}

#[test]
fn hits_lie_on_their_curves_in_random_scenes() {
    hunt("random scenes", &free_scenes());
}

#[test]
fn hits_lie_on_their_curves_on_a_lattice() {
    hunt("lattice scenes", &lattice_scenes());
}

#[test]
fn hits_lie_on_their_curves_where_scenes_are_turned() {
    let turned = (lattice_scenes(), prop_oneof![-180.0..180.0, Just(45.0)]);
    hunt("turned scenes", &turned.prop_map(|(Random(scene), angle)| Random(turned_about_origin(scene, angle))));
}

fn turned_about_origin(scene: Scene, angle: f64) -> Scene {
    turned(scene, angle, DVec2::ZERO)
}

#[test]
fn hits_lie_on_their_curves_where_rays_are_aimed_at_corners() {
    let mut random = support::random::Random(11);
    let (mut hits, mut worst) = (0, 0.0_f64);
    for _ in 0..size(200, 5_000) {
        let bodies = group(&mut random);
        let marks = Marks::new(&compile(&Scene::new(bodies.clone(), Vec::new())).unwrap().system);
        let sources = (0..20).filter_map(|_| marks.ray(&mut random)).map(|(_, source)| source).collect();
        let (more, off) = worst_hit(&run_scene(eight_bounces(bodies, sources)));
        hits += more;
        worst = worst.max(off);
    }
    report("rays aimed at corners", hits, worst);
}

#[test]
fn hits_lie_on_arcs_of_any_radius() {
    let mut random = support::random::Random(12);
    let (mut hits, mut worst) = (0, 0.0_f64);
    let signed = |random: &mut support::random::Random, x: f64| if random.below(2) == 0 { x } else { -x };
    for _ in 0..size(300, 5_000) {
        // Radii of 1e1 to 1e15 for the lens, 1e-12 to 1 for the ball.
        let magnitude = |random: &mut support::random::Random, from: i32, decades: f64| {
            libm::pow(10.0, f64::from(from) + decades * random.unit())
        };
        let radius = magnitude(&mut random, 1, 14.0);
        let (r1, r2) = (signed(&mut random, radius), signed(&mut random, 7.0 * radius));
        let ball = magnitude(&mut random, -12, 12.0);
        let at = DVec2::new(3.0 + random.unit(), 2.0 * random.unit() - 1.0);
        let aims = (0..10).map(|_| {
            let beside = at + ball * DVec2::new(random.unit() - 0.5, random.unit() - 0.5);
            format!("(light: Ray(from: (-5, {}), direction: Towards(({}, {}))))", random.unit(), beside.x, beside.y)
        });
        let run = run_text(&format!(
            "(bodies: [(shape: Lens(radii: ({r1}, {r2}), thickness: 1.5, diameter: 6), medium: Index(1.5)), \
             (shape: Disk({ball}), at: ({}, {}), medium: Index(2))], sources: [{}, \
             (light: Point(at: ({}, {}), rays: 20))], trace: (max_depth: 4, min_power: 0))",
            at.x,
            at.y,
            aims.collect::<Vec<_>>().join(", "),
            at.x,
            at.y,
        ));
        let (more, off) = worst_hit(&run);
        hits += more;
        worst = worst.max(off);
    }
    report("arcs of all radii", hits, worst);
}
