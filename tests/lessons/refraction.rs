//! Scenes of `scenes/refraction`.

use glam::DVec2;
use snellius::scene::Light;

use crate::Lesson;
use crate::measure::{
    along, asin, changed, exit, fresnel, index, near, offset, only_ray, path, ray, sin, tan, theta_i, theta_t, turn,
};
use crate::support::{Run, segment};

pub(crate) const LESSONS: &[Lesson] = &[
    ("refraction/air-bubble", a_bubble_diverges_and_its_rim_reflects_totally),
    ("refraction/apparent-depth", rays_seem_to_come_from_depth_over_n),
    ("refraction/brewster-p", p_is_not_reflected_at_brewsters_angle),
    ("refraction/brewster-s", reflected_stands_at_90_to_refracted),
    ("refraction/fixed-shares", a_tenth_stays_at_every_hit),
    ("refraction/index-matching", equal_indices_leave_rays_alone),
    ("refraction/into-denser", bends_toward_the_normal),
    ("refraction/into-thinner", bends_away_from_the_normal),
    ("refraction/protractor", the_half_disk_bends_only_at_its_flat_face),
    ("refraction/slab-displacement", displaced_and_not_turned),
    ("refraction/slab-reflections", parallel_rays_in_geometric_series),
    ("refraction/wavefronts", wavefronts_stay_across_the_rays),
];

fn the_half_disk_bends_only_at_its_flat_face(run: &Run) {
    let ray = only_ray(run);
    near(theta_i(ray, ""), 0.0, 1e-9);
    near(theta_i(ray, "t"), 35.0, 1e-3);
    near(theta_t(ray, "t"), asin(1.5 * sin(theta_i(ray, "t"))), 1e-12);
    near(theta_t(ray, "t"), 59.4, 0.05);
}

/// Points of equal optical path on neighboring rays: the line through them stands across the rays before and behind.
fn wavefronts_stay_across_the_rays(run: &Run) {
    let after = |number: usize, optical_path: f64| {
        let (entry, inside) = (segment(ray(run, 0, number), ""), segment(ray(run, 0, number), "t"));
        inside.from + inside.direction * ((optical_path - entry.optical_path) / inside.medium_index)
    };
    let entry = segment(ray(run, 0, 0), "").optical_path.max(segment(ray(run, 0, 8), "").optical_path);
    let direction = segment(ray(run, 0, 4), "t").direction;
    for number in 0..8 {
        near(direction.dot(after(number + 1, entry + 5.0) - after(number, entry + 5.0)), 0.0, 1e-12);
        near((after(number, entry + 10.0) - after(number, entry + 5.0)).length(), 5.0 / 1.5, 1e-12);
    }
    near(5.0 / 1.5, 3.3, 0.05);
}

fn bends_toward_the_normal(run: &Run) {
    let n = index("N-BK7");
    let ray = only_ray(run);
    near(theta_i(ray, ""), 45.0, 1e-12);
    near(theta_t(ray, ""), asin(sin(45.0) / n), 1e-12);
    assert!(theta_t(ray, "") < theta_i(ray, ""));
    let (s, p) = fresnel(1.0, n, 45.0);
    near(segment(ray, "r").power.total(), 0.5 * (s + p), 1e-14);
    near(segment(ray, "r").power.total(), 0.053, 5e-4);
    near(segment(ray, "t").power.total(), 1.0 - 0.5 * (s + p), 1e-14);
}

fn bends_away_from_the_normal(run: &Run) {
    let n = index("water");
    let ray = only_ray(run);
    near(theta_i(ray, ""), 30.0, 0.01);
    near(theta_t(ray, ""), asin(n * sin(theta_i(ray, ""))), 1e-12);
    assert!(theta_t(ray, "") > theta_i(ray, ""));
    let (s, p) = fresnel(n, 1.0, theta_i(ray, ""));
    near(segment(ray, "r").power.total(), 0.5 * (s + p), 1e-14);
    near(segment(ray, "r").power.total(), 0.026, 5e-4);
}

fn displaced_and_not_turned(run: &Run) {
    let ray = only_ray(run);
    let (entry, exit) = (segment(ray, ""), exit(ray));
    along(exit.direction, entry.direction, 1e-13);
    let inside = asin(sin(50.0) / index("N-BK7"));
    let displacement = 30.0 * sin(50.0 - inside) / crate::measure::cos(inside);
    // To the right of a ray that goes down to the right: below its line.
    near(offset(entry, exit), -displacement, 1e-12);
    near(displacement, 11.7, 0.05);
}

/// s light loses R at the first face; each round trip inside leaves R² of it.
fn parallel_rays_in_geometric_series(run: &Run) {
    let ray = only_ray(run);
    let (r, _) = fresnel(1.0, index("N-SF6"), 70.0);
    let entry = segment(ray, "").direction;
    near(segment(ray, "r").power.total(), r, 1e-14);
    for bounces in 0..4 {
        let inside = "r".repeat(2 * bounces);
        let below = segment(ray, &format!("t{inside}t"));
        let above = segment(ray, &format!("tr{inside}t"));
        let expected = (1.0 - r) * (1.0 - r) * (0..bounces).map(|_| r * r).product::<f64>();
        near(below.power.total() / expected, 1.0, 1e-12);
        near(above.power.total() / (expected * r), 1.0, 1e-12);
        along(below.direction, entry, 1e-13);
        along(above.direction, DVec2::new(entry.x, -entry.y), 1e-13);
    }
    near(r, 0.406, 5e-4);
    near(r * r, 0.164, 5e-4);
}

fn reflected_stands_at_90_to_refracted(run: &Run) {
    let ray = only_ray(run);
    near(tan(theta_i(ray, "")), 1.5, 1e-14);
    let (reflected, refracted) = (segment(ray, "r"), segment(ray, "t"));
    near(reflected.direction.dot(refracted.direction), 0.0, 1e-15);
    // ((n² − 1)/(n² + 1))² = (5/13)².
    near(reflected.power.total(), 25.0 / 169.0, 1e-15);
    near(25.0 / 169.0, 0.148, 5e-4);
}

fn p_is_not_reflected_at_brewsters_angle(run: &Run) {
    let ray = only_ray(run);
    let (incoming, refracted) = (segment(ray, ""), segment(ray, "t"));
    near(tan(theta_i(ray, "")), 1.5, 1e-14);
    near(theta_i(ray, ""), 56.3, 0.05);
    let reflected = DVec2::new(incoming.direction.x, -incoming.direction.y);
    near(reflected.dot(refracted.direction), 0.0, 1e-15);
    assert!(incoming.hit.unwrap().reflectance.p < 1e-30);
    assert!(incoming.hit.unwrap().reflectance.s > 0.1, "s light would be reflected");
    near(refracted.power.total(), 1.0, 1e-15);
}

fn rays_seem_to_come_from_depth_over_n(run: &Run) {
    const DEPTH: f64 = 40.0;
    let n = index("water");
    for number in [0, 1, 3, 4] {
        let ray = ray(run, 0, number);
        let apparent = depth_of_image(run, number);
        near(apparent, DEPTH * tan(theta_i(ray, "")) / tan(theta_t(ray, "")), 1e-12);
        assert!(apparent < DEPTH / n, "oblique rays meet the axis even higher");
        near(apparent, 30.0, 1.0);
    }
    let near_normal = changed(run, |scene| {
        let Light::Fan { spread, .. } = &mut scene.sources[0].light else { panic!("a fan") };
        *spread = 1e-3;
    });
    near(depth_of_image(&near_normal, 0), DEPTH / n, 1e-8);
    near(DEPTH / n, 30.0, 0.05);
}

/// Depth below the surface y = 0 at which a ray in the air, drawn backward, meets the vertical through the coin.
fn depth_of_image(run: &Run, number: usize) -> f64 {
    let exit = exit(ray(run, 0, number));
    exit.from.x * exit.direction.y / exit.direction.x
}

fn a_tenth_stays_at_every_hit(run: &Run) {
    let ray = only_ray(run);
    for (path, power) in [("r", 0.3), ("tt", 0.36), ("trt", 0.108), ("trrt", 0.0324)] {
        near(segment(ray, path).power.total(), power, 1e-15);
    }
    for hit in ray.segments.iter().filter_map(|segment| segment.hit) {
        near(hit.absorptance, 0.1, 1e-15);
        assert_eq!((hit.reflectance.s, hit.reflectance.p), (0.3, 0.3), "whatever the angle and the polarization");
    }
    // What stays of the first hits: 0.1 · (1 + 0.6 + 0.6 · 0.3 + …), 0.6 · (1 + 0.3 + …) being inside.
    let whole = changed(run, |scene| scene.trace.min_power = 0.0);
    near(whole.trace.summary.balance.absorbed.value(), 0.1 * (1.0 + 0.6 / 0.7), 1e-12);
}

fn equal_indices_leave_rays_alone(run: &Run) {
    const RADIUS: f64 = 12.0;
    let relative = index("water") / 1.474;
    for number in 0..6 {
        let in_glycerol = ray(run, 1, number);
        assert_eq!(path(in_glycerol, exit(in_glycerol)), "tt", "in and out of the tank, and nothing in it");
        assert_eq!(exit(in_glycerol).direction, DVec2::NEG_Y);
        assert_eq!(exit(in_glycerol).from.x, in_glycerol.segments[0].from.x);

        let in_water = ray(run, 0, number);
        let height = in_water.segments[0].from.x + 45.0;
        let bent = turn(DVec2::NEG_Y, segment(in_water, "ttt").direction);
        near(bent, -2.0 * (asin(height / RADIUS) - asin(relative * height / RADIUS)), 1e-11);
        assert!(bent * height < 0.0, "toward the axis");
    }
}

fn a_bubble_diverges_and_its_rim_reflects_totally(run: &Run) {
    const RADIUS: f64 = 20.0;
    let n = index("water");
    near(RADIUS / n, 15.0, 0.05);
    for number in 0..9 {
        let ray = ray(run, 0, number);
        let height = ray.segments[0].from.y;
        let leaving = exit(ray);
        if height.abs() > RADIUS / n {
            assert_eq!(path(ray, leaving), "i");
            assert!(theta_i(ray, "") > asin(1.0 / n));
        } else {
            assert_eq!(path(ray, leaving), "tt");
            let bent = 2.0 * (asin(n * height / RADIUS) - asin(height / RADIUS));
            near(turn(DVec2::X, leaving.direction), bent, 1e-11);
        }
    }
}
