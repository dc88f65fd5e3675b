//! The nearest hit by parry2d's hierarchy of boxes.

use glam::DVec2;
use parry2d_f64::bounding_volume::Aabb;
use parry2d_f64::math::Vector;
use parry2d_f64::partitioning::{Bvh, BvhBuildStrategy, BvhNode};
use parry2d_f64::query::{Ray, RayCast};
use parry2d_f64::shape::Segment;
use snellius::geometry::Curve;

use crate::scalar::Edge;

/// Its default, mostly the faster of its two.
pub(crate) const STRATEGY: BvhBuildStrategy = BvhBuildStrategy::Binned;

/// Edges in a hierarchy of boxes.
pub(crate) struct Parry {
    boxes: Bvh,
    segments: Vec<Segment>,
    edges: Vec<Edge>,
}

impl Parry {
    pub(crate) fn new(curves: &[Curve], strategy: BvhBuildStrategy) -> Self {
        let segments = curves.iter().map(|curve| Segment::new(vector(curve.a), vector(curve.b))).collect();
        Self { boxes: boxes(curves, strategy), segments, edges: curves.iter().map(Edge::new).collect() }
    }

    /// With parry's own test of a segment, as its polyline does.
    pub(crate) fn nearest_with_its_own_test(&self, from: DVec2, direction: DVec2, last: usize) -> Option<(usize, f64)> {
        self.cast(from, direction, last, |k, ray, best| self.segments[k].cast_local_ray(ray, best, false))
    }

    /// With the plain loop's test of an edge.
    pub(crate) fn nearest(&self, from: DVec2, direction: DVec2, last: usize) -> Option<(usize, f64)> {
        self.cast(from, direction, last, |k, _, _| self.edges[k].distance(from, direction))
    }

    /// Its hierarchy with tests of one's own for edges and boxes, the direction inverted once a ray and not once a box.
    pub(crate) fn nearest_with_our_tests(&self, from: DVec2, direction: DVec2, last: usize) -> Option<(usize, f64)> {
        let inverse = direction.recip();
        let entry = |node: &BvhNode, best: f64| {
            let (low, high) = (node.mins(), node.maxs());
            let one = (DVec2::new(low.x, low.y) - from) * inverse;
            let other = (DVec2::new(high.x, high.y) - from) * inverse;
            let (enter, leave) = (one.min(other).max_element().max(0.0), one.max(other).min_element().min(best));
            if enter <= leave { enter } else { f64::MAX }
        };
        let test = |k: u32, _| self.edges[k as usize].distance(from, direction).filter(|_| k as usize != last);
        self.boxes.find_best(f64::MAX, entry, test).map(|(k, distance)| (k as usize, distance))
    }

    fn cast(
        &self,
        from: DVec2,
        direction: DVec2,
        last: usize,
        test: impl Fn(usize, &Ray, f64) -> Option<f64>,
    ) -> Option<(usize, f64)> {
        let ray = Ray::new(vector(from), vector(direction));
        let test = |k: u32, best: f64| (k as usize != last).then(|| test(k as usize, &ray, best)).flatten();
        self.boxes.cast_ray(&ray, f64::MAX, test).map(|(k, distance)| (k as usize, distance))
    }
}

/// The hierarchy alone.
pub(crate) fn boxes(curves: &[Curve], strategy: BvhBuildStrategy) -> Bvh {
    let around = |curve: &Curve| Aabb::new(vector(curve.a.min(curve.b)), vector(curve.a.max(curve.b)));
    Bvh::from_leaves(strategy, &curves.iter().map(around).collect::<Vec<_>>())
}

fn vector(p: DVec2) -> Vector {
    Vector::new(p.x, p.y)
}
