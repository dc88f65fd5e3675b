//! Which boundaries come near each other.

use std::ops::Deref;

use crate::compile::lists::Lists;
use crate::geometry::{Bounds, RunTree};

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
    pub(crate) fn neighbors(&self, margin: f64) -> Lists {
        let mut lists = Lists::new();
        for around in self.around() {
            self.meeting(around.grown(margin), |other| lists.push(other));
            lists.end();
        }
        lists
    }

    /// Pairs of boxes that share a point, the earlier first, sorted; `neighbors` are the runs'.
    pub(crate) fn pairs(&self, neighbors: &Lists) -> Vec<(usize, usize)> {
        let mut pairs = Vec::with_capacity(self.boxes.len());
        for run in 0..self.around().len() {
            let others = || neighbors.of(run).iter().filter(|other| **other >= run);
            for i in self.range(run) {
                let one = self.boxes[i];
                for &other in others().filter(|other| self.around()[**other].meets(one)) {
                    let later = self.range(other).start.max(i + 1)..self.range(other).end;
                    pairs.extend(later.filter(|j| self.boxes[*j].meets(one)).map(|j| (i, j)));
                }
            }
        }
        pairs
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
        assert_eq!(runs.pairs(&runs.neighbors(0.0)), expected);
    }
}
