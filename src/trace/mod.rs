//! From a compiled system to the ray tree: every ray followed through every hit, with a closed set of endings.

mod collect;
mod corner;
mod hit;
mod nearest;
mod probe;
mod segment;
mod summary;
mod tracer;
mod work;

#[cfg(test)]
mod plain;
#[cfg(test)]
mod tests;

pub use collect::visit;
pub use nearest::{Crossing, Ray, Search};
pub use segment::{Ending, Hit, RayTree, Segment, SegmentId, TracedRay, Via};
pub use summary::{PowerBalance, ScreenHit, ScreenRecord, Summary};
pub use work::Work;

use std::sync::Mutex;

use crate::system::OpticalSystem;
use crate::trace::collect::collect;

/// A whole trace: the ray tree and what became of the light.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Trace {
    /// Every ray with its branches.
    pub tree: RayTree,
    /// Counts, power balance and screens.
    pub summary: Summary,
}

/// Receives the segments of a trace: rays in the order of sources, rays and lines, and each ray's segments depth-first,
/// transmitted before reflected. `ray` carries no segments.
pub trait Visitor {
    /// One segment, followed or cut.
    fn segment(&mut self, ray: &TracedRay, segment: Segment);

    /// Whether more rays are to be followed; asked before each.
    fn goes_on(&self) -> bool {
        true
    }
}

/// Traces every ray of a system and keeps the tree; [`RayTree`] shows one. Rays are traced on all processors; the result does
/// not depend on how many there are.
#[must_use]
pub fn trace(system: &OpticalSystem) -> Trace {
    trace_watched(system, &|_| {})
}

/// [`trace`], telling `progress` now and then how many more segments there are; from any thread. What is followed twice, since
/// the segments of the scene run out, is told twice.
#[must_use]
pub fn trace_watched(system: &OpticalSystem, progress: &(dyn Fn(u64) + Sync)) -> Trace {
    let mut tree = RayTree::default();
    let summary = gather(system, Some(&mut tree), progress);
    Trace { tree, summary }
}

/// [`trace`] in the place of an earlier trace, of whatever system, for many traces one after the other. It uses that trace's memory
/// again: to get as much anew from the operating system takes longer than tracing.
pub fn retrace(system: &OpticalSystem, trace: &mut Trace) {
    trace.summary = gather(system, Some(&mut trace.tree), &|_| {});
}

/// Traces every ray of a system and keeps no tree: memory for the depth of the tree, not for its size.
#[must_use]
pub fn summarize(system: &OpticalSystem) -> Summary {
    summarize_watched(system, &|_| {})
}

/// [`summarize`], telling `progress` now and then how many more segments there are; from any thread.
#[must_use]
pub fn summarize_watched(system: &OpticalSystem, progress: &(dyn Fn(u64) + Sync)) -> Summary {
    gather(system, None, progress)
}

fn gather(system: &OpticalSystem, mut tree: Option<&mut RayTree>, progress: &(dyn Fn(u64) + Sync)) -> Summary {
    let mut summary = Summary::new(system);
    let memory = |tree: &mut RayTree| tree.rays.drain(..).rev().map(|ray| ray.segments).collect();
    let memory = tree.as_deref_mut().map(|tree| Mutex::new(memory(tree)));
    collect(system, memory, progress, |stretch| {
        summary.work.add(&stretch.work);
        summary.add(stretch.summary);
        if let Some(tree) = &mut tree {
            tree.rays.extend(stretch.rays);
        }
    });
    summary
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
