use glam::DVec2;

use crate::diagram::Figure;
use crate::diagram::branches::Branch;
use crate::diagram::frame::clip;
use crate::diagram::generations::Aged;
use crate::diagram::hits::is_imaging;
use crate::diagram::styles::strength;
use crate::drawing::{Path, Shape, Stroke};

/// Length of a normal to each side, pixels, while there are few.
const LENGTH: f64 = 45.0;
/// Length where there are many, pixels.
const SHORTEST: f64 = 14.0;
/// More hits than this make the normals shorter.
const UNCROWDED: f64 = 5.0;
/// A normal whose end is nearer to the ray than this lies within the ray's line, pixels.
const HIDDEN: f64 = 0.5;
/// Parallel normals closer than this are one, pixels.
const COINCIDENT: f64 = 8.0;
/// More would be noise.
const MOST: usize = 400;
/// Hits beyond this many are not looked at.
const MOST_TRIED: usize = 4000;

/// A place where light turns.
struct Normal {
    at: DVec2,
    along: DVec2,
    /// Sine of the smaller of the angles at which light comes and goes.
    sine: f64,
    strength: f64,
    /// Of the first light that turns there.
    generation: u32,
}

/// Dashed normals where light is reflected or transmitted; at a screen or an absorber no angle matters.
///
/// At perpendicular incidence the ray is its own normal: a normal that would lie within the ray's line is left out, since
/// its dashes would only show through a faint ray.
pub(super) fn normals(figure: &Figure<'_>) -> Vec<Aged> {
    let mut normals: Vec<Normal> = Vec::new();
    for branch in figure.branches.iter().rev().take(MOST_TRIED) {
        let Some(normal) = normal(figure, branch) else { continue };
        if let Some(other) = normals.iter_mut().find(|other| coincide(other, &normal)) {
            other.sine = other.sine.max(normal.sine);
            other.generation = other.generation.min(normal.generation);
        } else if normals.len() < MOST {
            normals.push(normal);
        }
    }
    let count = u32::try_from(normals.len()).map_or(f64::INFINITY, f64::from);
    let length = (LENGTH * (UNCROWDED / count).sqrt()).clamp(SHORTEST, LENGTH);
    let seen = normals.iter().rev().filter(|normal| normal.sine * length >= HIDDEN);
    seen.filter_map(|normal| mark(figure, normal, length)).collect()
}

fn normal(figure: &Figure<'_>, branch: &Branch<'_>) -> Option<Normal> {
    let hit = branch.segment.hit?;
    let turns = hit.n_t.is_some() || hit.reflectance.total() > 0.0;
    let at = figure.frame.place(branch.segment.to?);
    let along = figure.frame.turn(hit.normal).normalize_or_zero();
    let sine = hit.sin_t.map_or(hit.sin_i.abs(), |sin_t| sin_t.abs().min(hit.sin_i.abs()));
    let turns = turns && !is_imaging(figure, branch);
    let (strength, generation) = (strength(branch.share), branch.generation());
    (turns && figure.frame.area.contains(at)).then_some(Normal { at, along, sine, strength, generation })
}

fn coincide(a: &Normal, b: &Normal) -> bool {
    (a.at - b.at).length() < COINCIDENT && a.along.dot(b.along).abs() > 0.999
}

fn mark(figure: &Figure<'_>, normal: &Normal, length: f64) -> Option<Aged> {
    let start = normal.at - normal.along * length;
    let [a, b] = clip(start, normal.along, 2.0 * length, &figure.frame.area)?;
    // A normal is quieter than the ray that needs it.
    let stroke = Stroke::solid(figure.palette.quiet, 1.0).faded(0.9 * figure.styles.opacity(normal.strength));
    Some((normal.generation, Shape::stroked(Path::line(a, b), stroke.dashed(&[5.0, 4.0]), "normal").into()))
}
