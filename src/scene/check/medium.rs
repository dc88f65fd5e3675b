use std::collections::HashSet;
use std::fmt;

use super::checker::{Checker, Text, show, show_rounded};
use crate::light::Wavelength;
use crate::media::{Dispersion, MediumError};
use crate::scene::{MAX_INDEX, MAX_LINES, Medium, Problem, Scene, Shape, Source, Spectrum, Substance};

/// The cure for a formula that gives no index.
const COEFFICIENTS: &str = "correct the coefficients; λ counts in micrometers in them";

/// A medium's own numbers, or its name in the catalog; indices over the spectrum are checked with the sources.
pub(super) fn check_medium(c: &mut Checker, path: impl Text, medium: &Medium) {
    match medium.dispersion() {
        Err(problem) => {
            let path = if problem.path.is_empty() { path.to_string() } else { format!("{path}.{}", problem.path) };
            c.problems.push(Problem { path, ..problem });
        }
        Ok(dispersion) => {
            let index = dispersion.index(Wavelength::D);
            c.problems.extend(match medium {
                Medium::Index(_) => too_large(
                    format_args!("{path}.n"),
                    index,
                    "write an index from 1 to 1000000; that of diamond is 2.42",
                ),
                Medium::Speed(_) => {
                    too_large(format_args!("{path}.v"), index, "write a speed from 299.792458 to 299792458 m/s")
                }
                _ => None,
            });
        }
    }
}

fn is_constant(medium: &Medium) -> bool {
    matches!(medium, Medium::Index(_) | Medium::Speed(_))
}

fn too_large(path: impl Text, index: f64, help: &str) -> Option<Problem> {
    (index > MAX_INDEX).then(|| {
        let message = format!("the refractive index is {}, above {}", show_rounded(index), show(MAX_INDEX));
        Problem::error(path.to_string(), message, help).label("too large")
    })
}

/// Every line of every source has an index in every medium.
pub(super) fn check_wavelengths(c: &mut Checker, scene: &Scene) {
    let media = dispersive_media(scene);
    for (k, source) in scene.sources.iter().enumerate() {
        let path = format!("sources[{k}].spectrum");
        for (owner, medium, dispersion) in &media {
            c.problems.extend(first_fault(&path, source, owner, medium, dispersion));
        }
    }
}

/// The problem at the first line for which a medium has no index.
fn first_fault(
    path: impl Text,
    source: &Source,
    owner: &str,
    medium: &Medium,
    dispersion: &Dispersion,
) -> Option<Problem> {
    if matches!(source.spectrum, Spectrum::White { samples } if samples as usize > MAX_LINES) {
        return None;
    }
    let lines = source.spectrum.lines().map(Wavelength::from_nanometers).enumerate();
    let mut checked = lines.filter_map(|(k, line)| Some((k, dispersion.check(line?))));
    let (k, error) = match checked.find(|(_, checked)| !checked.as_ref().is_ok_and(|index| *index <= MAX_INDEX))? {
        (_, Ok(index)) => return too_large(owner, index, COEFFICIENTS),
        (k, Err(error)) => (k, error),
    };
    let name = match medium {
        Medium::Catalog(name) => format!("`{name}`"),
        _ => "the medium".to_owned(),
    };
    Some(match error {
        MediumError::OutOfRange { wavelength, range: (from, to), .. } => {
            let (wavelength, from, to) = (show(wavelength), show(from), show(to));
            let message = format!("{name} of `{owner}` is known from {from} to {to} nm, not at {wavelength} nm");
            let help = format!("choose wavelengths from {from} to {to} nm, or another medium");
            let at = match source.spectrum {
                Spectrum::Line(_) => format!("{path}.nm"),
                Spectrum::Lines(_) => format!("{path}.nm[{k}]"),
                Spectrum::White { .. } => path.to_string(),
            };
            Problem::error(at, message, help).label("outside the medium's range")
        }
        MediumError::BelowOne { wavelength, index } => {
            let (wavelength, index) = (show(wavelength), show_rounded(index));
            let message = format!(
                "{name} of `{owner}` has the index {index} at {wavelength} nm, below 1: faster than light in vacuum"
            );
            Problem::error(owner, message, COEFFICIENTS).label("below 1")
        }
        other => {
            let message = format!("{name} of `{owner}` has no index for this light: {other}");
            Problem::error(owner, message, COEFFICIENTS).label("no index")
        }
    })
}

/// Media whose index depends on the wavelength, once each, with the path of where they are first used.
fn dispersive_media<'a>(scene: &'a Scene) -> Vec<(String, &'a Medium, Dispersion)> {
    let mut media = Vec::new();
    let mut known = HashSet::new();
    let mut add = |path: fmt::Arguments<'_>, medium: &'a Medium| {
        if is_constant(medium) || !known.insert(format!("{medium:?}")) {
            return;
        }
        if let Ok(dispersion) = medium.dispersion() {
            media.push((path.to_string(), medium, dispersion));
        }
    };
    add(format_args!("surroundings"), &scene.surroundings);
    for (k, body) in scene.bodies.iter().enumerate() {
        if let Substance::Medium(medium) = &body.substance {
            add(format_args!("bodies[{k}].medium"), medium);
        }
        if let Shape::LensGroup { surfaces, .. } = &body.shape {
            for (j, medium) in surfaces.iter().enumerate().filter_map(|(j, s)| Some((j, s.medium.as_ref()?))) {
                add(format_args!("bodies[{k}].shape.surfaces[{j}].medium"), medium);
            }
        }
    }
    media
}
