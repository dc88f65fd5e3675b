//! Where rays start, where they head, and what they stand in.

use glam::DVec2;
use snellius::light::Power;
use snellius::numerics::Turn;
use snellius::trace::{Segment, TracedRay};

use crate::U;
use crate::support::run_text;

fn rays(source: &str) -> Vec<TracedRay> {
    run_text(&format!("(sources: [{source}])")).trace.tree.rays
}

fn starts(light: &str) -> Vec<(DVec2, DVec2)> {
    rays(&format!("(light: {light})")).iter().map(|ray| (ray.segments[0].from, ray.segments[0].direction)).collect()
}

fn start_in(bodies: &str, from: (f64, f64), angle: f64) -> Segment {
    let light = format!("Ray(from: {from:?}, direction: Angle({angle}))");
    run_text(&format!("(bodies: [{bodies}], sources: [(light: {light})])")).trace.tree.rays[0].segments[0]
}

#[test]
fn a_beam_starts_along_its_width_turned_by_90_degrees() {
    let beam = starts("Beam(center: (3, 4), direction: Towards((6, 8)), width: 10, rays: 5)");
    for (k, (from, direction)) in beam.into_iter().enumerate() {
        let across = (f64::from(u32::try_from(k).unwrap()) / 4.0 - 0.5) * 10.0;
        assert!(from.distance(DVec2::new(3.0, 4.0) + across * DVec2::new(-0.8, 0.6)) <= 16.0 * U * 10.0);
        assert!(direction.distance(DVec2::new(0.6, 0.8)) <= 2.0 * U);
    }
    assert_eq!(
        starts("Beam(center: (3, 4), direction: Angle(90), width: 10, rays: 1)"),
        [(DVec2::new(3.0, 4.0), DVec2::Y)]
    );
}

#[test]
fn a_fan_spreads_from_clockwise_to_counter_clockwise() {
    let fan = starts("Fan(from: (1, 2), direction: Angle(20), spread: 60, rays: 4)");
    for (k, angle) in [-10.0, 10.0, 30.0, 50.0].into_iter().enumerate() {
        assert_eq!(fan[k].0, DVec2::new(1.0, 2.0));
        assert!(fan[k].1.distance(Turn::degrees(angle).direction()) <= 4.0 * U, "{angle}");
    }
    assert_eq!(starts("Fan(from: (1, 2), direction: Towards((1, 9)), spread: 60, rays: 1)")[0].1, DVec2::Y);
}

#[test]
fn a_point_shines_all_round() {
    let point = starts("Point(at: (1, 2), rays: 8)");
    assert_eq!(point.len(), 8);
    for (k, (from, direction)) in point.into_iter().enumerate() {
        let angle = 45.0 * f64::from(u32::try_from(k).unwrap());
        assert_eq!((from, direction), (DVec2::new(1.0, 2.0), Turn::degrees(angle).direction()));
    }
}

#[test]
fn towards_has_no_trouble_with_magnitudes() {
    for scale in ["1e-30", "1e29", "1e-9", "1"] {
        let from_to = format!("Ray(from: (0, 0), direction: Towards((3{e}, 4{e})))", e = scale.trim_start_matches('1'));
        assert!(starts(&from_to)[0].1.distance(DVec2::new(0.6, 0.8)) <= 2.0 * U, "{scale}");
    }
}

#[test]
fn lines_and_power_are_shared_equally() {
    let light = "light: Fan(from: (0, 0), direction: Angle(0), spread: 10, rays: 2)";
    let white = rays(&format!("({light}, spectrum: White(samples: 3), power: 12)"));
    let lines: Vec<_> = white.iter().map(|ray| (ray.ray, ray.wavelength.nanometers(), ray.power)).collect();
    assert_eq!(
        lines,
        [(0, 420.0, 2.0), (0, 560.0, 2.0), (0, 700.0, 2.0), (1, 420.0, 2.0), (1, 560.0, 2.0), (1, 700.0, 2.0)]
    );
    assert_eq!(rays(&format!("({light}, spectrum: White(samples: 1))"))[0].wavelength.nanometers(), 560.0);
    assert_eq!(rays(&format!("({light})"))[0].wavelength.nanometers(), 587.5618);
    for (name, power) in
        [("Unpolarized", Power { s: 2.0, p: 2.0 }), ("S", Power { s: 4.0, p: 0.0 }), ("P", Power { s: 0.0, p: 4.0 })]
    {
        assert_eq!(rays(&format!("({light}, power: 8, polarization: {name})"))[1].segments[0].power, power);
    }
}

const SQUARE: &str = "(shape: Rectangle(4, 4), medium: Index(1.5))";

#[test]
fn on_a_boundary_a_ray_starts_in_what_it_heads_into_and_does_not_hit_there() {
    for (from, angle, index, length) in [
        ((-2.0, 0.5), 10.0, 1.5, Some(4.0)),
        ((-2.0, 0.5), 170.0, 1.0, None),
        // Along the face: the medium on its left.
        ((-2.0, 0.5), 90.0, 1.0, None),
        ((-2.0, 0.5), -90.0, 1.5, Some(2.5)),
        // At a corner: the sector that it heads into.
        ((-2.0, -2.0), 45.0, 1.5, Some(5.6)),
        ((-2.0, -2.0), 135.0, 1.0, None),
        ((-2.0, -2.0), 0.0, 1.5, Some(4.0)),
        ((-2.0, -2.0), 90.0, 1.0, None),
        ((-2.0, -2.0), 180.0, 1.0, None),
        ((-2.0, -2.0), -90.0, 1.0, None),
    ] {
        let start = start_in(SQUARE, from, angle);
        assert_eq!(start.medium_index, index, "{from:?} at {angle}");
        let found = start.to.map(|to| to.distance(start.from));
        assert_eq!(found.is_some(), length.is_some(), "{from:?} at {angle}");
        assert!(found.is_none_or(|found| found >= length.unwrap()), "{from:?} at {angle}");
    }
}

#[test]
fn on_an_arc_a_tangent_ray_starts_outside() {
    let disk = "(shape: Disk(2), medium: Index(1.5))";
    for angle in [0.0, 90.0, 180.0, 270.0, 30.0, 45.0, 123.4] {
        let at = 2.0 * Turn::degrees(angle).direction();
        for (turn, index) in
            [(90.0, 1.0), (-90.0, 1.0), (180.0, 1.5), (0.0, 1.0), (91.0, 1.5), (-91.0, 1.5), (89.0, 1.0)]
        {
            let start = start_in(disk, (at.x, at.y), angle + turn);
            // Elsewhere the rounded tangent may cut the disk, by less than it shows.
            let on_axis = angle % 90.0 == 0.0;
            if turn.abs() != 90.0 || on_axis {
                assert_eq!(start.medium_index, index, "{angle} {turn}");
            }
        }
    }
}

#[test]
fn where_three_media_meet_the_sector_decides() {
    let bodies = "(shape: Polygon([(0, 0), (4, 0), (4, 4), (0, 4)]), medium: Index(1.2)), \
        (shape: Polygon([(0, 0), (0, 4), (-4, 4), (-4, 0)]), medium: Index(1.4)), \
        (shape: Polygon([(0, 0), (-4, 0), (-4, -4), (0, -4)]), medium: Index(1.6))";
    for (angle, index) in
        [(45.0, 1.2), (0.0, 1.2), (90.0, 1.4), (135.0, 1.4), (180.0, 1.6), (225.0, 1.6), (270.0, 1.0), (315.0, 1.0)]
    {
        assert_eq!(start_in(bodies, (0.0, 0.0), angle).medium_index, index, "{angle}");
    }
}
