//! The point that a scene is computed about, so that one far from the coordinate origin loses no digits.

use glam::DVec2;

use crate::geometry::Bounds;

/// A point near the middle of a box, on a grid as coarse as the box: a scene near the coordinate origin keeps its
/// coordinates, and one moved by a multiple of the grid step gets the same relative coordinates bit for bit.
pub(crate) fn origin(bounds: Bounds) -> DVec2 {
    if bounds.min.x > bounds.max.x {
        return DVec2::ZERO;
    }
    let extent = bounds.size().max_element();
    if extent <= 0.0 {
        return bounds.min;
    }
    let (_, exponent) = libm::frexp(extent);
    let step = libm::ldexp(1.0, exponent);
    // Rounded at thirds, which no coordinate with a short binary fraction hits.
    // Of a box so thin that its place is no number of steps, the place itself.
    let snap = |x: f64| if (x / step).is_finite() { step * (x / step + 1.0 / 3.0).floor() } else { x };
    let center = bounds.center();
    DVec2::new(snap(center.x), snap(center.y))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moves_with_the_scene_by_powers_of_two_and_stays_at_zero_near_it() {
        let near = Bounds::of([DVec2::new(-30.0, 0.0), DVec2::new(40.0, 40.0)]);
        assert_eq!(origin(near), DVec2::ZERO);
        let shift = DVec2::new(1_048_576.0, -262_144.0);
        assert_eq!(origin(Bounds::of([near.min + shift, near.max + shift])), shift);
    }
}
