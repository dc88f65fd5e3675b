//! Sides of interfaces from which a ray meets nothing any more, since the whole scene lies behind them.

use glam::DVec2;

use crate::geometry::Curve;
use crate::system::Interface;

/// In larger scenes few rays leave from such a side, and the search for it is quadratic.
const MOST: usize = 64;

/// Interfaces with whether the side is their left one. Distances below `near` are rounding.
pub(crate) fn outward_sides(interfaces: &[Interface], near: f64) -> Vec<(usize, bool)> {
    if interfaces.len() > MOST {
        return Vec::new();
    }
    let sides = (0..interfaces.len()).flat_map(|place| [(place, true), (place, false)]);
    sides.filter(|&(place, left)| sees_nothing(interfaces, place, left, near)).collect()
}

/// Whether all interfaces lie behind the tangents of one: an edge's line, or the lines that touch an arc, which bulges to that
/// side.
fn sees_nothing(interfaces: &[Interface], place: usize, left: bool, near: f64) -> bool {
    let one = &interfaces[place];
    let sense = if left { 1.0 } else { -1.0 };
    if one.curve.curvature * sense > 0.0 {
        return false;
    }
    // What lies behind the tangents at an arc's ends and behind its chord lies behind every tangent between.
    let is_behind = |p: DVec2| {
        let behind = |end: DVec2| sense * one.curve.normal_at(end).dot(p - end) < -near;
        let chord = sense * (one.curve.b - one.curve.a).normalize().perp();
        behind(one.curve.a) && behind(one.curve.b) && chord.dot(p - one.curve.a) < -near
    };
    interfaces.iter().enumerate().all(|(k, other)| {
        let is_known = |end: usize| one.ends.contains(&other.ends[end]);
        k == place
            || other.curve.same_circle(&one.curve)
            || ((is_known(0) || is_behind(other.curve.a))
                && (is_known(1) || is_behind(other.curve.b))
                && (other.curve.is_straight() || tip(&other.curve).is_some_and(is_behind)))
    })
}

/// Where the tangents at an arc's ends meet, beyond the arc: it runs inside the triangle. `None` for about half a circle.
fn tip(arc: &Curve) -> Option<DVec2> {
    let chord = arc.b - arc.a;
    let sin = 0.5 * chord.length() * arc.curvature;
    let cos = ((1.0 - sin) * (1.0 + sin)).max(0.0).sqrt();
    (cos > 0.01).then(|| 0.5 * (arc.a + arc.b) - 0.5 * sin / cos * chord.perp())
}
