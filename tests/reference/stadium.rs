//! How long a path stays true where errors grow as fast as they can: the stadium of two half circles and two edges, in
//! which light between mirrors is chaotic.
//!
//! # Source
//! Bunimovich, "On the ergodic properties of nowhere dispersing billiards", Commun. Math. Phys. 65 (1979).

use glam::DVec2;
use snellius::{Scene, Segment, compile, trace};

use crate::support::figures::{U, at_least, counted, size};
use crate::support::random::Random;
use crate::support::wide::{Wide2, narrow};
use crate::tracer::{self, Ray, reference};

/// What a position may be off, in sizes.
const KEPT: f64 = 1e-6;
/// Bounces between which the growth of errors is measured: the start is forgotten, and they are small still.
const GROWTH: [usize; 2] = [4, 24];

#[test]
fn a_chaotic_path_is_kept_as_long_as_f64_can() {
    let scene = scene(size(100, 1000));
    let system = compile(&scene).unwrap().system;
    let (tree, reference) = (trace(&system).tree, reference(&scene, system.origin()));
    let exponents: Vec<_> = reference.rays.iter().filter_map(exponent).collect();
    let pairs = tree.rays.iter().zip(&reference.rays);
    let mut kept: Vec<_> = pairs.map(|(traced, ray)| kept(&traced.segments, ray, reference.size)).collect();
    kept.sort_by(f64::total_cmp);
    let limit = libm::log(KEPT / U) / mean(&exponents);
    counted("stadium: Lyapunov exponent per bounce", mean(&exponents));
    counted("stadium: bounces that f64 can keep 1e-6 for", limit);
    counted("stadium: bounces that 1e-6 is kept for, mean", mean(&kept));
    counted("stadium: bounces that 1e-6 is kept for, median", kept[kept.len() / 2]);
    at_least("stadium: mean of bounces kept against what can be", mean(&kept) / limit, 0.95);
    at_least("stadium: median of bounces kept against what can be", kept[kept.len() / 2] / limit, 0.95);
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Half circles of radius 1 about (−1, 0) and (1, 0), and the edges between them.
fn scene(rays: u32) -> Scene {
    let mut random = Random(3);
    let light = |_| {
        // Evenly over the inside and all directions: the share of time that a long path spends there.
        let mut point = || DVec2::new(4.0 * random.unit() - 2.0, 2.0 * random.unit() - 1.0);
        let from = std::iter::from_fn(|| Some(point())).find(|p| (p.abs() - DVec2::X).max(DVec2::ZERO).length() < 0.99);
        let DVec2 { x, y } = from.unwrap();
        format!("(light: Ray(from: ({x:?}, {y:?}), direction: Angle({:?}))),", 360.0 * random.unit())
    };
    let sources: String = (0..rays).map(light).collect();
    let text = format!(
        "(
            bodies: [(surface: Mirror, shape: Outline(start: (-1, -1), path: [
                LineTo((1, -1)), ArcTo(through: (2, 0), to: (1, 1)), LineTo((-1, 1)), ArcTo(through: (-2, 0), to: (-1, -1)),
            ]))],
            trace: (max_depth: 100),
            sources: [{sources}],
        )"
    );
    Scene::from_ron(&text).unwrap_or_else(|problems| panic!("{problems}"))
}

/// The reference's segments, one after the other.
fn course(ray: &Ray) -> impl Iterator<Item = &tracer::Segment> {
    std::iter::successors(Some(&ray.first), |segment| segment.children.first())
}

/// By which factor, as its logarithm, a disturbance grows per bounce.
fn exponent(ray: &Ray) -> Option<f64> {
    let [first, last] = GROWTH.map(|bounce| Some(libm::log(course(ray).nth(bounce)?.end.as_ref()?.of_position())));
    Some((last? - first?) / (GROWTH[1] - GROWTH[0]) as f64)
}

/// After how many bounces a position is off by more than 1e-6, between two bounces by the logarithm of the error. A ray
/// that is set aside before counts up to there.
fn kept(traced: &[Segment], ray: &Ray, size: f64) -> f64 {
    let error = |(segment, truth): (&Segment, &tracer::Segment)| {
        let truth = truth.end.as_ref()?.truth();
        Some(narrow((Wide2::from(segment.to?) - truth.p).length()) / size)
    };
    let errors: Vec<f64> = traced.iter().zip(course(ray)).map_while(error).collect();
    let Some(passed) = errors.iter().position(|error| *error > KEPT) else { return errors.len() as f64 };
    let [before, after] = [errors[passed - 1], errors[passed]].map(|error| libm::log(error / KEPT));
    // The hit with the place k is the bounce k + 1.
    passed as f64 + before / (before - after)
}
