//! The ideal thin lens and its images.

use glam::DVec2;

use snellius::trace::{Segment, TracedRay};

use crate::rays::{assert_near, distance, images, is_ahead, meet, out, rays, slope, y_at};
use crate::support::Run;

/// The object's parallel, center and focus ray, and the way of each behind the lens.
fn principal(run: &Run) -> [(&TracedRay, &Segment); 3] {
    let rays = rays(run, "object");
    assert_eq!(rays.len(), 3);
    [0, 1, 2].map(|k| (rays[k], out(rays[k])))
}

/// The image point from the lens equation 1/s + 1/s′ = 1/f for a lens at the origin.
fn image(object: DVec2, focal_length: f64) -> DVec2 {
    let s = -object.x;
    let behind = 1.0 / (1.0 / focal_length - 1.0 / s);
    DVec2::new(behind, -object.y * behind / s)
}

/// Each of the three does what it is named for, and all meet in the image point.
fn assert_principal_rays(run: &Run, object: DVec2, focal_length: f64) -> DVec2 {
    let [(first, parallel), (_, center), (third, focus)] = principal(run);
    assert_near(slope(&first.segments[0]), 0.0, 1e-15, "the parallel ray");
    assert_near(y_at(parallel, focal_length), 0.0, 1e-12, "the parallel ray goes through F′");
    assert_near(slope(center), object.y / object.x, 1e-15, "the center ray goes straight on");
    assert_near(slope(focus), 0.0, 1e-15, "the ray through F leaves parallel");
    assert_near(y_at(&third.segments[0], -focal_length), 0.0, 1e-12, "the ray aimed at F");
    let image = image(object, focal_length);
    for pair in [[parallel, center], [center, focus], [parallel, focus]] {
        let found = meet(pair[0], pair[1]);
        assert!(found.distance(image) < 1e-12 * image.length(), "{found} instead of {image}");
        assert_near(1.0 / -object.x + 1.0 / found.x, 1.0 / focal_length, 1e-15, "1/s + 1/s′ = 1/f");
    }
    let drawn = images(run);
    assert!(drawn[0].tip.distance(image) < 1e-12 * image.length(), "the arrow that is drawn: {:?}", drawn[0]);
    assert!(drawn[0].foot.distance(DVec2::new(image.x, 0.0)) < 1e-12 * image.length());
    image
}

pub(crate) fn three_principal_rays_meet_in_the_image(run: &Run) {
    let image = assert_principal_rays(run, DVec2::new(-60.0, 12.0), 40.0);
    assert!(image.distance(DVec2::new(120.0, -24.0)) < 1e-12, "the caption's image: {image}");
    assert!(images(run)[0].is_real && principal(run).iter().all(|(_, ray)| is_ahead(ray, image)), "light gets there");
}

/// The three rays spread behind the lens from an upright virtual image in front of it.
fn assert_virtual_image(run: &Run, image: DVec2) {
    assert!(image.x < 0.0 && image.y > 0.0, "upright and in front of the lens: {image}");
    assert!(!images(run)[0].is_real);
    for (_, ray) in principal(run) {
        assert!(distance(ray, image) < 1e-12, "{} from the image", distance(ray, image));
        assert!(!is_ahead(ray, image), "no light gets there");
    }
}

pub(crate) fn a_magnifier_makes_a_large_virtual_image(run: &Run) {
    let image = assert_principal_rays(run, DVec2::new(-25.0, 8.0), 40.0);
    assert_virtual_image(run, image);
    assert_near(image.x, -66.7, 0.05, "the caption's distance");
    assert_near(image.y / 8.0, 2.67, 0.005, "the caption's magnification");
}

pub(crate) fn a_diverging_lens_makes_a_small_virtual_image(run: &Run) {
    let image = assert_principal_rays(run, DVec2::new(-60.0, 20.0), -40.0);
    assert_virtual_image(run, image);
    assert!(image.distance(DVec2::new(-24.0, 8.0)) < 1e-12, "the caption's image: {image}");
}
