use glam::DVec2;

use crate::geometry::{CircleRoots, Curve};
use crate::laws::{CardinalPoints, RayMatrix};
use crate::scene::OpticalAxis;
use crate::system::{Action, Interface, MediumId};

/// Lengths below this share of the place of a body are rounding.
const ROUNDING: f64 = 1e-9;

/// The faces of a body along its optical axis, with the media that are really on their two sides.
pub(crate) struct Centered {
    /// In the order in which light along the axis meets them; at least one.
    faces: Vec<Face>,
}

/// A face where it crosses the axis.
struct Face {
    /// Distance from the first vertex, scene units.
    at: f64,
    /// Indices before and behind it.
    n: [f64; 2],
    matrix: RayMatrix,
    is_mirror: bool,
}

impl Centered {
    /// The faces between the two vertices of an axis along the light; `None` where they are no centered system: a face that
    /// stands askew or lets no light on, a mirror within a lens, or no face at all. `interfaces` are relative to `origin`.
    pub(crate) fn new(
        interfaces: &[Interface],
        origin: DVec2,
        axis: &OpticalAxis,
        index: impl Fn(MediumId) -> f64,
    ) -> Option<Self> {
        let first = axis.vertices[0] - origin;
        let length = (axis.vertices[1] - axis.vertices[0]).dot(axis.direction);
        let near = ROUNDING * (axis.vertices[0].abs().max_element() + length + axis.half_height);
        let mut faces: Vec<Face> = Vec::new();
        for interface in interfaces {
            if let Some(at) = crossing(&interface.curve, first, axis.direction, [-near, length + near]) {
                faces.push(face(interface, at, first, axis.direction, &index)?);
            }
        }
        faces.sort_by(|a, b| a.at.total_cmp(&b.at));
        faces.dedup_by(|a, b| (a.at - b.at).abs() <= near);
        let is_lens = !faces.is_empty() && faces.iter().all(|face| !face.is_mirror);
        (is_lens || faces.len() == 1).then_some(Self { faces })
    }

    /// Its cardinal points, front ones from the first vertex and back ones from the last; `None` without power.
    pub(crate) fn cardinal_points(&self) -> Option<CardinalPoints> {
        let (first, last) = (self.faces.first()?, self.faces.last()?);
        let mut at = first.at;
        let matrix = self.faces.iter().fold(RayMatrix::IDENTITY, |matrix, face| {
            let way = RayMatrix::translation(face.at - at, face.n[0]);
            at = face.at;
            matrix.then(way).then(face.matrix)
        });
        matrix.cardinal_points(first.n[0], if last.is_mirror { last.n[0] } else { last.n[1] })
    }

    /// Whether a ray near the axis keeps within a height at all faces, by its height and slope at the first vertex.
    pub(crate) fn passes(&self, mut height: f64, slope: f64, within: f64) -> bool {
        let Some(first) = self.faces.first() else { return false };
        let (mut at, mut reduced) = (first.at, first.n[0] * slope);
        self.faces.iter().all(|face| {
            height += (face.at - at) * reduced / face.n[0];
            at = face.at;
            reduced += face.matrix.c * height;
            height.abs() <= within
        })
    }
}

/// What an interface is to light along an axis; `None` where it stands askew or lets no light on.
fn face(interface: &Interface, at: f64, o: DVec2, d: DVec2, index: impl Fn(MediumId) -> f64) -> Option<Face> {
    let Interface { curve, left, right, action, .. } = interface;
    let ahead = curve.normal_at(o + at * d).dot(d);
    let [before, behind] = (if ahead > 0.0 { [*right, *left] } else { [*left, *right] }).map(index);
    let curvature = curve.curvature * ahead.signum();
    let matrix = match action {
        Action::Refract | Action::Split { .. } => Some(RayMatrix::refraction(before, behind, curvature)),
        Action::Mirror => Some(RayMatrix::mirror(before, curvature)),
        Action::ThinLens { focal_length, .. } => Some(RayMatrix::thin_lens(*focal_length, before, behind)),
        Action::Absorb | Action::Detect { .. } => None,
    }?;
    let is_upright = ahead.abs() >= 1.0 - ROUNDING;
    is_upright.then_some(Face { at, n: [before, behind], matrix, is_mirror: *action == Action::Mirror })
}

/// Where a line crosses a curve within bounds, its ends included.
fn crossing(curve: &Curve, o: DVec2, d: DVec2, within: [f64; 2]) -> Option<f64> {
    let on_curve = |t: &f64| {
        let p = o + *t * d;
        let near = ROUNDING * (within[1] - within[0] + p.abs().max_element());
        (within[0]..=within[1]).contains(t) && curve.clamp(p).distance(p) <= near
    };
    if curve.is_straight() {
        return Some(curve.n.dot(curve.m - o) / curve.n.dot(d)).filter(on_curve);
    }
    let roots = CircleRoots::new(curve, o, d);
    [roots.from_left, roots.from_right].into_iter().filter(|_| roots.meets).find(on_curve)
}
