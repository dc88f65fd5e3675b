//! Where two curves cross.

use glam::DVec2;

use crate::geometry::{CircleRoots, Curve};
use crate::numerics::{cross, side};

/// Points inside both curves, arcs of at most half a circle, where one passes through the other or touches it within
/// `tolerance`. Curves that lie on one line or circle within `tolerance` have none.
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
    // A short edge tells little of where a long one crosses it.
    let is_shorter = first.a.distance_squared(first.b) < second.a.distance_squared(second.b);
    let at = if is_shorter { first.a.lerp(first.b, a / (a - b)) } else { second.a.lerp(second.b, from / (from - to)) };
    proper.then_some(at)
}

/// Whether a point lies on a curve, strictly between its ends, within `tolerance`.
pub(crate) fn lies_on(curve: &Curve, p: DVec2, tolerance: f64) -> bool {
    curve.offset(p).abs() <= tolerance && lies_between(curve, p)
}

/// Whether a point of a curve's line or circle lies strictly between its ends.
fn lies_between(curve: &Curve, p: DVec2) -> bool {
    if curve.is_straight() {
        let along = curve.along(p);
        return 0.0 < along && along < curve.a.distance_squared(curve.b);
    }
    // Of the circle's points the arc's are those nearer to its apex than its ends are.
    let apex = curve.midpoint();
    apex.distance_squared(p) < apex.distance_squared(curve.a)
}

/// The points that two whole lines or circles have in common: where the first passes from the second's left to its right, and
/// where from right to left.
type Common = [DVec2; 2];

/// Of the common points those inside both curves. The sides on which a curve's ends lie tell which of the points it holds: near
/// an end, or near the chord of a flat arc, rounding misplaces the points themselves.
fn on_both(first: &Curve, second: &Curve, common: Common, tolerance: f64) -> Vec<DVec2> {
    let [down, up] = held(first, second, common, tolerance);
    // Where the first passes to the second's right, the second passes to the first's left.
    let [second_up, second_down] = held(second, first, [common[1], common[0]], tolerance);
    let points = common.into_iter().zip([down && second_down, up && second_up]);
    points.filter(|(_, held)| *held).map(|(p, _)| second.clamp(first.clamp(p))).collect()
}

/// Which of the common points a curve holds, the first being where it passes from the other's left to its right.
fn held(curve: &Curve, other: &Curve, common: Common, tolerance: f64) -> [bool; 2] {
    let side_of_other = |p| if other.is_straight() { side(other.a, other.b, p) } else { other.offset(p) };
    let [from, to] = [curve.a, curve.b].map(|end| side_of_other(end) > 0.0);
    if from != to {
        return [from, to];
    }
    let middle = common[0].midpoint(common[1]);
    // Both lie between the ends or both beyond; where curves all but coincide, rounding puts them anywhere.
    let (center, half) = (curve.midpoint(), curve.midpoint().distance(curve.a));
    let is_common = |p: &DVec2| center.distance(*p) <= 1.01 * half && other.offset(*p).abs() <= tolerance;
    let are_common = common.iter().all(is_common);
    let has_both = if curve.is_straight() {
        let is_outside = from == (other.curvature < 0.0);
        are_common && is_outside && lies_between(curve, middle)
    } else {
        are_common && curve.bulge_holds(middle)
    };
    [has_both; 2]
}

fn line_arc(line: &Curve, arc: &Curve, tolerance: f64) -> Vec<DVec2> {
    let direction = (line.b - line.a).normalize_or_zero();
    let at = |t: f64| line.a + t * direction;
    // The line's point nearest to the center: a touch is one point, not two close ones or none by rounding.
    let middle = at((arc.n + arc.curvature * (arc.m - line.a)).dot(direction) / arc.curvature);
    if arc.offset(middle).abs() <= tolerance {
        let is_inside = [line, arc].into_iter().all(|curve| lies_between(curve, middle));
        return is_inside.then_some(middle).into_iter().collect();
    }
    let polished = |t: f64| polish(line, arc, at(t));
    roots(arc, line.a, direction)
        .map_or_else(Vec::new, |distances| on_both(line, arc, distances.map(polished), tolerance))
}

/// Distances along a line at which it crosses an arc's circle, from the arc's left to its right first; `None` where they miss
/// each other.
fn roots(arc: &Curve, o: DVec2, d: DVec2) -> Option<[f64; 2]> {
    let Curve { m, n, curvature, .. } = *arc;
    let q = o - m;
    let (b, c) = ((curvature * q - n).dot(d), (curvature * q - 2.0 * n).dot(q));
    let square = b * b - curvature * c;
    // Far from the circle the difference cancels; close to a flat one, along it, the sine of the angle between them is 1.
    if (curvature * q).length_squared() > 1.0 || square <= 0.0 {
        let roots = CircleRoots::new(arc, o, d);
        return roots.meets.then_some([roots.from_left, roots.from_right]);
    }
    let root = square.sqrt();
    let (less, more) = (-(b + root), root - b);
    Some([if b <= 0.0 { more / curvature } else { c / less }, if b >= 0.0 { less / curvature } else { c / more }])
}

fn arc_arc(first: &Curve, second: &Curve, tolerance: f64) -> Vec<DVec2> {
    let (curved, flat) =
        if first.curvature.abs() >= second.curvature.abs() { (first, second) } else { (second, first) };
    let Some((foot, direction)) = radical_axis(curved, flat) else { return Vec::new() };
    let at = |t: f64| foot + t * direction;
    // Between the common points, or where the circles touch: on the line through their centers.
    let middle = at((curved.n + curved.curvature * (curved.m - foot)).dot(direction) / curved.curvature);
    let touch = first.project(middle);
    if second.offset(touch).abs() <= tolerance {
        let is_inside = [first, second].into_iter().all(|curve| lies_between(curve, touch));
        return is_inside.then_some(touch).into_iter().collect();
    }
    let Some(distances) = roots(curved, foot, direction) else { return Vec::new() };
    let [p, q] = distances.map(|t| polish(first, second, at(t)));
    let rise = |p: DVec2| first.tangent_at(p).dot(second.normal_at(p));
    on_both(first, second, if rise(p) < rise(q) { [p, q] } else { [q, p] }, tolerance)
}

/// The line through the common points of two circles, by a point and a unit direction: the difference of their equations, in
/// which nothing cancels when the flatter one's radius grows without bound. `None` for one center.
fn radical_axis(curved: &Curve, flat: &Curve) -> Option<(DVec2, DVec2)> {
    let about = curved.a;
    // κ |q|² − 2 g·q + c = 0 with q = p − about.
    let equation = |curve: &Curve| {
        let m = curve.m - about;
        (curve.n + curve.curvature * m, (curve.curvature * m + 2.0 * curve.n).dot(m))
    };
    let ((g, c), (h, d)) = (equation(flat), equation(curved));
    let share = flat.curvature / curved.curvature;
    let normal = g - share * h;
    let square = normal.length_squared();
    let foot = about + 0.5 * (c - share * d) / square * normal;
    foot.is_finite().then(|| (foot, normal.perp() / square.sqrt()))
}

/// A common point of two curves brought to rounding error by Newton steps on both at once.
fn polish(first: &Curve, second: &Curve, start: DVec2) -> DVec2 {
    let miss = |p: DVec2| first.offset(p).abs() + second.offset(p).abs();
    let mut p = start;
    for _ in 0..4 {
        let (n1, n2) = (first.normal_at(p), second.normal_at(p));
        let (f1, f2) = (first.offset(p), second.offset(p));
        let next = p - DVec2::new(f1 * n2.y - f2 * n1.y, f2 * n1.x - f1 * n2.x) / cross(n1, n2);
        // Along curves that all but coincide rounding leads anywhere.
        let is_nearer = miss(next) < miss(p);
        if !is_nearer {
            break;
        }
        p = next;
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
