use glam::DVec2;

use crate::geometry::Curve;

/// The smallest axis-parallel box around something; empty until something is added.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Lower left corner; above `max` while empty.
    pub min: DVec2,
    /// Upper right corner.
    pub max: DVec2,
}

impl Bounds {
    /// The empty box.
    pub const EMPTY: Self = Self { min: DVec2::INFINITY, max: DVec2::NEG_INFINITY };

    /// The box around points.
    pub fn of(points: impl IntoIterator<Item = DVec2>) -> Self {
        points.into_iter().fold(Self::EMPTY, Self::with)
    }

    /// The box that holds a point too.
    #[must_use]
    pub fn with(self, p: DVec2) -> Self {
        Self { min: self.min.min(p), max: self.max.max(p) }
    }

    /// The box that holds another box too.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// The box grown by a margin on every side.
    #[must_use]
    pub fn grown(self, margin: f64) -> Self {
        Self { min: self.min - DVec2::splat(margin), max: self.max + DVec2::splat(margin) }
    }

    /// Whether a point lies inside or on the border.
    #[must_use]
    pub fn contains(self, p: DVec2) -> bool {
        p.cmpge(self.min).all() && p.cmple(self.max).all()
    }

    /// Whether two boxes share a point.
    #[must_use]
    pub fn meets(self, other: Self) -> bool {
        self.min.cmple(other.max).all() && other.min.cmple(self.max).all()
    }

    /// Width and height; negative while empty.
    #[must_use]
    pub fn size(self) -> DVec2 {
        self.max - self.min
    }

    /// The middle.
    #[must_use]
    pub fn center(self) -> DVec2 {
        self.min + 0.5 * self.size()
    }

    /// Largest absolute coordinate; 0 while empty.
    #[must_use]
    pub fn reach(self) -> f64 {
        if self.min.x > self.max.x { 0.0 } else { self.min.abs().max(self.max.abs()).max_element() }
    }
}

impl From<&Curve> for Bounds {
    /// The box around a curve: exact for an edge, up to rounding for an arc.
    fn from(curve: &Curve) -> Self {
        let mut bounds = Self::of([curve.a, curve.b]);
        if !curve.is_straight() {
            let (center, radius) = (curve.center(), curve.curvature.abs().recip());
            let extremes = [DVec2::X, DVec2::Y, -DVec2::X, -DVec2::Y].map(|axis| center + radius * axis);
            bounds = extremes.into_iter().filter(|p| curve.bulge_holds(*p)).fold(bounds, Self::with);
            bounds = bounds.with(curve.midpoint());
        }
        bounds
    }
}
