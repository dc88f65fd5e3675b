use std::ops::Range;

use glam::{DVec2, Vec4};

use crate::geometry::box_tree::{Line, Waiting};
use crate::geometry::{Bounds, Curve, RunTree};

/// Curves in runs that a line finds, and those of a run that it surely passes by.
#[derive(Clone, Debug)]
pub(crate) struct CurveTree {
    runs: RunTree,
    ends: Vec<Ends>,
}

/// The ends of the curves in a run side by side, in the tree's units.
#[derive(Clone, Copy, Debug)]
struct Ends {
    /// By axis.
    a: [[Vec4; 2]; 2],
    b: [[Vec4; 2]; 2],
    /// A line passes by whose two sides are alike and beyond this.
    margin: [Vec4; 2],
}

impl CurveTree {
    /// Over curves of at most half a circle each; distances below `near` are rounding.
    pub(crate) fn new<'a>(curves: impl Iterator<Item = &'a Curve> + Clone, near: f64) -> Self {
        let runs = RunTree::new(curves.clone().map(|curve| Bounds::from(curve).grown(2.0 * near)));
        let mut ends = vec![Ends::NONE; runs.around().len()];
        let places = (0..ends.len()).flat_map(|run| runs.range(run).enumerate().map(move |(slot, _)| (run, slot)));
        for ((run, slot), curve) in places.zip(curves) {
            ends[run].set(slot, [curve.a, curve.b].map(|end| runs.tree.local(end)), runs.tree.margin(curve, near));
        }
        Self { runs, ends }
    }

    /// Visits at least the curves whose boxes share a point with `bounds`; returns how many nodes of the tree were looked at.
    pub(crate) fn meeting(&self, bounds: Bounds, mut visit: impl FnMut(usize)) -> usize {
        self.runs.meeting(bounds, |run| self.runs.range(run).for_each(&mut visit))
    }

    /// The curves in runs, by their places.
    pub(crate) fn runs(&self) -> impl Iterator<Item = Range<usize>> {
        (0..self.ends.len()).map(|run| self.runs.range(run))
    }

    /// [`BoxTree::along`](crate::geometry::BoxTree::along), for the curves that the line does not surely pass by; the run
    /// `left_behind` is left out.
    #[inline]
    pub(crate) fn along(
        &self,
        from: DVec2,
        direction: DVec2,
        begin: f64,
        left_behind: u32,
        waiting: &mut Waiting,
        mut visit: impl FnMut(usize) -> f64,
    ) -> u64 {
        self.runs.tree.along(from, direction, begin, left_behind, waiting, |line, run| {
            let (start, mut met) = (self.runs.range(run).start, self.ends[run].met(line));
            let mut end = f64::INFINITY;
            while met != 0 {
                end = end.min(visit(start + met.trailing_zeros() as usize));
                met &= met - 1;
            }
            end
        })
    }
}

impl Ends {
    const NONE: Self = Self { a: [[Vec4::ZERO; 2]; 2], b: [[Vec4::ZERO; 2]; 2], margin: [Vec4::NEG_INFINITY; 2] };

    fn set(&mut self, slot: usize, [a, b]: [[f32; 2]; 2], margin: f32) {
        for axis in 0..2 {
            self.a[axis][slot / 4][slot % 4] = a[axis];
            self.b[axis][slot / 4][slot % 4] = b[axis];
        }
        self.margin[slot / 4][slot % 4] = margin;
    }

    /// The curves that a line does not surely pass by, a bit each.
    #[inline]
    fn met(&self, line: &Line) -> u32 {
        let mut met = 0;
        for k in 0..2 {
            let [a, b] = [&self.a, &self.b].map(|end| line.sides(end[0][k], end[1][k]));
            let passes = a.min(b).cmpgt(self.margin[k]) | a.max(b).cmplt(-self.margin[k]);
            met |= (passes.bitmask() ^ 15) << (4 * k);
        }
        met
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::BoxTree;
    use crate::numerics::Turn;

    #[test]
    fn a_line_finds_the_curves_that_it_meets_and_few_others() {
        let corner = |k: i32| Turn::degrees(45.0 * f64::from(k)).direction();
        let edges: Vec<_> = (0..8).map(|k| Curve::line(corner(k), corner(k + 1))).collect();
        let found = |curves: &[Curve], y: f64| {
            let (mut found, mut waiting) = (Vec::new(), Waiting::new());
            CurveTree::new(curves.iter(), 1e-12).along(
                DVec2::new(-3.0, y),
                DVec2::X,
                0.0,
                BoxTree::NO_BOX,
                &mut waiting,
                |place| {
                    found.push(place);
                    f64::INFINITY
                },
            );
            found
        };
        assert_eq!(found(&edges, 0.3), [0, 3]);
        assert_eq!(found(&edges, 0.8), [1, 2]);
        // Both ends of an arc lie on one side of a line that meets its bulge; the other line misses its box.
        let arc = [Curve::arc(DVec2::new(1.0, 0.6), DVec2::new(0.0, 0.8), DVec2::new(-1.0, 0.6)).unwrap()];
        assert_eq!((found(&arc, 0.79).len(), found(&arc, 0.5).len()), (1, 0));
    }
}
