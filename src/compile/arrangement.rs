//! The curves of all bodies cut at their common points into pieces that meet only at shared vertices, pieces that
//! coincide merged into one.

use std::collections::HashMap;

use glam::DVec2;

use crate::compile::cuts::{Cuts, FEW};
use crate::compile::effort::{Effort, Exhausted};
use crate::compile::leaders::Leaders;
use crate::compile::runs::Runs;
use crate::geometry::{Bounds, Curve, crossings, lies_on};
use crate::numerics::cross;

/// Boundaries are one where they lie within this many units in the last place of their largest coordinate.
const COINCIDENCE: f64 = 16.0 * 0.5 * f64::EPSILON;

/// No piece.
const NONE: usize = usize::MAX;

/// One curve of a body's outline, an arc of at most half a circle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Boundary {
    /// Relative to the system's origin.
    pub(crate) curve: Curve,
    /// Largest absolute coordinate in the scene and relative to the origin.
    pub(crate) reach: f64,
    /// Place of its outline among all outlines.
    pub(crate) outline: usize,
    /// Distance along the outline from its first point, scene units.
    pub(crate) along: f64,
}

/// A piece of boundary between two vertices.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    pub(crate) ends: [usize; 2],
    /// The first boundary that runs here, forward: it gives the curve.
    pub(crate) boundary: usize,
}

/// A boundary that runs along a piece.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Member {
    /// Place among the boundaries.
    pub(crate) boundary: usize,
    /// Whether it runs in the piece's direction.
    pub(crate) forward: bool,
}

/// Distance within which two curves, or a point and a curve, are one.
pub(crate) fn tolerance(reach: f64) -> f64 {
    COINCIDENCE * reach
}

/// The box within which a boundary may meet others.
pub(crate) fn bounds(boundary: &Boundary) -> Bounds {
    Bounds::from(&boundary.curve).grown(2.0 * tolerance(boundary.reach))
}

/// The pieces, and the points of their vertices.
#[derive(Default)]
pub(crate) struct Pieces {
    pub(crate) list: Vec<Piece>,
    /// The later boundaries that run along a piece, too, in order, of the few pieces that have some.
    twins: HashMap<usize, Vec<Member>>,
    points: Vec<DVec2>,
}

impl Pieces {
    /// All boundaries that run along a piece, by its place in the list, in order.
    pub(crate) fn members(&self, piece: usize) -> impl DoubleEndedIterator<Item = Member> + Clone {
        let first = Member { boundary: self.list[piece].boundary, forward: true };
        let twins = self.twins.get(&piece).map_or(&[][..], Vec::as_slice);
        std::iter::once(first).chain(twins.iter().copied())
    }

    /// Where a piece runs.
    pub(crate) fn curve(&self, boundaries: &[Boundary], piece: &Piece) -> Curve {
        between(&self.points, piece.ends, &boundaries[piece.boundary].curve)
    }
}

/// The part of a curve between two vertices on it.
fn between(points: &[DVec2], ends: [usize; 2], curve: &Curve) -> Curve {
    Curve { a: points[ends[0]], b: points[ends[1]], ..*curve }
}

/// Cuts the boundaries at their common points and merges what coincides. `pairs` are those whose boxes meet, the earlier
/// first, sorted.
pub(crate) fn arrange(
    boundaries: &[Boundary],
    runs: &Runs,
    pairs: &[(usize, usize)],
    effort: &Effort,
) -> Result<Pieces, Exhausted> {
    let mut arrangement = Arrangement::new(boundaries, runs, effort);
    for &(i, j) in pairs {
        arrangement.join_ends(i, j);
    }
    for &(i, j) in pairs {
        arrangement.cut_at_ends(i, j);
        arrangement.cut_at_ends(j, i);
    }
    for &(i, j) in pairs {
        effort.check(j)?;
        arrangement.cut_at_crossings(i, j);
    }
    let pieces = arrangement.pieces();
    Ok(Pieces { points: arrangement.points, ..pieces })
}

struct Arrangement<'a> {
    boundaries: &'a [Boundary],
    runs: &'a Runs,
    effort: &'a Effort,
    /// The ends of boundary k are 2k and 2k + 1; those after are where boundaries cross.
    points: Vec<DVec2>,
    leaders: Leaders,
    /// The points at which boundaries are cut, of those that are.
    cuts: HashMap<usize, Cuts>,
}

/// The end points of a boundary.
fn ends(boundary: usize) -> [usize; 2] {
    [2 * boundary, 2 * boundary + 1]
}

impl<'a> Arrangement<'a> {
    fn new(boundaries: &'a [Boundary], runs: &'a Runs, effort: &'a Effort) -> Self {
        let points: Vec<_> = boundaries.iter().flat_map(|b| [b.curve.a, b.curve.b]).collect();
        let leaders = Leaders::new(points.len());
        Self { boundaries, runs, effort, points, leaders, cuts: HashMap::new() }
    }

    fn cut(&mut self, boundary: usize, point: usize) {
        let p = self.at(point);
        self.cuts.entry(boundary).or_default().push(point, p, &self.boundaries[boundary].curve);
    }

    /// The ends of a boundary and those of its cuts that may be within `tolerance` of a point, in order.
    fn vertices_near(&self, boundary: usize, p: DVec2, tolerance: f64) -> impl Iterator<Item = usize> {
        // Points move by a few tolerances as more of them become one.
        let cuts = |cuts: &Cuts| cuts.near(p, 64.0 * tolerance, &self.boundaries[boundary].curve);
        let cuts = self.cuts.get(&boundary).map(cuts).unwrap_or_default();
        self.effort.spend(cuts.len() / FEW);
        ends(boundary).into_iter().chain(cuts)
    }

    fn vertex(&self, point: usize) -> usize {
        self.leaders.of(point)
    }

    fn at(&self, point: usize) -> DVec2 {
        self.points[self.vertex(point)]
    }

    fn pair_tolerance(&self, i: usize, j: usize) -> f64 {
        tolerance(self.boundaries[i].reach.max(self.boundaries[j].reach))
    }

    fn join_ends(&mut self, i: usize, j: usize) {
        let tolerance = self.pair_tolerance(i, j);
        for first in ends(i) {
            for second in ends(j) {
                if self.points[first].distance(self.points[second]) <= tolerance {
                    self.leaders.unite(first, second);
                }
            }
        }
    }

    /// Cuts boundary `i` where an end of `j` lies on it.
    fn cut_at_ends(&mut self, i: usize, j: usize) {
        let tolerance = self.pair_tolerance(i, j);
        for end in ends(j) {
            let p = self.at(end);
            if lies_on(&self.boundaries[i].curve, p, tolerance) && self.known_at(i, p, tolerance).is_none() {
                self.cut(i, end);
            }
        }
    }

    fn cut_at_crossings(&mut self, i: usize, j: usize) {
        let tolerance = self.pair_tolerance(i, j);
        for p in crossings(&self.boundaries[i].curve, &self.boundaries[j].curve, tolerance) {
            if self.meet_before(i, j, p, tolerance) {
                continue;
            }
            let known = [self.known_at(i, p, tolerance), self.known_at(j, p, tolerance)];
            let vertex = known[0].or(known[1]).unwrap_or_else(|| {
                self.points.push(p);
                self.leaders.push();
                self.points.len() - 1
            });
            if let [Some(first), Some(second)] = known {
                self.leaders.unite(first, second);
            }
            for (boundary, known) in [(i, known[0]), (j, known[1])] {
                if known.is_none() {
                    self.cut(boundary, vertex);
                }
            }
            if known == [None, None] {
                self.cut_coincident([i, j], vertex, tolerance);
            }
        }
    }

    /// Cuts what runs along one of two boundaries at a new vertex on both, too: a third curve that crosses two coincident ones at
    /// a small angle meets them in places that are farther apart than they are.
    fn cut_coincident(&mut self, crossing: [usize; 2], vertex: usize, tolerance: f64) {
        let p = self.at(vertex);
        let around = Bounds::of([p]).grown(2.0 * tolerance);
        let nearby = self.runs.boxes_meeting(around, self.effort);
        for i in crossing {
            for &k in nearby.iter().filter(|k| **k != i && self.runs.meet(i, **k)) {
                let tolerance = self.pair_tolerance(i, k);
                if lies_on(&self.boundaries[k].curve, p, tolerance) && self.known_at(k, p, tolerance).is_none() {
                    self.cut(k, vertex);
                }
            }
        }
    }

    /// Whether two boundaries share a vertex and are one from there to a point where they cross: at a small angle they cross
    /// again beside it by rounding.
    fn meet_before(&self, i: usize, j: usize, p: DVec2, tolerance: f64) -> bool {
        let [first, second] = [i, j].map(|k| &self.boundaries[k].curve);
        let vertex = |point: usize| self.vertex(point);
        let number = |k: &usize| self.cuts.get(k).map_or(0, |cuts| cuts.all().len());
        let (few, many) = if number(&i) <= number(&j) { (i, j) } else { (j, i) };
        let of_few = self.vertices_near(few, p, reach_of_contact(first, second, p, tolerance));
        let is_shared = |vertex: &usize| {
            let mut others = self.vertices_near(many, self.points[*vertex], tolerance);
            others.any(|other| self.vertex(other) == *vertex)
        };
        let shared = of_few.map(vertex).filter(is_shared);
        let apart = |vertex: usize| second.offset(first.project(self.points[vertex].midpoint(p))).abs();
        shared.into_iter().any(|vertex| apart(vertex) <= tolerance)
    }

    /// The end or cut of a boundary within `tolerance` of a point.
    fn known_at(&self, boundary: usize, p: DVec2, tolerance: f64) -> Option<usize> {
        self.vertices_near(boundary, p, tolerance).find(|&point| self.at(point).distance(p) <= tolerance)
    }

    /// The pieces, without their points.
    fn pieces(&self) -> Pieces {
        let mut pieces = Pieces { list: Vec::with_capacity(self.boundaries.len()), ..Pieces::default() };
        // The last piece at each vertex that is the smaller of its two, and for each piece the one before it there.
        let mut last = vec![NONE; self.points.len()];
        let mut before: Vec<usize> = Vec::with_capacity(self.boundaries.len());
        for boundary in 0..self.boundaries.len() {
            self.each_part(boundary, |ends| {
                let smaller = ends[0].min(ends[1]);
                let there = std::iter::successors(Some(last[smaller]), |k| before.get(*k).copied());
                // The earliest that qualifies.
                let is_twin = |k: &usize| self.run_together(&pieces.list[*k], boundary, ends);
                if let Some(k) = there.take_while(|k| *k != NONE).filter(is_twin).last() {
                    let forward = pieces.list[k].ends[0] == ends[0];
                    pieces.twins.entry(k).or_default().push(Member { boundary, forward });
                } else {
                    before.push(last[smaller]);
                    last[smaller] = pieces.list.len();
                    pieces.list.push(Piece { ends, boundary });
                }
            });
        }
        pieces
    }

    /// Whether the part of a boundary between two vertices runs along a piece.
    fn run_together(&self, piece: &Piece, boundary: usize, ends: [usize; 2]) -> bool {
        let same_ends = piece.ends == ends || piece.ends == [ends[1], ends[0]];
        let curve = |ends, boundary: usize| between(&self.points, ends, &self.boundaries[boundary].curve);
        same_ends && {
            let middle = curve(ends, boundary).midpoint();
            let tolerance = self.pair_tolerance(boundary, piece.boundary);
            lies_on(&curve(piece.ends, piece.boundary), middle, tolerance)
        }
    }

    /// Visits the parts of a boundary between its vertices, in order.
    fn each_part(&self, boundary: usize, mut visit: impl FnMut([usize; 2])) {
        let [first, last] = ends(boundary).map(|end| self.vertex(end));
        let curve = &self.boundaries[boundary].curve;
        let cuts = self.cuts.get(&boundary).map_or(&[][..], Cuts::all).iter().map(|&cut| self.vertex(cut));
        let mut inner: Vec<usize> = cuts.filter(|&vertex| vertex != first && vertex != last).collect();
        inner.sort_by(|&u, &v| curve.along(self.points[u]).total_cmp(&curve.along(self.points[v])));
        let mut from = first;
        for to in inner.into_iter().chain([last]) {
            if to != from {
                visit([from, to]);
                from = to;
            }
        }
    }
}

/// How far from a point where two curves cross they may run within `tolerance` of each other half way there; infinite where
/// they bend alike.
fn reach_of_contact(first: &Curve, second: &Curve, p: DVec2, tolerance: f64) -> f64 {
    let (n1, n2) = (first.normal_at(p), second.normal_at(p));
    let (sin, sense) = (cross(n1, n2).abs(), n1.dot(n2).signum());
    // At a distance s they are about s sin − s²/2 × the difference of their curvatures apart.
    let bend = (first.curvature - sense * second.curvature).abs();
    let square = sin * sin - 4.0 * bend * tolerance;
    if square > 0.0 { 8.0 * tolerance / (sin + square.sqrt()) } else { f64::INFINITY }
}
