use crate::laws::{IndexError, check_index, index_from_speed};
use crate::media::{Dispersion, MediumError, catalog};
use crate::scene::Problem;
use crate::scene::problem::shortened;

/// A transparent, isotropic, lossless medium, by what its refractive index is computed from.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Medium {
    /// The same index n ≥ 1 at every wavelength.
    Index(f64),
    /// The phase speed of light v in m/s, 0 < v ≤ c; n = c/v.
    Speed(f64),
    /// Cauchy's formula n = A + B/λ² + C/λ⁴ …, λ in micrometers.
    Cauchy(Vec<f64>),
    /// Sellmeier's formula n² = 1 + Σ Bᵢ λ²/(λ² − Cᵢ), λ in micrometers.
    Sellmeier {
        /// B₁ to B₃, no unit.
        b: [f64; 3],
        /// C₁ to C₃ in µm².
        c: [f64; 3],
    },
    /// A medium of the built-in catalog by its name, such as `N-BK7`.
    Catalog(String),
}

impl Medium {
    /// The refractive index against wavelength.
    ///
    /// # Errors
    /// What is wrong with the medium's numbers or name; the problem's path is relative to the medium.
    pub fn dispersion(&self) -> Result<Dispersion, Problem> {
        match self {
            Self::Index(n) => {
                check_index(*n).map_err(index_problem).and_then(|n| formula(Dispersion::constant(n), "n"))
            }
            Self::Speed(v) => {
                index_from_speed(*v).map_err(speed_problem).and_then(|n| formula(Dispersion::constant(n), "v"))
            }
            Self::Cauchy(coefficients) => formula(Dispersion::cauchy(coefficients), "coefficients"),
            Self::Sellmeier { b, c } => {
                let terms = [(b[0], c[0]), (b[1], c[1]), (b[2], c[2])];
                formula(Dispersion::sellmeier(&terms), "b")
            }
            Self::Catalog(name) => {
                catalog::find(name).map(|entry| entry.dispersion().clone()).ok_or_else(|| unknown(name))
            }
        }
    }
}

fn index_problem(error: IndexError) -> Problem {
    let help = "write n ≥ 1: 1 is vacuum, water has 1.33, glass 1.5 to 1.9, diamond 2.42";
    Problem::error("n", error.to_string(), help).label("not an index")
}

fn speed_problem(error: IndexError) -> Problem {
    let help = "write the phase speed in m/s, above 0 and at most 299792458; in water it is 2.25e8";
    Problem::error("v", error.to_string(), help).label("not a speed")
}

fn formula(dispersion: Result<Dispersion, MediumError>, path: &str) -> Result<Dispersion, Problem> {
    dispersion.map_err(|error| {
        let help = "write finite coefficients; λ counts in micrometers in them";
        Problem::error(path, error.to_string(), help).label("not a formula")
    })
}

fn unknown(name: &str) -> Problem {
    let near = catalog::nearest(&shortened(name)).map_or(String::new(), |near| format!("did you mean `{near}`? "));
    let help = format!("{near}`snellius materials` lists all names");
    Problem::error("name", format!("the catalog has no medium `{}`", shortened(name)), help).label("unknown name")
}
