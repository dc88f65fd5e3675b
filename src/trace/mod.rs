//! From a compiled system to the ray tree: every ray followed through every hit, with a closed set of endings.

mod corner;
mod hit;
mod nearest;
mod segment;
mod summary;
mod tracer;

#[cfg(test)]
mod tests;

pub use segment::{Ending, Hit, RayTree, Segment, SegmentId, TracedRay, Via};
pub use summary::{PowerBalance, ScreenHit, ScreenRecord, Summary};
pub use tracer::{Visitor, visit};

use crate::system::OpticalSystem;

/// A whole trace: the ray tree and what became of the light.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    /// Every ray with its branches.
    pub tree: RayTree,
    /// Counts, power balance and screens.
    pub summary: Summary,
}

/// Traces every ray of a system and keeps the tree.
#[must_use]
pub fn trace(system: &OpticalSystem) -> Trace {
    let mut trace = Trace { tree: RayTree::default(), summary: Summary::new(system) };
    visit(system, &mut trace);
    trace
}

/// Traces every ray of a system and keeps no tree: memory for the depth of the tree, not for its size.
#[must_use]
pub fn summarize(system: &OpticalSystem) -> Summary {
    let mut summary = Summary::new(system);
    visit(system, &mut summary);
    summary
}

impl Visitor for Trace {
    fn segment(&mut self, ray: &TracedRay, segment: Segment) {
        self.tree.segment(ray, segment);
        self.summary.segment(ray, segment);
    }
}

impl Visitor for RayTree {
    fn segment(&mut self, ray: &TracedRay, segment: Segment) {
        if segment.parent.is_none() {
            self.rays.push(ray.clone());
        }
        if let Some(last) = self.rays.last_mut() {
            last.segments.push(segment);
        }
    }
}
