//! What keeps a lens from a perfect focus: round faces, color, flat facets.

use snellius::analysis::irradiance;
use snellius::light::Wavelength;
use snellius::trace::TracedRay;

use crate::measure::{index, index_at};
use crate::rays::{
    Face, assert_cross_as_computed, assert_near, axis_crossing, focus, height, lensmaker, narrowed, out, rays, slope,
    spread, x_at,
};
use crate::support::Run;

const LINES: [Wavelength; 3] = [Wavelength::HYDROGEN_F, Wavelength::D, Wavelength::HYDROGEN_C];

/// Third-order spherical aberration of a thin lens for a distant object, but for a factor that its shape does not change:
/// Jenkins and White, "Fundamentals of Optics", 4th ed., section 9.4, shape factor q = (r2 + r1)/(r2 − r1), p = −1.
fn spherical_aberration(n: f64, q: f64) -> f64 {
    (n + 2.0) / (n - 1.0) * q * q - 4.0 * (n + 1.0) * q + (3.0 * n + 2.0) * (n - 1.0) + n * n * n / (n - 1.0)
}

pub(crate) fn the_curved_face_first_is_four_times_better(run: &Run) {
    let n = index("N-BK7");
    let faces = |radii: [f64; 2]| {
        [Face { vertex: -3.0, radius: radii[0], index: n }, Face { vertex: 3.0, radius: radii[1], index: 1.0 }]
    };
    let ways = [("upper", 12.5, [31.0, f64::INFINITY], 1.2), ("lower", -12.5, [f64::INFINITY, -31.0], 4.7)];
    let errors = ways.map(|(source, axis, radii, caption)| {
        assert_cross_as_computed(run, source, axis, &faces(radii));
        let (_, back) = lensmaker(n, radii, 6.0);
        assert_near(focus(run, source, axis), 3.0 + back, 1e-6, "focus");
        let error = |run: &Run| 3.0 + back - x_at(out(rays(run, source).last().unwrap()), axis);
        assert_near(error(run), caption, 0.05, "the caption's error of the rim ray");
        [error(run), error(&narrowed(run, 0.5))]
    });
    let [rim, near_axis] = [0, 1].map(|k| errors[1][k] / errors[0][k]);
    assert_near(rim, 4.0, 0.05, "the caption's ratio");
    let thin = spherical_aberration(n, -1.0) / spherical_aberration(n, 1.0);
    assert_near(near_axis / thin, 1.0, 0.03, "ratio against that of thin lenses");
}

pub(crate) fn rim_rays_cross_earlier(run: &Run) {
    let n = index("N-BK7");
    let faces =
        [Face { vertex: -14.0, radius: f64::INFINITY, index: n }, Face { vertex: 0.0, radius: -40.0, index: 1.0 }];
    assert_cross_as_computed(run, "beam", 0.0, &faces);
    assert_near(focus(run, "beam", 0.0), 40.0 / (n - 1.0), 1e-6, "tip of the caustic");
    let upper: Vec<_> = rays(run, "beam").into_iter().filter(|ray| height(ray, 0.0) > 0.0).collect();
    let crossings: Vec<_> = upper.iter().map(|ray| x_at(out(ray), 0.0)).collect();
    assert!(crossings.is_sorted_by(|inner, outer| inner > outer), "farther out, earlier: {crossings:?}");
    assert!(spread(crossings) > 20.0);
}

pub(crate) fn blue_crosses_before_red(run: &Run) {
    let upper: Vec<&TracedRay> = rays(run, "beam").into_iter().filter(|ray| height(ray, 0.0) > 0.0).collect();
    let crossings: Vec<_> = upper.iter().map(|ray| x_at(out(ray), 0.0)).collect();
    for (ray, crossing) in upper.iter().zip(&crossings) {
        let n = index_at("N-SF11", ray.wavelength);
        let faces =
            [Face { vertex: -3.5, radius: 50.0, index: n }, Face { vertex: 3.5, radius: f64::INFINITY, index: 1.0 }];
        assert_near(*crossing, axis_crossing(&faces, 12.0), 1e-9, &format!("crossing of {}", ray.name()));
    }
    assert_eq!(crossings.len(), 15);
    assert!(crossings.is_sorted_by(|bluer, redder| bluer < redder), "{crossings:?}");
    assert_near(crossings[14] - crossings[0], 4.7, 0.05, "the caption's distance");
}

/// Where the upper rays of F, d and C cross the axis.
fn crossings(run: &Run, source: &str, axis: f64) -> [f64; 3] {
    let upper = |line: &Wavelength| {
        let of_line = |ray: &&TracedRay| ray.wavelength == *line && height(ray, axis) > 0.0;
        x_at(out(rays(run, source).into_iter().find(of_line).unwrap()), axis)
    };
    LINES.each_ref().map(upper)
}

pub(crate) fn the_achromat_joins_the_colors_that_the_singlet_spreads(run: &Run) {
    let narrow = narrowed(run, 1e-3);
    let focal_length = |source: &str| {
        let ray = rays(&narrow, source).into_iter().find(|ray| ray.wavelength == Wavelength::D && ray.ray == 1);
        -1e-3 / slope(out(ray.unwrap()))
    };
    let [singlet, doublet] = [focal_length("upper"), focal_length("lower")];
    assert_near(doublet, 100.0, 0.02, "focal length of the achromat");
    assert_near(singlet / doublet, 1.0, 1e-4, "the same focal length");
    for run in [run, &narrow] {
        let [singlet, doublet] = [crossings(run, "upper", 15.0), crossings(run, "lower", -15.0)].map(|[f, _, c]| c - f);
        assert!(doublet.abs() < 0.2 * singlet, "F–C spread {doublet} against {singlet}");
        assert_near(singlet, 3.0, 0.1, "the caption's spread");
    }
    let [f, d, c] = LINES.map(|line| index_at("SF5", line));
    let [blue, _, red] = crossings(&narrow, "upper", 15.0);
    assert_near((red - blue) / singlet * (d - 1.0) / (f - c), 1.0, 0.03, "spread f/V of the singlet");
    for (line, expected) in LINES.iter().zip(crossings(run, "lower", -15.0)) {
        let faces = [
            Face { vertex: 0.0, radius: 53.24, index: index_at("N-BK7", *line) },
            Face { vertex: 7.0, radius: -46.89, index: index_at("SF5", *line) },
            Face { vertex: 10.0, radius: -182.91, index: 1.0 },
        ];
        assert_near(axis_crossing(&faces, 11.0), expected, 1e-9, "crossing behind the achromat");
    }
}

pub(crate) fn facets_bring_strips_not_a_focus(run: &Run) {
    let [blur_true, blur_facets] = [0, 1].map(|k| {
        let hits = &run.trace.summary.screens[k].hits;
        assert_eq!(hits.len(), 17, "all light lands");
        spread(hits.iter().map(|hit| hit.position))
    });
    assert!(blur_facets > 5.0 * blur_true, "blur {blur_facets} against {blur_true}");
    let directions = |source: &str| {
        let mut slopes: Vec<_> = rays(run, source).iter().map(|ray| slope(out(ray))).collect();
        slopes.sort_by(f64::total_cmp);
        slopes.dedup_by(|a, b| (*a - *b).abs() < 1e-12);
        slopes.len()
    };
    assert_eq!(directions("upper"), 17, "the true lens turns every ray by its own angle");
    assert!(directions("lower") <= 9, "facets turn whole strips: {} directions", directions("lower"));
}

/// Neighbors cross on the screen where the landing place, as a function of the height, turns round.
pub(crate) fn the_screen_is_brightest_where_it_cuts_the_caustic(run: &Run) {
    let screen = &irradiance(&run.system, &run.trace.tree)[0];
    let place = |ray: &TracedRay| ray.segments.last().unwrap().hit.unwrap().position.unwrap();
    let places: Vec<f64> = run.trace.tree.rays.iter().map(place).collect();
    let lowest = places.iter().copied().fold(f64::INFINITY, f64::min);
    let turns = places.windows(3).position(|three| three[1] < three[0] && three[1] < three[2]).unwrap();
    assert_eq!(places[turns + 1], lowest, "the turning place is the rim of the spot");
    assert!(turns > 0 && turns < 20, "and not the beam's own rim");
    let rays = [turns, turns + 1].map(|number| *run.trace.tree.rays[number].segments.last().unwrap());
    let [a, b] = rays.map(|segment| (segment.from, segment.direction));
    let along = (b.0 - a.0).perp_dot(b.1) / a.1.perp_dot(b.1);
    assert!(((a.0 + along * a.1).x - 54.0).abs() < 1.5, "neighbors cross near the screen");
    let parts: Vec<_> = screen.parts(&screen.curves[0]).collect();
    let brightest = parts.iter().copied().reduce(|a, b| if b.1 > a.1 { b } else { a }).unwrap();
    let width = brightest.0[1] - brightest.0[0];
    let from_rim = |position: f64| (position - lowest).min(screen.length - lowest - position).abs();
    assert!(from_rim(0.5 * (brightest.0[0] + brightest.0[1])) < 1.5 * width, "{brightest:?}");
    let middle = parts[parts.len() / 2].1;
    assert!(middle > 0.0 && middle < 0.25 * brightest.1, "{middle} and {brightest:?}");
}
