//! Scenes of `scenes/total-reflection`.

use snellius::scene::Medium;
use snellius::trace::{Ending, TracedRay, Via};

use crate::Lesson;
use crate::measure::{asin, changed, cos, fresnel, index, near, no_branch, only_ray, sin, theta_i, theta_t};
use crate::support::{Run, segment};

pub(crate) const LESSONS: &[Lesson] = &[
    ("total-reflection/brilliant", diamond_returns_more_than_glass),
    ("total-reflection/half-disk-above", nothing_is_transmitted_above),
    ("total-reflection/half-disk-at", nothing_is_transmitted_at),
    ("total-reflection/half-disk-below", most_is_transmitted_below),
    ("total-reflection/light-guide-bent", bends_lose_nothing),
    ("total-reflection/light-guide-straight", every_bounce_is_total),
    ("total-reflection/point-under-water", light_leaves_only_within_the_critical_cone),
    ("total-reflection/prism-in-water", water_opens_the_prism),
];

/// Critical angle of the half-disks, n = 1.5.
fn critical() -> f64 {
    asin(2.0 / 3.0)
}

fn most_is_transmitted_below(run: &Run) {
    let ray = only_ray(run);
    let flat = segment(ray, "t").hit.unwrap();
    let theta = flat.theta_i_degrees();
    near(theta, 30.0, 0.01);
    assert!(theta < critical() && !flat.total_internal_reflection);
    near(theta_t(ray, "t"), asin(1.5 * sin(theta)), 1e-12);
    near(theta_t(ray, "t"), 48.6, 0.05);
    let (s, p) = fresnel(1.5, 1.0, theta);
    near(segment(ray, "tr").power.total() / segment(ray, "t").power.total(), 0.5 * (s + p), 1e-14);
    near(0.5 * (s + p), 0.055, 5e-4);
}

fn nothing_is_transmitted_at(run: &Run) {
    let ray = only_ray(run);
    let flat = segment(ray, "t").hit.unwrap();
    near(flat.theta_i_degrees(), critical(), 1e-12);
    assert_eq!(flat.theta_t_degrees(), Some(90.0));
    everything_is_reflected(ray);
}

fn nothing_is_transmitted_above(run: &Run) {
    let ray = only_ray(run);
    let flat = segment(ray, "t").hit.unwrap();
    near(flat.theta_i_degrees(), 50.0, 0.01);
    near(flat.critical_degrees().unwrap(), critical(), 1e-12);
    assert!(flat.theta_i_degrees() > critical());
    assert_eq!(flat.theta_t_degrees(), None);
    everything_is_reflected(ray);
}

fn everything_is_reflected(ray: &TracedRay) {
    assert!(segment(ray, "t").hit.unwrap().total_internal_reflection);
    no_branch(ray, "tt");
    assert_eq!(segment(ray, "ti").power, segment(ray, "t").power);
    near(theta_i(ray, "ti"), 0.0, 1e-12);
}

fn every_bounce_is_total(run: &Run) {
    let n = index("PMMA");
    let enters = |theta| 1.0 - 0.5 * (fresnel(1.0, n, theta).0 + fresnel(1.0, n, theta).1);
    arrives_by_total_reflection(run, (enters(0.0) + enters(15.0) + enters(30.0)) / 3.0);
    for (ray, (theta, bounces)) in run.trace.tree.rays.iter().zip([(0.0, 0), (15.0, 2), (30.0, 4)]) {
        near(theta_i(ray, ""), theta, 1e-12);
        assert_eq!(inner_hits(ray).count(), bounces);
        assert!(inner_hits(ray).all(|hit| (hit - (90.0 - asin(sin(theta) / n))).abs() < 1e-12));
    }
}

fn bends_lose_nothing(run: &Run) {
    arrives_by_total_reflection(run, 1.0 - normal_reflectance(index("PMMA")));
    assert!(run.trace.tree.rays.iter().all(|ray| inner_hits(ray).count() >= 2));
}

fn normal_reflectance(n: f64) -> f64 {
    (n - 1.0) * (n - 1.0) / ((n + 1.0) * (n + 1.0))
}

/// All that enters the guide, `share` of the light, meets its sides past the critical angle and lands on the detector.
fn arrives_by_total_reflection(run: &Run, share: f64) {
    let critical = asin(1.0 / index("PMMA"));
    near(critical, 42.1, 0.05);
    for ray in &run.trace.tree.rays {
        let bounced =
            |segment: &&snellius::trace::Segment| segment.via != Via::Source && segment.ending == Ending::Interface;
        for segment in ray.segments.iter().filter(bounced) {
            assert!(segment.hit.unwrap().total_internal_reflection);
        }
        assert!(inner_hits(ray).all(|theta| theta > critical));
    }
    let balance = &run.trace.summary.balance;
    let arrives = balance.detected.value() / balance.emitted.value();
    near(arrives, share, 1e-14);
    assert!(arrives >= 0.95);
}

/// Angles of incidence where a ray inside a guide meets its sides.
fn inner_hits(ray: &TracedRay) -> impl Iterator<Item = f64> {
    let inside = ray.segments.iter().filter(|segment| segment.via != Via::Source);
    inside.filter(|segment| segment.ending == Ending::Interface).map(|segment| segment.hit.unwrap().theta_i_degrees())
}

fn water_opens_the_prism(run: &Run) {
    let (glass, water) = (index("N-BK7"), index("water"));
    let ray = only_ray(run);
    near(theta_i(ray, "t"), 45.0, 1e-12);
    assert!(45.0 < asin(water / glass) && 45.0 > asin(1.0 / glass));
    near(asin(water / glass), 61.5, 0.05);
    near(theta_t(ray, "t"), asin(glass * sin(45.0) / water), 1e-12);
    near(theta_t(ray, "t"), 53.5, 0.05);
    let (s, p) = fresnel(glass, water, 45.0);
    near(segment(ray, "tt").power.total() / segment(ray, "t").power.total(), 1.0 - 0.5 * (s + p), 1e-14);
    near(0.5 * (s + p), 0.012, 5e-4);
    let in_air = changed(run, |scene| scene.surroundings = Medium::Index(1.0));
    assert!(segment(only_ray(&in_air), "t").hit.unwrap().total_internal_reflection);
}

fn diamond_returns_more_than_glass(run: &Run) {
    let (diamond, glass) = (asin(1.0 / index("diamond")), asin(1.0 / index("N-BK7")));
    near(diamond, 24.4, 0.05);
    near(glass, 41.2, 0.05);
    // What falls in through the table meets the pavilion first, at its slope: between the two critical angles.
    let slope = crate::measure::atan(21.54 / 25.0);
    near(slope, 40.75, 0.01);
    for number in 0..6 {
        let pavilion = |source| segment(crate::measure::ray(run, source, number), "t").hit.unwrap();
        near(pavilion(0).theta_i_degrees(), slope, 1e-11);
        near(pavilion(1).theta_i_degrees(), slope, 1e-11);
        assert!(pavilion(0).total_internal_reflection && !pavilion(1).total_internal_reflection);
    }
    near(sent_up(run, 0), 0.86, 0.005);
    near(sent_up(run, 1), 0.47, 0.005);
}

/// Share of a source's power that leaves upward.
fn sent_up(run: &Run, source: usize) -> f64 {
    let rays = run.trace.tree.rays.iter().filter(|ray| ray.source == source);
    let escaped = rays.flat_map(|ray| &ray.segments).filter(|segment| segment.ending == Ending::Escaped);
    escaped.filter(|segment| segment.direction.y > 0.0).map(|segment| segment.power.total()).sum()
}

/// 24 rays all round, 15° apart; ray 6 heads straight up.
fn light_leaves_only_within_the_critical_cone(run: &Run) {
    const DEPTH: f64 = 30.0;
    let n = 299_792_458.0 / 2.25e8;
    let critical = asin(1.0 / n);
    near(critical, 48.6, 0.05);
    assert_eq!(run.trace.tree.rays.len(), 24);
    for number in 1..12 {
        let ray = &run.trace.tree.rays[number];
        let theta = 15.0 * (number as f64 - 6.0).abs();
        let surface = segment(ray, "").hit.unwrap();
        near(surface.theta_i_degrees(), theta, 1e-12);
        if theta < critical {
            near(theta_t(ray, ""), asin(n * sin(theta)), 1e-11);
            near(segment(ray, "").to.unwrap().x.abs(), DEPTH * sin(theta) / cos(theta), 1e-12);
            assert_eq!(segment(ray, "t").ending, Ending::Escaped);
        } else {
            assert!(surface.total_internal_reflection);
            assert_eq!(segment(ray, "i").power, segment(ray, "").power);
            no_branch(ray, "t");
        }
    }
    let leave =
        (1..12).filter(|&number| !segment(&run.trace.tree.rays[number], "").hit.unwrap().total_internal_reflection);
    assert_eq!(leave.count(), 7);
}
