//! The built-in catalog: media as data in `catalog.ron`, each with the source of its coefficients.
//!
//! Makers of optical glass publish indices relative to air. They stand here as absolute ones, as in the makers' own
//! tables; the difference is 0.03 %.

use std::sync::OnceLock;

use serde::Deserialize;

use super::Dispersion;
use super::formula::Formula;
use crate::light::Wavelength;

/// A medium of the catalog.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Entry {
    /// Its name, as in `Catalog("N-BK7")`.
    pub name: &'static str,
    /// What kind of medium it is, such as `crown glass` or `crystal`.
    pub group: &'static str,
    /// What else to know: material, temperature, use; may be empty.
    pub note: &'static str,
    /// The vacuum wavelengths in nm for which the coefficients hold, ends included.
    pub range_nm: (f64, f64),
    /// Index at the d line as the maker publishes it; `None` for media without a maker.
    pub published_n_d: Option<f64>,
    /// Abbe number V_d as the maker publishes it; `None` for media without a maker.
    pub published_abbe_number: Option<f64>,
    /// Where the coefficients come from.
    pub source: &'static str,
    dispersion: Dispersion,
}

impl Entry {
    /// Its index against wavelength.
    #[must_use]
    pub fn dispersion(&self) -> &Dispersion {
        &self.dispersion
    }

    /// Index n_d at the helium d line, 587.5618 nm.
    #[must_use]
    pub fn n_d(&self) -> f64 {
        self.dispersion.index(Wavelength::D)
    }

    /// Abbe number V_d = (n_d − 1)/(n_F − n_C): the higher, the less dispersion.
    #[must_use]
    pub fn abbe_number(&self) -> f64 {
        let spread = self.dispersion.index(Wavelength::HYDROGEN_F) - self.dispersion.index(Wavelength::HYDROGEN_C);
        (self.n_d() - 1.0) / spread
    }
}

/// All media, in the order of the data: glasses from crown to dense flint, crystals, plastics, liquids, air.
#[must_use]
pub fn entries() -> &'static [Entry] {
    static ENTRIES: OnceLock<Vec<Entry>> = OnceLock::new();
    // The data are part of the program and read whole in the tests, so that there is no error to report.
    ENTRIES.get_or_init(|| rows().unwrap_or_default().into_iter().map(Entry::from).collect())
}

/// The medium of exactly this name.
#[must_use]
pub fn find(name: &str) -> Option<&'static Entry> {
    entries().iter().find(|entry| entry.name == name)
}

/// The name most like the one asked for, to suggest in a message; `None` where nothing comes near.
///
/// Letter case, spaces and punctuation do not count, and neither does the prefix `N-` of lead-free glasses.
#[must_use]
pub fn nearest(name: &str) -> Option<&'static str> {
    let likeness = |entry: &Entry| strsim::jaro_winkler(&plain(name), &plain(entry.name));
    let best = entries().iter().rev().map(|entry| (likeness(entry), entry.name)).max_by(|a, b| a.0.total_cmp(&b.0))?;
    (best.0 > 0.8).then_some(best.1)
}

/// Lower-case letters and digits only, without the prefix `N-`.
fn plain(name: &str) -> String {
    let lower = name.to_lowercase();
    lower.strip_prefix("n-").unwrap_or(&lower).chars().filter(|c| c.is_alphanumeric()).collect()
}

/// One row of `catalog.ron`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Row {
    name: &'static str,
    group: &'static str,
    note: &'static str,
    formula: Formula,
    range_nm: (f64, f64),
    n_d: f64,
    v_d: f64,
    quoted: bool,
    source: &'static str,
}

fn rows() -> Result<Vec<Row>, ron::error::SpannedError> {
    ron::from_str(include_str!("catalog.ron"))
}

impl From<Row> for Entry {
    fn from(row: Row) -> Self {
        let Row { name, group, note, formula, range_nm, n_d, v_d, quoted, source } = row;
        Self {
            name,
            group,
            note,
            range_nm,
            published_n_d: quoted.then_some(n_d),
            published_abbe_number: quoted.then_some(v_d),
            source,
            dispersion: Dispersion::cataloged(formula, range_nm, name),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::MediumError;
    use super::*;

    #[test]
    fn every_row_reproduces_its_n_d_and_v_d() {
        let rows = rows().unwrap();
        assert!(rows.len() >= 25);
        for row in rows {
            let (name, n_d, v_d) = (row.name, row.n_d, row.v_d);
            let entry = Entry::from(row);
            assert!((entry.n_d() - n_d).abs() < 1e-5, "{name}: n_d {}", entry.n_d());
            assert!((entry.abbe_number() - v_d).abs() < 0.02, "{name}: V_d {}", entry.abbe_number());
        }
    }

    #[test]
    fn every_row_is_whole() {
        for entry in entries() {
            let name = entry.name;
            assert!(std::ptr::eq(find(name).unwrap(), entry), "{name} stands twice");
            assert!(entry.source.len() > 20 && !entry.group.is_empty(), "{name} needs a source and a group");
            let (from, to) = entry.range_nm;
            assert!(from <= 480.0 && 700.0 <= to, "{name} does not cover F to C");
            for k in 0..=100 {
                let nm = from + (to - from) * f64::from(k) / 100.0;
                let wavelength = Wavelength::from_nanometers(nm.clamp(from, to)).unwrap();
                assert!(entry.dispersion().check(wavelength).is_ok(), "{name} at {nm} nm");
            }
        }
    }

    #[test]
    fn a_wavelength_out_of_range_is_an_error_with_the_range() {
        let bk7 = find("N-BK7").unwrap().dispersion();
        let error = bk7.check(Wavelength::from_nanometers(200.0).unwrap()).unwrap_err();
        assert!(matches!(error, MediumError::OutOfRange { medium: "N-BK7", .. }));
        assert_eq!(error.to_string(), "the index of N-BK7 is known from 300 nm to 2500 nm, not at 200 nm");
    }

    #[test]
    fn media_equal_themselves_only() {
        for (i, a) in entries().iter().enumerate() {
            for (j, b) in entries().iter().enumerate() {
                assert_eq!(a.dispersion() == b.dispersion(), i == j, "{} and {}", a.name, b.name);
            }
        }
    }

    #[test]
    fn a_formula_written_out_is_the_same_medium() {
        let terms = [(1.03961212, 0.00600069867), (0.231792344, 0.0200179144), (1.01046945, 103.560653)];
        assert_eq!(find("N-BK7").unwrap().dispersion(), &Dispersion::sellmeier(&terms).unwrap());
    }

    #[test]
    fn names_are_exact_and_near_ones_are_suggested() {
        assert!(find("n-bk7").is_none());
        for (wrong, right) in [
            ("BK7", "N-BK7"),
            ("n-bk7", "N-BK7"),
            ("NBK7", "N-BK7"),
            ("sf 11", "N-SF11"),
            ("Fused Silica", "fused silica"),
            ("dimond", "diamond"),
            ("Wasser", "water"),
            ("pmma", "PMMA"),
            ("sapphire", "sapphire (o)"),
        ] {
            assert_eq!(nearest(wrong), Some(right), "{wrong}");
        }
        assert_eq!(nearest("zzzz"), None);
        assert_eq!(nearest(""), None);
    }
}
