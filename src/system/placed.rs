use glam::DVec2;

use crate::geometry::Curve;
use crate::light::{Power, Wavelength};
use crate::scene::OpticalAxis;
use crate::system::MediumId;

/// A body where it stands, in scene coordinates.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct PlacedBody {
    /// Its name, or `#k` for the k-th from 0.
    pub name: String,
    /// Its outlines: one, but for lens groups (one an element) and stops (one a jaw).
    pub outlines: Vec<Outline>,
}

/// One connected line of a body.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Outline {
    /// Its curves, each starting where the one before ends, in the order written.
    pub curves: Vec<Curve>,
    /// Whether the last curve ends where the first starts.
    pub closed: bool,
    /// What fills it; `None` for a surface.
    pub medium: Option<MediumId>,
}

/// A source with its rays laid out.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct PlacedSource {
    /// Starts of its rays, in order.
    pub starts: Vec<RayStart>,
    /// Vacuum wavelengths of every ray, in order.
    pub lines: Vec<Wavelength>,
    /// Power of one ray at one line.
    pub power: Power,
    /// The arrow that it is, if it is one.
    pub object: Option<PlacedObject>,
}

/// An object arrow, and what finds its image.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct PlacedObject {
    /// Its foot, in scene coordinates.
    pub foot: DVec2,
    /// Its tip, from which its rays start, in scene coordinates.
    pub tip: DVec2,
    /// The body that it faces, by its place in the scene.
    pub body: usize,
    /// That body's optical axis along the light.
    pub axis: OpticalAxis,
    /// Rays that no light follows: along the axis from beside the tip, and two neighbors from the foot.
    pub probes: [RayStart; 3],
}

/// Where a ray starts.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct RayStart {
    /// Its first point, relative to the system's origin.
    pub from: DVec2,
    /// Unit direction.
    pub direction: DVec2,
    /// The medium it starts in.
    pub medium: MediumId,
    /// What it starts on.
    pub start: Start,
}

/// What a ray stands on when it sets out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Start {
    /// Free space.
    Free,
    /// An interface, by its place in the list; it heads to the left of it or the right.
    On {
        /// The interface.
        interface: usize,
        /// Whether it heads to the left of the direction of travel; the direction of the ray must agree.
        left: bool,
    },
    /// The end that several interfaces share.
    AtVertex(crate::system::VertexId),
}
