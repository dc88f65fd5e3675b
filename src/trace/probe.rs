//! Whether and where a ray's line crosses one interface, decided by identity where distances cannot: the interface that the
//! ray stands on, and the vertices it shares.
//!
//! Which side of the ray a vertex lies on is the same for all that end there, since the same numbers give the same sign: an
//! outline is crossed on its way in and out, or not at all.

use glam::DVec2;

use crate::geometry::{CircleRoots, Curve};
use crate::numerics::{cross, side, side_of_ray};
use crate::system::{Interface, OpticalSystem, Start, VertexId};
use crate::trace::Ray;
use crate::trace::corner::{corner, opens_to};

/// Edges that are met at an angle with a smaller sine are met with care.
const GRAZING: f64 = 1.0 / 1024.0;

/// A crossing of the ray's whole line.
#[derive(Clone, Copy)]
pub(crate) struct Met {
    /// Distance along the ray; below 0 behind it.
    pub(crate) distance: f64,
    /// The distance is good to this.
    pub(crate) slack: f64,
    /// Whether the line comes from the interface's left.
    pub(crate) from_left: bool,
    pub(crate) is_ahead: bool,
    /// Whether the start lies on the interface up to rounding, so that the crossing may be on its other side.
    pub(crate) is_in_doubt: bool,
}

/// A ray among the interfaces of a system.
#[derive(Clone, Copy)]
pub(crate) struct Probe<'a> {
    pub(crate) system: &'a OpticalSystem,
    pub(crate) ray: Ray,
    /// The interface that the ray stands on, and whether it heads to its left.
    last: Option<(&'a Interface, bool)>,
    /// Its place if it is an edge, which cannot be met again.
    pub(crate) edge: usize,
    /// Distances below this are rounding.
    near: f64,
}

impl<'a> Probe<'a> {
    #[inline(always)]
    pub(crate) fn new(system: &'a OpticalSystem, ray: Ray) -> Self {
        let last = match ray.start {
            Start::On { interface, left } => Some((interface, &system.interfaces[interface], left)),
            Start::Free | Start::AtVertex(_) => None,
        };
        let edge = last.filter(|(_, last, _)| last.curve.is_straight()).map_or(usize::MAX, |(place, ..)| place);
        Self { system, ray, last: last.map(|(_, last, left)| (last, left)), edge, near: system.near }
    }

    /// Whether the ray's line is in its medium just before the start, as 1 or 0: it is not where the ray leaves a boundary of
    /// its medium. `None` at a vertex, where several crossings lie at the start itself.
    pub(crate) fn inside_before_start(&self) -> Option<i32> {
        match (self.ray.start, self.last) {
            (Start::AtVertex(_), _) => None,
            (_, Some((last, _))) => Some(i32::from(last.left == last.right)),
            _ => Some(1),
        }
    }

    /// Whether the ray passes one crossing before another, each with its interface and distance. Of two edges with a common
    /// end, both crossed on the same side of it, that which leads backward from it: exact where the distances are not.
    pub(crate) fn is_before(&self, one: (usize, f64), other: (usize, f64)) -> bool {
        let by_distance = one.1 < other.1;
        let [first, second] = [one.0, other.0].map(|place| &self.system.interfaces[place]);
        let Some((corner, [u, v])) = corner(first, second) else { return by_distance };
        let p = [first.curve.a, first.curve.b][usize::from(first.ends[0] != corner)];
        let turn = side(p, u, v);
        if turn == 0.0 { by_distance } else { (turn > 0.0) == self.is_left(corner, p) }
    }

    /// How far to the left of the line a curve's ends lie.
    #[inline(always)]
    pub(crate) fn sides(&self, curve: &Curve) -> [f64; 2] {
        [curve.a, curve.b].map(|end| self.ray.direction.perp_dot(end - self.ray.from))
    }

    /// Whether a curve with these sides surely lies beside the line: both ends do, by more than rounding and the sagitta.
    #[inline(always)]
    pub(crate) fn passes_by(&self, curve: &Curve, [a, b]: [f64; 2]) -> bool {
        let margin = if curve.is_straight() { self.near } else { 2.0 * self.near + curve.sagitta_at_most() };
        (a > margin && b > margin) || (a < -margin && b < -margin)
    }

    /// Visits where the line crosses the interface at place `index`.
    #[inline(always)]
    pub(crate) fn crossings(&self, index: usize, candidate: &Interface, visit: impl FnMut(Met)) {
        if candidate.curve.is_straight() {
            self.edge(index, candidate).into_iter().for_each(visit);
        } else {
            self.arc(index, candidate).into_iter().flatten().for_each(visit);
        }
    }

    /// Side of the ray on which a vertex lies: true is left. The ends of the straight edge that the ray stands on, and an
    /// arc's end where it stands, follow from the side it heads to.
    #[inline]
    fn is_left(&self, vertex: VertexId, p: DVec2) -> bool {
        if let Some((last, heads_left)) = self.last
            && (last.ends[0] == vertex || last.ends[1] == vertex)
            && (last.curve.is_straight() || p.distance(self.ray.from) <= self.near)
        {
            return heads_left == (last.ends[0] == vertex);
        }
        let turn = self.ray.direction.perp_dot(p - self.ray.from);
        if turn.abs() > self.near { turn > 0.0 } else { self.is_left_of_touched(vertex, p) }
    }

    /// Side on which a vertex counts that lies on the ray's line up to rounding.
    #[cold]
    fn is_left_of_touched(&self, vertex: VertexId, p: DVec2) -> bool {
        if self.ray.start != Start::Free {
            return self.leaves_on_the_left(p);
        }
        // A free start is as exact as it is given.
        let exact = side_of_ray(self.ray.from, self.ray.direction, p);
        if exact == 0.0 { self.passed_by(vertex, p).unwrap_or(false) } else { exact > 0.0 }
    }

    /// Side on which a vertex counts that the line of a free ray runs through, by what ends there: a corner that the ray
    /// only touches is passed by, the end of an open line is met. `None` where interfaces leave to both sides or along
    /// the ray.
    fn passed_by(&self, vertex: VertexId, p: DVec2) -> Option<bool> {
        let mut sides = Vec::new();
        self.system.near_point(p, |place| sides.extend(self.leaving_sides(&self.system.interfaces[place], vertex)));
        let sides: Option<Vec<bool>> = sides.into_iter().collect();
        match sides?[..] {
            [left] => Some(!left),
            [left, ref others @ ..] => others.iter().all(|other| *other == left).then_some(left),
            [] => None,
        }
    }

    /// For each end of an interface at a vertex, whether the interface leaves it to the ray's left; `None` along the ray.
    fn leaving_sides(&self, interface: &Interface, vertex: VertexId) -> Vec<Option<bool>> {
        let reversed = interface.curve.reversed();
        let from = [(interface.ends[0], &interface.curve), (interface.ends[1], &reversed)];
        let side = |curve: &Curve| {
            let tangent = curve.tangent_at(curve.a);
            let turn = self.ray.direction.perp_dot(tangent);
            let is_along = turn.abs() * curve.a.distance(curve.b) <= self.near;
            let bend = if is_along { curve.curvature * self.ray.direction.dot(tangent) } else { turn };
            (bend != 0.0).then_some(bend > 0.0)
        };
        from.into_iter().filter(|(end, _)| *end == vertex).map(|(_, curve)| side(curve)).collect()
    }

    /// Side on which a vertex counts that the line of a secondary ray runs through, up to rounding: true is left. The ray
    /// tilts away from the interface it stands on.
    fn leaves_on_the_left(&self, p: DVec2) -> bool {
        self.last.is_some_and(|(last, heads_left)| {
            let along = last.curve.tangent_at(self.ray.from).dot(self.ray.direction) > 0.0;
            let ahead = (p - self.ray.from).dot(self.ray.direction) > 0.0;
            (heads_left != along) == ahead
        })
    }

    /// Whether the ray's line passes between the ends of an interface; then whether it comes from its left.
    #[inline]
    fn passes_from_left(&self, candidate: &Interface) -> Option<bool> {
        let [a, b] = candidate.ends;
        let (a_left, b_left) = (self.is_left(a, candidate.curve.a), self.is_left(b, candidate.curve.b));
        (a_left != b_left).then_some(b_left)
    }

    /// The crossing of an edge: not of one that the ray stands on.
    #[inline(always)]
    fn edge(&self, index: usize, candidate: &Interface) -> Option<Met> {
        let sides = self.sides(&candidate.curve);
        if self.passes_by(&candidate.curve, sides) {
            return None;
        }
        if matches!(self.ray.start, Start::AtVertex(vertex) if candidate.ends.contains(&vertex)) || index == self.edge {
            return None;
        }
        self.plain_edge(candidate, sides).or_else(|| self.edge_with_care(candidate))
    }

    /// The crossing of an edge whose ends lie on these sides, but `None` if it takes care.
    #[inline(always)]
    pub(crate) fn plain_edge(&self, candidate: &Interface, [a_side, b_side]: [f64; 2]) -> Option<Met> {
        let Curve { m, n, .. } = candidate.curve;
        let (across, apart) = (n.dot(self.ray.direction), n.dot(m - self.ray.from));
        let is_sure = a_side.abs() > self.near && b_side.abs() > self.near;
        if !is_sure || across.abs() < GRAZING || apart.abs() <= self.near {
            return None;
        }
        let from_left = b_side > 0.0;
        // Ahead if the ray starts on the side that it comes from.
        let is_ahead = (apart < 0.0) == from_left;
        Some(Met { distance: apart / across, slack: self.near / GRAZING, from_left, is_ahead, is_in_doubt: false })
    }

    /// The crossing of an edge that is met at a small angle, or touched at an end, or on whose line the ray starts.
    #[cold]
    fn edge_with_care(&self, candidate: &Interface) -> Option<Met> {
        let Curve { m, n, .. } = candidate.curve;
        let (across, apart) = (n.dot(self.ray.direction), n.dot(m - self.ray.from));
        let from_left = self.passes_from_left(candidate)?;
        let [a, b] = [candidate.curve.a, candidate.curve.b].map(|p| (p - self.ray.from).dot(self.ray.direction));
        let (begin, end) = (a.min(b), a.max(b));
        // An edge along the ray, up to rounding, is met at once.
        let is_along = across.abs() * (end - begin) <= self.near;
        let distance = if is_along { 0.0 } else { apart / across }.max(begin).min(end);
        let slack = if is_along { end - begin } else { self.near / across.abs() };
        let is_ahead = (apart < 0.0) == from_left;
        let met = Met { distance, slack, from_left, is_ahead, is_in_doubt: false };
        Some(if apart.abs() > self.near { met } else { self.edge_at_start(candidate, met, begin, end) })
    }

    /// A crossing of an edge on whose line the ray starts up to rounding; the edge lies between two distances along the ray.
    fn edge_at_start(&self, candidate: &Interface, met: Met, begin: f64, end: f64) -> Met {
        let is_ahead = if self.touches_last(candidate) {
            self.is_ahead(candidate, met.distance)
        } else if begin > self.near || end < -self.near {
            begin > self.near
        } else {
            let start = side(candidate.curve.a, candidate.curve.b, self.ray.from);
            start != 0.0 && (start > 0.0) == met.from_left
        };
        Met { is_ahead, is_in_doubt: begin <= self.near && end >= -self.near, ..met }
    }

    #[inline(never)]
    fn arc(&self, index: usize, candidate: &Interface) -> [Option<Met>; 2] {
        // Of a piece so short that its chord is rounding nothing else would say that the line is far away.
        if self.passes_by(&candidate.curve, self.sides(&candidate.curve)) {
            return [None, None];
        }
        match self.ray.start {
            Start::On { interface, left } if interface == index => return [self.again(candidate, left), None],
            Start::AtVertex(vertex) if candidate.ends.contains(&vertex) => {
                return [self.off_vertex(candidate, vertex), None];
            }
            _ => {}
        }
        if let Some((last, heads_left)) = self.last.filter(|(last, _)| last.curve.same_circle(&candidate.curve)) {
            let passes = self.passes_from_left(candidate).is_some();
            return [passes.then(|| self.across(&last.curve, heads_left)).flatten(), None];
        }
        let roots = CircleRoots::new(&candidate.curve, self.ray.from, self.ray.direction);
        let met = |from_left: bool| {
            let distance = if from_left { roots.from_left } else { roots.from_right };
            Some(self.met_on_arc(candidate, distance, from_left))
        };
        match self.passes_from_left(candidate) {
            Some(from_left) => [met(from_left), None],
            // In through the outside first, and out again; a line that only touches does neither.
            None if roots.meets && self.cuts_off_bulge(candidate) && !self.touches(&roots, candidate) => {
                let left_is_outside = candidate.curve.curvature < 0.0;
                [met(left_is_outside), met(!left_is_outside)]
            }
            None => [None, None],
        }
    }

    fn met_on_arc(&self, candidate: &Interface, distance: f64, from_left: bool) -> Met {
        // Far from the circle.
        if candidate.curve.power(self.ray.from).abs() > 4.0 * self.near {
            return Met { distance, slack: 0.0, from_left, is_ahead: distance > 0.0, is_in_doubt: false };
        }
        let normal = candidate.curve.normal_at(self.ray.from + distance * self.ray.direction);
        let is_in_doubt = (distance * normal.dot(self.ray.direction)).abs() <= 2.0 * self.near;
        Met { distance, slack: 0.0, from_left, is_ahead: self.is_ahead(candidate, distance), is_in_doubt }
    }

    /// Whether the ray only touches a circle ahead, up to the rounding of its aim, 8 u of the largest coordinate: the cap of
    /// chord L that it cuts off is L²κ/8 high.
    fn touches(&self, roots: &CircleRoots, candidate: &Interface) -> bool {
        let chord = roots.from_left - roots.from_right;
        let height = chord * chord * candidate.curve.curvature.abs() / 8.0;
        roots.from_left.min(roots.from_right) > self.near && height <= self.near / 16.0
    }

    /// For an arc whose ends lie on one side of the ray's line, and a line that meets its circle: whether the arc is what
    /// the line cuts off on the other side. It is if it holds that side's farthest point.
    fn cuts_off_bulge(&self, candidate: &Interface) -> bool {
        let curve = &candidate.curve;
        let other_side = if self.is_left(candidate.ends[0], curve.a) { -1.0 } else { 1.0 };
        let a_to_farthest =
            curve.curvature.signum() * curve.normal_at(curve.a) + other_side * self.ray.direction.perp();
        cross(curve.b - curve.a, a_to_farthest) * curve.curvature < 0.0
    }

    /// The arc that the ray stands on, met again: where its line does not pass between the ends, both of its points are
    /// the arc's.
    fn again(&self, last: &Interface, heads_left: bool) -> Option<Met> {
        let both_on_arc = self.passes_from_left(last).is_none();
        both_on_arc.then(|| self.across(&last.curve, heads_left)).flatten()
    }

    /// From a point of a circle through it to the other side: t = −2 B/κ; behind a ray that heads out of it.
    fn across(&self, circle: &Curve, heads_left: bool) -> Option<Met> {
        let is_ahead = heads_left == (circle.curvature > 0.0);
        let gradient = circle.normal_at(self.ray.from);
        let distance = 2.0 * gradient.dot(self.ray.direction) / circle.curvature;
        distance.is_finite().then_some(Met {
            distance,
            slack: 0.0,
            from_left: heads_left,
            is_ahead,
            is_in_doubt: false,
        })
    }

    /// An interface that ends where the ray starts: an edge is not met again, an arc where the ray runs into its bulge.
    fn off_vertex(&self, candidate: &Interface, vertex: VertexId) -> Option<Met> {
        let Interface { curve, ends, .. } = candidate;
        let at_start = ends[0] == vertex;
        let (at, other, far) = if at_start { (curve.a, ends[1], curve.b) } else { (curve.b, ends[0], curve.a) };
        // An arc that turns left bulges to the right of its chord, which is there if the other end is on the ray's left.
        let into_bulge = (self.is_left(other, far) == at_start) == (curve.curvature > 0.0);
        let distance = 2.0 * curve.normal_at(at).dot(self.ray.direction) / curve.curvature;
        (into_bulge && distance > self.near && distance.is_finite()).then_some(Met {
            distance,
            slack: 0.0,
            from_left: curve.curvature > 0.0,
            is_ahead: true,
            is_in_doubt: false,
        })
    }

    /// Whether a distance lies ahead. Beside a vertex that a candidate shares with the interface the ray stands on, the
    /// corner decides: the candidate is ahead where it opens to the side that the ray heads to.
    fn is_ahead(&self, candidate: &Interface, distance: f64) -> bool {
        let corner = self.last.and_then(|(last, left)| Some((last, left, self.shared_end(last, candidate)?)));
        let Some((last, heads_left, start)) = corner else { return self.is_ahead_of_start(candidate, distance) };
        let both_straight = last.curve.is_straight() && candidate.curve.is_straight();
        let met = candidate.curve.normal_at(self.ray.from + distance * self.ray.direction);
        let is_clear = candidate.curve.offset(self.ray.from).abs() > self.near
            || (distance * met.dot(self.ray.direction)).abs() > self.near;
        if is_clear && !both_straight {
            return distance > 0.0;
        }
        opens_to(last, candidate, start, self.near).map_or(!both_straight && distance > 0.0, |left| left == heads_left)
    }

    /// A distance from a start within rounding of an arc counts as ahead: the ray is in the medium that it leaves there.
    /// Over a distance t the arc bends away from its tangent by κ t²/2.
    fn is_ahead_of_start(&self, candidate: &Interface, distance: f64) -> bool {
        let leaves = candidate.left != candidate.right && self.ray.start == Start::Free;
        let bent = 0.5 * candidate.curve.curvature.abs() * distance * distance;
        let at_start = leaves && bent <= self.near && candidate.curve.offset(self.ray.from).abs() <= self.near;
        distance > 0.0 || at_start
    }

    fn touches_last(&self, candidate: &Interface) -> bool {
        self.last.is_some_and(|(last, _)| self.shared_end(last, candidate).is_some())
    }

    /// Whether the end that a candidate shares with the interface the ray stands on is its start; of two such ends the
    /// one nearer to the ray. `None` if they share none.
    fn shared_end(&self, last: &Interface, candidate: &Interface) -> Option<bool> {
        let shared = candidate.ends.map(|end| last.ends.contains(&end));
        let from_ray = |p: DVec2| p.distance_squared(self.ray.from);
        match shared {
            [true, true] => Some(from_ray(candidate.curve.a) <= from_ray(candidate.curve.b)),
            [start, end] => (start || end).then_some(start),
        }
    }
}
