//! The ideal thin lens and its images.

use glam::DVec2;

use snellius::trace::Segment;

use crate::rays::{assert_near, distance, is_ahead, meet, out, rays, slope, y_at};
use crate::support::Run;

/// The way behind the lens of the parallel, the center and the focus ray.
fn behind(run: &Run) -> [&Segment; 3] {
    ["parallel", "center", "focus"].map(|source| out(rays(run, source)[0]))
}

/// The image point from the lens equation 1/s + 1/s′ = 1/f for a lens at the origin.
fn image(object: DVec2, focal_length: f64) -> DVec2 {
    let s = -object.x;
    let behind = 1.0 / (1.0 / focal_length - 1.0 / s);
    DVec2::new(behind, -object.y * behind / s)
}

/// Each of the three does what it is named for, and all meet in the image point.
fn assert_principal_rays(run: &Run, object: DVec2, focal_length: f64) -> DVec2 {
    let [parallel, center, focus] = behind(run);
    assert_near(y_at(parallel, focal_length), 0.0, 1e-12, "the parallel ray goes through F′");
    assert_near(slope(center), object.y / object.x, 1e-15, "the center ray goes straight on");
    assert_near(slope(focus), 0.0, 1e-15, "the ray through F leaves parallel");
    let ahead = rays(run, "focus")[0].segments[0];
    assert_near(y_at(&ahead, -focal_length), 0.0, 1e-12, "the ray aimed at F");
    let image = image(object, focal_length);
    for pair in [[parallel, center], [center, focus], [parallel, focus]] {
        let found = meet(pair[0], pair[1]);
        assert!(found.distance(image) < 1e-12 * image.length(), "{found} instead of {image}");
        assert_near(1.0 / -object.x + 1.0 / found.x, 1.0 / focal_length, 1e-15, "1/s + 1/s′ = 1/f");
    }
    image
}

pub(crate) fn three_principal_rays_meet_in_the_image(run: &Run) {
    let image = assert_principal_rays(run, DVec2::new(-60.0, 12.0), 40.0);
    assert!(image.distance(DVec2::new(120.0, -24.0)) < 1e-12, "the caption's image: {image}");
    let hits = &run.trace.summary.screens[0].hits;
    assert_eq!(hits.len(), 3);
    for hit in hits {
        assert_near(hit.position, 24.0, 1e-12, "place on the screen");
    }
}

/// The three rays spread behind the lens from an upright virtual image in front of it.
fn assert_virtual_image(run: &Run, image: DVec2) {
    assert!(image.x < 0.0 && image.y > 0.0, "upright and in front of the lens: {image}");
    for ray in behind(run) {
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
