//! Refractive indices by their formulas. The catalog is read as data: its file holds what was published.

use f256::f256;
use serde::Deserialize;
use snellius::scene::Medium;

use crate::support::root;
use crate::support::wide::wide;

/// A formula of the refractiveindex.info database; two media are the same where their formulas are.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub(crate) enum Formula {
    Constant(f64),
    Speed(f64),
    Cauchy(Vec<f64>),
    Sellmeier { constant: f64, terms: Vec<(f64, f64)> },
    SellmeierRoot { constant: f64, terms: Vec<(f64, f64)> },
    Powers { constant: f64, terms: Vec<(f64, f64)> },
    Gas { constant: f64, terms: Vec<(f64, f64)> },
}

#[derive(Deserialize)]
struct Row {
    name: String,
    formula: Formula,
}

impl Formula {
    pub(crate) fn of(medium: &Medium) -> Self {
        match medium {
            Medium::Index(n) => Self::Constant(*n),
            Medium::Speed(v) => Self::Speed(*v),
            Medium::Cauchy(coefficients) => match coefficients.iter().rposition(|c| *c != 0.0) {
                Some(0) | None => Self::Constant(coefficients[0]),
                Some(last) => Self::Cauchy(coefficients[..=last].to_vec()),
            },
            Medium::Sellmeier { b, c } => {
                Self::Sellmeier { constant: 0.0, terms: b.iter().copied().zip(c.iter().copied()).collect() }
            }
            Medium::Catalog(name) => {
                let text = std::fs::read_to_string(root().join("src/media/catalog.ron")).unwrap();
                let rows: Vec<Row> = ron::from_str(&text).unwrap();
                rows.into_iter().find(|row| row.name == *name).unwrap().formula
            }
            other => panic!("the reference knows no {other:?}"),
        }
    }

    /// The index at a vacuum wavelength in nanometers.
    pub(crate) fn index(&self, nanometers: f256) -> f256 {
        let wavelength = nanometers / wide(1000.0);
        let square = wavelength * wavelength;
        let sum = |constant: f64, terms: &[(f64, f64)], term: &dyn Fn(f256, f256) -> f256| {
            terms.iter().fold(wide(constant), |sum, (b, c)| sum + term(wide(*b), wide(*c)))
        };
        match self {
            Self::Constant(n) => wide(*n),
            Self::Speed(v) => wide(299_792_458.0) / wide(*v),
            Self::Cauchy(coefficients) => coefficients.iter().rev().fold(f256::ZERO, |sum, c| sum / square + wide(*c)),
            Self::Sellmeier { constant, terms } => {
                (f256::ONE + sum(*constant, terms, &|b, c| b * square / (square - c))).sqrt()
            }
            Self::SellmeierRoot { constant, terms } => {
                (f256::ONE + sum(*constant, terms, &|b, c| b * square / (square - c * c))).sqrt()
            }
            Self::Powers { constant, terms } => sum(*constant, terms, &|c, p| c * wavelength.powf(&p)).sqrt(),
            Self::Gas { constant, terms } => f256::ONE + sum(*constant, terms, &|b, c| b / (c - f256::ONE / square)),
        }
    }
}
