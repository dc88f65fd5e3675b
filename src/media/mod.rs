//! Refractive index against wavelength.

use crate::light::Wavelength;

/// Placeholder until the catalog stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Dispersion(f64);

impl Dispersion {
    /// Index at a wavelength.
    #[must_use]
    pub fn index(&self, _: Wavelength) -> f64 {
        self.0
    }
}
