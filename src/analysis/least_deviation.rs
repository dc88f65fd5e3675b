//! The ray that is turned least.

use glam::DVec2;

use crate::analysis::bundle::branch;
use crate::analysis::turning_degrees;
use crate::light::Wavelength;
use crate::system::{OpticalSystem, PlacedSource, RayStart, Start};
use crate::trace::trace;

/// Rays between two neighbors of the best one in a round of the search.
const BETWEEN: u32 = 16;
/// Rounds of the search, each eight times finer than the one before. Near the least deviation the deviation depends on the
/// square of the way from it, so that it is known to its last digits long before the ray is.
const ROUNDS: u32 = 9;

/// The ray of a source that is turned least on some path.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct LeastDeviation {
    /// Where it starts, in scene coordinates.
    pub from: DVec2,
    /// Its unit direction.
    pub direction: DVec2,
    /// By how much it turns, as [`turning_degrees`] counts: its magnitude is the least.
    pub degrees: f64,
}

/// The least deviation on a path (`tt` through a prism, `trt` of the first rainbow) for one wavelength, sought by tracing: among
/// the source's rays first, then between the best one's neighbors, halfway rays of the beam or the fan that it is.
///
/// The best of the rays themselves is the answer where it has a neighbor on one side only, as at the end of a beam, or starts
/// on a boundary. `None` if no ray takes the path. Letters do not tell faces apart: the source should light one way through a body.
///
/// # Source
/// Hecht, "Optics", 4th ed., section 5.5.1, for prisms, whose closed form is
/// [`minimum_deviation`](crate::laws::minimum_deviation); for the rainbow, van de Hulst, "Light Scattering by Small Particles", chapter
/// 13.
#[must_use]
pub fn least_deviation(
    system: &OpticalSystem,
    source: usize,
    path: &str,
    wavelength: Wavelength,
) -> Option<LeastDeviation> {
    let placed = system.sources.get(source)?;
    let mut starts = placed.starts.clone();
    let (mut best, mut degrees) = least(system, placed, &starts, path, wavelength)?;
    for _ in 0..ROUNDS {
        let Some([before, after]) = neighbors(&starts, best) else { break };
        let between = |k: u32| between(before, after, f64::from(k) / f64::from(BETWEEN));
        let finer: Vec<RayStart> = (0..=BETWEEN).map(between).collect();
        let Some((place, turned)) = least(system, placed, &finer, path, wavelength) else { break };
        (starts, best, degrees) = (finer, place, turned);
    }
    let RayStart { from, direction, .. } = starts.get(best)?;
    Some(LeastDeviation { from: *from + system.origin, direction: *direction, degrees })
}

/// The place of the start whose ray turns least on a path, and by how much.
fn least(
    system: &OpticalSystem,
    placed: &PlacedSource,
    starts: &[RayStart],
    path: &str,
    wavelength: Wavelength,
) -> Option<(usize, f64)> {
    let source = PlacedSource { starts: starts.to_vec(), lines: vec![wavelength], object: None, ..placed.clone() };
    let tree = trace(&OpticalSystem { sources: vec![source], ..system.clone() }).tree;
    let turned = tree.rays.iter().filter_map(|ray| Some((ray.ray, turning_degrees(ray, branch(ray, path)?.id)?)));
    turned.min_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()))
}

/// The starts on both sides of one, if all three lie free in one medium.
fn neighbors(starts: &[RayStart], best: usize) -> Option<[&RayStart; 2]> {
    let around = starts.get(best.checked_sub(1)?..=best + 1)?;
    let free = |start: &RayStart| start.start == Start::Free && start.medium == around[0].medium;
    around.iter().all(free).then(|| [&around[0], &around[2]])
}

/// A start at a share of the way from one to another.
fn between(a: &RayStart, b: &RayStart, share: f64) -> RayStart {
    let direction = a.direction.lerp(b.direction, share).normalize_or(a.direction);
    RayStart { from: a.from.lerp(b.from, share), direction, ..*a }
}
