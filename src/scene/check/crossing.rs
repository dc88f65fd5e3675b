//! Whether a closed chain of edges and arcs meets itself. Straight edges are told apart exactly, by Shewchuk's adaptive
//! predicates ("Adaptive precision floating-point arithmetic and fast robust geometric predicates", 1997, section 4.1);
//! where arcs take part, meetings within rounding of a corner are let pass between the two curves that share it.

use glam::DVec2;
use robust::{Coord, orient2d};

use crate::geometry::{Bounds, Curve, crossings, lies_on};

/// Most comparisons for all chains of a scene before one is given up.
pub(super) const MOST_STEPS: usize = 100_000_000;

/// Most curves that are looked at one by one.
const FEW: usize = 16;

/// Why a chain is no simple outline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fault {
    /// The numbers of two curves that meet where they must not.
    Meet(usize, usize),
    /// Too many curves lie side by side to compare them all.
    TooTangled,
}

/// The first fault of a closed chain in which each curve begins where the one before ends. `steps` counts comparisons.
///
/// Chains whose neighbors lie close together take n log n steps; others are given up after about a second.
pub(super) fn first_fault(curves: &[Curve], steps: &mut usize) -> Option<Fault> {
    let mut tree = Tree::new(curves);
    let last = curves.len().saturating_sub(1);
    (0..curves.len()).find_map(|i| {
        let meets = |j: usize| match (j - i, i) {
            (1, _) if last == 1 => folds_back(&curves[i], &curves[j]) || folds_back(&curves[j], &curves[i]),
            (1, _) => folds_back(&curves[i], &curves[j]),
            (_, 0) if j == last => folds_back(&curves[j], &curves[i]),
            _ => meet(&curves[i], &curves[j]),
        };
        let first = tree.first(tree.boxes_of(i), i + 1, meets, steps);
        let tangled = (*steps > MOST_STEPS).then_some(Fault::TooTangled);
        first.map(|j| Fault::Meet(i, j)).or(tangled)
    })
}

/// Boxes around runs of consecutive curves: node k has the children 2k and 2k + 1, curve i is leaf `leaves` + i.
struct Tree {
    boxes: Vec<Bounds>,
    leaves: usize,
    /// Nodes still to be looked at, and how many leaves each has; kept for its memory.
    waiting: Vec<(usize, usize)>,
}

impl Tree {
    fn new(curves: &[Curve]) -> Self {
        let leaves = curves.len().next_power_of_two();
        let mut boxes = vec![Bounds::EMPTY; 2 * leaves];
        for (i, curve) in curves.iter().enumerate() {
            let bounds = Bounds::from(curve);
            boxes[leaves + i] = if curve.is_straight() { bounds } else { bounds.grown(1e-9 * bounds.reach()) };
        }
        for k in (1..leaves).rev() {
            boxes[k] = boxes[2 * k].union(boxes[2 * k + 1]);
        }
        Self { boxes, leaves, waiting: Vec::new() }
    }

    fn boxes_of(&self, i: usize) -> Bounds {
        self.boxes[self.leaves + i]
    }

    /// The first curve from number `from` on whose box meets `bounds` and that passes the test.
    fn first(&mut self, bounds: Bounds, from: usize, test: impl Fn(usize) -> bool, steps: &mut usize) -> Option<usize> {
        if self.leaves <= FEW {
            let mut others = from..self.leaves;
            return others.find(|j| self.boxes_of(*j).meets(bounds) && test(*j));
        }
        self.waiting.clear();
        self.waiting.push((1, self.leaves));
        while let Some((node, width)) = self.waiting.pop() {
            *steps += 1;
            let end = (node * width) + width - self.leaves;
            if end <= from || !self.boxes[node].meets(bounds) {
                continue;
            }
            if width > 1 {
                self.waiting.extend([(2 * node + 1, width / 2), (2 * node, width / 2)]);
            } else if test(node - self.leaves) {
                return Some(node - self.leaves);
            }
        }
        None
    }
}

fn side(a: DVec2, b: DVec2, p: DVec2) -> f64 {
    let [a, b, p] = [a, b, p].map(|p| Coord { x: p.x, y: p.y });
    orient2d(a, b, p)
}

/// Whether the second of two curves that follow each other leads back into the first.
fn folds_back(first: &Curve, second: &Curve) -> bool {
    if first.is_straight() && second.is_straight() {
        let opposed = (first.b - first.a).dot(second.b - second.a) < 0.0;
        return opposed && side(first.a, first.b, second.b) == 0.0;
    }
    let shared: Vec<_> = [first.a, first.b].into_iter().filter(|p| [second.a, second.b].contains(p)).collect();
    arcs_meet(first, second, &shared)
}

fn meet(first: &Curve, second: &Curve) -> bool {
    if first.is_straight() && second.is_straight() { edges_meet(first, second) } else { arcs_meet(first, second, &[]) }
}

fn edges_meet(first: &Curve, second: &Curve) -> bool {
    let (a, b, c, d) = (first.a, first.b, second.a, second.b);
    let [abc, abd, cda, cdb] = [side(a, b, c), side(a, b, d), side(c, d, a), side(c, d, b)];
    let apart = |p: f64, q: f64| (p > 0.0 && q > 0.0) || (p < 0.0 && q < 0.0);
    // On one line, the boxes decide, and they are known to meet.
    !apart(abc, abd) && !apart(cda, cdb) && Bounds::of([a, b]).meets(Bounds::of([c, d]))
}

/// Whether two curves of which at least one is an arc meet anywhere but at corners that they share: there rounding decides.
fn arcs_meet(first: &Curve, second: &Curve, shared: &[DVec2]) -> bool {
    let around = Bounds::from(first).union(Bounds::from(second));
    let (rounding, size) = (8.0 * f64::EPSILON * around.reach(), around.size().max_element());
    let is_elsewhere = |p: &DVec2| shared.iter().all(|corner| corner.distance(*p) > 1e-9 * size);
    let touches = |curve: &Curve, other: &Curve| {
        let on_other = |p: &DVec2| halves(other).iter().any(|half| lies_on(half, *p, rounding));
        [curve.a, curve.b].iter().any(|end| is_elsewhere(end) && on_other(end))
    };
    let (ours, theirs) = (halves(first), halves(second));
    let mut pairs = ours.iter().flat_map(|one| theirs.iter().map(move |other| (one, other)));
    touches(first, second)
        || touches(second, first)
        || pairs.any(|(one, other)| crossings(one, other, rounding).iter().any(is_elsewhere))
}

fn halves(curve: &Curve) -> Vec<Curve> {
    if curve.is_straight() { vec![*curve] } else { curve.halves().to_vec() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn first_crossing(curves: &[Curve]) -> Option<(usize, usize)> {
        first_fault(curves, &mut 0).map(|fault| match fault {
            Fault::Meet(i, j) => (i, j),
            Fault::TooTangled => panic!("{fault:?}"),
        })
    }

    fn chain(points: &[(f64, f64)]) -> Vec<Curve> {
        let next = points.iter().cycle().skip(1);
        points.iter().zip(next).map(|(a, b)| Curve::line((*a).into(), (*b).into())).collect()
    }

    #[test]
    fn simple_outlines_pass() {
        assert_eq!(first_crossing(&chain(&[(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)])), None);
        assert_eq!(first_crossing(&chain(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 1.0), (0.0, 4.0)])), None);
        let bulge = Curve::arc(DVec2::ZERO, DVec2::new(1.0, -1.0), DVec2::new(2.0, 0.0)).unwrap();
        assert_eq!(first_crossing(&[bulge, Curve::line(bulge.b, bulge.a)]), None);
    }

    #[test]
    fn crossing_touching_and_folding_edges_are_found() {
        assert_eq!(first_crossing(&chain(&[(0.0, 0.0), (4.0, 4.0), (4.0, 0.0), (0.0, 4.0)])), Some((0, 2)));
        assert_eq!(first_crossing(&chain(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 0.0), (0.0, 4.0)])), Some((0, 2)));
        assert_eq!(first_crossing(&chain(&[(0.0, 0.0), (4.0, 0.0), (2.0, 0.0), (2.0, 4.0)])), Some((0, 1)));
        assert_eq!(first_crossing(&chain(&[(2.0, 0.0), (2.0, 4.0), (0.0, 0.0), (4.0, 0.0)])), Some((0, 2)));
    }

    #[test]
    fn an_arc_that_cuts_an_edge_is_found() {
        let square = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];
        let mut curves = chain(&square);
        curves[0] = Curve::arc(DVec2::ZERO, DVec2::new(2.0, 4.5), DVec2::new(4.0, 0.0)).unwrap();
        assert!(first_crossing(&curves).is_some());
        curves[0] = Curve::arc(DVec2::ZERO, DVec2::new(2.0, 1.5), DVec2::new(4.0, 0.0)).unwrap();
        assert_eq!(first_crossing(&curves), None);
    }

    #[test]
    fn flat_arcs_that_cross_or_touch_are_found() {
        // A radius of 1e9 beside one of 100.
        let flat =
            Curve::arc(DVec2::new(40.0, 0.0), DVec2::new(60.0 - 7e-7, 30.0 + 5e-7), DVec2::new(80.0, 60.0)).unwrap();
        let round = Curve::arc(DVec2::new(0.0, 80.0), DVec2::new(48.7, 4.8), DVec2::new(20.0, -80.0)).unwrap();
        let line = Curve::line;
        assert_eq!(first_crossing(&[line(round.b, flat.a), flat, line(flat.b, round.a), round]), Some((1, 3)));
        // The corner at (0, 60) stands on the first edge.
        let (foot, top, corner) = (DVec2::new(0.0, -60.0), DVec2::new(0.0, 80.0), DVec2::new(0.0, 60.0));
        let bulge = Curve::arc(top, DVec2::new(2.0, 70.0), corner).unwrap();
        let back = Curve::arc(corner, DVec2::new(-1e-3, 0.0), foot).unwrap();
        assert_eq!(first_crossing(&[line(foot, top), bulge, back]), Some((0, 1)));
    }

    #[test]
    fn an_arc_that_leads_back_through_its_neighbor_is_found() {
        let back = Curve::arc(DVec2::new(4.0, 0.0), DVec2::new(2.0, -1.0), DVec2::new(1.0, 2.0)).unwrap();
        let curves = [Curve::line(DVec2::ZERO, back.a), back, Curve::line(back.b, DVec2::ZERO)];
        assert_eq!(first_crossing(&curves), Some((0, 1)));
    }

    #[test]
    fn what_would_take_too_long_is_given_up() {
        // Long teeth across both axes, whose boxes all overlap.
        let tooth = |k: u32| {
            let across = DVec2::new(1e-3, -1e-3) * f64::from(k / 2);
            let along = if matches!(k % 4, 0 | 3) { 0.0 } else { 1e6 };
            (along + across.x, along + across.y)
        };
        let mut points: Vec<(f64, f64)> = (0..60_000).map(tooth).collect();
        points.push((-1e6, -1e6));
        assert_eq!(first_fault(&chain(&points), &mut 0), Some(Fault::TooTangled));
        // All chains of a scene share what they may take.
        points.truncate(6_000);
        points.push((-1e6, -1e6));
        let (chain, mut steps) = (chain(&points), 0);
        assert_eq!(first_fault(&chain, &mut steps), None);
        assert_eq!(first_fault(&chain, &mut (MOST_STEPS - steps / 2)), Some(Fault::TooTangled));
    }

    #[test]
    fn a_hundred_thousand_edges_take_no_time() {
        let comb = |k: u32| (f64::from(k / 2), if matches!(k % 4, 0 | 3) { 1.0 } else { 9.0 });
        let mut points: Vec<(f64, f64)> = (0..100_000).map(comb).collect();
        points.extend([(1e5, -1.0), (-1.0, -1.0)]);
        assert_eq!(first_crossing(&chain(&points)), None);
    }
}
