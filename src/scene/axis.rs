use glam::DVec2;

use crate::geometry::{Curve, Placement};
use crate::numerics::Turn;
use crate::scene::{Body, Shape, Substance, Surface};

/// How a body makes images.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Imaging {
    /// A lens or a group of lenses.
    Lens,
    /// An ideal thin lens.
    ThinLens,
    /// A mirror on an arc.
    CurvedMirror,
    /// A mirror on a straight line; its axis is the normal in its middle.
    FlatMirror,
}

/// The optical axis of a body, in scene coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct OpticalAxis {
    /// How the body makes images.
    pub imaging: Imaging,
    /// Where the axis meets the body's first face and its last; equal for what has one face.
    pub vertices: [DVec2; 2],
    /// Unit direction: of a lens from the first vertex to the last, of an arc toward its center.
    pub direction: DVec2,
    /// Half of the body's height across the axis, scene units.
    pub half_height: f64,
    /// Of a mirror on an arc its center.
    pub center: Option<DVec2>,
}

impl Body {
    /// Its optical axis: of a lens or lens group the line through its vertices, of a [`Surface::ThinLens`] and of a mirror on a
    /// [`Shape::Flat`] or [`Shape::Arc`] the normal in the middle. `None` for other bodies, and where the numbers make no axis.
    #[must_use]
    pub fn optical_axis(&self) -> Option<OpticalAxis> {
        let own = own_axis(&self.shape, &self.substance)?;
        let placement = Placement::new(self.rotate, self.at);
        let axis = OpticalAxis {
            vertices: own.vertices.map(|vertex| placement.point(vertex)),
            direction: Turn::degrees(self.rotate).apply(own.direction),
            center: own.center.map(|center| placement.point(center)),
            ..own
        };
        let is_placed = axis.vertices.iter().all(|vertex| vertex.is_finite()) && axis.direction.is_finite();
        (is_placed && axis.direction != DVec2::ZERO && axis.half_height > 0.0).then_some(axis)
    }
}

/// The axis of a shape about its own origin.
fn own_axis(shape: &Shape, substance: &Substance) -> Option<OpticalAxis> {
    match (shape, substance) {
        (Shape::Lens { thickness, diameter, .. }, Substance::Medium(_)) => {
            Some(lens([-0.5 * thickness, 0.5 * thickness], *diameter))
        }
        (Shape::LensGroup { diameter, surfaces }, _) => {
            Some(lens([0.0, surfaces.iter().filter_map(|surface| surface.thickness).sum()], *diameter))
        }
        (Shape::Flat { from, to }, Substance::Surface(Surface::ThinLens { .. })) => {
            Some(line(Imaging::ThinLens, *from, *to))
        }
        (Shape::Flat { from, to }, Substance::Surface(Surface::Mirror)) => Some(line(Imaging::FlatMirror, *from, *to)),
        (Shape::Arc { from, through, to }, Substance::Surface(Surface::Mirror)) => {
            Some(Curve::arc(*from, *through, *to).map_or_else(|| line(Imaging::FlatMirror, *from, *to), arc))
        }
        _ => None,
    }
}

fn lens(vertices: [f64; 2], diameter: f64) -> OpticalAxis {
    let vertices = vertices.map(|x| DVec2::new(x, 0.0));
    OpticalAxis { imaging: Imaging::Lens, vertices, direction: DVec2::X, half_height: 0.5 * diameter, center: None }
}

fn line(imaging: Imaging, from: DVec2, to: DVec2) -> OpticalAxis {
    let middle = 0.5 * from + 0.5 * to;
    let direction = -(to - from).normalize_or_zero().perp();
    OpticalAxis { imaging, vertices: [middle; 2], direction, half_height: 0.5 * from.distance(to), center: None }
}

fn arc(arc: Curve) -> OpticalAxis {
    let half_height =
        if arc.spans_more_than_half() { arc.curvature.abs().recip() } else { 0.5 * arc.a.distance(arc.b) };
    OpticalAxis {
        imaging: Imaging::CurvedMirror,
        vertices: [arc.m; 2],
        direction: arc.n * arc.curvature.signum(),
        half_height,
        center: Some(arc.center()),
    }
}

impl OpticalAxis {
    /// The same axis with the light of a point in front of it: its first vertex is the one that the light meets first.
    /// `None` for a point that is in front of neither end.
    #[must_use]
    pub fn along_light(&self, point: DVec2) -> Option<Self> {
        let [first, last] = self.vertices;
        if (first - point).dot(self.direction) > 0.0 {
            Some(*self)
        } else if (point - last).dot(self.direction) > 0.0 {
            Some(self.reversed())
        } else {
            None
        }
    }

    /// The same axis for light that goes the other way.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let [first, last] = self.vertices;
        Self { vertices: [last, first], direction: -self.direction, ..*self }
    }
}

/// The body whose image an object with this foot is meant to have: of all that have an optical axis the one with the nearest
/// vertex, of several as near the first. `None` if there is none.
#[must_use]
pub fn facing(bodies: &[Body], foot: DVec2) -> Option<(usize, OpticalAxis)> {
    let axes = bodies.iter().enumerate().filter_map(|(k, body)| Some((k, body.optical_axis()?)));
    let distance = |axis: &OpticalAxis| axis.vertices[0].distance(foot).min(axis.vertices[1].distance(foot));
    axes.min_by(|(_, a), (_, b)| distance(a).total_cmp(&distance(b)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    fn axes(bodies: &str) -> Vec<Option<OpticalAxis>> {
        let scene = Scene::from_ron(&format!("(bodies: [{bodies}])")).unwrap();
        scene.bodies.iter().map(Body::optical_axis).collect()
    }

    #[test]
    fn axes_turn_and_move_with_their_bodies() {
        let lens = "shape: Lens(radii: (50, -50), thickness: 6, diameter: 26), medium: Index(1.5)";
        let axes = axes(&format!(
            "({lens}, at: (10, 5), rotate: 90),
            (shape: Arc(from: (5, -25), through: (0, 0), to: (5, 25)), surface: Mirror, at: (7, 0)),
            (shape: Flat(from: (0, -4), to: (0, 8)), surface: ThinLens(focal_length: 9)),
            (shape: Disk(3), medium: Index(1.5))"
        ));
        let lens = axes[0].unwrap();
        assert!(
            (lens.vertices[0] - DVec2::new(10.0, 2.0)).length() < 1e-14 && lens.direction.abs_diff_eq(DVec2::Y, 1e-15)
        );
        assert_eq!((lens.imaging, lens.half_height), (Imaging::Lens, 13.0));
        let mirror = axes[1].unwrap();
        assert_eq!((mirror.imaging, mirror.half_height), (Imaging::CurvedMirror, 25.0));
        assert!(
            (mirror.vertices[0] - DVec2::new(7.0, 0.0)).length() < 1e-14 && mirror.direction.x > 0.999,
            "to the center"
        );
        let thin = axes[2].unwrap();
        assert_eq!((thin.vertices[0], thin.direction.x.abs()), (DVec2::new(0.0, 2.0), 1.0));
        assert_eq!(axes[3], None);
    }

    #[test]
    fn far_from_the_origin_an_axis_keeps_its_direction() {
        let lens = "shape: Lens(radii: (50, -50), thickness: 6, diameter: 26), medium: Index(1.5), rotate: 33";
        let [near, far] = axes(&format!("({lens}), ({lens}, at: (3e9, 7e9))"))[..] else { panic!("two") };
        assert_eq!(near.unwrap().direction, far.unwrap().direction);
    }

    #[test]
    fn an_object_faces_the_nearest_vertex() {
        let scene = Scene::from_ron(
            "(bodies: [
                (shape: Lens(radii: (50, -50), thickness: 6, diameter: 26), at: (40, 0), medium: Index(1.5)),
                (shape: Flat(from: (0, -9), to: (0, 9)), surface: Mirror),
                (shape: Disk(1), at: (19, 0), medium: Index(1.5)),
            ])",
        )
        .unwrap();
        let faced = |x: f64| facing(&scene.bodies, DVec2::new(x, 0.0)).unwrap();
        assert_eq!((faced(18.0).0, faced(19.0).0, faced(90.0).0), (1, 0, 0));
        let (_, lens) = faced(90.0);
        assert_eq!(lens.along_light(DVec2::new(90.0, 3.0)).unwrap().vertices[0], DVec2::new(43.0, 0.0));
        assert_eq!(lens.along_light(DVec2::new(40.0, 3.0)), None);
    }
}
