use std::collections::HashSet;

use super::checker::{Checker, Text, show, show_rounded};
use crate::light::Wavelength;
use crate::media::{Dispersion, MediumError};
use crate::scene::{Body, Limit, MAX_INDEX, Medium, Problem, Scene, Shape, Source, Spectrum, Substance};

/// The cure for a formula that gives no index.
const COEFFICIENTS: &str = "correct the coefficients; λ counts in micrometers in them";

/// A medium's own numbers, or its name in the catalog; indices over the spectrum are checked with the sources.
pub(super) fn check_medium(c: &mut Checker<'_>, path: impl Text, medium: &Medium) {
    match medium.dispersion() {
        Err(problem) => {
            let path = if problem.path.is_empty() { path.to_string() } else { format!("{path}.{}", problem.path) };
            c.push(Problem { path, ..problem });
        }
        Ok(dispersion) => {
            let index = dispersion.index(Wavelength::D);
            let problem = match medium {
                Medium::Index(_) => too_large(
                    format_args!("{path}.n"),
                    index,
                    "write an index from 1 to 1000000; that of diamond is 2.42",
                ),
                Medium::Speed(_) => {
                    too_large(format_args!("{path}.v"), index, "write a speed from 299.792458 to 299792458 m/s")
                }
                _ => None,
            };
            problem.into_iter().for_each(|problem| c.push(problem));
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

/// Every line of every source has an index in every medium. The lines are few enough to be gone through.
pub(super) fn check_wavelengths(c: &mut Checker<'_>, scene: &Scene) {
    let lines: HashSet<u64> =
        scene.sources.iter().flat_map(|source| source.spectrum.lines()).map(f64::to_bits).collect();
    if !check_indices(c, scene, lines.len() as u64) {
        return;
    }
    let is_faulty = |dispersion: &Dispersion, line: u64| {
        let line = Wavelength::from_nanometers(f64::from_bits(line));
        line.is_some_and(|line| !is_sound(&dispersion.check(line)))
    };
    let mut media = dispersive_media(scene);
    let mut faulty: HashSet<u64> = HashSet::new();
    media.retain(|(_, _, dispersion)| {
        let faults: Vec<u64> = lines.iter().copied().filter(|line| is_faulty(dispersion, *line)).collect();
        faulty.extend(&faults);
        !faults.is_empty()
    });
    let is_at_fault = |source: &Source| source.spectrum.lines().any(|line| faulty.contains(&line.to_bits()));
    for (k, source) in scene.sources.iter().enumerate().filter(|(_, source)| is_at_fault(source)) {
        let path = format!("sources[{k}].spectrum");
        for (owner, medium, dispersion) in &media {
            if c.found.is_full() {
                return;
            }
            first_fault(&path, source, owner, medium, dispersion).into_iter().for_each(|problem| c.push(problem));
        }
    }
}

/// The index of every medium at every line, before any is computed.
fn check_indices(c: &mut Checker<'_>, scene: &Scene, lines: u64) -> bool {
    let most = c.limits.of(Limit::Indices);
    let indices = |media: usize| (media as u64).saturating_mul(lines);
    // Told apart only where there may be too many.
    if indices(1 + media(scene).count()) <= most {
        return true;
    }
    let different: HashSet<String> = media(scene).map(|(_, medium)| format!("{medium:?}")).collect();
    let indices = indices(different.len());
    c.require(indices <= most, || {
        let media = different.len();
        let message = format!(
            "{media} media at {lines} spectral lines have {indices} refractive indices; at most {most} are allowed"
        );
        let help = format!("use fewer different media or spectral lines; {}", Limit::Indices.cure());
        Problem::error("", message, help).label("too many")
    })
}

fn is_sound(index: &Result<f64, MediumError>) -> bool {
    index.as_ref().is_ok_and(|index| *index <= MAX_INDEX)
}

/// The problem at the first line for which a medium has no index.
fn first_fault(
    path: impl Text,
    source: &Source,
    owner: &str,
    medium: &Medium,
    dispersion: &Dispersion,
) -> Option<Problem> {
    let lines = source.spectrum.lines().map(Wavelength::from_nanometers).enumerate();
    let mut checked = lines.filter_map(|(k, line)| Some((k, dispersion.check(line?))));
    let (k, error) = match checked.find(|(_, checked)| !is_sound(checked))? {
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
fn dispersive_media(scene: &Scene) -> Vec<(String, &Medium, Dispersion)> {
    let mut known = HashSet::new();
    let dispersive = media(scene).filter(|(_, medium)| !is_constant(medium) && known.insert(format!("{medium:?}")));
    dispersive.filter_map(|(owner, medium)| Some((owner.path(), medium, medium.dispersion().ok()?))).collect()
}

/// What a medium fills.
enum Owner {
    Surroundings,
    Body(usize),
    /// The space behind a surface of a lens group.
    Element(usize, usize),
}

impl Owner {
    fn path(&self) -> String {
        match self {
            Self::Surroundings => "surroundings".to_owned(),
            Self::Body(body) => format!("bodies[{body}].medium"),
            Self::Element(body, surface) => format!("bodies[{body}].shape.surfaces[{surface}].medium"),
        }
    }
}

/// All media of a scene, in the order of their first use.
fn media(scene: &Scene) -> impl Iterator<Item = (Owner, &Medium)> {
    fn of_body((k, body): (usize, &Body)) -> impl Iterator<Item = (Owner, &Medium)> {
        let own = if let Substance::Medium(medium) = &body.substance { Some((Owner::Body(k), medium)) } else { None };
        let surfaces = if let Shape::LensGroup { surfaces, .. } = &body.shape { surfaces.as_slice() } else { &[] };
        let within =
            surfaces.iter().enumerate().filter_map(move |(j, s)| Some((Owner::Element(k, j), s.medium.as_ref()?)));
        own.into_iter().chain(within)
    }
    let first = std::iter::once((Owner::Surroundings, &scene.surroundings));
    first.chain(scene.bodies.iter().enumerate().flat_map(of_body))
}
