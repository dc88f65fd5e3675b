//! How the light on a screen is spread along it.

use std::collections::BTreeMap;

use crate::light::Wavelength;
use crate::numerics::Sum;
use crate::system::OpticalSystem;
use crate::trace::{Ending, RayTree, Segment, TracedRay};

/// So many equal parts a screen has.
const PARTS: usize = 241;

/// Irradiance along a screen.
///
/// Rays are samples of a beam. Each stands for the light half way to its neighbors: rays with consecutive numbers of one source and
/// one line that came by hits at the same bodies. Its power is spread evenly over the stretch of the screen between the middles of the
/// ways to their two landing points, on the outer side of the last ray as far as on its inner one, and at its point where it
/// has no neighbor. So a smooth beam has a smooth curve however few rays show it, light that folds over itself adds up, and no
/// power is lost or made: of each line, the sum of value times width over all parts is the power that landed, up to rounding. What
/// is sharper than a part is as high as the part allows.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Irradiance {
    /// The screen, by its place among the scene's bodies.
    pub body: usize,
    /// Length of the screen, scene units; positions count from its first point, as in a trace.
    pub length: f64,
    /// How many branches landed.
    pub hits: usize,
    /// One curve for each spectral line that landed, ascending.
    pub curves: Vec<Curve>,
}

/// Irradiance of one spectral line.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Curve {
    /// Vacuum wavelength.
    pub wavelength: Wavelength,
    /// Branches that landed.
    pub hits: usize,
    /// Power per length, in the sources' unit per scene unit, of equal parts of the screen from its first point on.
    pub values: Vec<f64>,
}

/// Light on its place: a branch that landed.
#[derive(Clone, Copy)]
struct Landed {
    ray: usize,
    position: f64,
    power: f64,
}

/// What neighbors have in common: source, and the letter and the body of every hit on the way.
type Way = (usize, Vec<(Option<char>, usize)>);

impl Irradiance {
    /// The parts of a curve: the positions of both ends of each, and the value.
    pub fn parts<'a>(&self, curve: &'a Curve) -> impl Iterator<Item = ([f64; 2], f64)> + use<'a> {
        let width = self.length / count(curve.values.len());
        curve.values.iter().enumerate().map(move |(k, value)| ([width * count(k), width * count(k + 1)], *value))
    }
}

/// What landed on a screen: by the bits of the wavelength, which for numbers above 0 sort as these do, and by the way.
type Lines = BTreeMap<u64, (Wavelength, BTreeMap<Way, Vec<Landed>>)>;

/// The irradiance on every screen, in the bodies' order, hit or not. `tree` must come from `system`.
#[must_use]
pub fn irradiance(system: &OpticalSystem, tree: &RayTree) -> Vec<Irradiance> {
    let mut screens: BTreeMap<usize, Lines> = system.screens.iter().map(|&body| (body, Lines::new())).collect();
    for (ray, segment) in tree.rays.iter().flat_map(|ray| ray.segments.iter().map(move |segment| (ray, segment))) {
        let Some(hit) = segment.hit.filter(|_| segment.ending == Ending::Detected) else { continue };
        let (Some(lines), Some(position)) = (screens.get_mut(&hit.body), hit.position) else { continue };
        let bits = ray.wavelength.nanometers().to_bits();
        let (_, ways) = lines.entry(bits).or_insert_with(|| (ray.wavelength, BTreeMap::new()));
        let landed = Landed { ray: ray.ray, position, power: segment.power.total() };
        ways.entry(way(ray, segment)).or_default().push(landed);
    }
    screens.into_iter().map(|(body, lines)| on_screen(system, body, lines)).collect()
}

fn on_screen(system: &OpticalSystem, body: usize, lines: Lines) -> Irradiance {
    let outline = system.bodies.get(body).and_then(|body| body.outlines.first());
    let length = outline.map_or(0.0, |outline| outline.curves.iter().map(|curve| curve.length()).sum());
    let is_closed = outline.is_some_and(|outline| outline.closed);
    let hits = lines.values().flat_map(|(_, ways)| ways.values()).map(Vec::len).sum();
    let curves = lines.into_values().map(|(wavelength, ways)| {
        let mut parts = Parts::new(length, is_closed);
        let hits = ways.values().map(Vec::len).sum();
        for mut landed in ways.into_values() {
            landed.sort_by_key(|landed| landed.ray);
            landed.chunk_by(|a, b| are_neighbors(a, b, length, is_closed)).for_each(|run| parts.add_run(run));
        }
        Curve { wavelength, hits, values: parts.values() }
    });
    Irradiance { body, length, hits, curves: curves.collect() }
}

fn way(ray: &TracedRay, segment: &Segment) -> Way {
    let hits = ray.ancestors(segment.id).filter_map(|segment| Some((segment.via.letter(), segment.hit?.body)));
    (ray.source, hits.collect())
}

/// Whether light between two rays landed between them; not where a closed screen's end meets its start.
fn are_neighbors(a: &Landed, b: &Landed, length: f64, is_closed: bool) -> bool {
    b.ray - a.ray == 1 && !(is_closed && (b.position - a.position).abs() > 0.5 * length)
}

/// A part of a screen that a ray stands for.
struct Stretch {
    from: f64,
    to: f64,
    /// Where the ray landed.
    at: f64,
    power: f64,
}

impl Stretch {
    fn moved(&self, by: f64) -> Self {
        Self { from: self.from + by, to: self.to + by, at: self.at + by, ..*self }
    }

    /// The share of it between two positions; all of it where it has no length.
    fn covered(&self, begin: f64, end: f64) -> f64 {
        let length = self.to - self.from;
        if length > 0.0 { ((self.to.min(end) - self.from.max(begin)) / length).clamp(0.0, 1.0) } else { 1.0 }
    }
}

/// Power in equal parts of a screen.
struct Parts {
    width: f64,
    /// Whether the last part is beside the first.
    is_closed: bool,
    power: Vec<Sum>,
}

impl Parts {
    fn new(length: f64, is_closed: bool) -> Self {
        Self { width: length / count(PARTS), is_closed, power: vec![Sum::default(); PARTS] }
    }

    fn values(&self) -> Vec<f64> {
        self.power.iter().map(|power| power.value() / self.width).collect()
    }

    /// Spreads the power of neighbors. What their stretches have beyond the screen's ends is shared by all of them: the light
    /// there would not have landed.
    fn add_run(&mut self, run: &[Landed]) {
        let stretches = run.iter().enumerate().map(|(place, landed)| {
            let half_way = |neighbor: Option<&Landed>| neighbor.map(|next| 0.5 * (next.position - landed.position));
            let before = half_way(place.checked_sub(1).and_then(|place| run.get(place)));
            let behind = half_way(run.get(place + 1));
            let from = landed.position + before.or(behind.map(|way| -way)).unwrap_or(0.0);
            let to = landed.position + behind.or(before.map(|way| -way)).unwrap_or(0.0);
            Stretch { from: from.min(to), to: from.max(to), at: landed.position, power: landed.power }
        });
        let stretches: Vec<Stretch> = stretches.collect();
        let length = self.width * count(PARTS);
        let landed: f64 = stretches.iter().map(|stretch| stretch.power).sum();
        let kept: f64 = stretches.iter().map(|stretch| stretch.power * stretch.covered(0.0, length)).sum();
        for stretch in &stretches {
            if self.is_closed {
                // What lies beyond one end lies within the other.
                for turn in [-length, 0.0, length] {
                    self.spread(&stretch.moved(turn));
                }
            } else {
                self.spread(&Stretch { power: stretch.power * (landed / kept), ..*stretch });
            }
        }
    }

    /// Spreads power evenly over a stretch, as far as the screen goes.
    fn spread(&mut self, stretch: &Stretch) {
        let (first, last) = (self.part(stretch.from), self.part(stretch.to));
        let length = self.width * count(PARTS);
        if stretch.to < 0.0 || stretch.from > length {
            return;
        }
        for part in first..=last {
            let (begin, end) = (self.width * count(part), self.width * count(part + 1));
            // Rounding must not lose what lies on the screen's ends.
            let end = if part + 1 == PARTS && !self.is_closed { end.max(stretch.at) } else { end };
            let share = if first == last {
                stretch.covered(0.0, self.width * count(PARTS))
            } else {
                stretch.covered(begin, end)
            };
            self.power[part].add(stretch.power * share);
        }
    }

    /// The part in which a position lies.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the parts")]
    fn part(&self, position: f64) -> usize {
        (position / self.width).clamp(0.0, count(PARTS - 1)) as usize
    }
}

#[expect(clippy::cast_precision_loss, reason = "a small number")]
fn count(parts: usize) -> f64 {
    parts as f64
}
