//! Snell's law, by components and in the vector form.

use glam::DVec2;

use super::{Incidence, relative_index, renormalized};
use crate::numerics::{cross_parts, excess_length, product_parts};

/// What the boundary lets through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Refraction {
    /// A transmitted ray, n_i S1 = n_t S2.
    Refracted {
        /// Unit direction T of the transmitted ray.
        direction: DVec2,
        /// Cosine C1 of the angle of incidence, 0 to 1.
        cos_i: f64,
        /// Sine S1 of the angle of incidence, signed: positive where V turns counter-clockwise from −N.
        sin_i: f64,
        /// Cosine C2 of the angle of transmission, above 0 (at least 0 between equal indices).
        cos_t: f64,
        /// Sine S2 of the angle of transmission, signed as S1.
        sin_t: f64,
    },
    /// Nothing is transmitted: 1 − (1 − C1²)/η² ≤ 0. At exactly 0 the transmitted ray would run along the boundary and
    /// carry nothing.
    TotalInternalReflection {
        /// Cosine C1 of the angle of incidence, 0 to 1.
        cos_i: f64,
        /// Sine S1 of the angle of incidence, signed as above.
        sin_i: f64,
        /// Whether the discriminant is 0, up to the rounding of V and N: T would run along the boundary, at 90° from the
        /// normal.
        critical: bool,
    },
}

impl Refraction {
    /// Cosine C1 of the angle of incidence, 0 to 1.
    #[must_use]
    pub fn cos_i(&self) -> f64 {
        match *self {
            Self::Refracted { cos_i, .. } | Self::TotalInternalReflection { cos_i, .. } => cos_i,
        }
    }

    /// Sine S1 of the angle of incidence, signed: positive where V turns counter-clockwise from −N.
    #[must_use]
    pub fn sin_i(&self) -> f64 {
        match *self {
            Self::Refracted { sin_i, .. } | Self::TotalInternalReflection { sin_i, .. } => sin_i,
        }
    }

    /// Unit direction of the transmitted ray; `None` at total internal reflection.
    #[must_use]
    pub fn direction(&self) -> Option<DVec2> {
        match *self {
            Self::Refracted { direction, .. } => Some(direction),
            Self::TotalInternalReflection { .. } => None,
        }
    }
}

/// Snell's law, n_i sin θ_i = n_t sin θ_t: refracts the unit direction `v` at a boundary with unit normal `n` against it
/// (N·V < 0), from absolute index `n_i` into `n_t`, both at least 1.
///
#[cfg_attr(doc, doc = include_str!("../../docs/figures/refraction.svg"))]
///
/// Equal indices return `v` itself, bit for bit, at every angle. At grazing incidence (C1 = 0) into a denser medium the
/// ray is refracted at the critical angle of the way back. (n_t C2)² ≤ 0 is total internal reflection, and only a thinner
/// medium can give it. Module [`laws`](super) says why the law is computed by components.
///
/// # Accuracy
/// The arguments are taken as exact, `v` and `n` as directions whose lengths are 1 but for rounding: sin θ_i is their cross
/// product over their lengths. n_i sin θ_i is carried with twice the digits, so that the subtraction from n_t loses none: T is
/// within 4 u max(1, tan θ_t) of the true direction, u = 2^-53, and within 2 u near the critical angle. The discriminant C2² is
/// good to some 2^-102 max(1, n_i/n_t), which tells total reflection from transmission; C2 has the relative error of its root
/// beside a few u.
///
/// # Source
/// Hecht, "Optics", 4th ed., section 4.4.1; Born & Wolf, "Principles of Optics", 7th ed., section 1.5.1; total internal
/// reflection: Hecht section 4.7, Born & Wolf section 1.5.4.
#[inline]
#[must_use]
pub fn refract(v: DVec2, n: DVec2, n_i: f64, n_t: f64) -> Refraction {
    refract_at(&Incidence::new(v, n), v, (n, excess_length(n)), n_i, n_t)
}

/// The same for an incidence that is known, and the excess of the normal's length.
#[inline(always)]
pub(crate) fn refract_at(incidence: &Incidence, v: DVec2, (n, excess): (DVec2, f64), n_i: f64, n_t: f64) -> Refraction {
    let Incidence { cos: cos_i, sin: sin_i, tangent } = *incidence;
    // The same medium on both sides: no boundary at all.
    #[expect(clippy::float_cmp, reason = "only the very same index is no boundary")]
    if n_i == n_t {
        return Refraction::Refracted { direction: v, cos_i, sin_i, cos_t: cos_i, sin_t: sin_i };
    }
    let (k, rest) = along_boundary(v, (n, excess), n_i);
    let transmitted_normal_squared = ((n_t - k.abs()) - rest) * (n_t + k.abs());
    // Total internal reflection: nothing is transmitted.
    if transmitted_normal_squared <= RESOLUTION * n_t * n_t {
        let critical = -transmitted_normal_squared <= CRITICAL * n_i * n_t;
        return Refraction::TotalInternalReflection { cos_i, sin_i, critical };
    }
    // The component of n V along the boundary is the same on both sides.
    let (cos_t, sin_t) = (transmitted_normal_squared.sqrt() / n_t, k / n_t);
    Refraction::Refracted { direction: renormalized(sin_t * tangent - cos_t * n), cos_i, sin_i, cos_t, sin_t }
}

/// k = n_i sin θ_i, signed as the sine, and what |k| still lacks: the cross product of `v` and `n` with what rounding took
/// from it, over their lengths. With |v|² |n|² = 1 + e that divides by 1 + e/2 − e²/8.
#[inline(always)]
fn along_boundary(v: DVec2, (n, excess): (DVec2, f64), n_i: f64) -> (f64, f64) {
    let (sine, sine_rest) = cross_parts(v, n);
    let e = excess_length(v) + excess;
    let (k, k_rest) = product_parts(n_i, sine);
    let rest = k_rest + n_i * sine_rest - k * (0.5 * e - 0.375 * e * e);
    // The nearest number first, so that k alone is good to one rounding.
    let nearest = k + rest;
    (nearest, (rest - (nearest - k)) * sine.signum())
}

/// Discriminants below this are 0: their own error is some 2^-102 n_i/n_t.
const RESOLUTION: f64 = f64::EPSILON * f64::EPSILON * 16.0;

/// Rounding V and N to their nearest numbers moves 1 − (1 − C1²)/η² by up to 4 u n_i/n_t: that much past it is still the
/// critical angle.
const CRITICAL: f64 = 2.0 * f64::EPSILON;

/// The vector form of Snell's law: T = V/η + (C1/η − C2) N with C1 = −N·V, C2 = √(1 + (C1² − 1)/η²) and η = n_t/n_i, the
/// transmitted direction straight from the incoming one and the normal, without an angle or a tangent. `None` where the
/// radicand is 0 or below: total internal reflection.
///
/// The ray is shortened by η, which leaves its component along the boundary as Snell's law wants it, and the component
/// along N is then replaced by C2, so that the length is 1 again. For teaching, and to hold [`refract`] against: it loses
/// digits toward normal incidence and toward the critical angle.
///
/// # Source
/// Glassner, "Surface Physics for Ray Tracing", in "An Introduction to Ray Tracing", 1989, chapter 4.
#[must_use]
pub fn refract_vector_form(v: DVec2, n: DVec2, n_i: f64, n_t: f64) -> Option<DVec2> {
    let eta = relative_index(n_i, n_t);
    let c1 = -n.dot(v);
    let radicand = 1.0 + (c1 * c1 - 1.0) / (eta * eta);
    (radicand > 0.0).then(|| v / eta + (c1 / eta - radicand.sqrt()) * n)
}

#[cfg(test)]
mod tests {
    use super::*;

    const N: DVec2 = DVec2::NEG_X;

    #[test]
    fn the_3_4_5_ray() {
        // sin θ_i = 4/5 into n = 4/3: sin θ_t = 3/5 exactly.
        let Refraction::Refracted { direction, cos_i, sin_i, cos_t, sin_t } =
            refract(DVec2::new(0.6, 0.8), N, 1.0, 4.0 / 3.0)
        else {
            panic!("a ray into the denser medium is always transmitted")
        };
        assert_eq!((cos_i, sin_i), (0.6, 0.8));
        assert!((cos_t - 0.8).abs() < 2e-16 && (sin_t - 0.6).abs() < 2e-16);
        assert!((direction - DVec2::new(0.8, 0.6)).length() < 2e-16);
    }

    #[test]
    fn the_vector_form_of_the_3_4_5_ray() {
        let t = refract_vector_form(DVec2::new(0.6, 0.8), N, 1.0, 4.0 / 3.0).unwrap();
        assert!((t - DVec2::new(0.8, 0.6)).length() < 2e-16);
        let back = refract_vector_form(DVec2::new(0.8, -0.6), N, 4.0 / 3.0, 1.0).unwrap();
        assert!((back - DVec2::new(0.6, -0.8)).length() < 4e-16);
    }

    #[test]
    fn the_vector_form_goes_straight_at_normal_incidence_and_ends_at_the_critical_angle() {
        for (n_i, n_t) in [(1.0, 1.5), (1.5, 1.0), (1.5, 1.5)] {
            let t = refract_vector_form(DVec2::X, N, n_i, n_t).unwrap();
            assert!((t - DVec2::X).length() < 4e-16, "{n_i} to {n_t}: {t}");
        }
        // From n = 2 into 1 the critical angle is 30°: past it at sin θ_i = 4/5, not yet at sin θ_i = 0.48.
        assert_eq!(refract_vector_form(DVec2::new(0.6, 0.8), N, 2.0, 1.0), None);
        assert!(refract_vector_form(DVec2::new(0.8772684879784524, 0.48), N, 2.0, 1.0).is_some());
    }

    #[test]
    fn normal_incidence_goes_straight() {
        assert_eq!(refract(DVec2::X, N, 1.0, 1.5).direction(), Some(DVec2::X));
        assert_eq!(refract(DVec2::X, N, 1.5, 1.0).direction(), Some(DVec2::X));
    }

    #[test]
    fn at_the_critical_angle_nothing_is_transmitted() {
        // From n = 5/2 into 3/2 it is that of the 3-4-5 triangle, which is a vector of numbers without rounding.
        let fifth = 1_801_439_850_948_198.0 * 0.5 * f64::EPSILON;
        let at = |sin: f64| refract(DVec2::new(4.0 * fifth, sin), N, 2.5, 1.5);
        let sin = 3.0 * fifth;
        assert!(matches!(at(sin), Refraction::TotalInternalReflection { critical: true, .. }));
        assert!(matches!(at(sin + 1e-15), Refraction::TotalInternalReflection { critical: false, .. }));
        let just_below = at(sin.next_down()).direction().unwrap();
        assert!(just_below.x > 0.0 && just_below.x < 3e-8 && just_below.y > 1.0 - 2e-16, "{just_below}");
    }

    #[test]
    fn the_critical_angle_as_scenes_give_it() {
        // sin θ_i = 4/5 and n_i = 5/4; sin θ_i = 1/n_i: at the critical angle up to the rounding of V.
        let steep = |n_i: f64| ((1.0 - 1.0 / (n_i * n_i)).sqrt(), 1.0 / n_i, n_i);
        for (cos_i, sin_i, n_i) in [(0.6, 0.8, 1.25), steep(2.0), steep(2.5), steep(4.0), steep(8.0), steep(16.0)] {
            match refract(DVec2::new(cos_i, sin_i), N, n_i, 1.0) {
                Refraction::Refracted { cos_t, .. } => assert!(cos_t < 3e-8, "{n_i}: {cos_t}"),
                Refraction::TotalInternalReflection { critical, .. } => assert!(critical, "{n_i}"),
            }
            let (sin, cos) = (sin_i - 1e-15, cos_i + 1e-15 * sin_i / cos_i);
            assert!(refract(DVec2::new(cos, sin), N, n_i, 1.0).direction().is_some());
            let (sin, cos) = (sin_i + 1e-15, cos_i - 1e-15 * sin_i / cos_i);
            let beyond = refract(DVec2::new(cos, sin), N, n_i, 1.0);
            assert!(matches!(beyond, Refraction::TotalInternalReflection { critical: false, .. }), "{n_i}");
        }
    }

    #[test]
    fn nearly_equal_indices_near_the_critical_angle() {
        // cos θ_c = 4.47e-4; a change by 1e-10 of it does not reach the last digit of the sine.
        let (n_i, n_t): (f64, f64) = (1.0 + 1e-7, 1.0);
        let critical = ((n_i - n_t) * (n_i + n_t)).sqrt() / n_i;
        for (share, transmitted) in [(1.0 + 1e-10, true), (1.0 - 1e-10, false)] {
            let cos = critical * share;
            let v = DVec2::new(cos, ((1.0 - cos) * (1.0 + cos)).sqrt());
            assert_eq!(refract(v, N, n_i, n_t).direction().is_some(), transmitted, "{share}");
        }
    }

    #[test]
    fn equal_indices_change_no_bit() {
        for v in [DVec2::new(0.6, 0.8), DVec2::Y, DVec2::new(1e-300, 1.0), DVec2::new(0.1, 0.995)] {
            assert_eq!(refract(v, N, 1.7, 1.7).direction(), Some(v));
        }
    }

    #[test]
    fn the_sine_of_a_tiny_angle_keeps_its_digits() {
        let Refraction::Refracted { sin_t, .. } = refract(DVec2::new(1.0, 3e-9), N, 1.0, 1.5) else {
            panic!("a ray into the denser medium is always transmitted")
        };
        assert!((sin_t / 2e-9 - 1.0).abs() < 4e-16);
    }
}
