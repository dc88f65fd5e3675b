//! Law of reflection.

use glam::DVec2;

use super::{Incidence, renormalized};

/// The reflected unit direction R = V + 2 C1 N for unit `v` and unit normal `n` against it.
///
#[cfg_attr(doc, doc = include_str!("../../docs/figures/reflection.svg"))]
///
/// Computed by components: V = S1 τ − C1 N turns into R = S1 τ + C1 N. At grazing incidence (C1 = 0) R is V, along the
/// boundary.
///
/// # Source
/// Hecht, "Optics", 4th ed., section 4.3.1; vector form: Glassner, "Surface Physics for Ray Tracing", in "An
/// Introduction to Ray Tracing", 1989, chapter 4.
#[inline]
#[must_use]
pub fn reflect(v: DVec2, n: DVec2) -> DVec2 {
    reflect_at(&Incidence::new(v, n), n)
}

/// The same for an incidence that is known.
#[inline]
pub(crate) fn reflect_at(incidence: &Incidence, n: DVec2) -> DVec2 {
    renormalized(incidence.sin * incidence.tangent + incidence.cos * n)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn right_angles_are_exact() {
        let n = DVec2::new(-1.0, 0.0);
        assert_eq!(reflect(DVec2::X, n), -DVec2::X);
        assert_eq!(reflect(DVec2::Y, n), DVec2::Y);
        let v = DVec2::new(0.6, -0.8);
        assert!((reflect(v, DVec2::Y) - DVec2::new(0.6, 0.8)).length() < 2e-16);
    }
}
