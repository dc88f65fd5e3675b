use std::ops::Range;

use crate::geometry::{Bounds, BoxTree};

/// Boxes in runs, found by where they are: those that follow each other in the list share a point as a rule, and a tree over
/// the runs finds them all at a fraction of the cost.
#[derive(Clone, Debug)]
pub(crate) struct RunTree {
    /// The first box of each run, and the number of boxes.
    starts: Vec<usize>,
    around: Vec<Bounds>,
    pub(super) tree: BoxTree,
}

impl RunTree {
    /// Most boxes in a run.
    pub(crate) const LONGEST: usize = 8;

    /// Over boxes that are told by their places in a list, ascending from 0.
    pub(crate) fn new(boxes: impl Iterator<Item = Bounds>) -> Self {
        let (mut starts, mut around): (Vec<usize>, Vec<Bounds>) = (Vec::new(), Vec::new());
        let mut count = 0;
        for one in boxes {
            match (starts.last(), around.last_mut()) {
                (Some(start), Some(run)) if count - start < Self::LONGEST && run.meets(one) => *run = run.union(one),
                _ => {
                    starts.push(count);
                    around.push(one);
                }
            }
            count += 1;
        }
        starts.push(count);
        let tree = BoxTree::new(&around);
        Self { starts, around, tree }
    }

    /// The boxes around runs.
    pub(crate) fn around(&self) -> &[Bounds] {
        &self.around
    }

    /// The boxes of a run, by their places.
    #[inline]
    pub(crate) fn range(&self, run: usize) -> Range<usize> {
        self.starts[run]..self.starts[run + 1]
    }

    /// The run of a box.
    pub(crate) fn run_of(&self, place: usize) -> usize {
        self.starts.partition_point(|start| *start <= place) - 1
    }

    /// For each run the first of ascending places that lies in it or after it, and at the end how many there are.
    pub(crate) fn firsts(&self, places: impl Iterator<Item = usize>) -> Vec<usize> {
        let mut places = places.peekable();
        let mut firsts = vec![0];
        for end in &self.starts[1..] {
            let within = std::iter::from_fn(|| places.next_if(|place| place < end)).count();
            firsts.push(firsts[firsts.len() - 1] + within);
        }
        firsts
    }

    /// Visits every run that shares a point with `bounds`; returns how many nodes of the tree were looked at.
    pub(crate) fn meeting(&self, bounds: Bounds, mut visit: impl FnMut(usize)) -> usize {
        self.tree.meeting(bounds, |run| {
            if self.around[run].meets(bounds) {
                visit(run);
            }
        })
    }
}
