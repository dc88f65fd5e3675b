//! Several lenses together: telescopes, a relay, a camera, a Cooke triplet.

use glam::DVec2;

use snellius::trace::{Ending, Segment, TracedRay};

use crate::measure::tan;
use crate::rays::{assert_near, distance, images, narrowed, out, rays, shrunk, slope, spread, x_at, y_at};
use crate::support::Run;

/// The way between the first and the second lens.
fn between(ray: &TracedRay) -> &Segment {
    &ray.segments[1]
}

pub(crate) fn the_beam_leaves_parallel_and_three_times_as_wide(run: &Run) {
    let laser = rays(run, "laser");
    for ray in &laser {
        assert_near(slope(out(ray)), 0.0, 1e-15, "parallel");
        assert_near(out(ray).from.y, 3.0 * ray.segments[0].from.y, 1e-12, "height");
        assert!(distance(between(ray), DVec2::new(-30.0, 0.0)) < 1e-12, "from the common focus");
    }
    let width = |y: fn(&TracedRay) -> f64| spread(laser.iter().map(|ray| y(ray)));
    assert_near(width(|ray| out(ray).from.y) / width(|ray| ray.segments[0].from.y), 90.0 / 30.0, 1e-14, "width");
}

/// Both stars leave the telescope parallel, their slopes and widths changed by −f1/f2 and f2/f1.
fn assert_telescope(run: &Run, focal_lengths: [f64; 2]) {
    let [first, second] = focal_lengths;
    let magnification = -first / second;
    for (source, degrees) in [("star on the axis", 0.0), ("star off the axis", 3.0)] {
        let star = rays(run, source);
        let before = tan(degrees);
        for ray in &star {
            assert_near(slope(&ray.segments[0]), before, 1e-15, "slope before");
            assert_near(slope(out(ray)), magnification * before, 1e-14, "slope behind");
            assert!(distance(between(ray), DVec2::new(first, first * before)) < 1e-12, "through the image of the star");
        }
        let widths = [1, 2].map(|k| spread(star.iter().map(|ray| ray.segments[k].from.y)));
        assert_near(widths[0] / widths[1], magnification.abs(), 1e-12, "width");
    }
    assert_near(tan(11.8), 4.0 * tan(3.0), 0.001, "the caption's angle");
}

pub(crate) fn kepler_turns_light_four_times_as_far_to_the_other_side(run: &Run) {
    assert_telescope(run, [80.0, 20.0]);
    assert!(rays(run, "star off the axis").iter().all(|ray| slope(out(ray)) < 0.0));
}

pub(crate) fn galileo_turns_light_four_times_as_far(run: &Run) {
    assert_telescope(run, [80.0, -20.0]);
    assert!(rays(run, "star off the axis").iter().all(|ray| slope(out(ray)) > 0.0));
}

pub(crate) fn a_relay_images_upside_down_by_the_ratio_of_focal_lengths(run: &Run) {
    for (source, y) in [("tip", 10.0), ("foot", 0.0)] {
        for ray in rays(run, source) {
            assert_near(slope(between(ray)), -y / 30.0, 1e-15, "parallel between the lenses");
            assert_eq!(out(ray).ending, Ending::Detected);
            assert_near(out(ray).to.unwrap().y, -y * 45.0 / 30.0, 1e-12, "image");
        }
    }
}

pub(crate) fn the_second_lens_images_the_first_image(run: &Run) {
    let found = images(run);
    assert_eq!(found.len(), 2);
    let [first, second] = [&found[0], &found[1]];
    assert!(first.is_real && first.is_intermediate && second.is_real && !second.is_intermediate);
    assert!(first.tip.distance(DVec2::new(50.0 + 75.0, -1.5 * 6.0)) < 1e-11, "1/50 + 1/75 = 1/30: {first:?}");
    assert!(second.tip.distance(DVec2::new(185.0 + 60.0, 1.5 * 6.0)) < 1e-11, "1/60 + 1/60 = 1/30: {second:?}");
}

pub(crate) fn distances_count_from_the_principal_planes(run: &Run) {
    let power = 0.8 * (2.0 / 90.0 - 0.8 * 24.0 / (1.8 * 90.0 * 90.0));
    let front = -12.0 + 0.8 * 24.0 / (1.8 * 90.0 * power);
    let s = 110.0 + front;
    let behind = 1.0 / (power - 1.0 / s);
    assert_near(1.0 / power, 59.8, 0.05, "the caption's focal length");
    assert_near(s, 105.1, 0.05, "the caption's distance to H");
    assert_near(behind, 138.7, 0.05, "the caption's distance from H′");
    let small = images(&shrunk(run, 1e-3));
    assert!(small[0].tip.distance(DVec2::new(behind - front, -6e-3 * behind / s)) < 1e-4, "{small:?}");
    let drawn = images(run);
    assert!(
        ((behind - front - drawn[0].tip.x) / behind - 0.03).abs() < 0.005,
        "the arrow stands a little short: {drawn:?}"
    );
    // The ray through the principal planes: out at the height at which it was aimed.
    let run = &shrunk(run, 1e-3);
    for ray in rays(run, "object") {
        assert_near(y_at(out(ray), -front), y_at(&ray.segments[0], front), 1e-8, "the same height");
    }
}

pub(crate) fn only_the_far_point_is_sharp_on_the_film(run: &Run) {
    for ray in rays(run, "far") {
        assert_near(out(ray).to.unwrap().y, 0.0, 1e-12, "1/90 + 1/45 = 1/30");
    }
    for ray in rays(run, "near") {
        assert_near(out(ray).to.unwrap().y, 0.25 * out(ray).from.y, 1e-12, "a quarter of the beam");
        assert_near(y_at(out(ray), 45.0 + 15.0), 0.0, 1e-12, "1/60 + 1/60 = 1/30");
    }
}

/// y where a ray passes x.
fn y_passing(ray: &TracedRay, x: f64) -> f64 {
    let there = |segment: &&Segment| segment.from.x <= x && segment.to.is_some_and(|to| to.x > x);
    y_at(ray.segments.iter().find(there).unwrap(), x)
}

pub(crate) fn three_fields_pass_the_stop_and_are_sharp(run: &Run) {
    let narrow = narrowed(run, 1e-3);
    let axial = out(rays(&narrow, "0°")[1]);
    // The prescription's values, computed with 60 digits.
    let (focal_length, back) = (50.000_286_971_920_39, 43.080_280_070_425_78);
    assert_near(-1e-3 / slope(axial), focal_length, 1e-6, "focal length");
    assert_near(x_at(axial, 0.0), 17.0 + back, 1e-6, "focus");
    for (source, degrees) in [("0°", 0.0), ("7°", 7.0), ("14°", 14.0)] {
        let field = rays(run, source);
        assert_eq!(field.len(), 5);
        assert!(field.iter().all(|ray| out(ray).ending == Ending::Detected && ray.segments.len() == 7), "{source}");
        let at_stop: Vec<_> = field.iter().map(|ray| y_passing(ray, 12.0)).collect();
        assert!(at_stop.iter().all(|y| y.abs() < 3.1), "{source} passes the stop: {at_stop:?}");
        assert!(spread(at_stop) > 0.95 * 6.2, "{source} fills the stop");
        let image = || field.iter().map(|ray| out(ray).to.unwrap().y);
        assert!(spread(image()) < 0.06, "{source} is sharp: {}", spread(image()));
        let expected = focal_length * tan(degrees);
        assert_near(image().sum::<f64>() / 5.0, expected, 0.03, "image height f tan θ");
    }
}
