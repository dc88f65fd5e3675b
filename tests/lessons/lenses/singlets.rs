//! Single lenses and where they focus.

use snellius::scene::{Light, Medium, Scene, Substance};

use crate::measure::{changed, index};
use crate::rays::{
    Face, assert_cross_as_computed, assert_near, focus, is_ahead, lensmaker, narrowed, out, rays, slope, spread, x_at,
};
use crate::support::Run;

pub(crate) fn a_biconvex_lens_focuses_where_the_lensmaker_says(run: &Run) {
    let n = index("N-BK7");
    let (_, back) = lensmaker(n, [50.0, -50.0], 6.0);
    assert_near(back, 47.4, 0.05, "the caption's back focal length");
    assert_near(focus(run, "beam", 0.0), 3.0 + back, 1e-6, "focus");
    let faces = [Face { vertex: -3.0, radius: 50.0, index: n }, Face { vertex: 3.0, radius: -50.0, index: 1.0 }];
    assert_cross_as_computed(run, "beam", 0.0, &faces);
}

/// Plane wavefronts leave as arcs about the focus: near the axis the optical paths to it are equal, farther out they differ
/// by the aberration, which grows with the fourth power of the height.
pub(crate) fn all_ways_to_the_focus_take_equally_long(run: &Run) {
    let focus = glam::DVec2::new(7.0 + lensmaker(index("N-BK7"), [50.0, -50.0], 14.0).1, 0.0);
    let differs = |height: f64| {
        let run = changed(run, |scene| {
            if let Light::Beam { width, rays, .. } = &mut scene.sources[0].light {
                (*width, *rays) = (2.0 * height, 3);
            }
        });
        let ways = rays(&run, "beam").into_iter().map(|ray| {
            let last = out(ray);
            last.optical_path + last.medium_index * (focus - last.from).length()
        });
        spread(ways)
    };
    assert!(differs(0.5) < 1e-5, "{}", differs(0.5));
    let grows = differs(4.0) / differs(2.0);
    assert!((14.0..18.0).contains(&grows), "{grows}");
}

pub(crate) fn a_biconcave_lens_has_a_virtual_focus(run: &Run) {
    let n = index("N-BK7");
    let (_, back) = lensmaker(n, [-40.0, 40.0], 3.0);
    assert_near(back, -39.2, 0.05, "the caption's virtual focus");
    assert_near(focus(run, "beam", 0.0), 1.5 + back, 1e-6, "virtual focus");
    let faces = [Face { vertex: -1.5, radius: -40.0, index: n }, Face { vertex: 1.5, radius: 40.0, index: 1.0 }];
    assert_cross_as_computed(run, "beam", 0.0, &faces);
    for ray in rays(run, "beam").into_iter().filter(|ray| slope(out(ray)) != 0.0) {
        let crossing = glam::DVec2::new(x_at(out(ray), 0.0), 0.0);
        assert!(!is_ahead(out(ray), crossing), "only the backward extension meets the axis");
    }
}

pub(crate) fn the_thick_middle_gathers_and_the_thin_one_spreads(run: &Run) {
    let n = index("N-BK7");
    let thick = ("upper", 16.0, [20.0, 40.0], 5.0, 71.0);
    let thin = ("lower", -16.0, [40.0, 20.0], 2.0, -80.0);
    for (source, axis, radii, thickness, caption) in [thick, thin] {
        let (focal_length, back) = lensmaker(n, radii, thickness);
        assert_near(focal_length, caption, 0.5, "the caption's focal length");
        assert_near(focus(run, source, axis), 0.5 * thickness + back, 1e-6, "focus");
        let upper_ray = out(rays(run, source).last().unwrap());
        assert_eq!(slope(upper_ray) < 0.0, focal_length > 0.0, "{source}: toward the axis or away from it");
        let front = Face { vertex: -0.5 * thickness, radius: radii[0], index: n };
        let rear = Face { vertex: 0.5 * thickness, radius: radii[1], index: 1.0 };
        assert_cross_as_computed(run, source, axis, &[front, rear]);
    }
}

pub(crate) fn a_ball_focuses_by_its_closed_form(run: &Run) {
    let n = index("N-BK7");
    let focal_length = n * 20.0 / (4.0 * (n - 1.0));
    assert_near(focal_length, 14.7, 0.05, "the caption's focal length");
    assert_near(focus(run, "beam", 0.0), focal_length, 1e-6, "focus from the center");
    let narrow = narrowed(run, 1e-3);
    assert_near(-1e-3 / slope(out(rays(&narrow, "beam")[1])), focal_length, 1e-6, "focal length");
    let faces = [Face { vertex: -10.0, radius: 10.0, index: n }, Face { vertex: 10.0, radius: -10.0, index: 1.0 }];
    assert_cross_as_computed(run, "beam", 0.0, &faces);
}

pub(crate) fn an_air_lens_in_water_spreads_what_a_glass_one_gathers(run: &Run) {
    let relative = index("air") / index("water");
    assert_near(relative, 0.75, 0.001, "the caption's ratio");
    let (_, back) = lensmaker(relative, [40.0, -40.0], 8.0);
    assert!(back < 0.0, "the lens spreads");
    assert_near(focus(run, "beam", 0.0), 4.0 + back, 1e-6, "virtual focus");
    let faces = [Face { vertex: -4.0, radius: 40.0, index: relative }, Face { vertex: 4.0, radius: -40.0, index: 1.0 }];
    assert_cross_as_computed(run, "beam", 0.0, &faces);
    let of_glass = |scene: &mut Scene| scene.bodies[0].substance = Substance::Medium(Medium::Catalog("N-BK7".into()));
    let (_, back) = lensmaker(index("N-BK7") / index("water"), [40.0, -40.0], 8.0);
    assert!(back > 0.0, "a lens of glass gathers");
    assert_near(focus(&changed(run, of_glass), "beam", 0.0), 4.0 + back, 1e-6, "focus of the same lens of glass");
}
