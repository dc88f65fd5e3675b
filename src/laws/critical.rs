//! The angles of incidence at which transmission, or reflection of p, stops.

use crate::numerics::atan2_degrees;

/// The critical angle, sin θ_c = n_t/n_i, in degrees, 0 to 90; `None` unless n_i > n_t, since into the denser medium every
/// angle is transmitted.
///
/// Computed as tan θ_c = n_t/√((n_i − n_t)(n_i + n_t)), which keeps its digits as the indices draw together and θ_c
/// approaches 90°, where the arc sine loses half of them.
///
/// # Source
/// Hecht, "Optics", 4th ed., section 4.7; Born & Wolf, "Principles of Optics", 7th ed., section 1.5.4.
#[must_use]
pub fn critical_angle(n_i: f64, n_t: f64) -> Option<f64> {
    (n_i > n_t).then(|| atan2_degrees(n_t, ((n_i - n_t) * (n_i + n_t)).sqrt()))
}

/// Brewster's angle, tan θ_B = n_t/n_i, in degrees, 0 to 90: light that arrives at it from `n_i` reflects no p
/// polarization. 45° between equal indices, where nothing is reflected at any angle.
///
/// # Source
/// Hecht, "Optics", 4th ed., section 8.6.1; Born & Wolf, "Principles of Optics", 7th ed., section 1.5.3.
#[must_use]
pub fn brewster_angle(n_i: f64, n_t: f64) -> f64 {
    atan2_degrees(n_t, n_i)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_toward_the_thinner_medium() {
        assert_eq!(critical_angle(1.0, 1.5), None);
        assert_eq!(critical_angle(1.5, 1.5), None);
        assert!((critical_angle(2.0, 1.0).unwrap() - 30.0).abs() < 1e-14);
    }

    #[test]
    fn nearly_equal_indices() {
        // 90° − θ_c = √(2 δ) radians to first order in the contrast δ; here δ = 2^-52.
        let short_of_90 = 90.0 - critical_angle(1.0 + f64::EPSILON, 1.0).unwrap();
        assert!((short_of_90.to_radians() / (2.0 * f64::EPSILON).sqrt() - 1.0).abs() < 1e-6);
    }

    #[test]
    fn brewster_and_its_way_back_add_to_90() {
        assert!((brewster_angle(1.0, 1.5) + brewster_angle(1.5, 1.0) - 90.0).abs() < 2e-14);
    }
}
