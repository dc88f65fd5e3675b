//! By how much light has turned.

use glam::DVec2;

use crate::numerics::{Sum, atan2_degrees, cross, dot};
use crate::trace::{SegmentId, TracedRay};

/// The deviation δ from one direction to another, degrees counter-clockwise, above −180 to 180. It keeps its digits however
/// small it is. Directions opposite up to rounding deviate by 180; a zero vector by 0.
#[must_use]
pub fn deviation_degrees(from: DVec2, to: DVec2) -> f64 {
    let angle = atan2_degrees(cross(from, to), dot(from, to));
    // Turned back, the sign would be that of a rounding.
    if angle.abs() >= 180.0 - 1e-10 { 180.0 } else { angle }
}

/// By how much a branch has turned on its way from the source, degrees counter-clockwise: the turns at its hits together. It
/// differs from the [`deviation_degrees`] between the two directions by whole turns, and goes beyond 180 where light goes
/// round, as in the drop of a secondary rainbow. Light sent straight back turns by +180 there. `None` if the ray has no such
/// branch.
///
/// # Source
/// van de Hulst, "Light Scattering by Small Particles", chapter 12: a ray that leaves a sphere after k reflections inside has turned
/// by 2(θ_i − θ_t) + k(180° − 2 θ_t).
#[must_use]
pub fn turning_degrees(ray: &TracedRay, branch: SegmentId) -> Option<f64> {
    let end = ray.segments.get(branch.index())?;
    let (mut turns, mut segment) = (Sum::default(), end);
    for parent in ray.ancestors(branch).skip(1) {
        turns.add(deviation_degrees(parent.direction, segment.direction));
        segment = parent;
    }
    let direct = deviation_degrees(segment.direction, end.direction);
    // The directions know the angle best, the turns on the way how often light went round.
    Some(direct + 360.0 * ((turns.value() - direct) / 360.0).round())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::Turn;

    #[test]
    fn small_and_large_deviations() {
        for angle in [1e-12, -1e-9, 0.5, -90.0, 179.0, -179.999] {
            for start in [0.0, 33.0, 180.0] {
                let deviation =
                    deviation_degrees(Turn::degrees(start).direction(), Turn::degrees(start + angle).direction());
                assert!((deviation - angle).abs() < 4e-14, "{deviation} is not {angle}");
            }
        }
        let tiny = deviation_degrees(DVec2::X, DVec2::new(1.0, 1e-200));
        assert!((tiny * std::f64::consts::PI / 180.0 / 1e-200 - 1.0).abs() < 1e-15, "{tiny:e}");
    }

    #[test]
    fn turned_back_is_plus_180() {
        assert_eq!(deviation_degrees(DVec2::X, DVec2::new(-1.0, -1e-16)), 180.0);
        assert_eq!(deviation_degrees(DVec2::X, DVec2::new(-1.0, 1e-16)), 180.0);
    }
}
