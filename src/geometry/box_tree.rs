//! A search tree over boxes, four to a node.
//!
//! # Source
//! Wald, Benthin and Boulos, "Getting Rid of Packets", IEEE Symposium on Interactive Ray Tracing 2008, for the wide nodes.

use glam::{DVec2, Vec4};

use crate::geometry::box_split::{Flat, Item, around, split};
use crate::geometry::{Bounds, Curve};

/// Boxes by their place in a list, found by where they are.
///
/// A search visits every box that qualifies and some that only nearly do: boxes are kept in single precision of the whole
/// tree's extent, rounded outward.
#[derive(Clone, Debug)]
pub(crate) struct BoxTree {
    nodes: Vec<Node>,
    /// The box around all boxes.
    bounds: Bounds,
    /// A power of two that brings `bounds`, less its center, to at most 1.
    scale: f64,
}

/// Four boxes side by side, with what is in each.
#[derive(Clone, Copy, Debug)]
struct Node {
    /// By axis, the lower and the upper ends.
    ends: [[Vec4; 2]; 2],
    content: [u32; 4],
}

/// In `content`, for a box of the list and not a node.
const ITEM: u32 = 1 << 31;
/// In `content`, for nothing.
const NONE: u32 = u32::MAX;
/// How far boxes are grown, in units of the extent. Rounding boxes and rays to single precision moves them by up to 2^-21.
const PAD: f32 = 1.0 / 1_048_576.0;
/// What waits to be searched: the distance at which a line enters a box, in the tree's units, and what is in the box.
pub(crate) type Waiting = Vec<(f32, u32)>;

impl BoxTree {
    /// The place of no box.
    pub(crate) const NO_BOX: u32 = !ITEM;

    /// A tree over at most 2^31 − 1 boxes. Boxes beyond that are left out.
    pub(crate) fn new(boxes: &[Bounds]) -> Self {
        let bounds = boxes.iter().fold(Bounds::EMPTY, |all, one| all.union(*one));
        let extent = bounds.size().max_element();
        let scale = if extent > 0.0 { libm::ldexp(1.0, -libm::frexp(extent).1) } else { 1.0 };
        let mut tree = Self { nodes: Vec::with_capacity(boxes.len() / 2 + 1), bounds, scale };
        let mut items: Vec<Item> =
            (0..ITEM - 1).zip(boxes).map(|(k, b)| Item { place: k, flat: tree.flat(*b) }).collect();
        tree.node(&mut items, 0);
        tree
    }

    /// Visits the boxes that share a point with `bounds`; returns how many nodes were looked at.
    pub(crate) fn meeting(&self, bounds: Bounds, mut visit: impl FnMut(usize)) -> usize {
        let (min, max) = (self.local(bounds.min), self.local(bounds.max));
        let (mut waiting, mut looked_at) = (vec![0], 0);
        while let Some(place) = waiting.pop() {
            let Some(node) = self.nodes.get(place as usize) else { continue };
            looked_at += 1;
            for slot in 0..4 {
                let meets = |axis: usize| {
                    let [low, high] = node.ends[axis].map(|ends| ends[slot]);
                    low <= max[axis] && min[axis] <= high
                };
                match node.content[slot] {
                    content if content == NONE || !(meets(0) && meets(1)) => {}
                    content if content & ITEM != 0 => visit((content & !ITEM) as usize),
                    content => waiting.push(content),
                }
            }
        }
        looked_at
    }

    /// Visits the boxes that a line meets at a distance of at least `begin` from its point `from` along the unit vector
    /// `direction`, about in the order in which it meets them. `visit` returns the distance beyond which nothing counts any
    /// more. The box at place `left_out` is not visited. Returns how many nodes were looked at. `waiting` is working memory.
    pub(super) fn along(
        &self,
        from: DVec2,
        direction: DVec2,
        begin: f64,
        left_out: u32,
        waiting: &mut Waiting,
        mut visit: impl FnMut(&Line, usize) -> f64,
    ) -> u64 {
        let Some(line) = self.line(from, direction, begin) else { return 0 };
        let (mut end, mut looked_at) = (f32::INFINITY, 0);
        waiting.clear();
        let mut next = Some(0);
        while let Some(content) = next {
            next = None;
            if content & ITEM == 0 {
                looked_at += 1;
                next = self.nodes[content as usize].nearest_met(&line, end, left_out | ITEM, waiting);
            } else if content != NONE {
                end = end.min(line.until(visit(&line, (content & !ITEM) as usize)));
            }
            while next.is_none()
                && let Some((entry, content)) = waiting.pop()
            {
                next = (entry <= end).then_some(content);
            }
        }
        looked_at
    }

    /// A line in the tree's units from where it enters the tree; `None` if it misses it.
    fn line(&self, from: DVec2, direction: DVec2, begin: f64) -> Option<Line> {
        let pad = f64::from(PAD) / self.scale;
        if begin == 0.0 && self.bounds.contains(from) {
            return Some(self.line_from(from, direction, 0.0));
        }
        let [x, y] = [0, 1].map(|axis| {
            let (o, d) = (from[axis], no_zero(direction[axis]));
            let t = [self.bounds.min[axis] - pad, self.bounds.max[axis] + pad].map(|edge| (edge - o) / d);
            if d < 0.0 { [t[1], t[0]] } else { t }
        });
        let (entry, exit) = (x[0].max(y[0]).max(begin), x[1].min(y[1]));
        // Each is good to a few ulp.
        if entry - exit > 16.0 * f64::EPSILON * (entry.abs() + exit.abs()) {
            return None;
        }
        // Where rounding on the way to the tree is not small against its boxes, everything counts.
        let is_far = (from.abs().max_element() + entry.abs()) * 16.0 * f64::EPSILON > 0.25 * pad;
        if is_far {
            let (origin, inverse, entry) = ([0.0; 2], [0.0; 2], f64::NEG_INFINITY);
            return Some(Line { origin, direction: [0.0; 2], inverse, near: [0; 2], entry, scale: self.scale });
        }
        (entry <= exit).then(|| self.line_from(from, direction, entry))
    }

    #[expect(clippy::cast_possible_truncation, reason = "PAD holds what is lost")]
    fn line_from(&self, from: DVec2, direction: DVec2, entry: f64) -> Line {
        Line {
            origin: self.local(from + entry * direction),
            direction: [direction.x as f32, direction.y as f32],
            inverse: [0, 1].map(|axis| inverse(direction[axis])),
            near: [0, 1].map(|axis| usize::from(inverse(direction[axis]) < 0.0)),
            entry,
            scale: self.scale,
        }
    }

    /// Makes the node over `items` and all below it; returns its place.
    fn node(&mut self, items: &mut [Item], depth: u32) -> u32 {
        let place = self.nodes.len();
        self.nodes.push(Node::EMPTY);
        let mut node = Node::EMPTY;
        let (low, high) = split(items, depth);
        let [(a, b), (c, d)] = [low, high].map(|half| split(half, depth));
        for (slot, part) in [a, b, c, d].into_iter().enumerate() {
            match part {
                [] => {}
                [item] => node.set(slot, item.flat, item.place | ITEM),
                _ => {
                    let around = around(part);
                    node.set(slot, around, self.node(part, depth + 1));
                }
            }
        }
        self.nodes[place] = node;
        u32::try_from(place).unwrap_or(NONE)
    }

    fn flat(&self, bounds: Bounds) -> Flat {
        Flat::new(self.local(bounds.min), self.local(bounds.max))
    }

    /// How far beside a line both ends of a curve must lie for it to pass by: more than rounding and the sagitta.
    #[expect(clippy::cast_possible_truncation, reason = "PAD holds what is lost")]
    pub(super) fn margin(&self, curve: &Curve, near: f64) -> f32 {
        (self.scale * (curve.sagitta_at_most() + 2.0 * near)) as f32 * (1.0 + PAD) + 2.0 * PAD
    }

    /// A point in the tree's units, in single precision.
    #[expect(clippy::cast_possible_truncation, reason = "PAD holds what is lost")]
    pub(super) fn local(&self, p: DVec2) -> [f32; 2] {
        let scaled = (p - self.bounds.center()) * self.scale;
        [scaled.x as f32, scaled.y as f32]
    }
}

impl Node {
    const EMPTY: Self = Self { ends: [[Vec4::INFINITY, Vec4::NEG_INFINITY]; 2], content: [NONE; 4] };

    fn set(&mut self, slot: usize, flat: Flat, content: u32) {
        for axis in 0..2 {
            let [min, max] = flat.ends(axis);
            self.ends[axis][0][slot] = min - PAD;
            self.ends[axis][1][slot] = max + PAD;
        }
        self.content[slot] = content;
    }

    /// What the line meets first, before `end`; what else it meets goes on the list, the nearest last. Of its
    /// contents one is left out.
    #[inline]
    fn nearest_met(&self, line: &Line, end: f32, left_out: u32, waiting: &mut Waiting) -> Option<u32> {
        let [x, y] = [0, 1].map(|axis| {
            let t = |end: usize| (self.ends[axis][end] - line.origin[axis]) * line.inverse[axis];
            (t(line.near[axis]), t(1 - line.near[axis]))
        });
        let (entry, exit) = (x.0.max(y.0).max(Vec4::ZERO), x.1.min(y.1).min(Vec4::splat(end)));
        let mut met = entry.cmple(exit).bitmask();
        for slot in 0..4 {
            met &= !(u32::from(self.content[slot] == left_out) << slot);
        }
        let entry = entry.to_array();
        let mut take = || {
            let slot = met.trailing_zeros() as usize;
            met &= met.wrapping_sub(1);
            (slot < 4).then(|| (entry[slot], self.content[slot]))
        };
        let mut nearest = take()?;
        let first = waiting.len();
        while let Some(mut other) = take() {
            if other.0 < nearest.0 {
                std::mem::swap(&mut other, &mut nearest);
            }
            waiting.push(other);
            let mut place = waiting.len() - 1;
            while place > first && waiting[place - 1].0 < waiting[place].0 {
                waiting.swap(place - 1, place);
                place -= 1;
            }
        }
        Some(nearest.1)
    }
}

/// A line in the tree's units.
pub(super) struct Line {
    origin: [f32; 2],
    /// 0 where everything counts.
    direction: [f32; 2],
    /// One over the direction's components, no infinity; 0 meets everything.
    inverse: [f32; 2],
    /// Which end of a box it meets first, by axis.
    near: [usize; 2],
    /// Distance of `origin` along the line, unscaled.
    entry: f64,
    scale: f64,
}

impl Line {
    /// How far to the left of the line points lie, to `PAD`.
    #[inline]
    pub(super) fn sides(&self, x: Vec4, y: Vec4) -> Vec4 {
        (y - self.origin[1]) * self.direction[0] - (x - self.origin[0]) * self.direction[1]
    }

    /// A distance in the tree's units from `origin`, rounded up.
    #[expect(clippy::cast_possible_truncation, reason = "the factor holds what is lost")]
    fn until(&self, distance: f64) -> f32 {
        ((distance - self.entry) * self.scale) as f32 * (1.0 + PAD) + PAD
    }
}

/// One over a component of a direction, in single precision and no infinity.
#[expect(clippy::cast_possible_truncation, reason = "PAD holds what is lost")]
fn inverse(component: f64) -> f32 {
    no_zero(component).recip() as f32
}

/// A component of a direction, away from 0 so far that its inverse is no infinity in single precision.
fn no_zero(component: f64) -> f64 {
    if component.abs() < 1e-18 { 1e-18_f64.copysign(component) } else { component }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Boxes of very different sizes, some of no width, by a multiplicative sequence.
    fn boxes(count: u32, shift: DVec2) -> Vec<Bounds> {
        let unit = |k: u32| f64::from(k.wrapping_mul(2_654_435_769) >> 8) / 16_777_216.0;
        let one = |k: u32| {
            let min = DVec2::new(unit(4 * k), unit(4 * k + 1));
            let size = DVec2::new(unit(4 * k + 2), unit(4 * k + 3)).powf(6.0);
            Bounds::of([min + shift, min + shift + if k.is_multiple_of(5) { DVec2::new(size.x, 0.0) } else { size }])
        };
        (0..count).map(one).collect()
    }

    /// Whether a line meets a box at a distance of at least `begin`, by its corners and ends.
    fn meets(bounds: Bounds, from: DVec2, direction: DVec2, begin: f64) -> bool {
        let corners =
            [bounds.min, DVec2::new(bounds.max.x, bounds.min.y), bounds.max, DVec2::new(bounds.min.x, bounds.max.y)];
        let sides = corners.map(|p| direction.perp_dot(p - from));
        let crosses = sides.iter().any(|side| *side <= 0.0) && sides.iter().any(|side| *side >= 0.0);
        crosses && (bounds.contains(from) || corners.iter().any(|p| (*p - from).dot(direction) >= begin))
    }

    #[test]
    fn a_line_finds_every_box_that_it_meets() {
        for (count, shift) in [(0, DVec2::ZERO), (1, DVec2::X), (7, DVec2::ZERO), (500, DVec2::splat(-3e4))] {
            let boxes = boxes(count, shift);
            let tree = BoxTree::new(&boxes);
            for k in 0..64 {
                let angle = f64::from(k) * 360.0 / 64.0;
                let direction = crate::numerics::Turn::degrees(angle).direction();
                for (away, begin) in [(0.1, 0.0), (3.0, 0.0), (3.0, f64::NEG_INFINITY), (1e13, f64::NEG_INFINITY)] {
                    let from = shift + DVec2::splat(0.5) - away * direction;
                    let mut found = vec![false; boxes.len()];
                    tree.along(from, direction, begin, BoxTree::NO_BOX, &mut Waiting::new(), |_, place| {
                        found[place] = true;
                        f64::INFINITY
                    });
                    for (place, one) in boxes.iter().enumerate() {
                        assert!(found[place] || !meets(*one, from, direction, begin), "{place} of {count} at {angle}°");
                    }
                }
            }
        }
    }

    #[test]
    fn a_box_finds_every_box_that_it_meets_and_few_others() {
        let boxes = boxes(500, DVec2::ZERO);
        let tree = BoxTree::new(&boxes);
        for one in &boxes {
            let mut found = vec![false; boxes.len()];
            tree.meeting(*one, |place| found[place] = true);
            let met = boxes.iter().filter(|other| one.meets(**other)).count();
            assert!(boxes.iter().zip(&found).all(|(other, found)| *found || !one.meets(*other)));
            assert!(found.iter().filter(|found| **found).count() <= met + 2);
        }
    }

    #[test]
    fn what_ends_a_search_spares_the_rest() {
        let row: Vec<_> =
            (0..4096).map(|k| Bounds::of([DVec2::new(f64::from(k), -1.0), DVec2::new(f64::from(k), 1.0)])).collect();
        let tree = BoxTree::new(&row);
        let mut first = None;
        let looked_at =
            tree.along(DVec2::new(-1.0, 0.1), DVec2::X, 0.0, BoxTree::NO_BOX, &mut Waiting::new(), |_, place| {
                first.get_or_insert(place);
                f64::from(u32::try_from(place).unwrap()) + 1.0
            });
        assert_eq!(first, Some(0));
        assert!(looked_at <= 20, "{looked_at} nodes");
    }
}
