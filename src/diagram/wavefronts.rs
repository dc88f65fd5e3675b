//! Marks of equal optical path from a source: where its light is at one time.

use std::collections::BTreeMap;

use glam::DVec2;

use crate::diagram::branches::{Branch, letters};
use crate::diagram::generations::Aged;
use crate::diagram::hits::is_thin_lens;
use crate::diagram::{Figure, nice};
use crate::drawing::{Cap, Color, Path, Shape, Stroke};
use crate::scene::Light;

/// Half the length of a mark across its ray, pixels.
const HALF: f64 = 4.0;
/// More marks would be noise.
const MOST: usize = 4000;
/// A front runs across its rays: a line between two marks that is steeper along one of them, as a cosine, is none.
const STEEPEST: f64 = 0.5;

/// A mark of a wavefront on a branch.
struct Mark {
    /// The ray within its source.
    ray: usize,
    /// The branch's letters.
    path: String,
    at: DVec2,
    /// Unit direction of the branch in the figure.
    along: DVec2,
}

/// What marks of one wavefront have in common: the source, the line and the optical path, both by their bits, and the color.
type Front = (usize, u64, u64, Color);

/// A short line across each ray at every multiple of the step, those of neighboring rays joined. Too many are not drawn, and
/// none behind an ideal lens, which has no optical path of its own.
pub(super) fn wavefronts(figure: &Figure<'_>) -> Vec<Aged> {
    let Some(step) = figure.scene.diagram.wavefronts else { return Vec::new() };
    let mut fronts: BTreeMap<Front, Vec<Mark>> = BTreeMap::new();
    let mut count = 0;
    for branch in figure.branches.iter().rev().filter(|branch| !is_behind_thin_lens(figure, branch)) {
        for (length, mark) in marks(figure, branch, step) {
            count += 1;
            if count > MOST {
                return Vec::new();
            }
            let line = branch.ray.wavelength.nanometers().to_bits();
            let front = (branch.ray.source, line, length.to_bits(), figure.styles.color(branch));
            fronts.entry(front).or_default().push(mark);
        }
    }
    fronts.iter().flat_map(|((source, _, _, color), marks)| drawn(marks, last_ray(figure, *source), *color)).collect()
}

/// The marks on a branch, each with its optical path from the source.
fn marks(figure: &Figure<'_>, branch: &Branch<'_>, step: f64) -> Vec<(f64, Mark)> {
    let segment = branch.segment;
    let n = segment.medium_index;
    let start = segment.optical_path - segment.to.map_or(0.0, |to| n * (to - segment.from).length());
    let (from, scale) = (figure.frame.place(segment.from), figure.frame.scale());
    let along = figure.frame.turn(segment.direction);
    let [near, far] = branch.ends.map(|end| start + n * (end - from).dot(along) / scale);
    let mark = |length: f64| {
        let at = from + (length - start) / n * scale * along;
        (length, Mark { ray: branch.ray.ray, path: letters(branch.ray, segment.id), at, along })
    };
    nice::multiples(step, near, far).into_iter().map(mark).collect()
}

/// One wavefront, a path a generation: its marks, and the lines between those of neighboring rays that took the same path or are
/// one hit apart.
fn drawn(marks: &[Mark], last: Option<usize>, color: Color) -> Vec<Aged> {
    let mut paths: BTreeMap<u32, Path> = BTreeMap::new();
    let mut add = |generation: u32, line: Path| paths.entry(generation).or_default().append(line);
    for (place, mark) in marks.iter().enumerate() {
        let across = HALF * mark.along.perp();
        add(mark.generation(), Path::line(mark.at - across, mark.at + across));
        for other in marks.iter().skip(place + 1).filter(|other| are_neighbors(mark, other, last)) {
            add(mark.generation().max(other.generation()), Path::line(mark.at, other.at));
        }
    }
    let stroke = Stroke::solid(color, 1.1).capped(Cap::Butt).faded(0.6);
    let shape = |(generation, path)| (generation, Shape::stroked(path, stroke.clone(), "wavefront").into());
    paths.into_iter().map(shape).collect()
}

impl Mark {
    /// How many hits lie behind it.
    fn generation(&self) -> u32 {
        u32::try_from(self.path.len()).unwrap_or(u32::MAX)
    }
}

fn are_neighbors(a: &Mark, b: &Mark, last: Option<usize>) -> bool {
    let closes = last.is_some_and(|last| [a.ray, b.ray].contains(&0) && [a.ray, b.ray].contains(&last) && last > 1);
    if !(a.ray.abs_diff(b.ray) == 1 || closes) {
        return false;
    }
    let (short, long) = if a.path.len() <= b.path.len() { (&a.path, &b.path) } else { (&b.path, &a.path) };
    let apart = (b.at - a.at).normalize_or_zero();
    let is_across = [a, b].iter().all(|mark| mark.along.dot(apart).abs() <= STEEPEST);
    let is_one_way = long.len() - short.len() <= 1 && long.starts_with(short.as_str());
    is_one_way && is_across
}

/// The ray that stands beside the first, where rays leave all round.
fn last_ray(figure: &Figure<'_>, source: usize) -> Option<usize> {
    match figure.scene.sources.get(source)?.light {
        Light::Point { rays, .. } => usize::try_from(rays).ok()?.checked_sub(1),
        _ => None,
    }
}

fn is_behind_thin_lens(figure: &Figure<'_>, branch: &Branch<'_>) -> bool {
    let ancestors = branch.ray.ancestors(branch.segment.id).skip(1);
    ancestors.filter_map(|parent| parent.hit).any(|hit| is_thin_lens(figure, &hit))
}
