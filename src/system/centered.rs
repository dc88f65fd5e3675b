use glam::DVec2;

use crate::geometry::{CircleRoots, Curve};
use crate::laws::{CardinalPoints, RayMatrix};
use crate::scene::OpticalAxis;
use crate::system::{Action, Interface, MediumId};

/// Lengths below this share of the place of a body are rounding.
const ROUNDING: f64 = 1e-9;

/// The faces of a body along its optical axis, with the media that are really on their two sides.
#[derive(Clone, Debug)]
pub struct Centered {
    /// The axis, its direction that of the light, in scene coordinates.
    pub axis: OpticalAxis,
    /// The faces in the order in which light along the axis meets them; at least one.
    pub faces: Vec<Face>,
}

/// A face where it crosses the axis.
#[derive(Clone, Copy, Debug)]
pub struct Face {
    /// Distance from the first vertex, scene units.
    pub at: f64,
    /// Indices before and behind it.
    pub n: [f64; 2],
    /// 1/R, positive where the center lies ahead.
    pub curvature: f64,
    /// What it does to a ray.
    pub action: Action,
}

impl Centered {
    /// The faces between the two vertices of a body's axis; `None` where the body is not a centered system: a face that
    /// stands askew, a mirror within a lens, or no face at all. `interfaces` are relative to `origin`.
    pub(crate) fn new(
        interfaces: &[Interface],
        origin: DVec2,
        axis: OpticalAxis,
        index: impl Fn(MediumId) -> f64,
    ) -> Option<Self> {
        let first = axis.vertices[0] - origin;
        let length = (axis.vertices[1] - axis.vertices[0]).dot(axis.direction);
        let near = ROUNDING * (axis.vertices[0].abs().max_element() + length + axis.half_height);
        let mut faces: Vec<Face> = Vec::new();
        for Interface { curve, left, right, action, .. } in interfaces {
            let Some(at) = crossing(curve, first, axis.direction, [-near, length + near]) else { continue };
            let ahead = curve.normal_at(first + at * axis.direction).dot(axis.direction);
            if ahead.abs() < 1.0 - ROUNDING {
                return None;
            }
            let [before, behind] = if ahead > 0.0 { [right, left] } else { [left, right] };
            let n = [*before, *behind].map(&index);
            faces.push(Face { at, n, curvature: curve.curvature * ahead.signum(), action: *action });
        }
        faces.sort_by(|a, b| a.at.total_cmp(&b.at));
        faces.dedup_by(|a, b| (a.at - b.at).abs() <= near);
        let plain = |face: &Face| matches!(face.action, Action::Refract);
        (faces.len() == 1 || !faces.is_empty() && faces.iter().all(plain)).then_some(Self { axis, faces })
    }

    /// What the faces do to rays near the axis, from the first vertex to the last, or back to the first at a mirror. `None`
    /// where a face lets no light on.
    #[must_use]
    pub fn matrix(&self) -> Option<RayMatrix> {
        let mut matrix = RayMatrix::IDENTITY;
        let mut at = self.faces.first()?.at;
        for face in &self.faces {
            matrix = matrix.then(RayMatrix::translation(face.at - at, face.n[0])).then(face.matrix()?);
            at = face.at;
        }
        Some(matrix)
    }

    /// Its cardinal points, front ones from the first vertex and back ones from the last; `None` without power.
    #[must_use]
    pub fn cardinal_points(&self) -> Option<CardinalPoints> {
        let (first, last) = (self.faces.first()?, self.faces.last()?);
        let behind = if last.action == Action::Mirror { last.n[0] } else { last.n[1] };
        self.matrix()?.cardinal_points(first.n[0], behind)
    }

    /// Distance of a curved mirror's center of curvature from its vertex, positive ahead; `None` for everything else.
    #[must_use]
    pub fn mirror_center(&self) -> Option<f64> {
        let face = self.faces.first().filter(|face| face.action == Action::Mirror && face.curvature != 0.0)?;
        Some(face.curvature.recip())
    }

    /// Whether a ray near the axis passes between the rims of all faces, by its height and slope at the first vertex.
    pub(crate) fn passes(&self, mut height: f64, slope: f64, within: f64) -> bool {
        let Some(first) = self.faces.first() else { return false };
        let (mut at, mut reduced) = (first.at, first.n[0] * slope);
        self.faces.iter().all(|face| {
            height += (face.at - at) * reduced / face.n[0];
            at = face.at;
            reduced += face.matrix().map_or(0.0, |matrix| matrix.c * height);
            height.abs() <= within
        })
    }
}

impl Face {
    fn matrix(&self) -> Option<RayMatrix> {
        let [before, behind] = self.n;
        match self.action {
            Action::Refract | Action::Split { .. } => Some(RayMatrix::refraction(before, behind, self.curvature)),
            Action::Mirror => Some(RayMatrix::mirror(before, self.curvature)),
            Action::ThinLens { focal_length, .. } => Some(RayMatrix::thin_lens(focal_length, before, behind)),
            Action::Absorb | Action::Detect { .. } => None,
        }
    }
}

/// Where a line crosses a curve within bounds, its ends included.
fn crossing(curve: &Curve, o: DVec2, d: DVec2, within: [f64; 2]) -> Option<f64> {
    let on_curve = |t: f64| {
        let p = o + t * d;
        let near = within[1] - within[0];
        (within[0]..=within[1]).contains(&t) && curve.clamp(p).distance(p) <= ROUNDING * (near + p.abs().max_element())
    };
    if curve.is_straight() {
        let t = curve.n.dot(curve.m - o) / curve.n.dot(d);
        return Some(t).filter(|t| on_curve(*t));
    }
    let roots = CircleRoots::new(curve, o, d);
    [roots.from_left, roots.from_right].into_iter().find(|t| roots.meets && on_curve(*t))
}
