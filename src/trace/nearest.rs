//! The nearest interface ahead of a ray, decided by identity where distances cannot: the interface that the ray stands on,
//! the vertices it shares, and the medium that the ray is in.
//!
//! Which side of the ray a vertex lies on is computed once per vertex in effect, since the same numbers give the same
//! sign: an outline is crossed on its way in and out, or not at all. Only interfaces whose near side is the ray's medium
//! count.

use glam::DVec2;

use crate::geometry::{CircleRoots, Curve};
use crate::numerics::{cross, side, side_of_ray};
use crate::system::{Interface, MediumId, OpticalSystem, Start, VertexId};
use crate::trace::corner::{corner, opens_to};

/// A ray on its way.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ray {
    pub(crate) from: DVec2,
    pub(crate) direction: DVec2,
    pub(crate) medium: MediumId,
    pub(crate) start: Start,
}

/// What a ray meets first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Crossing {
    pub(crate) interface: usize,
    /// Distance along the ray, at least 0 for what it meets.
    pub(crate) distance: f64,
    /// Whether the ray comes from the interface's left.
    pub(crate) from_left: bool,
}

/// The first interface that the ray crosses; at a corner that two share, the one it passes first; of several others at one
/// distance the first in the list. `None` if the ray leaves.
///
/// Nothing leaks: a line crosses the closed boundary of a medium as often into it as out of it, and the crossings behind
/// the ray tell whether it starts inside. Where that count does not agree with the ray's medium, rounding has put a crossing
/// beside the start on the wrong side of it, and it changes sides.
pub(crate) fn nearest(system: &OpticalSystem, near: f64, ray: &Ray) -> Option<Crossing> {
    let probe = Probe { interfaces: &system.interfaces, ray, last: ray.last(&system.interfaces), near };
    let is_unbounded = ray.medium == system.surroundings;
    let (mut first, mut inside) = (None, i32::from(is_unbounded));
    probe.passages(|passage| {
        if !passage.is_ahead {
            inside += passage.entry;
        } else if passage.entry <= 0 && first.is_none_or(|best| probe.is_before(&passage.crossing, &best)) {
            first = Some(passage.crossing);
        }
    });
    let missing = match probe.inside_before_start() {
        Some(expected) => expected - inside,
        None => i32::from(first.is_none() && !is_unbounded),
    };
    let first = if missing == 0 { first } else { probe.first_by_count(missing) };
    first.map(|crossing| Crossing { distance: crossing.distance.max(0.0), ..crossing })
}

/// What lies on the other side of that boundary of a ray's medium which is nearest to the ray's start.
pub(crate) fn beyond(interfaces: &[Interface], ray: &Ray) -> MediumId {
    let away = |curve: &Curve| curve.clamp(curve.project(ray.from)).distance_squared(ray.from);
    let is_boundary = |one: &&Interface| (one.left == ray.medium) != (one.right == ray.medium);
    let nearest = interfaces.iter().filter(is_boundary).min_by(|u, v| away(&u.curve).total_cmp(&away(&v.curve)));
    nearest.map_or(ray.medium, |one| if one.left == ray.medium { one.right } else { one.left })
}

impl Ray {
    /// The interface that the ray stands on, and whether it heads to its left.
    fn last<'a>(&self, interfaces: &'a [Interface]) -> Option<(&'a Interface, bool)> {
        match self.start {
            Start::On { interface, left } => Some((&interfaces[interface], left)),
            Start::Free | Start::AtVertex(_) => None,
        }
    }
}

/// A crossing of the ray's whole line.
#[derive(Clone, Copy)]
struct Met {
    /// Distance along the ray; below 0 behind it.
    distance: f64,
    /// Whether the line comes from the interface's left.
    from_left: bool,
    is_ahead: bool,
}

/// A crossing of the ray's whole line with the boundary of the ray's medium, or with a surface inside of it.
#[derive(Clone, Copy)]
struct Passage {
    crossing: Crossing,
    is_ahead: bool,
    /// 1 into the ray's medium, −1 out of it, 0 from it into itself.
    entry: i32,
}

impl Passage {
    /// What the count of entries behind the start gains if this changes sides.
    fn gain(&self) -> i32 {
        if self.is_ahead { self.entry } else { -self.entry }
    }

    /// How far its distance speaks against its place on the other side of the start.
    fn against(&self) -> f64 {
        let Crossing { distance, .. } = self.crossing;
        (if self.is_ahead { distance } else { -distance }).max(0.0)
    }
}

struct Probe<'a> {
    interfaces: &'a [Interface],
    ray: &'a Ray,
    last: Option<(&'a Interface, bool)>,
    /// Distances below this are rounding.
    near: f64,
}

impl Probe<'_> {
    /// Whether the ray passes one crossing before another. Of two edges with a common end, both crossed on the same side
    /// of it, that which leads backward from it: exact where the distances are not.
    fn is_before(&self, one: &Crossing, other: &Crossing) -> bool {
        let by_distance = one.distance < other.distance;
        let (first, second) = (&self.interfaces[one.interface], &self.interfaces[other.interface]);
        let Some((corner, [u, v])) = corner(first, second) else { return by_distance };
        let p = [first.curve.a, first.curve.b][usize::from(first.ends[0] != corner)];
        let turn = side(p, u, v);
        if turn == 0.0 { by_distance } else { (turn > 0.0) == self.is_left(corner, p) }
    }

    /// Visits every crossing of the line with the boundary of the ray's medium, in the order of the list.
    fn passages(&self, mut visit: impl FnMut(Passage)) {
        let medium = self.ray.medium;
        for (interface, candidate) in self.interfaces.iter().enumerate() {
            if candidate.left != medium && candidate.right != medium {
                continue;
            }
            for Met { distance, from_left, is_ahead } in self.crossings(interface, candidate).into_iter().flatten() {
                let from = if from_left { candidate.left } else { candidate.right };
                let entry = match (candidate.left == candidate.right, from == medium) {
                    (true, _) => 0,
                    (false, true) => -1,
                    (false, false) => 1,
                };
                visit(Passage { crossing: Crossing { interface, distance, from_left }, is_ahead, entry });
            }
        }
    }

    /// Whether the ray's line is in its medium just before the start, as 1 or 0: it is not where the ray leaves a boundary of
    /// its medium. `None` at a vertex, where several crossings lie at the start itself.
    fn inside_before_start(&self) -> Option<i32> {
        match (self.ray.start, self.last) {
            (Start::AtVertex(_), _) => None,
            (_, Some((last, _))) => Some(i32::from(last.left == last.right)),
            _ => Some(1),
        }
    }

    /// The first crossing out of the medium once as many crossings as the count misses have changed sides of the start,
    /// those first whose distances speak least against it.
    fn first_by_count(&self, missing: i32) -> Option<Crossing> {
        let mut passages = Vec::new();
        self.passages(|passage| passages.push(passage));
        for _ in 0..missing.abs() {
            let helps = |passage: &&mut Passage| passage.gain() == missing.signum();
            let misplaced = passages.iter_mut().filter(helps).min_by(|u, v| u.against().total_cmp(&v.against()));
            if let Some(passage) = misplaced {
                passage.is_ahead = !passage.is_ahead;
            }
        }
        let exits = passages.into_iter().filter(|passage| passage.is_ahead && passage.entry <= 0);
        let crossings = exits.map(|passage| passage.crossing);
        crossings.reduce(|best, crossing| if self.is_before(&crossing, &best) { crossing } else { best })
    }

    fn crossings(&self, index: usize, candidate: &Interface) -> [Option<Met>; 2] {
        match self.ray.start {
            Start::On { interface, left } if interface == index => [self.again(candidate, left), None],
            Start::AtVertex(vertex) if candidate.ends.contains(&vertex) => [self.off_vertex(candidate, vertex), None],
            _ if candidate.curve.is_straight() => [self.edge(candidate), None],
            _ => self.arc(candidate),
        }
    }

    /// Side of the ray on which a vertex lies: true is left. The ends of the straight edge that the ray stands on, and an
    /// arc's end where it stands, follow from the side it heads to.
    fn is_left(&self, vertex: VertexId, p: DVec2) -> bool {
        if let Some((last, heads_left)) = self.last
            && let Some(end) = last.ends.iter().position(|end| *end == vertex)
            && (last.curve.is_straight() || p.distance(self.ray.from) <= self.near)
        {
            return heads_left == (end == 0);
        }
        let to_vertex = p - self.ray.from;
        let turn = self.ray.direction.perp_dot(to_vertex);
        if turn.abs() > self.near {
            return turn > 0.0;
        }
        if self.ray.start != Start::Free {
            return self.leaves_on_the_left(p);
        }
        // A free start is as exact as it is given.
        let exact = side_of_ray(self.ray.from, self.ray.direction, p);
        if exact == 0.0 { self.passed_by(vertex).unwrap_or(false) } else { exact > 0.0 }
    }

    /// Side on which a vertex counts that the line of a free ray runs through, by what ends there: a corner that the ray
    /// only touches is passed by, the end of an open line is met. `None` where interfaces leave to both sides or along
    /// the ray.
    fn passed_by(&self, vertex: VertexId) -> Option<bool> {
        let here = self.interfaces.iter().filter(|interface| interface.ends.contains(&vertex));
        let sides: Option<Vec<bool>> = here.flat_map(|interface| self.leaving_sides(interface, vertex)).collect();
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
    fn passes_from_left(&self, candidate: &Interface) -> Option<bool> {
        let [a, b] = candidate.ends;
        let (a_left, b_left) = (self.is_left(a, candidate.curve.a), self.is_left(b, candidate.curve.b));
        (a_left != b_left).then_some(b_left)
    }

    fn edge(&self, candidate: &Interface) -> Option<Met> {
        let from_left = self.passes_from_left(candidate)?;
        let Curve { a, b, m, n, .. } = candidate.curve;
        let [a, b] = [a, b].map(|p| (p - self.ray.from).dot(self.ray.direction));
        let across = n.dot(self.ray.direction);
        // An edge along the ray, up to rounding, is met at once.
        let is_along = across.abs() * (a - b).abs() <= self.near;
        let distance = if is_along { 0.0 } else { n.dot(m - self.ray.from) / across };
        let distance = distance.max(a.min(b)).min(a.max(b));
        let is_ahead = if is_along && a.min(b) > self.near {
            true
        } else if self.touches_last(candidate) {
            self.is_ahead(candidate, distance)
        } else {
            // Ahead if the ray starts on the side that it comes from.
            let start = side(candidate.curve.a, candidate.curve.b, self.ray.from);
            start != 0.0 && (start > 0.0) == from_left
        };
        Some(Met { distance, from_left, is_ahead })
    }

    fn arc(&self, candidate: &Interface) -> [Option<Met>; 2] {
        if let Some((last, heads_left)) = self.last.filter(|(last, _)| last.curve.same_circle(&candidate.curve)) {
            let passes = self.passes_from_left(candidate).is_some();
            return [passes.then(|| self.across(&last.curve, heads_left)).flatten(), None];
        }
        let roots = CircleRoots::new(&candidate.curve, self.ray.from, self.ray.direction);
        let met = |from_left: bool| {
            let distance = if from_left { roots.from_left } else { roots.from_right };
            Some(Met { distance, from_left, is_ahead: self.is_ahead(candidate, distance) })
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
        let both_on_arc = !last.curve.is_straight() && self.passes_from_left(last).is_none();
        both_on_arc.then(|| self.across(&last.curve, heads_left)).flatten()
    }

    /// From a point of a circle through it to the other side: t = −2 B/κ; behind a ray that heads out of it.
    fn across(&self, circle: &Curve, heads_left: bool) -> Option<Met> {
        let is_ahead = heads_left == (circle.curvature > 0.0);
        let gradient = circle.normal_at(self.ray.from);
        let distance = 2.0 * gradient.dot(self.ray.direction) / circle.curvature;
        distance.is_finite().then_some(Met { distance, from_left: heads_left, is_ahead })
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
            from_left: curve.curvature > 0.0,
            is_ahead: true,
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
