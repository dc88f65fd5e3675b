/// A vacuum wavelength in nanometers, finite and above 0.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Wavelength(f64);

impl Wavelength {
    /// The yellow helium d line, 587.5618 nm, at which catalogs quote n_d.
    pub const D: Self = Self(587.5618);
    /// The blue mercury g line, 435.8343 nm.
    pub const MERCURY_G: Self = Self(435.8343);
    /// The blue hydrogen F line, 486.1327 nm, the short end of the Abbe number.
    pub const HYDROGEN_F: Self = Self(486.1327);
    /// The green mercury e line, 546.0740 nm.
    pub const MERCURY_E: Self = Self(546.074);
    /// The center of the yellow sodium doublet D, 589.2938 nm; not the d line.
    pub const SODIUM_D: Self = Self(589.2938);
    /// The red line of the helium-neon laser, 632.8 nm.
    pub const HELIUM_NEON: Self = Self(632.8);
    /// The red hydrogen C line, 656.2725 nm, the long end of the Abbe number.
    pub const HYDROGEN_C: Self = Self(656.2725);

    /// The wavelength `nm` nanometers; `None` unless finite and above 0.
    #[must_use]
    pub fn from_nanometers(nm: f64) -> Option<Self> {
        (nm.is_finite() && nm > 0.0).then_some(Self(nm))
    }

    /// The wavelength in nanometers.
    #[must_use]
    pub fn nanometers(self) -> f64 {
        self.0
    }

    /// The wavelength in micrometers, the unit of dispersion formulas.
    #[must_use]
    pub fn micrometers(self) -> f64 {
        self.0 / 1000.0
    }
}
