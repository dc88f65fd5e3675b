//! Bodies that no light meets.

use std::collections::HashMap;

use glam::DVec2;

use crate::geometry::{Bounds, BoxTree, CircleRoots, Curve, CurveTree, Waiting};
use crate::scene::{Body, Problem, Scene, Shape, Substance, Surface};
use crate::system::{OpticalSystem, PlacedBody};
use crate::trace::{Ending, RayTree, Segment, TracedRay, Via, Visitor, visit};

/// Light that passes a boundary this close, as a share of the scene's largest coordinate, meets it: boundaries that coincide differ
/// by rounding.
const ROUNDING: f64 = 1e-9;
/// So many bodies have a warning each.
const FEW: usize = 3;
/// The direction in which crossings are counted to tell inside from outside: along no edge that anybody draws.
const ASKEW: DVec2 = DVec2::new(0.936_329_177_569_044_6, 0.351_123_441_588_391_7);

/// The bodies that no light meets, by their places in the scene, in order.
///
/// Light meets a body if a hit names it, if it crosses or touches the body's outline (boundaries between equal media and covered
/// ones too), if it starts inside, or if it passes the opening of a stop. Segments that were not followed meet nothing where
/// they were cut.
///
/// `tree` must come from `system`; without it the light is followed again, ray by ray until every body is met, and nothing is stored.
#[must_use]
pub fn unmet_bodies(system: &OpticalSystem, tree: Option<&RayTree>) -> Vec<usize> {
    unmet(system, tree).bodies
}

/// What is suspicious about where the light of a scene goes: bodies that it does not meet, by [`unmet_bodies`]. Beyond a few, one
/// warning sums them up.
///
/// There is none for a scene without light; none for absorbers, which also stand where no light should get; none for bodies in
/// contact with one that light meets, directly or by others (the lower layers of a stack, a mount); and none where light was cut by
/// `max_segments`, since the rest of it might meet anything.
#[must_use]
pub fn problems(scene: &Scene, system: &OpticalSystem, tree: Option<&RayTree>) -> Vec<Problem> {
    if system.sources.iter().all(|source| source.starts.is_empty()) {
        return Vec::new();
    }
    let Unmet { bodies, is_cut, is_exhausted } = unmet(system, tree);
    let bodies = if is_exhausted { Vec::new() } else { suspicious(scene, system, bodies) };
    if bodies.is_empty() {
        return Vec::new();
    }
    let name = |k: &usize| format!("`{}`", system.bodies[*k].name);
    let cut = if is_cut { "; branches that `max_depth` or `min_power` cut might meet it" } else { "" };
    let warning = |k: usize, message: String| {
        let help = format!("move it or the light, or leave it out{cut}");
        Problem::warning(format!("bodies[{k}]"), message, help).label("not met")
    };
    if bodies.len() <= FEW {
        return bodies.iter().map(|k| warning(*k, format!("no ray meets {}", name(k)))).collect();
    }
    let first = bodies.iter().take(FEW).map(name).collect::<Vec<_>>().join(", ");
    let (some, all) = (bodies.len(), system.bodies.len());
    vec![warning(bodies[0], format!("no ray meets {some} of the {all} bodies: {first} and {} more", some - FEW))]
}

/// Of the bodies that no light meets those that are probably not meant so.
fn suspicious(scene: &Scene, system: &OpticalSystem, mut unmet: Vec<usize>) -> Vec<usize> {
    let mut groups = Groups::of(system);
    let mut is_lit = vec![false; system.bodies.len()];
    for k in (0..system.bodies.len()).filter(|k| unmet.binary_search(k).is_err()) {
        is_lit[groups.of_body(k)] = true;
    }
    let is_meant = |k: usize| scene.bodies.get(k).is_none_or(is_there_to_be_missed);
    unmet.retain(|k| !is_meant(*k) && !is_lit[groups.of_body(*k)]);
    unmet
}

/// Bodies in contact with each other, directly or by others: one stands for all of a group.
struct Groups(Vec<usize>);

impl Groups {
    fn of(system: &OpticalSystem) -> Self {
        let mut groups = Self((0..system.bodies.len()).collect());
        let mut of_vertices = HashMap::new();
        for interface in &system.interfaces {
            for end in interface.ends {
                let other = *of_vertices.entry(end).or_insert(interface.body);
                let (one, other) = (groups.of_body(interface.body), groups.of_body(other));
                groups.0[one.max(other)] = one.min(other);
            }
        }
        groups
    }

    /// The body that stands for a body's group.
    fn of_body(&mut self, mut body: usize) -> usize {
        while self.0[body] != body {
            self.0[body] = self.0[self.0[body]];
            body = self.0[body];
        }
        body
    }
}

/// What became of the search.
struct Unmet {
    bodies: Vec<usize>,
    /// Whether branches were cut by `max_depth` or `min_power`.
    is_cut: bool,
    /// Whether light was cut by `max_segments`.
    is_exhausted: bool,
}

fn unmet(system: &OpticalSystem, tree: Option<&RayTree>) -> Unmet {
    let mut seen = Seen::new(system);
    seen.follow(system, tree);
    if seen.left > 0 && !seen.is_exhausted {
        // No hit names the rest; now where the light passes counts.
        seen.outlines = Some(Outlines::new(system, &seen.is_met));
        seen.follow(system, tree);
    }
    let bodies = (0..system.bodies.len()).filter(|k| !seen.is_met[*k]).collect();
    Unmet { bodies, is_cut: seen.is_cut, is_exhausted: seen.is_exhausted }
}

/// What the light has met.
struct Seen {
    is_met: Vec<bool>,
    /// How many bodies are left to be met.
    left: usize,
    is_cut: bool,
    is_exhausted: bool,
    /// Of the bodies that no hit names.
    outlines: Option<Outlines>,
    waiting: Waiting,
}

impl Seen {
    fn new(system: &OpticalSystem) -> Self {
        let left = system.bodies.len();
        let (is_met, waiting) = (vec![false; left], Waiting::new());
        Self { is_met, left, is_cut: false, is_exhausted: false, outlines: None, waiting }
    }

    fn follow(&mut self, system: &OpticalSystem, tree: Option<&RayTree>) {
        let Some(tree) = tree else { return visit(system, self) };
        for ray in tree.rays.iter() {
            if self.left == 0 {
                return;
            }
            ray.segments.iter().for_each(|segment| self.see(segment));
        }
    }

    fn see(&mut self, segment: &Segment) {
        match segment.ending {
            Ending::CutMaxSegments => self.is_exhausted = true,
            Ending::CutMaxDepth | Ending::CutMinPower => self.is_cut = true,
            _ => {}
        }
        if let Some(outlines) = self.outlines.take() {
            outlines.met_by(segment, &mut self.waiting, |body| meet(&mut self.is_met, &mut self.left, body));
            self.outlines = Some(outlines);
        } else if let Some(hit) = segment.hit {
            meet(&mut self.is_met, &mut self.left, hit.body);
        }
    }
}

fn meet(is_met: &mut [bool], left: &mut usize, body: usize) {
    if let Some(is_met) = is_met.get_mut(body).filter(|is_met| !**is_met) {
        *is_met = true;
        *left -= 1;
    }
}

impl Visitor for Seen {
    fn segment(&mut self, _: &TracedRay, segment: Segment) {
        self.see(&segment);
    }

    fn goes_on(&self) -> bool {
        self.left > 0
    }
}

/// Outlines that light may cross, in scene coordinates.
struct Outlines {
    /// Of at most half a circle each.
    curves: Vec<Curve>,
    bodies: Vec<usize>,
    tree: CurveTree,
    near: f64,
}

impl Outlines {
    /// Those of all bodies that are not met.
    fn new(system: &OpticalSystem, is_met: &[bool]) -> Self {
        let (mut curves, mut bodies) = (Vec::new(), Vec::new());
        for (k, body) in system.bodies.iter().enumerate().filter(|(k, _)| !is_met[*k]) {
            curves.extend(lines(body));
            bodies.resize(curves.len(), k);
        }
        let reach = curves.iter().map(Bounds::from).fold(Bounds::EMPTY, Bounds::union).reach();
        let near = ROUNDING * reach;
        let tree = CurveTree::new(curves.iter(), near);
        Self { curves, bodies, tree, near }
    }

    /// Tells which bodies a segment meets; some more than once.
    fn met_by(&self, segment: &Segment, waiting: &mut Waiting, mut meet: impl FnMut(usize)) {
        if segment.via == Via::Source {
            self.around(segment.from, waiting).into_iter().for_each(&mut meet);
        }
        let length = match (segment.to, segment.ending) {
            (Some(to), _) => segment.from.distance(to),
            (None, Ending::Escaped) => f64::INFINITY,
            _ => return,
        };
        let reach = -self.near..=length + self.near;
        self.along(segment.from, segment.direction, waiting, |body, at| {
            if reach.contains(&at) {
                meet(body);
            }
        });
    }

    /// The bodies that a point is inside of.
    fn around(&self, from: DVec2, waiting: &mut Waiting) -> Vec<usize> {
        let mut crossed = Vec::new();
        self.along(from, ASKEW, waiting, |body, at| {
            if at > 0.0 {
                crossed.push(body);
            }
        });
        crossed.sort_unstable();
        crossed.chunk_by(|a, b| a == b).filter(|same| same.len() % 2 == 1).map(|same| same[0]).collect()
    }

    /// Tells whose outlines a ray crosses, and how far along it, perhaps behind its start.
    fn along(&self, from: DVec2, direction: DVec2, waiting: &mut Waiting, mut tell: impl FnMut(usize, f64)) {
        let begin = -2.0 * self.near;
        self.tree.along(from, direction, begin, BoxTree::NO_BOX, waiting, |k| {
            for at in crossings(&self.curves[k], from, direction, self.near) {
                tell(self.bodies[k], at);
            }
            f64::INFINITY
        });
    }
}

/// The lines of a body, with that across the opening of a stop.
fn lines(body: &PlacedBody) -> Vec<Curve> {
    let of_outlines = body.outlines.iter().flat_map(|outline| &outline.curves);
    let halves = |curve: &Curve| if curve.spans_more_than_half() { curve.halves().to_vec() } else { vec![*curve] };
    let mut lines: Vec<Curve> = of_outlines.flat_map(halves).collect();
    if let [lower, upper] = body.outlines.as_slice()
        && !lower.closed
        && let (Some(lower), Some(upper)) = (lower.curves.last(), upper.curves.first())
    {
        lines.push(Curve::line(lower.b, upper.a));
    }
    lines
}

/// Where a line crosses a curve of at most half a circle, as distances from a point of the line.
fn crossings(curve: &Curve, from: DVec2, direction: DVec2, near: f64) -> impl Iterator<Item = f64> {
    let [one, other] = if curve.is_straight() {
        [curve.n.dot(curve.m - from) / curve.n.dot(direction), f64::NAN]
    } else {
        let roots = CircleRoots::new(curve, from, direction);
        if roots.meets { [roots.from_left, roots.from_right] } else { [f64::NAN; 2] }
    };
    let curve = *curve;
    let holds = move |t: &f64| {
        let p = from + *t * direction;
        let is_between = curve.is_straight() && (0.0..=curve.along(curve.b)).contains(&curve.along(p));
        is_between || curve.bulge_holds(p) || p.distance(curve.a) <= near || p.distance(curve.b) <= near
    };
    [one, other].into_iter().filter(|t| t.is_finite()).filter(holds)
}

/// Absorbers also stand where no light should get; a stop is there for light that it stops or lets pass.
fn is_there_to_be_missed(body: &Body) -> bool {
    matches!(body.substance, Substance::Surface(Surface::Absorber)) && !matches!(body.shape, Shape::Stop { .. })
}
