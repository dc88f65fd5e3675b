//! Scenes of `scenes/mirrors`.

use glam::DVec2;
use snellius::scene::{Direction, Light};
use snellius::trace::{Segment, TracedRay};

use crate::Lesson;
use crate::measure::{asin, changed, cos, sin};
use crate::rays::{assert_near, distance, focus, height, images, is_ahead, meet, out, rays, shrunk, slope, x_at};
use crate::support::Run;

pub(crate) const LESSONS: &[Lesson] = &[
    ("mirrors/caustic", reflected_rays_touch_the_nephroid),
    ("mirrors/center-of-curvature", light_from_the_center_comes_back),
    ("mirrors/concave", a_concave_mirror_focuses_at_half_its_radius),
    ("mirrors/concave-image", a_concave_mirror_images_what_stands_beyond_its_focus),
    ("mirrors/convex", a_convex_mirror_has_a_virtual_focus_at_half_its_radius),
    ("mirrors/convex-image", a_convex_mirror_shows_things_smaller),
    ("mirrors/optical-square", two_mirrors_turn_by_twice_their_angle),
    ("mirrors/plane", a_plane_mirror_images_behind_itself),
    ("mirrors/retroreflecting-ball", a_ball_of_index_two_sends_light_back),
    ("mirrors/shaving-mirror", a_shaving_mirror_magnifies),
];

/// The rays of a source off the axis, each with its height.
fn off_axis<'a>(run: &'a Run, source: &str) -> Vec<(&'a TracedRay, f64)> {
    let all = rays(run, source).into_iter().map(|ray| (ray, height(ray, 0.0)));
    all.filter(|(_, h)| h.abs() > 1e-9).collect()
}

/// How far from its center of curvature a mirror of radius R sends a ray across the axis: R/(2 cos θ).
fn from_center(radius: f64, h: f64) -> f64 {
    radius / (2.0 * (1.0 - (h / radius) * (h / radius)).sqrt())
}

pub(crate) fn a_concave_mirror_focuses_at_half_its_radius(run: &Run) {
    assert_near(focus(run, "beam", 0.0), -32.5, 1e-6, "f = R/2");
    for (ray, h) in off_axis(run, "beam") {
        let crossing = x_at(out(ray), 0.0);
        assert_near(crossing, -65.0 + from_center(65.0, h), 1e-10, "crossing of the axis");
        assert!(is_ahead(out(ray), DVec2::new(crossing, 0.0)), "light gets there");
    }
}

pub(crate) fn a_convex_mirror_has_a_virtual_focus_at_half_its_radius(run: &Run) {
    assert_near(focus(run, "beam", 0.0), 32.5, 1e-6, "f = R/2");
    for (ray, h) in off_axis(run, "beam") {
        let crossing = x_at(out(ray), 0.0);
        assert_near(crossing, 65.0 - from_center(65.0, h), 1e-10, "crossing of the axis");
        assert!(!is_ahead(out(ray), DVec2::new(crossing, 0.0)), "no light gets there");
    }
}

pub(crate) fn reflected_rays_touch_the_nephroid(run: &Run) {
    for (ray, h) in off_axis(run, "beam") {
        assert_eq!(ray.segments.len(), 2, "one reflection");
        let reflected = out(ray);
        assert_near(x_at(reflected, 0.0), from_center(50.0, h), 1e-9, "crossing of the axis");
        let theta = asin(h / 50.0);
        let touched = 12.5 * DVec2::new(3.0 * cos(theta) - cos(3.0 * theta), 3.0 * sin(theta) - sin(3.0 * theta));
        assert!(distance(reflected, touched) < 1e-12, "{} from the nephroid", distance(reflected, touched));
        let tangent = DVec2::new(sin(3.0 * theta) - sin(theta), cos(theta) - cos(3.0 * theta)).normalize();
        assert!(reflected.direction.perp_dot(tangent).abs() < 1e-12, "touched, not crossed");
    }
}

/// The reflected rays of a source.
fn reflected<'a>(run: &'a Run, source: &str) -> Vec<&'a Segment> {
    rays(run, source).into_iter().map(out).collect()
}

pub(crate) fn light_from_the_center_comes_back(run: &Run) {
    for ray in rays(run, "center") {
        assert!(out(ray).direction.distance(-ray.segments[0].direction) < 1e-14, "straight back");
        assert!(distance(out(ray), DVec2::ZERO) < 1e-13, "to the center");
    }
    let tip = reflected(run, "tip");
    let image = DVec2::new(0.0, -6.0);
    assert!(distance(tip[2], image) < 1e-13, "the ray by the mirror's vertex");
    assert!(tip.iter().all(|ray| distance(ray, image) < 0.5), "the others come near");
    let small = changed(run, |scene| {
        let from = DVec2::new(0.0, 1e-3);
        scene.sources[1].light = Light::Fan { from, direction: Direction::Angle(0.0), spread: 40.0, rays: 5 };
    });
    let tip = reflected(&small, "tip");
    assert!(tip.iter().all(|ray| distance(ray, DVec2::new(0.0, -1e-3)) < 1e-7), "a small object's image is sharp");
}

pub(crate) fn two_mirrors_turn_by_twice_their_angle(run: &Run) {
    for source in ["steep", "flat"] {
        let ray = rays(run, source)[0];
        assert_eq!(ray.segments.len(), 3, "two reflections");
        let turned = out(ray).direction;
        assert!(turned.distance(ray.segments[0].direction.perp()) < 1e-14, "{source}: by 90°");
    }
    let [steep, flat] = ["steep", "flat"].map(|source| slope(out(rays(run, source)[0])));
    assert!((steep - flat).abs() > 0.1, "different rays");
}

/// The image of a small object at the place and of the height that the caption tells, and that of the scene's nearly.
fn assert_image(run: &Run, image: DVec2, is_real: bool) {
    for (share, tolerance) in [(1e-3, 1e-6), (1.0, 0.03)] {
        let found = images(&shrunk(run, share));
        assert_eq!((found.len(), found[0].is_real), (1, is_real));
        assert_near(found[0].tip.x / image.x, 1.0, tolerance, "place of the image");
        assert_near(found[0].tip.y / (share * image.y), 1.0, tolerance, "height of the image");
        assert_eq!((found[0].foot.x, found[0].foot.y.abs() < 1e-12), (found[0].tip.x, true), "across the axis");
    }
}

pub(crate) fn a_concave_mirror_images_what_stands_beyond_its_focus(run: &Run) {
    assert_image(run, DVec2::new(-120.0, -10.0), true);
}

pub(crate) fn a_shaving_mirror_magnifies(run: &Run) {
    assert_image(run, DVec2::new(40.0, 10.0), false);
}

pub(crate) fn a_convex_mirror_shows_things_smaller(run: &Run) {
    assert_image(run, DVec2::new(24.0, 4.8), false);
}

pub(crate) fn a_plane_mirror_images_behind_itself(run: &Run) {
    let reflected = reflected(run, "object");
    let image = DVec2::new(40.0, 14.0);
    for pair in reflected.windows(2) {
        assert!(meet(pair[0], pair[1]).distance(image) < 1e-12, "as far behind as the source is in front");
    }
    assert!(reflected.iter().all(|ray| !is_ahead(ray, image)), "no light gets there");
    let drawn = images(run);
    assert!(
        drawn[0].tip.distance(image) < 1e-12 && drawn[0].foot.distance(DVec2::new(40.0, -4.0)) < 1e-12,
        "{drawn:?}"
    );
    for ray in rays(run, "object") {
        let [on, back] = [ray.segments[0].direction, out(ray).direction];
        assert!(back.distance(DVec2::new(-on.x, on.y)) < 1e-15, "angle out is angle in");
    }
}

pub(crate) fn a_ball_of_index_two_sends_light_back(run: &Run) {
    let mut errors = Vec::new();
    for (ray, h) in off_axis(run, "beam") {
        assert_eq!(ray.segments.len(), 4, "in, to the back, to the front, out");
        let (entering, inside) = (asin(h / 20.0), asin(h / 40.0));
        let error = 2.0 * entering - 4.0 * inside;
        let expected = DVec2::new(-cos(error), sin(error));
        assert!(out(ray).direction.distance(expected) < 1e-14, "turned by 180° less 2 θ₁ − 4 θ₂");
        errors.push((h, error));
    }
    assert_eq!(errors.len(), 3);
    assert_near(errors[1].1, 0.7, 0.06, "the caption's error");
    let cubic = |(h, error): (f64, f64)| error / (h * h * h);
    assert_near(cubic(errors[0]) / cubic(errors[1]), 1.0, 0.1, "it falls with the cube of the height");
}
