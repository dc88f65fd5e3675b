//! How much light a boundary reflects.

use crate::light::Power;

/// What a boundary between two transparent media reflects and transmits, by polarization.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fresnel {
    /// Amplitude reflection coefficient for s, −1 to 1; negative into the denser medium.
    pub r_s: f64,
    /// Amplitude reflection coefficient for p, −1 to 1, with the sign that makes r_p = −r_s at normal incidence.
    pub r_p: f64,
    /// Reflected fraction R of the power, 0 to 1.
    pub reflectance: Power,
    /// Transmitted fraction T of the power, 0 to 1; R + T = 1.
    pub transmittance: Power,
}

/// Fresnel's equations for a ray that [`refract`](super::refract) lets through; arguments as it returns them, the two sines
/// of one sign.
///
/// With a = n_i C1, b = n_t C2, c = n_t C1, d = n_i C2 the amplitudes are (a − b)/(a + b) and (c − d)/(c + d). The
/// differences cancel between similar media and near Brewster's angle, so Snell's law is put in first:
/// - a² − b² = n_i² − n_t², hence r_s = (n_i − n_t)(n_i + n_t)/(a + b)²;
/// - c² − d² = (n_t² − n_i²)(C1² − S2²), hence r_p = (n_t − n_i)(n_t + n_i) cos(θ_i + θ_t) cos(θ_i − θ_t)/(c + d)²; the first
///   cosine is 0 at Brewster's angle, where the reflected ray would be at right angles to the transmitted one;
/// - T_s = 4ab/(a + b)², T_p = 4cd/(c + d)².
///
/// The smaller of R and T is computed, the other is its complement, so that R + T = 1 to one rounding. Equal indices
/// reflect exactly nothing; grazing incidence (C1 = 0) reflects everything.
///
/// # Source
/// Hecht, "Optics", 4th ed., section 4.6.2 (amplitudes) and 4.6.3 (reflectance and transmittance);
/// Born & Wolf, "Principles of Optics", 7th ed., sections 1.5.2 and 1.5.3.
#[inline]
#[must_use]
pub fn fresnel(n_i: f64, n_t: f64, cos_i: f64, sin_i: f64, cos_t: f64, sin_t: f64) -> Fresnel {
    let contrast = (n_i - n_t) * (n_i + n_t);
    if contrast == 0.0 {
        let (reflectance, transmittance) = (Power::default(), Power::both(1.0));
        return Fresnel { r_s: 0.0, r_p: 0.0, reflectance, transmittance };
    }
    let (a, b) = (n_i * cos_i, n_t * cos_t);
    let (c, d) = (n_t * cos_i, n_i * cos_t);
    let s = (a + b) * (a + b);
    let p = (c + d) * (c + d);
    let r_s = contrast / s;
    let (cosines, sines) = (cos_i * cos_t, sin_i * sin_t);
    let r_p = -contrast * ((cosines - sines) * (cosines + sines)) / p;
    let (reflected_s, transmitted_s) = shares(r_s, 4.0 * a * b / s);
    let (reflected_p, transmitted_p) = shares(r_p, 4.0 * c * d / p);
    Fresnel {
        r_s,
        r_p,
        reflectance: Power { s: reflected_s, p: reflected_p },
        transmittance: Power { s: transmitted_s, p: transmitted_p },
    }
}

/// R and T from the reflected amplitude and the transmitted fraction: the smaller as it is, the larger as its complement.
fn shares(r: f64, transmitted: f64) -> (f64, f64) {
    let reflected = r * r;
    if reflected <= 0.5 { (reflected, 1.0 - reflected) } else { (1.0 - transmitted, transmitted) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn glass_at_normal_incidence_reflects_4_percent() {
        let f = fresnel(1.0, 1.5, 1.0, 0.0, 1.0, 0.0);
        assert!((f.r_s + 0.2).abs() < 1e-16 && (f.r_p - 0.2).abs() < 1e-16);
        assert!((f.reflectance.s - 0.04).abs() < 1e-17 && (f.transmittance.p - 0.96).abs() < 2e-16);
    }

    #[test]
    fn equal_indices_reflect_nothing() {
        for cos in [1.0, 0.5, 0.0] {
            let sin = f64::sqrt(1.0 - cos * cos);
            let f = fresnel(1.3, 1.3, cos, sin, cos, sin);
            assert_eq!((f.reflectance, f.transmittance), (Power::default(), Power::both(1.0)));
        }
    }

    #[test]
    fn grazing_incidence_reflects_everything() {
        let f = fresnel(1.0, 1.25, 0.0, 1.0, 0.6, 0.8);
        assert_eq!((f.reflectance, f.transmittance), (Power::both(1.0), Power::default()));
    }

    #[test]
    fn brewsters_angle_reflects_no_p() {
        // tan θ_B = 4/3: C1 = 3/5 = S2 exactly.
        let f = fresnel(1.0, 4.0 / 3.0, 0.6, 0.8, 0.8, 0.6);
        assert_eq!((f.r_p, f.reflectance.p, f.transmittance.p), (0.0, 0.0, 1.0));
    }
}
