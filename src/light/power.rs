use std::ops::{Add, Sub};

/// Power carried by a ray, its two polarizations apart, in the unit of the source's power.
///
/// In two dimensions every hit shares one plane of incidence, so s and p never mix and carrying them apart is exact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Power {
    /// Electric field perpendicular to the drawing plane (TE).
    pub s: f64,
    /// Electric field in the drawing plane (TM).
    pub p: f64,
}

impl Power {
    /// Both polarizations together.
    #[must_use]
    pub fn total(self) -> f64 {
        self.s + self.p
    }

    /// The part of each polarization that the fractions `share` leave.
    #[must_use]
    pub fn times(self, share: Self) -> Self {
        Self { s: self.s * share.s, p: self.p * share.p }
    }

    /// The same value for both polarizations.
    #[must_use]
    pub fn both(value: f64) -> Self {
        Self { s: value, p: value }
    }
}

impl Add for Power {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { s: self.s + other.s, p: self.p + other.p }
    }
}

impl Sub for Power {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { s: self.s - other.s, p: self.p - other.p }
    }
}
