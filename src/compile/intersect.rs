//! Where two curves cross.

use glam::DVec2;

use crate::geometry::{CircleRoots, Curve};
use crate::numerics::{cross, side};

/// Points inside both curves where one passes through the other or touches it within `tolerance`. Curves that lie on one line or circle within
/// `tolerance` have none.
pub(crate) fn crossings(first: &Curve, second: &Curve, tolerance: f64) -> Vec<DVec2> {
    if coincide(first, second, tolerance) {
        return Vec::new();
    }
    match (first.is_straight(), second.is_straight()) {
        (true, true) => line_line(first, second).into_iter().collect(),
        (true, false) => line_arc(first, second, tolerance),
        (false, true) => line_arc(second, first, tolerance),
        (false, false) => arc_arc(first, second, tolerance),
    }
}

/// Whether the shorter curve lies on the other's line or circle within `tolerance`.
fn coincide(first: &Curve, second: &Curve, tolerance: f64) -> bool {
    let chord = |curve: &Curve| curve.a.distance_squared(curve.b);
    let (short, long) = if chord(first) <= chord(second) { (first, second) } else { (second, first) };
    [short.a, short.midpoint(), short.b].into_iter().all(|p| long.offset(p).abs() <= tolerance)
}

fn line_line(first: &Curve, second: &Curve) -> Option<DVec2> {
    let (from, to) = (side(first.a, first.b, second.a), side(first.a, first.b, second.b));
    let (a, b) = (side(second.a, second.b, first.a), side(second.a, second.b, first.b));
    let proper = from * to < 0.0 && a * b < 0.0;
    proper.then(|| second.a.lerp(second.b, from / (from - to)))
}

fn line_arc(line: &Curve, arc: &Curve, tolerance: f64) -> Vec<DVec2> {
    let direction = (line.b - line.a).normalize_or_zero();
    let length = line.a.distance(line.b);
    let on_both = |t: f64| {
        let p = line.a + t * direction;
        (0.0 < t && t < length && arc.bulge_holds(p)).then_some(p)
    };
    let roots = CircleRoots::new(arc, line.a, direction);
    // The line's point nearest to the center: a touch is one point, not two close ones or none by rounding.
    let middle = (arc.n + arc.curvature * (arc.m - line.a)).dot(direction) / arc.curvature;
    let distances = if arc.offset(line.a + middle * direction).abs() <= tolerance {
        vec![middle]
    } else if roots.meets {
        vec![roots.from_left, roots.from_right]
    } else {
        Vec::new()
    };
    distances.into_iter().filter_map(on_both).collect()
}

fn arc_arc(first: &Curve, second: &Curve, tolerance: f64) -> Vec<DVec2> {
    let on_both = |p: &DVec2| first.bulge_holds(*p) && second.bulge_holds(*p);
    let touch = touch(first, second, tolerance);
    let points = if touch.is_some() { [touch, None] } else { circle_circle(first, second) };
    points.into_iter().flatten().filter(on_both).collect()
}

/// The point where two circles touch within `tolerance`: on the line through their centers.
fn touch(first: &Curve, second: &Curve, tolerance: f64) -> Option<DVec2> {
    let (center, radius) = (first.center(), first.curvature.abs().recip());
    let axis = (second.center() - center).normalize_or_zero();
    let facing = [center + radius * axis, center - radius * axis].map(|p| first.project(p));
    facing.into_iter().find(|p| second.offset(*p).abs() <= tolerance)
}

/// The two common points of two circles, each brought to rounding error by Newton steps on both circles at once.
fn circle_circle(first: &Curve, second: &Curve) -> [Option<DVec2>; 2] {
    let (c1, c2) = (first.center(), second.center());
    let (r1, r2) = (first.curvature.abs().recip(), second.curvature.abs().recip());
    let between = c2 - c1;
    let distance = between.length();
    let along = 0.5 * (distance + (r1 - r2) * (r1 + r2) / distance);
    let across_squared = (r1 - along) * (r1 + along);
    if !across_squared.is_finite() || across_squared < 0.0 {
        return [None, None];
    }
    let axis = between / distance;
    let (foot, across) = (c1 + along * axis, across_squared.sqrt() * axis.perp());
    [foot + across, foot - across].map(|start| Some(polish(first, second, start)))
}

fn polish(first: &Curve, second: &Curve, start: DVec2) -> DVec2 {
    let mut p = start;
    for _ in 0..4 {
        let (n1, n2) = (first.normal_at(p), second.normal_at(p));
        let (f1, f2) = (first.offset(p), second.offset(p));
        let determinant = cross(n1, n2);
        if determinant == 0.0 {
            break;
        }
        p -= DVec2::new(f1 * n2.y - f2 * n1.y, f2 * n1.x - f1 * n2.x) / determinant;
    }
    p
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_through_a_half_circle() {
        let arc = Curve::arc(DVec2::X, DVec2::Y, -DVec2::X).unwrap();
        let line = Curve::line(DVec2::new(0.6, -2.0), DVec2::new(0.6, 2.0));
        let points = crossings(&line, &arc, 1e-15);
        assert_eq!(points.len(), 1);
        assert!((points[0] - DVec2::new(0.6, 0.8)).length() < 4e-16);
    }

    #[test]
    fn two_lens_faces() {
        let left = Curve::arc(DVec2::new(0.0, -4.0), DVec2::new(-2.0, 0.0), DVec2::new(0.0, 4.0)).unwrap();
        let right = Curve::arc(DVec2::new(-1.0, -4.0), DVec2::new(1.0, 0.0), DVec2::new(-1.0, 4.0)).unwrap();
        let points = crossings(&left, &right, 1e-15);
        assert_eq!(points.len(), 2);
        for p in points {
            assert!(left.offset(p).abs() < 1e-15 && right.offset(p).abs() < 1e-15 && p.y.abs() > 3.0);
        }
    }

    #[test]
    fn one_circle_does_not_cross_itself() {
        let upper = Curve::arc(DVec2::X, DVec2::Y, -DVec2::X).unwrap();
        let again = Curve::arc(DVec2::new(0.6, 0.8), DVec2::Y, DVec2::new(-0.8, 0.6)).unwrap();
        assert!(crossings(&upper, &again, 4e-15).is_empty());
    }
}
