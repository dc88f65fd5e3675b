//! The compiled scene: boundaries with a medium on each side, no names, units or overlaps left to resolve.

mod cells;
mod interface;
mod placed;

pub(crate) use cells::Cells;
pub(crate) use interface::rounding;
pub use interface::{Action, Interface, MediumId, VertexId};
pub use placed::{Outline, PlacedBody, PlacedObject, PlacedSource, RayStart, Start};

use glam::DVec2;

use crate::geometry::{Bounds, CurveTree};
use crate::light::Wavelength;
use crate::media::Dispersion;
use crate::scene::TraceSettings;

/// A scene ready to trace.
///
/// Interfaces and ray starts are relative to [`OpticalSystem::origin`], so that a scene far from the coordinate origin
/// loses no digits; bodies and everything that leaves a trace are in scene coordinates.
#[derive(Clone, Debug)]
pub struct OpticalSystem {
    pub(crate) origin: DVec2,
    pub(crate) interfaces: Vec<Interface>,
    /// Distances below this are rounding.
    pub(crate) near: f64,
    /// Finds interfaces; `None` where they are so few that it is not worth it.
    pub(crate) tree: Option<CurveTree>,
    pub(crate) cells: Cells,
    pub(crate) media: Vec<Dispersion>,
    pub(crate) surroundings: MediumId,
    pub(crate) bodies: Vec<PlacedBody>,
    pub(crate) sources: Vec<PlacedSource>,
    /// Bodies that record what lands on them.
    pub(crate) screens: Vec<usize>,
    pub(crate) settings: TraceSettings,
    pub(crate) dropped: usize,
    pub(crate) title: String,
}

impl OpticalSystem {
    /// The bodies in the scene's order, placed, for drawing and for the names in a trace.
    #[must_use]
    pub fn bodies(&self) -> &[PlacedBody] {
        &self.bodies
    }

    /// The sources in the scene's order.
    #[must_use]
    pub fn sources(&self) -> &[PlacedSource] {
        &self.sources
    }

    /// The point that interfaces and ray starts are relative to, in scene coordinates.
    #[must_use]
    pub fn origin(&self) -> DVec2 {
        self.origin
    }

    /// The boundaries at which a ray changes.
    #[must_use]
    pub fn interfaces(&self) -> &[Interface] {
        &self.interfaces
    }

    /// The medium outside every body.
    #[must_use]
    pub fn surroundings(&self) -> MediumId {
        self.surroundings
    }

    /// Title of the scene.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.title
    }

    /// Pieces of boundary that are no interfaces, since the medium is the same on both sides.
    #[must_use]
    pub fn dropped_boundaries(&self) -> usize {
        self.dropped
    }

    /// Visits at least every interface that passes through or ends at a point, relative to the origin.
    pub(crate) fn near_point(&self, p: DVec2, visit: impl FnMut(usize)) {
        match &self.tree {
            Some(tree) => {
                tree.meeting(Bounds::of([p]), visit);
            }
            None => (0..self.interfaces.len()).for_each(visit),
        }
    }

    /// Refractive index of a medium at a vacuum wavelength, at least 1 at those of the scene's light; NaN for a medium that only
    /// another system has.
    #[must_use]
    pub fn index(&self, medium: MediumId, wavelength: Wavelength) -> f64 {
        self.media.get(medium.place()).map_or(f64::NAN, |medium| medium.index(wavelength))
    }

    /// Every wavelength that some source emits, ascending, each once.
    #[must_use]
    pub fn wavelengths(&self) -> Vec<Wavelength> {
        let mut lines: Vec<_> = self.sources.iter().flat_map(|source| source.lines.iter().copied()).collect();
        lines.sort_by(|a, b| a.nanometers().total_cmp(&b.nanometers()));
        lines.dedup();
        lines
    }
}
