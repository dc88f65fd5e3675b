use std::fmt;

/// Why a medium cannot be used, or not at a wavelength.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum MediumError {
    /// A dispersion formula without coefficients.
    NoCoefficients,
    /// A coefficient that is NaN or infinite.
    CoefficientNotFinite(f64),
    /// A vacuum wavelength outside the range in which the medium's formula holds; all in nm.
    OutOfRange {
        /// The medium's catalog name; empty for a formula of the user's own.
        medium: &'static str,
        /// The wavelength asked for.
        wavelength: f64,
        /// The range, ends included.
        range: (f64, f64),
    },
    /// The formula gives no finite index: a pole, or a negative n².
    NoIndex {
        /// The wavelength asked for, nm.
        wavelength: f64,
    },
    /// The index is below 1.
    BelowOne {
        /// The wavelength asked for, nm.
        wavelength: f64,
        /// What the formula gives there.
        index: f64,
    },
}

impl fmt::Display for MediumError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoCoefficients => write!(f, "a dispersion formula needs at least one coefficient"),
            Self::CoefficientNotFinite(value) => {
                write!(f, "the coefficients of a dispersion formula must be finite numbers, not {value}")
            }
            Self::OutOfRange { medium, wavelength, range: (from, to) } => {
                let medium = if medium.is_empty() { "the medium" } else { medium };
                write!(f, "the index of {medium} is known from {from} nm to {to} nm, not at {wavelength} nm")
            }
            Self::NoIndex { wavelength } => {
                write!(
                    f,
                    "the dispersion formula gives no refractive index at {wavelength} nm (λ counts in micrometers there)"
                )
            }
            Self::BelowOne { wavelength, index } => write!(
                f,
                "the refractive index at {wavelength} nm is {index}, below 1: light would be faster than in vacuum"
            ),
        }
    }
}

impl std::error::Error for MediumError {}
