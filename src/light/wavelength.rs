/// A vacuum wavelength in nanometres, finite and above 0.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Wavelength(f64);

impl Wavelength {
    /// The yellow helium d line, 587.5618 nm, at which catalogs quote n_d.
    pub const D: Self = Self(587.5618);

    /// A wavelength from nanometres; `None` unless finite and above 0.
    #[must_use]
    pub fn from_nanometres(nm: f64) -> Option<Self> {
        (nm.is_finite() && nm > 0.0).then_some(Self(nm))
    }

    /// The wavelength in nanometres.
    #[must_use]
    pub fn nanometres(self) -> f64 {
        self.0
    }

    /// The wavelength in micrometres, the unit of dispersion formulas.
    #[must_use]
    pub fn micrometres(self) -> f64 {
        self.0 / 1000.0
    }
}
