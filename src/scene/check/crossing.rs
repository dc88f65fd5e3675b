//! Whether a closed chain of edges and arcs meets itself. Straight edges are told apart exactly, by Shewchuk's adaptive
//! predicates ("Adaptive precision floating-point arithmetic and fast robust geometric predicates", 1997, section 4.1);
//! where arcs take part, meetings closer than rounding to an end are let pass.

use glam::DVec2;
use robust::{Coord, orient2d};

use crate::geometry::{Bounds, Curve};
use crate::numerics::cross;

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
    meet(first, second)
}

fn meet(first: &Curve, second: &Curve) -> bool {
    if first.is_straight() && second.is_straight() { edges_meet(first, second) } else { arcs_meet(first, second) }
}

fn edges_meet(first: &Curve, second: &Curve) -> bool {
    let (a, b, c, d) = (first.a, first.b, second.a, second.b);
    let [abc, abd, cda, cdb] = [side(a, b, c), side(a, b, d), side(c, d, a), side(c, d, b)];
    let apart = |p: f64, q: f64| (p > 0.0 && q > 0.0) || (p < 0.0 && q < 0.0);
    // On one line, the boxes decide, and they are known to meet.
    !apart(abc, abd) && !apart(cda, cdb) && Bounds::of([a, b]).meets(Bounds::of([c, d]))
}

/// Two curves of which at least one is an arc: their whole lines or circles are cut, and the points between the ends count.
fn arcs_meet(first: &Curve, second: &Curve) -> bool {
    let reach = Bounds::from(first).union(Bounds::from(second)).size().max_element();
    let inside = |curve: &Curve, p: DVec2| {
        let near_end = (p - curve.a).length().min((p - curve.b).length()) <= 1e-9 * reach;
        !near_end
            && halves(curve).iter().any(|half| (0.0..=half.along(half.b)).contains(&half.along(p)) && on_half(half, p))
    };
    cuts(first, second).into_iter().any(|p| inside(first, p) && inside(second, p))
}

fn halves(curve: &Curve) -> Vec<Curve> {
    if curve.is_straight() { vec![*curve] } else { curve.halves().to_vec() }
}

/// Whether a point of a half arc's circle lies on the bulging side of its chord.
fn on_half(half: &Curve, p: DVec2) -> bool {
    half.is_straight() || cross(half.b - half.a, p - half.a) * half.curvature <= 0.0
}

/// The points common to the whole lines or circles of two curves; none where they touch or coincide.
fn cuts(first: &Curve, second: &Curve) -> Vec<DVec2> {
    let (arc, other) = if first.is_straight() { (second, first) } else { (first, second) };
    let (center, radius) = (arc.center(), arc.curvature.recip().abs());
    // Foot of the common chord on the line through the center along `axis`.
    let (axis, foot) = if other.is_straight() {
        (other.n, (other.m - center).dot(other.n))
    } else {
        let between = other.center() - center;
        let distance = between.length();
        let other_radius = other.curvature.recip().abs();
        let foot = 0.5 * (distance + (radius - other_radius) * (radius + other_radius) / distance);
        (between / distance, foot)
    };
    let half_chord = ((radius - foot) * (radius + foot)).sqrt();
    // A chord that is short against the radius is a touch, up to rounding.
    if half_chord.is_nan() || half_chord <= 1e-7 * radius {
        return Vec::new();
    }
    let foot = center + foot * axis;
    vec![foot + half_chord * axis.perp(), foot - half_chord * axis.perp()]
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
