/// A transparent, isotropic, lossless medium, by what its refractive index is computed from.
#[derive(Clone, Debug, PartialEq)]
pub enum Medium {
    /// The same index n ≥ 1 at every wavelength.
    Index(f64),
    /// The phase speed of light v in m/s, 0 < v ≤ c; n = c/v.
    Speed(f64),
    /// Cauchy's formula n = A + B/λ² + C/λ⁴ …, λ in micrometres.
    Cauchy(Vec<f64>),
    /// Sellmeier's formula n² = 1 + Σ Bᵢ λ²/(λ² − Cᵢ), λ in micrometres.
    Sellmeier {
        /// B₁ to B₃, no unit.
        b: [f64; 3],
        /// C₁ to C₃ in µm².
        c: [f64; 3],
    },
    /// A medium of the built-in catalog by its name, such as `N-BK7`.
    Catalog(String),
}
