//! Deviation by a prism.

use crate::numerics::{Turn, asin_degrees};

/// The least angle, in degrees, by which a prism of relative index `n` and apex angle `apex_angle` (degrees, above 0 to below
/// 180) turns light that passes through both of its faces; negative, away from the base, where the prism is the thinner
/// medium. There the light crosses the prism symmetrically: sin((A + δ)/2) = n sin(A/2).
///
/// `None` where no light passes, n sin(A/2) > 1, and for an index or an angle outside its range.
///
/// # Source
/// Hecht, "Optics", 4th ed., section 5.5.1, equation 5.54; Born & Wolf, "Principles of Optics", 7th ed., section 4.7.2.
#[must_use]
pub fn minimum_deviation(n: f64, apex_angle: f64) -> Option<f64> {
    let sin = n * Turn::degrees(0.5 * apex_angle).sin;
    let is_prism = n > 0.0 && apex_angle > 0.0 && apex_angle < 180.0;
    (is_prism && sin <= 1.0).then(|| 2.0 * asin_degrees(sin) - apex_angle)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_equilateral_prism_of_root_two_turns_by_30_degrees() {
        let deviation = minimum_deviation(2_f64.sqrt(), 60.0).unwrap();
        assert!((deviation - 30.0).abs() < 1e-13, "{deviation}");
        let hollow = minimum_deviation(0.5_f64.sqrt(), 90.0).unwrap();
        assert!((hollow + 30.0).abs() < 1e-13, "{hollow}");
    }

    #[test]
    fn where_no_light_passes() {
        assert_eq!(minimum_deviation(1.5, 84.0), None);
        assert!(minimum_deviation(1.5, 83.0).is_some());
        for (n, apex_angle) in [(1.5, 0.0), (1.5, 180.0), (0.0, 60.0), (f64::NAN, 60.0), (1.5, f64::NAN)] {
            assert_eq!(minimum_deviation(n, apex_angle), None);
        }
    }
}
