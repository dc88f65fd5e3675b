//! What holds of every segment and every hit of every scene.

use glam::DVec2;
use proptest::prelude::*;
use snellius::geometry::Curve;
use snellius::light::Power;
use snellius::scene::{SecondaryRays, Substance};
use snellius::trace::{Ending, Segment, TracedRay, Via};

use crate::oracle::{clearance, crossings, distance, index_at};
use crate::scenes::{Random, free_scenes, lattice_scenes, turned_scenes};
use crate::support::{Run, run_scene};
use crate::{U, config};

proptest! {
    #![proptest_config(config(1500))]

    #[test]
    fn the_laws_hold_in_random_scenes(Random(scene) in free_scenes()) {
        check(&run_scene(scene));
    }

    #[test]
    fn the_laws_hold_where_faces_and_corners_coincide(Random(scene) in lattice_scenes()) {
        check(&run_scene(scene));
    }

    #[test]
    fn the_laws_hold_where_they_coincide_up_to_rounding(Random(scene) in turned_scenes()) {
        check(&run_scene(scene));
    }

    #[test]
    fn the_same_scene_gives_the_same_bits(Random(scene) in free_scenes()) {
        prop_assert_eq!(run_scene(scene.clone()).trace, run_scene(scene).trace);
    }
}

/// Holds a whole trace to the laws.
pub(crate) fn check(run: &Run) {
    let emitted = run.trace.summary.balance.emitted.value();
    assert!(run.trace.summary.balance.residual().abs() <= 64.0 * U * emitted, "{:?}", run.trace.summary.balance);
    let grazing = grazing(run);
    for ray in &run.trace.tree.rays {
        order(ray);
        for segment in &ray.segments {
            let parent = segment.parent.map(|id| &ray.segments[id.index()]);
            path(run, segment, parent);
            medium(run, ray, segment);
            surfaces(run, segment);
            if let Some(parent) = parent {
                bend(segment, parent, grazing);
            }
            powers(run, ray, segment);
        }
    }
}

/// Depth-first, transmitted before reflected; at most one child of each kind, and none of a segment that ended.
fn order(ray: &TracedRay) {
    let mut open: Vec<usize> = Vec::new();
    for (k, segment) in ray.segments.iter().enumerate() {
        assert_eq!(segment.id.index(), k);
        assert_eq!(segment.parent.is_none(), k == 0);
        assert_eq!(segment.parent.is_none(), segment.via == Via::Source);
        while let Some(last) = open.last().filter(|last| segment.parent.is_some_and(|parent| parent.index() != **last))
        {
            assert!(*last > 0, "the parent of {k} is closed");
            open.pop();
        }
        open.push(k);
        let children: Vec<_> = ray.segments.iter().filter(|child| child.parent == Some(segment.id)).collect();
        let ways: Vec<_> = children.iter().map(|child| child.via).collect();
        match segment.ending {
            Ending::Interface => assert!(
                matches!(
                    ways[..],
                    [Via::Transmission]
                        | [Via::Reflection]
                        | [Via::TotalInternalReflection]
                        | [Via::Transmission, Via::Reflection]
                ),
                "{ways:?}"
            ),
            _ => assert!(ways.is_empty(), "{ways:?}"),
        }
    }
}

fn path(run: &Run, segment: &Segment, parent: Option<&Segment>) {
    let Segment { from, direction, .. } = *segment;
    // One Newton step leaves the roundings of the two products and the sum of squares.
    assert!((direction.length_squared() - 1.0).abs() <= 8.0 * U, "{direction:?} is no unit vector");
    if let Some(parent) = parent {
        assert_eq!(parent.to, Some(from), "a child starts where its parent ends");
    }
    let before = parent.map_or(0.0, |parent| parent.optical_path);
    let Some(to) = segment.to else {
        assert_eq!(segment.optical_path, before);
        return;
    };
    let hit = segment.hit.expect("a segment that ends has a hit");
    let reach = reach(run) + from.abs().max(to.abs()).max_element();
    // The point is rounded along the ray, onto the curve and into the scene's coordinates, 8 u together; a curve that is one
    // with an earlier body's runs up to 16 u beside it.
    let outlines = &run.system.bodies()[hit.body].outlines;
    // The oracle measures from centers, which are good to an ulp of the radius.
    let units = |c: &Curve| {
        let radius = if c.curvature == 0.0 { 0.0 } else { c.curvature.abs().recip() };
        distance(c, to) / (U * (reach + radius))
    };
    let off = outlines.iter().flat_map(|o| &o.curves).map(units).fold(f64::INFINITY, f64::min);
    assert!(off <= 24.0, "a hit {off:.1} u off its outline: {segment:?}");
    let aside = direction.perp_dot(to - from);
    assert!(aside.abs() <= 32.0 * U * reach, "a hit {:.1} u off its ray: {segment:?}", aside / U / reach);
    let length = (to - from).dot(direction);
    // Where a ray grazes, the place along it is known to the square root of the rounding.
    assert!(length >= -8.0 * U.sqrt() * reach, "a hit {length:e} behind its start: {segment:?}");
    let optical = segment.medium_index * length;
    let rounding = U * (64.0 * segment.medium_index * reach + 4.0 * before);
    assert!((segment.optical_path - before - optical).abs() <= rounding, "optical path of {segment:?}");
}

fn reach(run: &Run) -> f64 {
    let curves = run.system.bodies().iter().flat_map(|body| &body.outlines).flat_map(|outline| &outline.curves);
    let sources = run.trace.tree.rays.iter().map(|ray| ray.segments[0].from);
    let points = curves.flat_map(|curve| [curve.a, curve.b, curve.m]).chain(sources);
    points.map(|p| p.abs().max_element()).fold(0.0, f64::max)
}

/// A segment runs in the medium of the last body that holds it, wherever it is probed; one that escapes is outside of all.
fn medium(run: &Run, ray: &TracedRay, segment: &Segment) {
    let Segment { from, direction, .. } = *segment;
    let probes: Vec<DVec2> = match (segment.to, segment.ending) {
        (Some(to), _) => [0.5, 0.1, 0.9].map(|part| from.lerp(to, part)).into(),
        (None, Ending::Escaped) => [1e-3, 0.3, 1.7, 4.0, 9.0, 20.0, 100.0].map(|t| from + t * direction).into(),
        _ => return,
    };
    for p in probes.into_iter().filter(|p| clearance(&run.system, *p) > 1e-9) {
        let there = index_at(&run.system, ray.wavelength, p, 1e-9);
        assert_eq!(segment.medium_index, there, "at {p:?} on {}: {segment:?}", ray.address(segment.id));
    }
    if segment.ending == Ending::Escaped {
        let outside = run.system.index(run.system.surroundings(), ray.wavelength);
        assert_eq!(segment.medium_index, outside, "a leak: {segment:?}");
    }
}

/// No segment passes through a surface.
fn surfaces(run: &Run, segment: &Segment) {
    let Segment { from, direction, .. } = *segment;
    let length = match (segment.to, segment.ending) {
        (Some(to), _) => from.distance(to),
        (None, Ending::Escaped) => f64::INFINITY,
        _ => return,
    };
    // Where a ray grazes an arc, the oracle knows the place to the square root of its rounding only.
    let margin = 1e-6 + 8.0 * (U * reach(run)).sqrt();
    for (body, placed) in run.scene.bodies.iter().zip(run.system.bodies()) {
        let Substance::Surface(_) = body.substance else { continue };
        for curve in placed.outlines.iter().flat_map(|outline| &outline.curves) {
            for t in crossings(curve, from, direction).into_iter().filter(|t| margin < *t && *t < length - margin) {
                let p = from + t * direction;
                let slanted = curve.normal_at(p).dot(direction).abs() > margin;
                let inside = p.distance(curve.a).min(p.distance(curve.b)) > margin;
                assert!(!(slanted && inside), "through a surface at {p:?}: {segment:?}");
            }
        }
    }
}

/// How far a ray may head away from an edge that it meets: a vertex within 64 ulp of the scene's size off the ray counts as
/// on either side of it, so that an edge which the ray runs along may be met from behind.
fn grazing(run: &Run) -> f64 {
    let shortest = run.system.interfaces().iter().map(|i| i.curve.a.distance(i.curve.b)).fold(f64::INFINITY, f64::min);
    4.0 * U + 2.0 * 128.0 * U * reach(run) / shortest
}

/// Snell's law and the law of reflection, from the directions alone.
fn bend(segment: &Segment, parent: &Segment, grazing: f64) {
    let hit = parent.hit.expect("a parent has a hit");
    let (v, d, n) = (parent.direction, segment.direction, hit.normal);
    let (along_v, along_d) = (v.perp_dot(n), d.perp_dot(n));
    assert!(n.dot(v) <= grazing, "the normal points against the ray");
    // Unit vectors rounded a few times each: tangential components are good to 8 u.
    match segment.via {
        Via::Transmission => {
            let n_t = hit.n_t.expect("transmitted into a medium");
            assert_eq!((hit.n_i, n_t), (parent.medium_index, segment.medium_index));
            let off = n_t * along_d - hit.n_i * along_v;
            assert!(off.abs() <= 8.0 * U * (hit.n_i + n_t), "Snell off by {:.1} u: {parent:?} {segment:?}", off / U);
            assert!(n.dot(d) <= grazing, "transmitted to the far side");
        }
        Via::Reflection | Via::TotalInternalReflection => {
            assert_eq!(parent.medium_index.to_bits(), segment.medium_index.to_bits());
            assert!((along_d - along_v).abs() <= 16.0 * U, "{segment:?}");
            assert!((n.dot(d) - n.dot(-v).max(0.0)).abs() <= 16.0 * U, "{segment:?}");
            assert!(n.dot(d) >= -8.0 * U, "reflected to the near side");
        }
        via => panic!("a segment with a parent has no {via:?}"),
    }
}

/// Fractions add to 1, powers of the children to what is not absorbed.
fn powers(run: &Run, ray: &TracedRay, segment: &Segment) {
    let Some(hit) = segment.hit else { return };
    for share in [|power: Power| power.s, |power: Power| power.p] {
        let (r, t) = (share(hit.reflectance), share(hit.transmittance));
        assert!((0.0..=1.0).contains(&r) && (0.0..=1.0).contains(&t), "R = {r}, T = {t}");
        assert!((r + t + hit.absorptance - 1.0).abs() <= 4.0 * U, "R + T = {}", r + t);
        let children = ray.segments.iter().filter(|child| child.parent == Some(segment.id));
        let passed_on: f64 = children.map(|child| share(child.power)).sum();
        let kept = share(segment.power) * (1.0 - hit.absorptance);
        assert!((passed_on - kept).abs() <= 8.0 * U * share(segment.power), "{passed_on} of {kept}");
    }
    if run.scene.trace.secondary_rays == SecondaryRays::Fresnel && segment.ending == Ending::Interface {
        let (r, t) = (hit.reflected_share(segment.power), hit.transmitted_share(segment.power));
        assert!((r + t + hit.absorptance - 1.0).abs() <= 8.0 * U);
    }
}
