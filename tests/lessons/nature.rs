//! Scenes of `scenes/nature`.

use glam::DVec2;
use snellius::light::Wavelength;
use snellius::scene::Light;
use snellius::trace::TracedRay;

use crate::Lesson;
use crate::measure::{acos, along, asin, changed, exit, index, index_at, near, path, ray, sin, theta_i, turn};
use crate::support::{Run, segment};

pub(crate) const LESSONS: &[Lesson] = &[
    ("nature/halo", ice_turns_by_22_degrees_at_least),
    ("nature/mirage", hot_air_turns_the_ray_upward),
    ("nature/rainbow-descartes", descartes_ray_is_turned_least),
    ("nature/rainbow-primary", red_is_outside_the_primary_bow),
    ("nature/rainbow-secondary", red_is_inside_the_secondary_bow),
    ("nature/snells-window", the_sky_stands_in_a_cone),
];

const DROP: f64 = 30.0;

/// Deviation of a ray that meets a drop at this height over its center and is reflected k times inside.
fn drop_deviation(n: f64, height: f64, reflections: u32) -> f64 {
    let (outside, inside) = (asin(height / DROP), asin(height / DROP / n));
    let k = f64::from(reflections);
    2.0 * (outside - inside) + k * (180.0 - 2.0 * inside)
}

/// Height of Descartes' ray, cos² θ = (n² − 1)/(k(k + 2)), whose deviation is least.
fn descartes_height(n: f64, reflections: u32) -> f64 {
    let k = f64::from(reflections);
    DROP * sin(acos(((n * n - 1.0) / (k * (k + 2.0))).sqrt()))
}

/// Angle between a bow and the point opposite to the Sun.
fn bow(n: f64, reflections: u32) -> f64 {
    (drop_deviation(n, descartes_height(n, reflections), reflections) - 180.0).abs()
}

/// Angle by which the branch is turned from the sunlight, all around, in the sense in which the drop turns it.
fn turned(ray: &TracedRay, branch: &str) -> f64 {
    let sunlight = &ray.segments[0];
    let sense = -sunlight.from.y.signum();
    (sense * turn(sunlight.direction, segment(ray, branch).direction)).rem_euclid(360.0)
}

fn descartes_ray_is_turned_least(run: &Run) {
    let n = index("water");
    let descartes = ray(run, 1, 0);
    near(descartes.segments[0].from.y, descartes_height(n, 1), 1e-12);
    let least = turned(descartes, "trt");
    near(least, drop_deviation(n, descartes_height(n, 1), 1), 1e-10);
    near(least, 138.0, 0.05);
    near(descartes_height(n, 1) / DROP, 0.861, 5e-4);
    for number in 0..9 {
        let ray = ray(run, 0, number);
        near(turned(ray, "trt"), drop_deviation(n, ray.segments[0].from.y, 1), 1e-10);
        assert!(turned(ray, "trt") > least);
    }
}

fn red_is_outside_the_primary_bow(run: &Run) {
    let rays = &run.trace.tree.rays;
    let angle = |ray: &TracedRay| 180.0 - turned(ray, "trt");
    colors_stand_in_the_bow(rays, 1, angle);
    assert!(rays.is_sorted_by(|shorter, longer| angle(shorter) < angle(longer)));
    near(bow(violet(), 1), 40.8, 0.05);
    near(bow(red(), 1), 42.4, 0.05);
}

fn red_is_inside_the_secondary_bow(run: &Run) {
    let rays = &run.trace.tree.rays;
    let angle = |ray: &TracedRay| turned(ray, "trrt") - 180.0;
    colors_stand_in_the_bow(rays, 2, angle);
    assert!(rays.is_sorted_by(|shorter, longer| angle(shorter) > angle(longer)));
    near(bow(violet(), 2), 53.2, 0.05);
    near(bow(red(), 2), 50.2, 0.05);
    assert!(rays.iter().all(|ray| segment(ray, "trrt").power.total() < segment(ray, "trt").power.total()));
}

/// Every color leaves by the closed form, and near its own bow.
fn colors_stand_in_the_bow(rays: &[TracedRay], reflections: u32, angle: impl Fn(&TracedRay) -> f64) {
    assert_eq!(rays.len(), 40);
    for ray in rays {
        let n = index_at("water", ray.wavelength);
        let deviation = drop_deviation(n, ray.segments[0].from.y.abs(), reflections);
        near(angle(ray), (deviation - 180.0).abs(), 1e-10);
        near(angle(ray), bow(n, reflections), 0.06);
    }
}

fn violet() -> f64 {
    index_at("water", Wavelength::from_nanometers(420.0).unwrap())
}

fn red() -> f64 {
    index_at("water", Wavelength::from_nanometers(700.0).unwrap())
}

fn the_sky_stands_in_a_cone(run: &Run) {
    let n = index("water");
    let window = asin(1.0 / n);
    near(window, 48.6, 0.05);
    for ray in &run.trace.tree.rays {
        let from_zenith = turn(DVec2::Y, ray.segments[0].direction);
        if from_zenith.abs() < window {
            near(turn(DVec2::Y, segment(ray, "t").direction), asin(n * sin(from_zenith)), 1e-10);
        } else {
            assert!(segment(ray, "").hit.unwrap().total_internal_reflection);
        }
    }
    assert!(!edge_is_mirrored(run, window - 1e-9) && edge_is_mirrored(run, window + 1e-9));
}

/// Whether the outermost ray of a fan of this half-angle is totally reflected.
fn edge_is_mirrored(run: &Run, half_angle: f64) -> bool {
    let fan = changed(run, |scene| {
        let Light::Fan { spread, .. } = &mut scene.sources[0].light else { panic!("a fan") };
        *spread = 2.0 * half_angle;
    });
    segment(ray(&fan, 0, 16), "").hit.unwrap().total_internal_reflection
}

fn hot_air_turns_the_ray_upward(run: &Run) {
    let ray = ray(run, 0, 0);
    let entry = ray.segments[0];
    // n cos α, α from the horizontal, is the same in every layer.
    for segment in &ray.segments {
        near(segment.medium_index * segment.direction.x, 1.2 * entry.direction.x, 1e-12);
    }
    let turning = segment(ray, "ttttt").hit.unwrap();
    assert!(turning.total_internal_reflection);
    assert!(turning.theta_i_degrees() > turning.critical_degrees().unwrap());
    assert!(theta_i(ray, "tttt") < segment(ray, "tttt").hit.unwrap().critical_degrees().unwrap());
    let last = ray.segments.last().unwrap();
    assert_eq!(path(ray, last), "tttttittttt");
    along(last.direction, DVec2::new(entry.direction.x, -entry.direction.y), 1e-13);
    let [straight, bent] = [1, 0].map(|source| {
        let hits = &run.trace.summary.screens[0].hits;
        hits.iter().find(|hit| hit.source == source).unwrap().position
    });
    near(bent, straight, 1e-3);
}

fn ice_turns_by_22_degrees_at_least(run: &Run) {
    let least = 2.0 * asin(1.31 * sin(30.0)) - 60.0;
    near(least, 21.8, 0.05);
    for ray in &run.trace.tree.rays {
        near(-turn(ray.segments[0].direction, exit(ray).direction), least, 1e-10);
        along(segment(ray, "t").direction, DVec2::X, 1e-10);
    }
    for tilt in [-8.0, -4.0, -1.0, 1.0, 4.0, 8.0] {
        let tumbled = changed(run, |scene| scene.bodies[0].rotate += tilt);
        let ray = ray(&tumbled, 0, 1);
        assert_eq!(path(ray, exit(ray)), "tt");
        assert!(-turn(ray.segments[0].direction, exit(ray).direction) > least);
    }
}
