//! Dispersion formulas, λ in micrometers throughout; numbers are those of the refractiveindex.info database.

use serde::Deserialize;

use crate::numerics::pow;

/// What the index is computed from.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub(super) enum Formula {
    /// n at every wavelength.
    Constant(f64),
    /// n = A + B/λ² + C/λ⁴ + … (formula 5 with even powers).
    Cauchy(Vec<f64>),
    /// n² = 1 + constant + Σ B λ²/(λ² − C), C in µm² (formula 2).
    Sellmeier { constant: f64, terms: Vec<(f64, f64)> },
    /// n² = 1 + constant + Σ B λ²/(λ² − C²), C in µm (formula 1).
    SellmeierRoot { constant: f64, terms: Vec<(f64, f64)> },
    /// n² = constant + Σ C λ^p, terms (C, p) (formula 3).
    Powers { constant: f64, terms: Vec<(f64, f64)> },
    /// n = 1 + constant + Σ B/(C − λ^−2), C in µm^−2 (formula 6, gases).
    Gas { constant: f64, terms: Vec<(f64, f64)> },
}

impl Formula {
    /// The index at a vacuum wavelength in micrometers; NaN or infinite where the formula breaks down.
    pub(super) fn index(&self, wavelength: f64) -> f64 {
        let square = wavelength * wavelength;
        match self {
            Self::Constant(n) => *n,
            Self::Cauchy(coefficients) => coefficients.iter().rev().fold(0.0, |sum, c| sum / square + c),
            Self::Sellmeier { constant, terms } => {
                (1.0 + constant + sum(terms, |b, c| b * square / (square - c))).sqrt()
            }
            Self::SellmeierRoot { constant, terms } => {
                (1.0 + constant + sum(terms, |b, c| b * square / (square - c * c))).sqrt()
            }
            Self::Powers { constant, terms } => (constant + sum(terms, |c, p| c * pow(wavelength, p))).sqrt(),
            Self::Gas { constant, terms } => 1.0 + constant + sum(terms, |b, c| b / (c - 1.0 / square)),
        }
    }

    /// Visits every number of the formula.
    pub(super) fn numbers(&self, mut visit: impl FnMut(f64)) {
        match self {
            Self::Constant(n) => visit(*n),
            Self::Cauchy(coefficients) => coefficients.iter().copied().for_each(visit),
            Self::Sellmeier { constant, terms }
            | Self::SellmeierRoot { constant, terms }
            | Self::Powers { constant, terms }
            | Self::Gas { constant, terms } => {
                visit(*constant);
                terms.iter().flat_map(|&(a, b)| [a, b]).for_each(visit);
            }
        }
    }
}

fn sum(terms: &[(f64, f64)], term: impl Fn(f64, f64) -> f64) -> f64 {
    terms.iter().map(|&(b, c)| term(b, c)).sum()
}
