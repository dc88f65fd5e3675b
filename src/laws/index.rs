//! Index of refraction.

use std::fmt;

/// Speed of light in vacuum in m/s, exact by the definition of the meter (SI, 1983).
pub const SPEED_OF_LIGHT: f64 = 299_792_458.0;

/// Why a number is no refractive index, or no speed of light in a medium.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum IndexError {
    /// The index is NaN or infinite.
    NotFinite(f64),
    /// The index is below 1: light would be faster than in vacuum.
    BelowOne(f64),
    /// The speed in m/s is above that in vacuum.
    FasterThanLight(f64),
    /// The speed in m/s is NaN, 0, negative, or so small that the index overflows.
    NotASpeed(f64),
}

impl fmt::Display for IndexError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite(n) => write!(f, "the refractive index must be a finite number, not {n}"),
            Self::BelowOne(n) => {
                write!(
                    f,
                    "the refractive index is {n}, below 1: light would be faster than in vacuum (n = c/v and v ≤ c)"
                )
            }
            Self::FasterThanLight(v) => {
                write!(f, "the speed of light in the medium is {v} m/s, above that in vacuum, {SPEED_OF_LIGHT} m/s")
            }
            Self::NotASpeed(v) => {
                write!(
                    f,
                    "the speed of light in the medium must be above 0 and at most {SPEED_OF_LIGHT} m/s, not {v} m/s"
                )
            }
        }
    }
}

impl std::error::Error for IndexError {}

/// The absolute index n = c/v ≥ 1 of a medium in which light has the phase speed `v`, m/s.
///
/// # Source
/// Hecht, "Optics", 4th ed., section 3.5.
///
/// # Errors
/// The speed is above c, 0, negative or NaN.
pub fn index_from_speed(v: f64) -> Result<f64, IndexError> {
    if v > SPEED_OF_LIGHT {
        return Err(IndexError::FasterThanLight(v));
    }
    let n = SPEED_OF_LIGHT / v;
    if v > 0.0 && n.is_finite() { Ok(n) } else { Err(IndexError::NotASpeed(v)) }
}

/// The absolute index itself, if a transparent medium can have it: finite and at least 1.
///
/// # Errors
/// The number is below 1, infinite or NaN.
pub fn check_index(n: f64) -> Result<f64, IndexError> {
    if !n.is_finite() {
        Err(IndexError::NotFinite(n))
    } else if n < 1.0 {
        Err(IndexError::BelowOne(n))
    } else {
        Ok(n)
    }
}

/// The relative index η = n_t/n_i of the transmitting to the incident medium: above 1 into the denser one.
///
/// # Source
/// Hecht, "Optics", 4th ed., section 4.4.1.
#[must_use]
pub fn relative_index(n_i: f64, n_t: f64) -> f64 {
    n_t / n_i
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn index_is_c_over_v() {
        assert_eq!(index_from_speed(SPEED_OF_LIGHT), Ok(1.0));
        assert_eq!(index_from_speed(SPEED_OF_LIGHT / 2.0), Ok(2.0));
        assert_eq!(relative_index(1.5, 3.0), 2.0);
    }

    #[test]
    fn impossible_speeds_are_refused_with_the_reason() {
        assert_eq!(index_from_speed(3e8), Err(IndexError::FasterThanLight(3e8)));
        for v in [0.0, -1.0, 1e-310] {
            assert_eq!(index_from_speed(v), Err(IndexError::NotASpeed(v)));
        }
        assert!(index_from_speed(f64::NAN).is_err());
        assert!(IndexError::FasterThanLight(3e8).to_string().contains("299792458 m/s"));
    }

    #[test]
    fn impossible_indices_are_refused_with_the_reason() {
        assert_eq!(check_index(1.0), Ok(1.0));
        assert_eq!(check_index(0.999), Err(IndexError::BelowOne(0.999)));
        assert_eq!(check_index(f64::INFINITY), Err(IndexError::NotFinite(f64::INFINITY)));
        assert!(check_index(f64::NAN).is_err());
    }
}
