//! Secondary rays: how a hit shares the light that arrives.

use super::Fresnel;
use crate::light::Power;

/// The shares of power that a hit gives to its secondary rays, and what stays.
///
/// Every hit spawns a reflected and a transmitted ray, and each of them hits again: the light c that arrives is
/// c = c_local + k_r c_r + k_t c_t, where c_r and c_t are the same sum at the reflected and the transmitted ray's next
/// hit. k_r is the reflectance, k_t the transmittance, both by polarization; c_local is what stays at the hit. Reflectance,
/// transmittance and absorptance add to 1.
///
/// # Source
/// Whitted, "An Improved Illumination Model for Shaded Display", Communications of the ACM 23(6), 1980, 343-349, for the
/// recursion over the tree of reflected and transmitted rays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shares {
    /// The reflected ray's fraction k_r, 0 to 1.
    pub reflectance: Power,
    /// The transmitted ray's fraction k_t, 0 to 1.
    pub transmittance: Power,
    /// The fraction that stays at the hit, 0 to 1, alike for both polarizations.
    pub absorptance: f64,
}

impl Shares {
    /// Constants `kr` and `kt`, each at least 0 and together at most 1, alike for both polarizations; the rest stays.
    #[must_use]
    pub fn fixed(kr: f64, kt: f64) -> Self {
        // Unlike `max`, which would make 0 of NaN.
        let rest = 1.0 - (kr + kt);
        let absorptance = if rest < 0.0 { 0.0 } else { rest };
        Self { reflectance: Power::both(kr), transmittance: Power::both(kt), absorptance }
    }

    /// Fresnel's equations, s and p apart; nothing stays.
    #[must_use]
    pub fn fresnel(law: Fresnel) -> Self {
        Self { reflectance: law.reflectance, transmittance: law.transmittance, absorptance: 0.0 }
    }

    /// The transmitted ray carries everything.
    #[must_use]
    pub fn transmitted_only() -> Self {
        Self::fixed(0.0, 1.0)
    }

    /// The reflected ray carries everything, as past the critical angle or at a mirror.
    #[must_use]
    pub fn total_reflection() -> Self {
        Self::fixed(1.0, 0.0)
    }

    /// Everything stays: there are no secondary rays.
    #[must_use]
    pub fn absorbed() -> Self {
        Self::fixed(0.0, 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laws::fresnel;

    #[test]
    fn what_fixed_shares_leave_stays() {
        let shares = Shares::fixed(0.25, 0.5);
        assert_eq!((shares.reflectance, shares.transmittance), (Power::both(0.25), Power::both(0.5)));
        assert_eq!(shares.absorptance, 0.25);
        // A sum rounded to just above 1 leaves nothing, not less.
        assert_eq!(Shares::fixed(1.0, f64::EPSILON).absorptance, 0.0);
    }

    #[test]
    fn glass_at_normal_incidence_reflects_4_percent_and_keeps_nothing() {
        let shares = Shares::fresnel(fresnel(1.0, 1.5, 1.0, 0.0, 1.0, 0.0));
        assert!((shares.reflectance.s - 0.04).abs() < 1e-16 && (shares.reflectance.p - 0.04).abs() < 1e-16);
        assert!((shares.transmittance.s - 0.96).abs() < 2e-16 && (shares.transmittance.p - 0.96).abs() < 2e-16);
        assert_eq!(shares.absorptance, 0.0);
    }

    #[test]
    fn one_ray_or_none_carries_everything() {
        let (none, all) = (Power::both(0.0), Power::both(1.0));
        let of = |shares: Shares| (shares.reflectance, shares.transmittance, shares.absorptance);
        assert_eq!(of(Shares::transmitted_only()), (none, all, 0.0));
        assert_eq!(of(Shares::total_reflection()), (all, none, 0.0));
        assert_eq!(of(Shares::absorbed()), (none, none, 1.0));
    }

    #[test]
    fn the_recursion_over_a_slab_gives_the_closed_form() {
        // Through two faces with k_r = 1/5 and k_t = 4/5 the light sent on is k_t²/(1 − k_r²) = 2/3.
        let face = Shares::fixed(0.2, 0.8);
        let inside = |left: u32| -> f64 {
            let mut light = 0.0;
            for _ in 0..left {
                light = face.transmittance.s + face.reflectance.s * (face.reflectance.s * light);
            }
            light
        };
        assert!((face.transmittance.s * inside(30) - 2.0 / 3.0).abs() < 1e-15);
    }
}
