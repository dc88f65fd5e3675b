//! The nearest hit by a plain loop over all edges and arcs.

use glam::DVec2;
use snellius::geometry::{CircleRoots, Curve};

use crate::flat::Flat;

/// Edges apart from what only arcs need, each in one cache line.
pub(crate) struct Loop {
    edges: Vec<Edge>,
    arcs: Vec<Curve>,
}

#[derive(Clone, Copy)]
pub(crate) struct Edge {
    a: DVec2,
    b: DVec2,
    /// Unit normal.
    n: DVec2,
    /// Distance of its line from the origin along the normal.
    offset: f64,
}

impl Edge {
    pub(crate) fn new(curve: &Curve) -> Self {
        Self { a: curve.a, b: curve.b, n: curve.n, offset: curve.n.dot(curve.m) }
    }

    /// Distance ahead at which a ray passes between the ends: its line does if they lie on both sides of it.
    pub(crate) fn distance(&self, from: DVec2, direction: DVec2) -> Option<f64> {
        let (a, b) = (direction.perp_dot(self.a - from), direction.perp_dot(self.b - from));
        if (a < 0.0) == (b < 0.0) {
            return None;
        }
        let distance = (self.offset - self.n.dot(from)) / self.n.dot(direction);
        (distance > 0.0).then_some(distance)
    }
}

impl Loop {
    pub(crate) fn new(flat: &Flat) -> Self {
        let (edges, arcs) = flat.curves.split_at(flat.edges);
        Self { edges: edges.iter().map(Edge::new).collect(), arcs: arcs.to_vec() }
    }

    pub(crate) fn nearest(&self, from: DVec2, direction: DVec2, last: usize) -> Option<(usize, f64)> {
        let mut best = None;
        let mut least = f64::INFINITY;
        for (k, edge) in self.edges.iter().enumerate() {
            if let Some(distance) = edge.distance(from, direction).filter(|distance| *distance < least && k != last) {
                least = distance;
                best = Some(k);
            }
        }
        for (k, arc) in (self.edges.len()..).zip(&self.arcs) {
            for distance in distances(arc, from, direction, k == last) {
                if distance > 0.0 && distance < least && holds(arc, from + distance * direction) {
                    least = distance;
                    best = Some(k);
                }
            }
        }
        best.map(|k| (k, least))
    }
}

/// Where a ray meets an arc's circle; from a point of it only the other one.
fn distances(arc: &Curve, from: DVec2, direction: DVec2, stands_on_it: bool) -> [f64; 2] {
    if stands_on_it {
        return [2.0 * arc.normal_at(from).dot(direction) / arc.curvature, 0.0];
    }
    let roots = CircleRoots::new(arc, from, direction);
    if roots.meets { [roots.from_left, roots.from_right] } else { [0.0; 2] }
}

/// Whether a point of an arc's circle is the arc's: it lies on the side of the chord to which the arc bulges.
fn holds(arc: &Curve, p: DVec2) -> bool {
    (arc.b - arc.a).perp_dot(p - arc.a) * arc.curvature < 0.0
}
