//! The boundaries on a line, in its order.

use glam::DVec2;

use crate::geometry::{CircleRoots, Curve};
use crate::numerics::cross;
use crate::system::{Action, Interface, MediumId, OpticalSystem};

/// A boundary stands upright on an axis that it turns by less than this, radians: by rounding and no more.
const UPRIGHT: f64 = 1e-9;

/// An optical axis, and where light that runs along it starts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// A point on it, in scene coordinates; only what lies ahead of it is met.
    pub from: DVec2,
    /// Its direction, that of the light; its length does not matter.
    pub direction: DVec2,
}

/// A boundary where an axis meets it.
#[derive(Clone, Copy)]
pub(super) struct Vertex {
    /// Distance along the axis, from the line's foot.
    pub(super) distance: f64,
    pub(super) action: Action,
    /// 1/R, positive where the center lies ahead.
    pub(super) curvature: f64,
    /// The media before and behind.
    pub(super) media: [MediumId; 2],
    /// Whether it leaves the direction of light along the axis as it is, or turns it back.
    pub(super) is_upright: bool,
}

impl Vertex {
    /// The same, met by light that comes back along the axis.
    pub(super) fn reversed(self) -> Self {
        let [before, behind] = self.media;
        Self { curvature: -self.curvature, media: [behind, before], ..self }
    }

    /// Whether it is a piece of the same boundary as another, on whose end the axis runs.
    fn continues(&self, other: &Self) -> bool {
        let is_same_action = match (self.action, other.action) {
            // Pieces of a screen differ in what they record.
            (Action::Detect { .. }, Action::Detect { .. }) => true,
            (one, other) => one == other,
        };
        let bends_alike = (self.curvature - other.curvature).abs() <= UPRIGHT * self.curvature.abs();
        is_same_action && self.media == other.media && bends_alike
    }
}

/// An axis with the boundaries on the whole of its line, relative to the system's origin.
pub(super) struct Line {
    /// The point of the line that is nearest to the origin, in scene coordinates.
    foot: DVec2,
    direction: DVec2,
    /// How far from the foot the axis starts.
    pub(super) start: f64,
    /// In order along the line.
    pub(super) vertices: Vec<Vertex>,
}

impl Line {
    /// `None` where the axis has no direction.
    pub(super) fn new(system: &OpticalSystem, axis: Axis, is_met: impl Fn(usize) -> bool) -> Option<Self> {
        let direction = axis.direction.try_normalize()?;
        let from = axis.from - system.origin;
        let start = from.dot(direction);
        // A start far away would blur where the line meets what.
        let foot = from - start * direction;
        let met = system.interfaces.iter().filter(|interface| is_met(interface.body));
        let met = met.flat_map(|interface| crossings(interface, foot, direction, system.near)).collect();
        let vertices = in_order(met, system.near);
        Some(Self { foot: foot + system.origin, direction, start: start + system.near, vertices })
    }

    /// A point of the line.
    pub(super) fn at(&self, distance: f64) -> DVec2 {
        self.foot + distance * self.direction
    }
}

/// Vertices in the order of the line, each once.
fn in_order(mut met: Vec<Vertex>, near: f64) -> Vec<Vertex> {
    met.sort_by(|u, v| u.distance.total_cmp(&v.distance));
    let mut vertices: Vec<Vertex> = Vec::new();
    for vertex in met {
        let mut same_place = vertices.iter().rev().take_while(|last| vertex.distance - last.distance <= near);
        if !same_place.any(|last| vertex.continues(last)) {
            vertices.push(vertex);
        }
    }
    // Where two bodies touch on the axis, their media tell which comes first.
    for place in 2..vertices.len() {
        let [last, this, next] = [place - 2, place - 1, place].map(|place| vertices[place]);
        let [wanted, first, second] = [last.media[1], this.media[0], next.media[0]];
        if next.distance - this.distance <= near && first != wanted && second == wanted {
            vertices.swap(place - 1, place);
        }
    }
    vertices
}

/// Where a line meets an interface, its ends included.
fn crossings(interface: &Interface, foot: DVec2, direction: DVec2, near: f64) -> impl Iterator<Item = Vertex> {
    let curve = &interface.curve;
    let is_on = move |distance: &f64| {
        let p = foot + *distance * direction;
        curve.clamp(curve.project(p)).distance(p) <= near
    };
    let distances = distances(curve, foot, direction).into_iter().filter(|distance| distance.is_finite());
    distances.filter(is_on).map(move |distance| vertex(interface, distance, foot, direction))
}

fn distances(curve: &Curve, foot: DVec2, direction: DVec2) -> Vec<f64> {
    if curve.is_straight() {
        return vec![curve.n.dot(curve.m - foot) / curve.n.dot(direction)];
    }
    let roots = CircleRoots::new(curve, foot, direction);
    if roots.meets { vec![roots.from_left, roots.from_right] } else { Vec::new() }
}

fn vertex(interface: &Interface, distance: f64, foot: DVec2, direction: DVec2) -> Vertex {
    let Interface { curve, left, right, action, .. } = interface;
    let at = foot + distance * direction;
    let normal = curve.normal_at(at);
    let is_from_left = normal.dot(direction) < 0.0;
    let off_center = match action {
        Action::ThinLens { center, focal_length } => cross(*center - at, direction) / focal_length,
        _ => 0.0,
    };
    Vertex {
        distance,
        action: *action,
        curvature: if is_from_left { -curve.curvature } else { curve.curvature },
        media: if is_from_left { [*left, *right] } else { [*right, *left] },
        is_upright: cross(normal, direction).abs().max(off_center.abs()) <= UPRIGHT,
    }
}
