//! From a compiled system to the ray tree: every ray followed through every hit, with a closed set of endings.

mod segment;
mod summary;

pub use segment::{Ending, Hit, RayTree, Segment, SegmentId, TracedRay, Via};
pub use summary::{PowerBalance, ScreenHit, ScreenRecord, Summary};

/// The ray tree of a scene and what became of its light.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trace {
    /// Every ray with its branches.
    pub tree: RayTree,
    /// Counts, powers and screens.
    pub summary: Summary,
}
