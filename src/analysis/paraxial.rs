//! Focal, principal and nodal points by the matrix method.

use glam::DVec2;

use crate::analysis::axis::{Axis, Line, Vertex};
use crate::laws::RayMatrix;
use crate::light::Wavelength;
use crate::system::{Action, MediumId, OpticalSystem};

/// A centered system for rays near its axis, with its cardinal points on the axis in scene coordinates.
///
/// # Source
/// Hecht, "Optics", 4th ed., sections 6.1 and 6.2.1; Born & Wolf, "Principles of Optics", 7th ed., sections 4.3 and 4.4.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Paraxial {
    /// The first vertex that light along the axis meets, and the last.
    pub vertices: [DVec2; 2],
    /// F, whose light leaves parallel to the axis, and F′, where light parallel to the axis meets it.
    pub focal_points: [DVec2; 2],
    /// H and H′: a ray aimed at a height of the plane through H leaves from the same height of that through H′.
    pub principal_points: [DVec2; 2],
    /// N and N′: a ray aimed at N leaves from N′ in its own direction.
    pub nodal_points: [DVec2; 2],
    /// f, from F to H along the light; positive for a system that gathers light.
    pub front_focal_length: f64,
    /// f′, from H′ to F′ along the light.
    pub back_focal_length: f64,
    /// Refractive index before the first vertex, n_1, and behind the last, n_2.
    pub indices: [f64; 2],
    /// What the system does to a ray between its first vertex and its last.
    pub matrix: RayMatrix,
}

/// The cardinal points of all that stands on an axis, at a vacuum wavelength.
///
/// The boundaries count in the order in which light along the axis meets them: faces between media, ideal thin lenses and beam
/// splitters (their transmitted light). A mirror sends the light back along the axis; distances behind it count along its new
/// way. An absorber or a screen ends the system.
///
/// `None` where there are no such points: nothing stands on the axis; the system has no power (a slab, a telescope at infinity);
/// a boundary does not stand upright on the axis, or the axis passes a thin lens beside its center; light between two mirrors
/// never leaves. Facets are flat: a faceted lens has no power where the axis meets a facet, and no upright boundary where it
/// meets a corner.
///
/// A wavelength outside of a medium's range extrapolates its formula; scenes refuse such wavelengths, this does not.
#[must_use]
pub fn paraxial(system: &OpticalSystem, axis: Axis, wavelength: Wavelength) -> Option<Paraxial> {
    Walk::new(system, Line::new(system, axis, |_| true)?, wavelength).cardinal_points()
}

/// [`paraxial`] of some bodies, by their places in the scene, as if the rest were not there. The media before and behind are
/// those on the two sides of their boundaries; a cemented face belongs to the later of its two bodies. `None` also where
/// the medium behind one of these boundaries is not the one before the next.
#[must_use]
pub fn paraxial_of(system: &OpticalSystem, bodies: &[usize], axis: Axis, wavelength: Wavelength) -> Option<Paraxial> {
    Walk::new(system, Line::new(system, axis, |body| bodies.contains(&body))?, wavelength).cardinal_points()
}

/// Light on its way along an axis.
struct Walk<'a> {
    system: &'a OpticalSystem,
    wavelength: Wavelength,
    line: Line,
    /// Whether it runs along the axis, or back along it.
    is_forward: bool,
    /// What it has passed; `None` before the first vertex.
    passed: Option<Passed>,
}

/// What light along an axis has passed.
#[derive(Clone, Copy)]
struct Passed {
    matrix: RayMatrix,
    n_1: f64,
    /// Distances along the line of the first and the last vertex.
    ends: [f64; 2],
    /// The medium behind the last vertex.
    medium: MediumId,
}

impl<'a> Walk<'a> {
    fn new(system: &'a OpticalSystem, line: Line, wavelength: Wavelength) -> Self {
        Self { system, wavelength, line, is_forward: true, passed: None }
    }

    fn cardinal_points(mut self) -> Option<Paraxial> {
        let mut next = Some(self.line.vertices.partition_point(|vertex| vertex.distance <= self.line.start));
        // Light that has not left after it has come back through everything never does.
        for _ in 0..=2 * self.line.vertices.len() {
            let vertex = next.and_then(|place| self.line.vertices.get(place).copied());
            let Some(vertex) = vertex.filter(|vertex| !is_end(vertex)) else { return self.paraxial() };
            let vertex = if self.is_forward { vertex } else { vertex.reversed() };
            self.passed = Some(self.pass(&vertex)?);
            self.is_forward ^= vertex.action == Action::Mirror;
            next = next.and_then(|place| if self.is_forward { place.checked_add(1) } else { place.checked_sub(1) });
        }
        None
    }

    /// What light has passed behind one more vertex.
    fn pass(&self, vertex: &Vertex) -> Option<Passed> {
        let [before, behind] = vertex.media;
        let [n_before, n_behind] = vertex.media.map(|medium| self.system.index(medium, self.wavelength));
        let start = Passed { matrix: RayMatrix::IDENTITY, n_1: n_before, ends: [vertex.distance; 2], medium: before };
        let Passed { matrix, n_1, ends: [first, last], medium } = self.passed.unwrap_or(start);
        if !vertex.is_upright || medium != before {
            return None;
        }
        let (element, medium) = match vertex.action {
            Action::ThinLens { focal_length, .. } => (RayMatrix::thin_lens(focal_length, n_before, n_behind), behind),
            Action::Mirror => (RayMatrix::mirror(n_before, vertex.curvature), before),
            _ => (RayMatrix::refraction(n_before, n_behind, vertex.curvature), behind),
        };
        let way = RayMatrix::translation((vertex.distance - last).abs(), n_before);
        Some(Passed { matrix: matrix.then(way).then(element), n_1, ends: [first, vertex.distance], medium })
    }

    fn paraxial(&self) -> Option<Paraxial> {
        let Passed { matrix, n_1, ends: [first, last], medium } = self.passed?;
        let n_2 = self.system.index(medium, self.wavelength);
        let points = matrix.cardinal_points(n_1, n_2)?;
        let sense = if self.is_forward { 1.0 } else { -1.0 };
        let pair = |front: f64, back: f64| [self.line.at(first + front), self.line.at(last + sense * back)];
        Some(Paraxial {
            vertices: pair(0.0, 0.0),
            focal_points: pair(points.front_focal_point, points.back_focal_point),
            principal_points: pair(points.front_principal_point, points.back_principal_point),
            nodal_points: pair(points.front_nodal_point, points.back_nodal_point),
            front_focal_length: points.front_focal_length,
            back_focal_length: points.back_focal_length,
            indices: [n_1, n_2],
            matrix,
        })
    }
}

/// Whether light along the axis ends here.
fn is_end(vertex: &Vertex) -> bool {
    matches!(vertex.action, Action::Absorb | Action::Detect { .. })
}
