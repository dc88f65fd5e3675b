//! Light: vacuum wavelength, spectral lines, color, and power in its two polarizations.

mod power;
mod wavelength;

pub use power::Power;
pub use wavelength::Wavelength;
