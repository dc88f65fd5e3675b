//! Refractive index against wavelength: dispersion formulas with their ranges, and a catalog of media as data.

pub mod catalog;
mod dispersion;
mod error;
mod formula;

pub use dispersion::Dispersion;
pub use error::MediumError;
