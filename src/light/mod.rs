//! Light: vacuum wavelength, spectral lines, color, and power in its two polarizations.

mod color;
mod fraunhofer;
mod power;
mod wavelength;

pub use color::{gray, readable_on_dark, readable_on_light, spectral_color};
pub use fraunhofer::{FRAUNHOFER, SpectralLine};
pub use power::Power;
pub use wavelength::Wavelength;
