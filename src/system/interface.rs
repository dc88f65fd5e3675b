use glam::DVec2;

use crate::geometry::Curve;

/// A medium of an [`OpticalSystem`](crate::OpticalSystem); two ids are equal exactly where the media are the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct MediumId(pub(crate) u32);

impl MediumId {
    /// Its place in the system's list.
    pub(crate) fn place(self) -> usize {
        self.0 as usize
    }
}

/// A point shared by every interface that ends there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct VertexId(pub(crate) u32);

/// A piece of boundary: an edge, or an arc of at most half a circle, with what lies on its two sides.
// What a search looks at comes first, in one line of the processor's cache.
#[derive(Clone, Debug, PartialEq)]
#[repr(C, align(64))]
#[non_exhaustive]
pub struct Interface {
    /// Where it runs, relative to the system's origin.
    pub curve: Curve,
    /// Its end points' identities: the start's, the end's.
    pub ends: [VertexId; 2],
    /// The medium on the left of the direction of travel.
    pub left: MediumId,
    /// The medium on the right.
    pub right: MediumId,
    /// By how much |n|² exceeds 1 for the unit normal n of an edge, which rounding has left.
    pub(crate) excess: f64,
    /// What it does to a ray.
    pub action: Action,
    /// The body that a hit here names, by its place in the scene.
    pub body: usize,
}

impl Interface {
    /// Whether a medium lies on one of its sides.
    #[inline(always)]
    pub(crate) fn bounds(&self, medium: MediumId) -> bool {
        self.left == medium || self.right == medium
    }
}

/// Distances below this are rounding: 64 ulp of the largest coordinate of any interface, relative to the origin or in the
/// scene, since boundaries that coincide up to the rounding of their places are one.
pub(crate) fn rounding<'a>(interfaces: impl IntoIterator<Item = &'a Interface>, origin: DVec2) -> f64 {
    let ends = interfaces.into_iter().flat_map(|interface| [interface.curve.a, interface.curve.b]);
    64.0 * f64::EPSILON * ends.fold(0.0, |reach, p| p.abs().max((p + origin).abs()).max_element().max(reach))
}

/// What an interface does to a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Action {
    /// Refracts and reflects.
    Refract,
    /// Reflects everything.
    Mirror,
    /// Takes everything.
    Absorb,
    /// Takes everything and records it.
    Detect {
        /// Distance along the screen from its first point to this piece's start, scene units.
        along: f64,
        /// +1 where the piece runs as the screen was written, −1 against it.
        sense: f64,
        /// Length of the whole screen if it is closed: its end is its first point again.
        perimeter: Option<f64>,
    },
    /// Reflects and transmits fixed shares.
    Split {
        /// Reflected share.
        reflect: f64,
        /// Transmitted share.
        transmit: f64,
    },
    /// The ideal thin lens.
    ThinLens {
        /// Center of the lens, relative to the system's origin.
        center: DVec2,
        /// Focal length, positive converging.
        focal_length: f64,
    },
}
