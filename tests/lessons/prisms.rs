//! Scenes of `scenes/prisms`.

use glam::DVec2;
use snellius::analysis::{Bundle, irradiance};
use snellius::numerics::Turn;
use snellius::scene::{Direction, Light};
use snellius::trace::{Segment, TracedRay};

use crate::Lesson;
use crate::measure::{
    along, asin, changed, cos, exit, index, index_at, near, offset, only_ray, path, ray, sin, tan, theta_i, theta_t,
    turn,
};
use crate::support::{Run, segment};

pub(crate) const LESSONS: &[Lesson] = &[
    ("prisms/beam-splitter-cube", halves_on_equal_paths),
    ("prisms/cauchy-sellmeier", cauchys_formula_holds_where_it_was_fitted),
    ("prisms/corner-reflector", every_ray_returns),
    ("prisms/dove", inverted_and_not_turned),
    ("prisms/hollow-in-water", turned_toward_the_apex),
    ("prisms/hydrogen-lines", each_line_has_a_place_of_its_own),
    ("prisms/minimum-deviation", the_symmetric_ray_is_turned_least),
    ("prisms/penta", turned_by_90_however_it_is_held),
    ("prisms/porro", sent_back_with_top_and_bottom_swapped),
    ("prisms/recombination", all_colors_leave_parallel),
    ("prisms/right-angle", turned_by_90_by_total_reflection),
    ("prisms/white-light", violet_is_turned_most),
];

/// A ray's own segment and the only one that leaves.
fn in_and_out(ray: &TracedRay) -> (&Segment, &Segment) {
    (&ray.segments[0], exit(ray))
}

fn turned_by_90_by_total_reflection(run: &Run) {
    let critical = asin(1.0 / index("N-BK7"));
    near(critical, 41.2, 0.05);
    assert_eq!(run.trace.tree.rays.len(), 3);
    for ray in &run.trace.tree.rays {
        let (entry, exit) = in_and_out(ray);
        near(turn(entry.direction, exit.direction), -90.0, 1e-12);
        near(theta_i(ray, "t"), 45.0, 1e-12);
        let hypotenuse = segment(ray, "t").hit.unwrap();
        near(hypotenuse.critical_degrees().unwrap(), critical, 1e-12);
        assert!(45.0 > critical && hypotenuse.total_internal_reflection);
        assert_eq!(path(ray, exit), "tit");
    }
}

fn sent_back_with_top_and_bottom_swapped(run: &Run) {
    let rays = &run.trace.tree.rays;
    for ray in rays {
        let (entry, exit) = in_and_out(ray);
        assert_eq!(path(ray, exit), "tiit");
        along(exit.direction, -entry.direction, 1e-12);
        near(exit.from.y, -entry.from.y, 1e-12);
    }
    assert!(rays[0].segments[0].from.y > rays[1].segments[0].from.y);
    assert!(exit(&rays[0]).from.y < exit(&rays[1]).from.y);
    for tilt in [-4.0, 3.0] {
        let tilted = changed(run, |scene| scene.bodies[0].rotate += tilt);
        let (entry, exit) = in_and_out(ray(&tilted, 0, 0));
        along(exit.direction, -entry.direction, 1e-12);
    }
}

/// In a prism of base L with 45° ends, a ray that enters at height y leaves at (tan α (L − y) − y)/(1 + tan α), α being
/// its slope inside.
fn inverted_and_not_turned(run: &Run) {
    const BASE: f64 = 101.5;
    let slope = 45.0 - asin(sin(45.0) / index("N-BK7"));
    for ray in &run.trace.tree.rays {
        let (entry, exit) = in_and_out(ray);
        along(exit.direction, entry.direction, 1e-13);
        assert_eq!(path(ray, exit), "tit");
        near(theta_i(ray, "t"), 90.0 - slope, 1e-12);
        let height = entry.from.y + 12.0;
        near(exit.from.y + 12.0, (tan(slope) * (BASE - height) - height) / (1.0 + tan(slope)), 1e-12);
        near(exit.from.y, -entry.from.y, 0.01);
    }
    near(90.0 - slope, 72.8, 0.05);
}

fn turned_by_90_however_it_is_held(run: &Run) {
    near(theta_i(ray(run, 0, 0), "t"), 22.5, 1e-12);
    assert!(22.5 < asin(1.0 / index("N-BK7")), "without silver, light would leave");
    for tilt in [0.0, -3.0, 1.0, 4.0] {
        let held = changed(run, |scene| scene.bodies.iter_mut().for_each(|body| body.rotate += tilt));
        for ray in &held.trace.tree.rays {
            let (entry, exit) = in_and_out(ray);
            near(turn(entry.direction, exit.direction), -90.0, 1e-12);
            assert_eq!(path(ray, exit), "trrt");
        }
    }
}

fn every_ray_returns(run: &Run) {
    let fan = changed(run, |scene| {
        scene.sources.truncate(1);
        let direction = Direction::Angle(0.0);
        scene.sources[0].light = Light::Fan { from: DVec2::new(-20.0, -2.0), direction, spread: 40.0, rays: 16 };
    });
    for ray in run.trace.tree.rays.iter().chain(&fan.trace.tree.rays) {
        let (entry, exit) = in_and_out(ray);
        assert_eq!(path(ray, exit), "rr");
        along(exit.direction, -entry.direction, 1e-14);
    }
}

fn the_symmetric_ray_is_turned_least(run: &Run) {
    let n = index("N-BK7");
    let least = 2.0 * asin(n * sin(30.0)) - 60.0;
    let ray = only_ray(run);
    near(deviation(ray), least, 1e-10);
    along(segment(ray, "t").direction, DVec2::X, 1e-10);
    near(theta_i(ray, ""), theta_t(ray, "t"), 1e-10);
    near(theta_i(ray, ""), 49.3, 0.05);
    near(least, 38.6, 0.05);
    for more in [-2.0, -0.1, 0.1, 2.0] {
        let other = changed(run, |scene| {
            let Light::Ray { direction: Direction::Angle(angle), .. } = &mut scene.sources[0].light else {
                panic!("a ray at an angle")
            };
            *angle += more;
        });
        assert!(deviation(only_ray(&other)) > least + 1e-6);
    }
}

/// Angle by which a prism with its apex up turns a ray down, from its entry to its second refraction.
fn deviation(ray: &TracedRay) -> f64 {
    -turn(ray.segments[0].direction, segment(ray, "tt").direction)
}

/// Deviation δ = θ + e − A of a ray that enters at θ and leaves at e.
fn deviation_by_formula(n: f64, theta: f64) -> f64 {
    theta + asin(n * sin(60.0 - asin(sin(theta) / n))) - 60.0
}

fn violet_is_turned_most(run: &Run) {
    let rays = &run.trace.tree.rays;
    assert_eq!(rays.len(), 90);
    for ray in rays {
        let n = index_at("N-SF11", ray.wavelength);
        near(deviation(ray), deviation_by_formula(n, theta_i(ray, "")), 1e-10);
    }
    assert!(rays.is_sorted_by(|shorter, longer| deviation(shorter) > deviation(longer)));
    near(index_at("N-SF11", rays[0].wavelength), 1.833, 5e-4);
    near(index_at("N-SF11", rays[89].wavelength), 1.772, 5e-4);
}

fn all_colors_leave_parallel(run: &Run) {
    let rays = &run.trace.tree.rays;
    for ray in rays {
        let (entry, exit) = in_and_out(ray);
        assert_eq!(path(ray, exit), "tttt");
        along(exit.direction, entry.direction, 1e-12);
    }
    assert!(rays.is_sorted_by(|shorter, longer| deviation(shorter) > deviation(longer)), "apart between the prisms");
    let beside = |ray| offset(&rays[0].segments[0], exit(ray));
    assert!(rays.is_sorted_by(|shorter, longer| beside(shorter) < beside(longer)), "red on top");
}

fn turned_toward_the_apex(run: &Run) {
    let relative = 1.0 / index("water");
    let ray = only_ray(run);
    near(deviation(ray), deviation_by_formula(relative, theta_i(ray, "")), 1e-10);
    near(-deviation(ray), 60.0 - 2.0 * asin(relative * sin(30.0)), 1e-6);
    near(-deviation(ray), 16.0, 0.05);
    near(theta_i(ray, ""), 22.0, 0.05);
    near(theta_t(ray, ""), 30.0, 0.01);
}

fn halves_on_equal_paths(run: &Run) {
    let ray = only_ray(run);
    let (on, turned) = (segment(ray, "ttt"), segment(ray, "trt"));
    along(on.direction, DVec2::X, 1e-15);
    along(turned.direction, Turn::degrees(-90.0).direction(), 1e-15);
    assert_eq!((on.power.total(), turned.power.total()), (0.5, 0.5));
    for branch in ["tt", "tr"] {
        near(segment(ray, branch).optical_path, 60.0 + 50.0 * index("N-BK7"), 1e-12);
    }
    assert_eq!(ray.segments.len(), 6, "nothing else comes of the cemented faces");
}

/// Rays: violet, indigo, blue-green and red through Sellmeier's prism, then the same through Cauchy's.
fn cauchys_formula_holds_where_it_was_fitted(run: &Run) {
    let rays = &run.trace.tree.rays;
    assert_eq!(rays.len(), 8);
    let turned = |ray: &TracedRay| {
        near(theta_i(ray, ""), 60.0, 1e-12);
        let (entry, exit) = in_and_out(ray);
        -turn(entry.direction, exit.direction)
    };
    for (sellmeier, cauchy) in rays[..4].iter().zip(&rays[4..]) {
        assert_eq!(sellmeier.wavelength, cauchy.wavelength);
        let n = index_at("N-SF10", sellmeier.wavelength);
        near(sellmeier.segments[1].medium_index, n, 1e-15);
        let inside = asin(sin(60.0) / n);
        near(turned(sellmeier), asin(n * sin(60.0 - inside)), 1e-10);
    }
    let less = [0, 1, 2, 3].map(|line| turned(&rays[line]) - turned(&rays[4 + line]));
    near(less[0], 0.58, 5e-3);
    near(less[1], 0.21, 5e-3);
    near(less[2], 0.0, 1e-5);
    near(less[3], 0.0, 1e-5);
}

/// Where the lines land follows from the index: δ = θ_i + asin(n sin(60° − asin(sin θ_i/n))) − 60°.
fn each_line_has_a_place_of_its_own(run: &Run) {
    let screen = &irradiance(&run.system, &run.trace.tree)[0];
    assert_eq!(screen.curves.len(), 3);
    let mut last = 0.0;
    for curve in &screen.curves {
        let n = index_at("N-SF11", curve.wavelength);
        let beam = Bundle::of(&run.trace.tree, 0, "tt").line(curve.wavelength);
        // The left face's normal points to 150°, and the light's way back to 213°.
        let theta_i = 33.0 + 30.0;
        let deviation = theta_i + asin(n * sin(60.0 - asin(sin(theta_i) / n))) - 60.0;
        assert_eq!(beam.rays().len(), 6);
        for ray in beam.rays() {
            near(turn(Turn::degrees(33.0).direction(), ray.direction), -deviation, 1e-12);
        }
        let lit: Vec<_> = screen.parts(curve).filter(|(_, value)| *value > 0.0).collect();
        let ([begin, _], [_, end]) = (lit.first().unwrap().0, lit.last().unwrap().0);
        assert!(begin > last + 2.0, "the screen is dark between the lines");
        last = end;
        let power: f64 = lit.iter().map(|([begin, end], value)| value * (end - begin)).sum();
        near(power, 1.0 / 3.0, 1e-14);
        // All of the beam's width, seen from a screen that stands askew to it, and one step more.
        let at_exit = |k: usize| beam.rays()[k].from;
        let width = (at_exit(5) - at_exit(0)).perp_dot(beam.rays()[0].direction).abs() / cos(33.0 - deviation);
        near(end - begin, 1.2 * width, 2.0 * screen.length / 240.0);
    }
}
