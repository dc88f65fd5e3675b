use std::hash::{Hash, Hasher};

use super::MediumError;
use super::formula::Formula;
use crate::light::Wavelength;

/// The refractive index of a transparent medium as a function of the vacuum wavelength.
///
/// Two are equal where they are the same medium: the same formula with the same coefficients, not merely the same index
/// at one wavelength. A name or a range makes no difference.
///
/// # Source
/// Hecht, "Optics", 4th ed., section 3.5.1; Born & Wolf, "Principles of Optics", 7th ed., section 2.3.4. The media of the
/// [`catalog`](super::catalog) use formulas 1, 2, 3, 5 and 6 of the refractiveindex.info database; each names the source
/// of its coefficients.
#[derive(Clone, Debug)]
pub struct Dispersion {
    formula: Formula,
    range_nm: (f64, f64),
    name: &'static str,
}

impl PartialEq for Dispersion {
    fn eq(&self, other: &Self) -> bool {
        self.formula == other.formula
    }
}

/// No coefficient is NaN.
impl Eq for Dispersion {}

impl Hash for Dispersion {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.formula.numbers(|number| (number + 0.0).to_bits().hash(state));
    }
}

impl Dispersion {
    /// The same index at every wavelength.
    ///
    /// # Errors
    /// The index is NaN or infinite. An index below 1 is refused by [`check`](Self::check).
    pub fn constant(n: f64) -> Result<Self, MediumError> {
        finite(&[n])?;
        Ok(Self::of_user(Formula::Constant(n)))
    }

    /// Cauchy's formula n = A + B/λ² + C/λ⁴ + …, λ in micrometers, any number of coefficients. Zeros at the end are no
    /// terms: A alone is a constant index.
    ///
    /// # Source
    /// Born & Wolf, "Principles of Optics", 7th ed., section 2.3.4; formula 5, with even powers, of the refractiveindex.info
    /// database.
    ///
    /// # Errors
    /// No coefficients, or one that is not finite.
    pub fn cauchy(coefficients: &[f64]) -> Result<Self, MediumError> {
        finite(coefficients)?;
        let terms = coefficients.iter().rposition(|c| *c != 0.0).map_or(1, |last| last + 1);
        match &coefficients[..terms] {
            [n] => Self::constant(*n),
            several => Ok(Self::of_user(Formula::Cauchy(several.to_vec()))),
        }
    }

    /// Sellmeier's formula n² = 1 + Σ B λ²/(λ² − C), λ in micrometers, any number of terms (B, C), C in µm².
    ///
    /// # Source
    /// Hecht, "Optics", 4th ed., section 3.5.1; formula 2 of the refractiveindex.info database.
    ///
    /// # Errors
    /// No terms, or a coefficient that is not finite.
    pub fn sellmeier(terms: &[(f64, f64)]) -> Result<Self, MediumError> {
        let coefficients: Vec<f64> = terms.iter().flat_map(|&(b, c)| [b, c]).collect();
        finite(&coefficients)?;
        Ok(Self::of_user(Formula::Sellmeier { constant: 0.0, terms: terms.to_vec() }))
    }

    pub(super) fn cataloged(formula: Formula, range_nm: (f64, f64), name: &'static str) -> Self {
        Self { formula, range_nm, name }
    }

    fn of_user(formula: Formula) -> Self {
        Self { formula, range_nm: (0.0, f64::INFINITY), name: "" }
    }

    /// The catalog's name of the medium; `None` for a formula of the user's.
    #[must_use]
    pub fn name(&self) -> Option<&'static str> {
        (!self.name.is_empty()).then_some(self.name)
    }

    /// The vacuum wavelengths in nm at which the formula holds, ends included; 0 to infinity for a formula of the user's.
    #[must_use]
    pub fn range_nm(&self) -> (f64, f64) {
        self.range_nm
    }

    /// Whether the index changes with the wavelength.
    #[must_use]
    pub fn is_dispersive(&self) -> bool {
        !matches!(self.formula, Formula::Constant(_))
    }

    /// The index at a vacuum wavelength, at least 1 wherever [`check`](Self::check) passes; elsewhere what the formula
    /// gives, be it NaN.
    #[must_use]
    pub fn index(&self, wavelength: Wavelength) -> f64 {
        self.formula.index(wavelength.micrometers())
    }

    /// The index at a vacuum wavelength, if the formula holds there and gives a possible one.
    ///
    /// # Errors
    /// The wavelength is out of range, or the index is below 1 or not finite.
    pub fn check(&self, wavelength: Wavelength) -> Result<f64, MediumError> {
        let (range, medium, wavelength_nm) = (self.range_nm, self.name, wavelength.nanometers());
        if !(range.0..=range.1).contains(&wavelength_nm) {
            return Err(MediumError::OutOfRange { medium, wavelength: wavelength_nm, range });
        }
        let index = self.index(wavelength);
        if !index.is_finite() {
            Err(MediumError::NoIndex { wavelength: wavelength_nm })
        } else if index < 1.0 {
            Err(MediumError::BelowOne { wavelength: wavelength_nm, index })
        } else {
            Ok(index)
        }
    }
}

/// Refuses coefficients that no formula can have.
fn finite(coefficients: &[f64]) -> Result<(), MediumError> {
    match coefficients.iter().find(|c| !c.is_finite()) {
        Some(bad) => Err(MediumError::CoefficientNotFinite(*bad)),
        None if coefficients.is_empty() => Err(MediumError::NoCoefficients),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nm(nm: f64) -> Wavelength {
        Wavelength::from_nanometers(nm).unwrap()
    }

    #[test]
    fn cauchy_by_hand() {
        // λ = 0.5 µm: 1.5 + 0.004/0.25 + 0.0001/0.0625.
        let medium = Dispersion::cauchy(&[1.5, 0.004, 0.0001]).unwrap();
        assert!((medium.index(nm(500.0)) - 1.5176).abs() < 1e-15);
    }

    #[test]
    fn sellmeier_by_hand() {
        // λ² = 0.25, C = 0.01: n² = 1 + 0.96·0.25/0.24 = 2.
        let medium = Dispersion::sellmeier(&[(0.96, 0.01)]).unwrap();
        assert!((medium.index(nm(500.0)) - 2.0_f64.sqrt()).abs() < 1e-15);
    }

    #[test]
    fn the_same_medium_is_the_same_formula() {
        let half = Dispersion::constant(1.5).unwrap();
        assert_eq!(half, Dispersion::cauchy(&[1.5, 0.0]).unwrap());
        assert_ne!(half, Dispersion::cauchy(&[1.5, 1e-9]).unwrap());
        assert_ne!(half, Dispersion::sellmeier(&[(1.25, 0.0)]).unwrap(), "the same n, not the same medium");
    }

    #[test]
    fn impossible_coefficients_and_wavelengths_are_refused() {
        assert_eq!(Dispersion::cauchy(&[]), Err(MediumError::NoCoefficients));
        assert_eq!(Dispersion::sellmeier(&[]), Err(MediumError::NoCoefficients));
        assert_eq!(Dispersion::cauchy(&[1.5, f64::INFINITY]), Err(MediumError::CoefficientNotFinite(f64::INFINITY)));
        let thin = Dispersion::cauchy(&[0.9, 0.025]).unwrap();
        assert_eq!(thin.check(nm(500.0)), Ok(1.0));
        let error = thin.check(nm(1000.0)).unwrap_err();
        assert_eq!(
            error.to_string(),
            "the refractive index at 1000 nm is 0.925, below 1: light would be faster than in vacuum"
        );
        let pole = Dispersion::sellmeier(&[(1.0, 0.25)]).unwrap();
        assert_eq!(pole.check(nm(500.0)), Err(MediumError::NoIndex { wavelength: 500.0 }));
        assert_eq!(pole.check(nm(450.0)), Err(MediumError::NoIndex { wavelength: 450.0 }), "n² is negative");
    }
}
