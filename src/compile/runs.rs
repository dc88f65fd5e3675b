//! Which boundaries come near each other.

use std::ops::Range;

use crate::compile::lists::Lists;
use crate::geometry::{Bounds, BoxTree};

/// Most boxes in a run.
const LONGEST: usize = 8;

/// Boxes in runs: those that follow each other in the list share a point as a rule, and a tree over the runs finds them all
/// at a fraction of the cost.
#[derive(Clone, Debug)]
pub(crate) struct Runs {
    boxes: Vec<Bounds>,
    /// The first box of each run, and the number of boxes.
    starts: Vec<usize>,
    around: Vec<Bounds>,
    tree: BoxTree,
}

impl Runs {
    pub(crate) fn new(boxes: Vec<Bounds>) -> Self {
        let (mut starts, mut around): (Vec<usize>, Vec<Bounds>) = (Vec::new(), Vec::new());
        for (k, one) in boxes.iter().enumerate() {
            match (starts.last(), around.last_mut()) {
                (Some(start), Some(run)) if k - start < LONGEST && run.meets(*one) => *run = run.union(*one),
                _ => {
                    starts.push(k);
                    around.push(*one);
                }
            }
        }
        starts.push(boxes.len());
        let tree = BoxTree::new(&around);
        Self { boxes, starts, around, tree }
    }

    /// The boxes around runs.
    pub(crate) fn around(&self) -> &[Bounds] {
        &self.around
    }

    /// The boxes of a run, by their places.
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

    /// Visits every run that shares a point with `bounds`.
    pub(crate) fn meeting(&self, bounds: Bounds, mut visit: impl FnMut(usize)) {
        self.tree.meeting(bounds, |run| {
            if self.around[run].meets(bounds) {
                visit(run);
            }
        });
    }

    /// For each run the runs that come within `margin` of it, itself too, ascending.
    pub(crate) fn neighbors(&self, margin: f64) -> Lists {
        let mut lists = Lists::new();
        for around in &self.around {
            self.meeting(around.grown(margin), |other| lists.push(other));
            lists.end();
        }
        lists
    }

    /// Pairs of boxes that share a point, the earlier first, sorted; `neighbors` are the runs'.
    pub(crate) fn pairs(&self, neighbors: &Lists) -> Vec<(usize, usize)> {
        let mut pairs = Vec::with_capacity(self.boxes.len());
        for run in 0..self.around.len() {
            let others = || neighbors.of(run).iter().filter(|other| **other >= run);
            for i in self.range(run) {
                let one = self.boxes[i];
                for &other in others().filter(|other| self.around[**other].meets(one)) {
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
