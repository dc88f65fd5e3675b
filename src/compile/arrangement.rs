//! The curves of all bodies cut at their common points into pieces that meet only at shared vertices, pieces that
//! coincide merged into one.

use std::collections::BTreeMap;

use glam::DVec2;

use crate::compile::intersect::crossings;
use crate::geometry::{Bounds, Curve};

/// Boundaries are one where they lie within this many units in the last place of their largest coordinate.
const COINCIDENCE: f64 = 16.0 * 0.5 * f64::EPSILON;

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
#[derive(Clone, Debug)]
pub(crate) struct Piece {
    pub(crate) curve: Curve,
    pub(crate) ends: [usize; 2],
    /// The boundaries that run here, the earliest first: it gives the curve.
    pub(crate) members: Vec<Member>,
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

/// Cuts the boundaries at their common points and merges what coincides.
pub(crate) fn arrange(boundaries: &[Boundary]) -> Vec<Piece> {
    let boxes: Vec<_> = boundaries.iter().map(|b| Bounds::from(&b.curve).grown(2.0 * tolerance(b.reach))).collect();
    let pairs = meeting(&boxes);
    let mut arrangement = Arrangement::new(boundaries, &pairs);
    for &(i, j) in &pairs {
        arrangement.join_ends(i, j);
    }
    for &(i, j) in &pairs {
        arrangement.cut_at_ends(i, j);
        arrangement.cut_at_ends(j, i);
    }
    for &(i, j) in &pairs {
        arrangement.cut_at_crossings(i, j);
    }
    arrangement.pieces()
}

/// Pairs of boxes that share a point, the earlier first.
pub(crate) fn meeting(boxes: &[Bounds]) -> Vec<(usize, usize)> {
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    order.sort_by(|&i, &j| boxes[i].min.x.total_cmp(&boxes[j].min.x));
    let mut pairs = Vec::new();
    for (place, &i) in order.iter().enumerate() {
        let reached = order[place + 1..].iter().take_while(|&&j| boxes[j].min.x <= boxes[i].max.x);
        pairs.extend(reached.filter(|&&j| boxes[i].meets(boxes[j])).map(|&j| (i.min(j), i.max(j))));
    }
    pairs.sort_unstable();
    pairs
}

struct Arrangement<'a> {
    boundaries: &'a [Boundary],
    points: Vec<DVec2>,
    /// Union-find over the points: the smallest of those that are one leads.
    leader: Vec<usize>,
    ends: Vec<[usize; 2]>,
    cuts: Vec<Vec<usize>>,
    /// Boundaries whose boxes meet a boundary's.
    neighbors: Vec<Vec<usize>>,
}

impl<'a> Arrangement<'a> {
    fn new(boundaries: &'a [Boundary], pairs: &[(usize, usize)]) -> Self {
        let mut neighbors = vec![Vec::new(); boundaries.len()];
        for &(i, j) in pairs {
            neighbors[i].push(j);
            neighbors[j].push(i);
        }
        let points: Vec<_> = boundaries.iter().flat_map(|b| [b.curve.a, b.curve.b]).collect();
        Self {
            boundaries,
            leader: (0..points.len()).collect(),
            ends: (0..boundaries.len()).map(|i| [2 * i, 2 * i + 1]).collect(),
            cuts: vec![Vec::new(); boundaries.len()],
            neighbors,
            points,
        }
    }

    fn vertex(&self, point: usize) -> usize {
        let mut vertex = point;
        while self.leader[vertex] != vertex {
            vertex = self.leader[vertex];
        }
        vertex
    }

    fn at(&self, point: usize) -> DVec2 {
        self.points[self.vertex(point)]
    }

    fn unite(&mut self, first: usize, second: usize) {
        let (first, second) = (self.vertex(first), self.vertex(second));
        self.leader[first.max(second)] = first.min(second);
    }

    fn pair_tolerance(&self, i: usize, j: usize) -> f64 {
        tolerance(self.boundaries[i].reach.max(self.boundaries[j].reach))
    }

    fn join_ends(&mut self, i: usize, j: usize) {
        let tolerance = self.pair_tolerance(i, j);
        for first in self.ends[i] {
            for second in self.ends[j] {
                if self.points[first].distance(self.points[second]) <= tolerance {
                    self.unite(first, second);
                }
            }
        }
    }

    /// Cuts boundary `i` where an end of `j` lies on it.
    fn cut_at_ends(&mut self, i: usize, j: usize) {
        let tolerance = self.pair_tolerance(i, j);
        for end in self.ends[j] {
            let p = self.at(end);
            if self.known_at(i, p, tolerance).is_none() && lies_on(&self.boundaries[i].curve, p, tolerance) {
                self.cuts[i].push(end);
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
                self.leader.push(self.points.len() - 1);
                self.points.len() - 1
            });
            if let [Some(first), Some(second)] = known {
                self.unite(first, second);
            }
            for (boundary, known) in [(i, known[0]), (j, known[1])] {
                if known.is_none() {
                    self.cuts[boundary].push(vertex);
                }
            }
            if known == [None, None] {
                self.cut_coincident(i, vertex);
                self.cut_coincident(j, vertex);
            }
        }
    }

    /// Cuts what runs along boundary `i` at a new vertex on it, too: a third curve that crosses two coincident ones at a small
    /// angle meets them in places that are farther apart than they are.
    fn cut_coincident(&mut self, i: usize, vertex: usize) {
        let p = self.at(vertex);
        for k in self.neighbors[i].clone() {
            let tolerance = self.pair_tolerance(i, k);
            if lies_on(&self.boundaries[k].curve, p, tolerance) && self.known_at(k, p, tolerance).is_none() {
                self.cuts[k].push(vertex);
            }
        }
    }

    /// Whether two boundaries share a vertex and are one from there to a point where they cross: at a small angle they cross
    /// again beside it by rounding.
    fn meet_before(&self, i: usize, j: usize, p: DVec2, tolerance: f64) -> bool {
        let vertices = |k: usize| self.ends[k].iter().chain(&self.cuts[k]).map(|&point| self.vertex(point));
        let shared = vertices(i).filter(|vertex| vertices(j).any(|other| other == *vertex));
        let [first, second] = [i, j].map(|k| &self.boundaries[k].curve);
        let apart = |vertex: usize| second.offset(first.project(self.points[vertex].midpoint(p))).abs();
        shared.into_iter().any(|vertex| apart(vertex) <= tolerance)
    }

    /// The end or cut of a boundary within `tolerance` of a point.
    fn known_at(&self, boundary: usize, p: DVec2, tolerance: f64) -> Option<usize> {
        let points = self.ends[boundary].iter().chain(&self.cuts[boundary]);
        points.copied().find(|&point| self.at(point).distance(p) <= tolerance)
    }

    fn pieces(&self) -> Vec<Piece> {
        let mut pieces: Vec<Piece> = Vec::new();
        let mut between: BTreeMap<[usize; 2], Vec<usize>> = BTreeMap::new();
        for (boundary, part) in (0..self.boundaries.len()).flat_map(|i| self.parts(i).into_iter().map(move |p| (i, p)))
        {
            let [from, to] = part.ends;
            let same = between.entry([from.min(to), from.max(to)]).or_default();
            let middle = part.curve.midpoint();
            let runs_along =
                |piece: &Piece| lies_on(&piece.curve, middle, self.pair_tolerance(boundary, piece.members[0].boundary));
            let twin = same.iter().copied().find(|&k| runs_along(&pieces[k]));
            if let Some(k) = twin {
                let forward = pieces[k].ends[0] == from;
                pieces[k].members.push(Member { boundary, forward });
            } else {
                same.push(pieces.len());
                pieces.push(Piece { members: vec![Member { boundary, forward: true }], ..part });
            }
        }
        pieces
    }

    /// A boundary cut at its vertices, without members yet.
    fn parts(&self, boundary: usize) -> Vec<Piece> {
        let curve = self.boundaries[boundary].curve;
        let [first, last] = self.ends[boundary].map(|end| self.vertex(end));
        let mut vertices: Vec<usize> = self.cuts[boundary].iter().map(|&cut| self.vertex(cut)).collect();
        vertices.retain(|&vertex| vertex != first && vertex != last);
        vertices.sort_by(|&u, &v| curve.along(self.points[u]).total_cmp(&curve.along(self.points[v])));
        vertices.insert(0, first);
        vertices.push(last);
        vertices.dedup();
        let part = |ends: &[usize]| Piece {
            curve: Curve { a: self.points[ends[0]], b: self.points[ends[1]], ..curve },
            ends: [ends[0], ends[1]],
            members: Vec::new(),
        };
        vertices.windows(2).map(part).collect()
    }
}

/// Whether a point lies on a curve, strictly between its ends, within `tolerance`.
pub(crate) fn lies_on(curve: &Curve, p: DVec2, tolerance: f64) -> bool {
    if curve.offset(p).abs() > tolerance {
        return false;
    }
    if curve.is_straight() {
        let along = curve.along(p);
        return 0.0 < along && along < curve.a.distance_squared(curve.b);
    }
    // Of the circle's points the arc's are those nearer to its apex than its ends are.
    let apex = curve.midpoint();
    apex.distance_squared(p) < apex.distance_squared(curve.a)
}
