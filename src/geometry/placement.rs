use glam::DVec2;

use crate::geometry::Curve;
use crate::numerics::Turn;

/// Where a body stands: turned about its own origin first, then moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    turn: Turn,
    at: DVec2,
}

impl Placement {
    /// A placement from the angle in degrees, counter-clockwise, and the place of the shape's origin.
    #[must_use]
    pub fn new(rotate: f64, at: DVec2) -> Self {
        Self { turn: Turn::degrees(rotate), at }
    }

    /// A point of the shape after placement.
    #[must_use]
    pub fn point(&self, p: DVec2) -> DVec2 {
        self.turn.apply(p) + self.at
    }

    /// A curve of the shape after placement.
    #[must_use]
    pub fn curve(&self, curve: &Curve) -> Curve {
        Curve {
            a: self.point(curve.a),
            b: self.point(curve.b),
            m: self.point(curve.m),
            n: self.turn.apply(curve.n),
            curvature: curve.curvature,
        }
    }
}
