use glam::DVec2;

use crate::geometry::Curve;
use crate::numerics::cross;

/// Where a line meets the circle that a curve is part of.
///
/// With q = o − m and B = κ q·d − n·d these are the roots of κ t² + 2 B t + C = 0, the quotient chosen so that nothing
/// cancels. The discriminant is (1 − S)(1 + S), where
/// S = d × (n − κ q) is the sine of the angle of incidence.
///
/// # Source
/// Press et al., "Numerical Recipes", 3rd ed., section 5.6, for the quotient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CircleRoots {
    /// Whether they meet; where they do not, both distances are that of the line's point nearest to the center.
    pub meets: bool,
    /// Distance along the line at which it crosses the circle from the curve's left to its right.
    pub from_left: f64,
    /// Distance at which it crosses from right to left.
    pub from_right: f64,
}

impl CircleRoots {
    /// The roots for the line through `o` along the unit vector `d`; not for straight edges.
    #[must_use]
    pub fn new(circle: &Curve, o: DVec2, d: DVec2) -> Self {
        let Curve { m, n, curvature, .. } = *circle;
        let q = o - m;
        let gradient = n - curvature * q;
        let sine = cross(d, gradient).abs();
        let square = (1.0 - sine) * (1.0 + sine);
        let (b, c) = (-gradient.dot(d), (curvature * q - 2.0 * n).dot(q));
        if square <= 0.0 {
            let nearest = -b / curvature;
            return Self { meets: square >= 0.0, from_left: nearest, from_right: nearest };
        }
        let root = square.sqrt();
        Self {
            meets: true,
            from_left: if b <= 0.0 { (root - b) / curvature } else { -c / (b + root) },
            from_right: if b >= 0.0 { -(b + root) / curvature } else { c / (root - b) },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::Turn;

    #[test]
    fn a_chord_of_the_unit_circle() {
        let arc = Curve::arc(DVec2::X, DVec2::Y, -DVec2::X).unwrap();
        let roots = CircleRoots::new(&arc, DVec2::new(-3.0, 0.6), DVec2::X);
        assert!(roots.meets);
        // A left turn has its inside on the left: the line enters from the right.
        assert!((roots.from_right - 2.2).abs() < 1e-15 && (roots.from_left - 3.8).abs() < 1e-15);
    }

    #[test]
    fn a_line_that_starts_where_it_touches_the_circle() {
        let arc = Curve::arc(DVec2::X, DVec2::Y, -DVec2::X).unwrap();
        for (angle, o) in [(30.0, 1.0 + f64::EPSILON), (45.0, 1.0 + 4.0 * f64::EPSILON)] {
            let turn = Turn::degrees(angle);
            let roots = CircleRoots::new(&arc, o * turn.direction(), turn.direction().perp());
            assert!(roots.from_left.abs() < 1e-7 && roots.from_right.abs() < 1e-7, "{roots:?}");
        }
    }

    #[test]
    fn a_radius_of_1e12_gives_the_near_root_in_full() {
        let sagitta = 0.5e-8;
        let arc = Curve::arc(DVec2::new(0.0, -100.0), DVec2::new(sagitta, 0.0), DVec2::new(0.0, 100.0)).unwrap();
        let roots = CircleRoots::new(&arc, DVec2::new(-10.0, 0.0), DVec2::X);
        assert!((roots.from_left - (10.0 + sagitta)).abs() < 1e-14);
    }
}
