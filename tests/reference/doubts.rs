//! Where f64 may decide otherwise, and rightly so: a path that comes so near to a vertex, to touching an arc, or to the
//! critical angle, that rounding decides. From there on branches are not compared.

use f256::f256;

use crate::bench::{Bench, Wall, coincidence};
use crate::condition::{Bundle, Nudge, State};
use crate::curve::Curve;
use crate::support::figures::U;
use crate::support::wide::{Wide2, power_of_two, wide};

/// Why a branch is set aside.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Doubt {
    /// It starts along a boundary, or all but on one.
    Start,
    /// It comes within 100 u × condition × size of a vertex or the crossing of two boundaries.
    Vertex,
    /// It comes as near to touching an arc.
    Touch,
    /// It comes within 100 u × condition of the critical angle.
    Critical,
    /// Its power is `min_power` to within 1e-12 of it.
    Power,
}

/// snellius lets a ray pass an arc of which it cuts off a cap no higher than this share of the largest coordinate, in which
/// it takes its aim to be rounding.
const LOWEST_CAP: f64 = 8.0 * U;

/// What a deviation of the disturbed states means for f64: 100 u of what 2^-60 did.
fn doubtful(deviation: f256, least: f256) -> f256 {
    wide(100.0 * U) * least.max(deviation / power_of_two(-60))
}

/// Whether the way to `distance` comes near an end of a wall, or near touching an arc.
///
/// A ray may start at the end of a wall, which it then stands on.
pub(crate) fn on_the_way(bench: &Bench, bundle: &Bundle, standing: &[usize], distance: Option<f256>) -> Option<Doubt> {
    let size = wide(bench.size);
    let State { p, d, .. } = *bundle.truth();
    let is_on_the_way =
        |along: f256, margin: f256| along > -margin && distance.is_none_or(|distance| along < distance + margin);
    for (number, wall) in bench.walls.iter().enumerate() {
        let is_here = |end: Wide2| standing.contains(&number) && (end - p).length() <= contact(wall);
        for (place, end) in wall.curve().ends().into_iter().enumerate().filter(|(_, end)| !is_here(*end)) {
            let offset = |state: &State, nudge: &Nudge| state.d.cross(nudge.curve(wall).ends()[place] - state.p);
            let margin = doubtful(bundle.nudged_deviation(offset), size);
            if d.cross(end - p).abs() < margin && is_on_the_way(d.dot(end - p), margin) {
                return Some(Doubt::Vertex);
            }
        }
        let Some(graze) = wall.curve().graze(p, d) else { continue };
        let gap = |state: &State, nudge: &Nudge| {
            nudge.curve(wall).graze(state.p, state.d).map_or(graze.gap, |graze| graze.gap)
        };
        let margin = doubtful(bundle.nudged_deviation(gap), size).max(wide(LOWEST_CAP * wall.reach.max(bench.size)));
        // What cuts off a cap so high meets the arc half a chord before its middle.
        let half_chord = wall.curve().circle.map_or(f256::ZERO, |circle| (wide(2.0) * circle.radius * margin).sqrt());
        if graze.gap.abs() < margin && is_on_the_way(graze.along, half_chord) {
            return Some(Doubt::Touch);
        }
    }
    None
}

/// Whether a hit on `boundary` is near a vertex, or near a wall that crosses there.
pub(crate) fn at_hit(bench: &Bench, bundle: &Bundle, boundary: &[usize]) -> Option<Doubt> {
    let p = bundle.truth().p;
    let deviation = bundle.deviation(|state| (state.p - p).length());
    let margin = doubtful(deviation, wide(bench.size)).max(wide(4.0) * bench.step);
    is_near_corner(bench, p, boundary, margin).then_some(Doubt::Vertex)
}

/// Whether the medium beside a point of a boundary cannot be told: it is asked for a step away.
pub(crate) fn hides_medium(bench: &Bench, p: Wide2, boundary: &[usize]) -> bool {
    is_near_corner(bench, p, boundary, wide(4.0) * bench.step)
}

/// Whether anything but the one boundary is within `margin` of a point on it.
fn is_near_corner(bench: &Bench, p: Wide2, boundary: &[usize], margin: f256) -> bool {
    let earliest = boundary.first().map(|wall| bench.walls[*wall].curve());
    // Walls in one place are one boundary only where they run on together.
    let parts = |curve: &Curve| {
        earliest.is_some_and(|earliest| {
            let turn = earliest.normal(p).cross(curve.normal(p)).abs();
            let bend = (earliest.curvature(p) - curve.curvature(p)).length() * wide(bench.size);
            turn.max(bend) > wide(1e-6)
        })
    };
    bench.walls.iter().enumerate().any(|(number, wall)| {
        let is_apart = !boundary.contains(&number) || parts(wall.curve());
        (is_apart && wall.curve().distance(p) < margin)
            || wall.curve().ends().iter().any(|end| (*end - p).length() < margin)
    })
}

/// Whether a start is on no boundary clearly, or on one clearly.
pub(crate) fn at_start(bench: &Bench, state: &State, boundary: &[usize]) -> Option<Doubt> {
    let margin = wide(100.0 * U * bench.size);
    let is_along = |wall: &usize| bench.walls[*wall].curve().normal(state.p).dot(state.d).abs() < wide(1e-9);
    let is_apart = |wall: &usize| !boundary.contains(wall);
    let mut others = (0..bench.walls.len()).filter(is_apart);
    let is_beside = others.any(|wall| bench.walls[wall].curve().distance(state.p) < margin);
    (is_beside || boundary.iter().any(is_along)).then_some(Doubt::Start)
}

/// The walls that a start is on, as exactly as coordinates are placed.
pub(crate) fn under_start(bench: &Bench, p: Wide2) -> Vec<usize> {
    let is_on = |wall: &usize| {
        let wall = &bench.walls[*wall];
        wall.curve().distance(p) <= contact(wall)
    };
    (0..bench.walls.len()).filter(is_on).collect()
}

/// Distance within which a start is on a wall: the rounding of the wall's placement.
fn contact(wall: &Wall) -> f256 {
    wide(0.25 * coincidence(wall.reach))
}

/// Whether an angle of incidence is near the critical one; `beyond` is n_i sin θ_i − n_t, `scale` n_i cos θ_i.
pub(crate) fn at_critical_angle(
    bundle: &Bundle,
    scale: f256,
    beyond: impl Fn(&State, &Nudge) -> f256,
) -> Option<Doubt> {
    let margin = doubtful(bundle.nudged_deviation(&beyond), scale);
    (beyond(bundle.truth(), &Nudge::NONE).abs() < margin).then_some(Doubt::Critical)
}

/// Whether a share of the starting power is near the least that is followed.
pub(crate) fn at_least_power(share: f256, least: f64) -> Option<Doubt> {
    ((share - wide(least)).abs() < wide(1e-12 * least)).then_some(Doubt::Power)
}
