//! The spectral lines that glass catalogs quote.

use super::Wavelength;

/// A spectral line with the letter that optics gives it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct SpectralLine {
    /// The letter, as in n_d; `HeNe` for the laser.
    pub letter: &'static str,
    /// What emits it.
    pub emitter: &'static str,
    /// Its wavelength.
    pub wavelength: Wavelength,
}

/// The lines g, F, e, d, D, HeNe and C, at which glass catalogs quote indices, from blue to red.
///
/// # Source
/// Schott, "Optical Glass. Description of Properties", 2020, and Technical Information TIE-29, "Refractive Index and
/// Dispersion".
pub const FRAUNHOFER: [SpectralLine; 7] = [
    line("g", "mercury", Wavelength::MERCURY_G),
    line("F", "hydrogen", Wavelength::HYDROGEN_F),
    line("e", "mercury", Wavelength::MERCURY_E),
    line("d", "helium", Wavelength::D),
    line("D", "sodium", Wavelength::SODIUM_D),
    line("HeNe", "helium-neon laser", Wavelength::HELIUM_NEON),
    line("C", "hydrogen", Wavelength::HYDROGEN_C),
];

const fn line(letter: &'static str, emitter: &'static str, wavelength: Wavelength) -> SpectralLine {
    SpectralLine { letter, emitter, wavelength }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn from_blue_to_red() {
        assert!(FRAUNHOFER.is_sorted_by(|a, b| a.wavelength < b.wavelength));
    }
}
