//! The angle of incidence without angles.

use glam::DVec2;

use crate::numerics::{cross, dot};

/// A ray's direction V taken apart at a boundary: V = sin·τ − cos·N, with the cosine and sine of the angle of incidence
/// as the dot and cross product of two unit vectors.
///
/// # Source
/// Glassner, "Surface Physics for Ray Tracing", in "An Introduction to Ray Tracing", 1989, chapter 4, for C1 = −N·V; the
/// products are [`dot`] and [`cross`], whose source stands there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Incidence {
    /// Cosine C1 = −N·V of the angle of incidence, 0 to 1. Below 0, where N does not oppose V, it is taken as 0.
    pub cos: f64,
    /// Sine S1 of the angle of incidence, −1 to 1: positive where V turns counter-clockwise from −N.
    pub sin: f64,
    /// Unit tangent τ of the boundary: −N turned counter-clockwise by 90°.
    pub tangent: DVec2,
}

impl Incidence {
    /// Takes the unit direction `v` apart along the unit normal `n` against it.
    ///
    /// Both are relatively accurate, the sine down to normal incidence and the cosine down to grazing, where they are the
    /// difference of nearly equal products.
    #[inline]
    #[must_use]
    pub fn new(v: DVec2, n: DVec2) -> Self {
        Self { cos: (-dot(v, n)).clamp(0.0, 1.0), sin: cross(v, n).clamp(-1.0, 1.0), tangent: -n.perp() }
    }
}
