//! Corners, where two interfaces share a vertex: decided by the way in which they leave it.

use glam::DVec2;

use crate::geometry::Curve;
use crate::numerics::{cross, side};
use crate::system::{Interface, VertexId};

/// Whether `candidate` leaves the vertex that it shares with `last`, its start or its end, to the left of `last`; `None` where
/// the two run on one line or circle. Distances below `near` are rounding.
pub(crate) fn opens_to(last: &Interface, candidate: &Interface, start: bool, near: f64) -> Option<bool> {
    let (last, candidate) = (&last.curve, &candidate.curve);
    let (vertex, other) = if start { (candidate.a, candidate.b) } else { (candidate.b, candidate.a) };
    let turn = if last.is_straight() && candidate.is_straight() {
        side(last.a, last.b, other)
    } else {
        let (along, tangent) = (last.tangent_at(vertex), candidate.tangent_at(vertex));
        let turn = cross(along, if start { tangent } else { -tangent });
        // Tangent up to the rounding of the two: the stronger curvature decides.
        let length = last.a.distance(last.b).min(candidate.a.distance(candidate.b));
        if turn.abs() * length <= near { bend(last, candidate, along.dot(tangent)) } else { turn }
    };
    (turn != 0.0).then_some(turn > 0.0)
}

/// The one vertex that two edges share, and their other ends; `None` for arcs.
pub(crate) fn corner(first: &Interface, second: &Interface) -> Option<(VertexId, [DVec2; 2])> {
    if !first.curve.is_straight() || !second.curve.is_straight() {
        return None;
    }
    let [from, to] = first.ends.map(|end| second.ends.contains(&end));
    let (shared, u) = match (from, to) {
        (true, false) => (first.ends[0], first.curve.b),
        (false, true) => (first.ends[1], first.curve.a),
        _ => return None,
    };
    let v = if second.ends[0] == shared { second.curve.b } else { second.curve.a };
    Some((shared, [u, v]))
}

/// Curvature of `candidate` above that of `last` where the two touch, seen along `last`; 0 where they are equal.
fn bend(last: &Curve, candidate: &Curve, sense: f64) -> f64 {
    let bend = candidate.curvature * sense.signum() - last.curvature;
    // Far above the rounding of a curvature.
    if bend.abs() <= 1e-12 * last.curvature.abs() { 0.0 } else { bend }
}
