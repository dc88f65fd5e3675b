//! Rays that go the same way together, and where they meet.

use glam::DVec2;

use crate::analysis::confusion::{Confusion, least_confusion};
use crate::light::Wavelength;
use crate::numerics::{cross, dot};
use crate::trace::{RayTree, Segment, SegmentId, TracedRay};

/// Rays whose directions differ by less, radians, are parallel: by rounding and no more.
pub(super) const PARALLEL: f64 = 1e-13;

/// The branches of a source's rays that have one path, such as `tt` behind a lens. Each counts as a line without end.
#[derive(Clone, Debug, PartialEq)]
pub struct Bundle {
    pub(super) rays: Vec<BundleRay>,
}

/// A ray of a bundle.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct BundleRay {
    /// The ray within its source.
    pub ray: usize,
    /// Vacuum wavelength.
    pub wavelength: Wavelength,
    /// Where the branch starts.
    pub from: DVec2,
    /// Its unit direction.
    pub direction: DVec2,
}

/// Where rays meet best.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Focus {
    /// The point with the least sum of squared distances from all rays.
    pub at: DVec2,
    /// Root of the mean squared distance of the rays from it, scene units: 0 up to rounding for a sharp image.
    pub spread: f64,
    /// On which side of the rays' starts it lies.
    pub kind: ImageKind,
}

/// Whether light passes through an image or only seems to come from it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ImageKind {
    /// Ahead of where every ray of the bundle starts.
    Real,
    /// Behind where every ray starts.
    Virtual,
    /// Ahead of some and behind others.
    Between,
}

impl Bundle {
    /// The branches of a source that have a path, written in the letters of an address: t transmitted, r reflected, i totally
    /// reflected; empty for the rays as the source sends them. In the order of the tree; rays without such a branch are
    /// left out.
    #[must_use]
    pub fn of(tree: &RayTree, source: usize, path: &str) -> Self {
        let rays = tree.rays.iter().filter(|ray| ray.source == source);
        Self { rays: rays.filter_map(|ray| Some(BundleRay::new(ray, branch(ray, path)?))).collect() }
    }

    /// Of these rays, those of one spectral line.
    #[must_use]
    pub fn line(&self, wavelength: Wavelength) -> Self {
        Self { rays: self.rays.iter().filter(|ray| ray.wavelength == wavelength).copied().collect() }
    }

    /// Of these rays, those with the lowest and the highest number within the source: the marginal rays of a beam or a fan.
    /// How far their [`focus`](Self::focus) lies before the [paraxial](super::paraxial) one is the longitudinal spherical
    /// aberration.
    ///
    /// # Source
    /// Hecht, "Optics", 4th ed., section 6.3.1.
    #[must_use]
    pub fn marginal(&self) -> Self {
        let numbers = || self.rays.iter().map(|ray| ray.ray);
        let ends = [numbers().min(), numbers().max()];
        Self { rays: self.rays.iter().filter(|ray| ends.contains(&Some(ray.ray))).copied().collect() }
    }

    /// Its rays.
    #[must_use]
    pub fn rays(&self) -> &[BundleRay] {
        &self.rays
    }

    /// The unit direction of the bundle: the mean of its rays'; the first ray's where they go all round. `None` without rays.
    #[must_use]
    pub fn direction(&self) -> Option<DVec2> {
        let sum: DVec2 = self.rays.iter().map(|ray| ray.direction).sum();
        let mean = sum / self.size();
        let chief = if mean.length() > 0.5 { mean } else { self.rays.first()?.direction };
        chief.try_normalize()
    }

    /// Where the rays meet, ahead of their starts or behind them. `None` for fewer than two rays and for parallel ones.
    #[must_use]
    pub fn focus(&self) -> Option<Focus> {
        let chief = self.direction()?;
        let middle = self.middle();
        // Along the bundle, x, and across, y, each ray is the line y cos α − x sin α = b.
        let cos: Vec<f64> = self.rays.iter().map(|ray| dot(chief, ray.direction)).collect();
        let sin: Vec<f64> = self.rays.iter().map(|ray| cross(chief, ray.direction)).collect();
        let b: Vec<f64> = self.rays.iter().map(|ray| cross(ray.direction, ray.from - middle)).collect();
        // Least squares by orthogonal columns: sines less the part along the cosines, small as the angles are.
        let along = product(&sin, &cos) / product(&cos, &cos);
        let rest: Vec<f64> = sin.iter().zip(&cos).map(|(sin, cos)| sin - along * cos).collect();
        if !rest.iter().any(|sin| sin.abs() > PARALLEL) {
            return None;
        }
        let x = -product(&rest, &b) / product(&rest, &rest);
        let y = product(&cos, &b) / product(&cos, &cos) + along * x;
        let at = middle + x * chief + y * chief.perp();
        at.is_finite().then(|| Focus { at, spread: self.spread(at), kind: self.kind(at) })
    }

    /// The circle of least confusion: where the bundle is narrowest across its [`direction`](Self::direction). `None` for
    /// fewer than two rays, for parallel ones, and where a ray does not go forward along that direction.
    #[must_use]
    pub fn least_confusion(&self) -> Option<Confusion> {
        least_confusion(self, self.direction()?)
    }

    /// On which side of its rays' starts a point lies.
    pub(super) fn kind(&self, at: DVec2) -> ImageKind {
        let ahead = self.rays.iter().filter(|ray| (at - ray.from).dot(ray.direction) >= 0.0).count();
        match ahead {
            0 => ImageKind::Virtual,
            all if all == self.rays.len() => ImageKind::Real,
            _ => ImageKind::Between,
        }
    }

    /// The middle of the starts: distances from it lose the fewest digits.
    pub(super) fn middle(&self) -> DVec2 {
        self.rays.iter().map(|ray| ray.from / self.size()).sum()
    }

    fn spread(&self, at: DVec2) -> f64 {
        let squares: f64 = self.rays.iter().map(|ray| cross(ray.direction, at - ray.from)).map(|d| d * d).sum();
        (squares / self.size()).sqrt()
    }

    #[expect(clippy::cast_precision_loss, reason = "no tree has 2^53 rays")]
    fn size(&self) -> f64 {
        self.rays.len() as f64
    }
}

impl BundleRay {
    pub(super) fn new(ray: &TracedRay, segment: &Segment) -> Self {
        let Segment { from, direction, .. } = *segment;
        Self { ray: ray.ray, wavelength: ray.wavelength, from, direction }
    }
}

fn product(u: &[f64], v: &[f64]) -> f64 {
    u.iter().zip(v).map(|(u, v)| u * v).sum()
}

/// The branch of a ray that has a path.
pub(super) fn branch<'a>(ray: &'a TracedRay, path: &str) -> Option<&'a Segment> {
    path.chars().try_fold(ray.segments.first()?, |segment, letter| child(ray, segment.id, letter))
}

/// The segment that begins where one ends, by its letter.
pub(super) fn child(ray: &TracedRay, parent: SegmentId, letter: char) -> Option<&Segment> {
    // A segment's children come after it.
    let later = ray.segments.get(parent.index()..)?;
    later.iter().find(|next| next.parent == Some(parent) && next.via.letter() == Some(letter))
}
