//! Which boundaries come near each other.

use std::ops::Deref;

use crate::compile::effort::{Effort, Exhausted};
use crate::compile::lists::Lists;
use crate::geometry::{Bounds, RunTree};

/// Nodes of a search tree that are looked at in the time of one comparison.
pub(crate) const NODES: usize = 16;

/// Boundaries' boxes in runs.
#[derive(Clone, Debug)]
pub(crate) struct Runs {
    boxes: Vec<Bounds>,
    tree: RunTree,
}

impl Deref for Runs {
    type Target = RunTree;

    fn deref(&self) -> &RunTree {
        &self.tree
    }
}

impl Runs {
    pub(crate) fn new(boxes: Vec<Bounds>) -> Self {
        let tree = RunTree::new(boxes.iter().copied());
        Self { boxes, tree }
    }

    /// For each run the runs that come within `margin` of it, itself too, ascending.
    pub(crate) fn neighbors(&self, margin: f64, effort: &Effort) -> Result<Lists, Exhausted> {
        let mut lists = Lists::new();
        for (run, around) in self.around().iter().enumerate() {
            effort.check(self.range(run).start)?;
            let mut count = 0;
            let nodes = self.meeting(around.grown(margin), |other| {
                lists.push(other);
                count += 1;
            });
            effort.spend(count + nodes / NODES);
            lists.end();
        }
        Ok(lists)
    }

    /// Visits the boxes that share a point with `bounds`, in order.
    pub(crate) fn boxes_meeting(&self, bounds: Bounds, effort: &Effort) -> Vec<usize> {
        let mut found = Vec::new();
        let nodes = self.meeting(bounds, |run| found.extend(self.range(run).filter(|k| self.boxes[*k].meets(bounds))));
        effort.spend(found.len() + nodes / NODES);
        found.sort_unstable();
        found
    }

    /// Whether two boxes share a point.
    pub(crate) fn meet(&self, one: usize, other: usize) -> bool {
        self.boxes[one].meets(self.boxes[other])
    }

    /// Pairs of boxes that share a point, the earlier first, sorted; `neighbors` are the runs'.
    pub(crate) fn pairs(&self, neighbors: &Lists, effort: &Effort) -> Result<Vec<(usize, usize)>, Exhausted> {
        let mut pairs = Vec::with_capacity(self.boxes.len());
        for run in 0..self.around().len() {
            let others = || neighbors.of(run).iter().filter(|other| **other >= run);
            for i in self.range(run) {
                effort.check(i)?;
                let (one, before) = (self.boxes[i], pairs.len());
                for &other in others().filter(|other| self.around()[**other].meets(one)) {
                    let later = self.range(other).start.max(i + 1)..self.range(other).end;
                    pairs.extend(later.filter(|j| self.boxes[*j].meets(one)).map(|j| (i, j)));
                }
                effort.spend(pairs.len() - before);
            }
        }
        Ok(pairs)
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;

    #[test]
    fn pairs_are_those_of_all_with_all() {
        let unit = |k: u32| f64::from(k.wrapping_mul(2_654_435_769) >> 8) / 16_777_216.0;
        let one = |k: u32| {
            let min = DVec2::new(unit(3 * k), unit(3 * k + 1));
            Bounds { min, max: min + 0.2 * unit(3 * k + 2) * unit(3 * k + 2) }
        };
        let boxes: Vec<_> = (0..300).map(one).collect();
        let all = (0..300).flat_map(|i| (i + 1..300).map(move |j| (i, j)));
        let expected: Vec<_> = all.filter(|(i, j)| boxes[*i].meets(boxes[*j])).collect();
        let runs = Runs::new(boxes);
        let effort = Effort::new(1_000_000);
        let neighbors = runs.neighbors(0.0, &effort).unwrap();
        assert_eq!(runs.pairs(&neighbors, &effort).unwrap(), expected);
    }
}
