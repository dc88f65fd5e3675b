//! From a compiled system to the ray tree: every ray followed through every hit, with a closed set of endings.

mod segment;
mod summary;

pub use segment::{Ending, Hit, RayTree, Segment, SegmentId, TracedRay, Via};
pub use summary::{PowerBalance, ScreenHit, ScreenRecord, Summary};
