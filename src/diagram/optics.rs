use std::collections::BTreeMap;

use glam::DVec2;

use crate::analysis::{Axis, ObjectImage, Paraxial, object_images, paraxial_of};
use crate::diagram::frame::Extent;
use crate::light::Wavelength;
use crate::scene::{Body, Imaging, OpticalAxis, Scene};
use crate::system::OpticalSystem;
use crate::trace::RayTree;

/// Points of more elements would be noise.
const MOST: usize = 6;
/// Points farther away than this many sizes of the scene are not worth a smaller figure.
const REACH: f64 = 3.0;

/// What a figure shows of image formation beside the rays.
pub(super) struct Optics {
    /// Images of objects.
    pub(super) images: Vec<ObjectImage>,
    /// Elements whose points and planes are marked.
    pub(super) elements: Vec<Element>,
}

/// A lens or curved mirror with its points, in scene coordinates.
pub(super) struct Element {
    /// Its axis along the light.
    pub(super) axis: OpticalAxis,
    /// Its number, counted from 1, if there are several.
    pub(super) number: Option<usize>,
    /// Focal points and center of curvature, each with its letters.
    pub(super) points: Vec<(&'static str, DVec2)>,
    /// Where principal planes cross the axis.
    pub(super) planes: Vec<(&'static str, DVec2)>,
}

impl Optics {
    pub(super) fn new(scene: &Scene, system: &OpticalSystem, tree: &RayTree) -> Self {
        let wanted = scene.diagram.focal_points || scene.diagram.principal_planes;
        let elements = if wanted { elements(scene, system, tree) } else { Vec::new() };
        Self { images: object_images(system, tree), elements }
    }

    /// Points that the figure should show if they are not too far from the things of the scene.
    pub(super) fn points(&self, things: &Extent) -> Vec<DVec2> {
        let reach = REACH * things.size().max_element();
        let images = self.images.iter().flat_map(|image| [image.foot, image.tip]);
        let all = images.chain(self.elements.iter().flat_map(|element| element.points.iter().map(|(_, p)| *p)));
        all.filter(|p| (*p - p.clamp(things.min, things.max)).length() <= reach).collect()
    }
}

/// Bodies with an optical axis, but for flat mirrors, by their places in the scene.
pub(super) fn axes(scene: &Scene) -> impl Iterator<Item = (usize, OpticalAxis)> {
    let axes = scene.bodies.iter().map(Body::optical_axis).enumerate();
    axes.filter_map(|(k, axis)| Some((k, axis.filter(|axis| axis.imaging != Imaging::FlatMirror)?)))
}

fn elements(scene: &Scene, system: &OpticalSystem, tree: &RayTree) -> Vec<Element> {
    let lines = system.wavelengths();
    let line = lines.get(lines.len() / 2).copied().unwrap_or(Wavelength::D);
    let first: Vec<_> = axes(scene).take(MOST + 1).collect();
    if first.len() > MOST {
        return Vec::new();
    }
    let light = directions(tree, &first);
    let several = first.len() > 1;
    let elements = first.into_iter().enumerate().filter_map(|(number, (body, axis))| {
        let along = light.get(&body).map_or(axis.direction.x + axis.direction.y, |light| light.dot(axis.direction));
        let axis = if along < 0.0 { axis.reversed() } else { axis };
        // From well in front of the first vertex.
        let from = axis.vertices[0] - 2.0 * axis.half_height * axis.direction;
        let paraxial = paraxial_of(system, &[body], Axis { from, direction: axis.direction }, line)?;
        let number = several.then_some(number + 1);
        Some(Element { axis, number, points: points(scene, &axis, &paraxial), planes: planes(scene, &axis, &paraxial) })
    });
    elements.collect()
}

/// The direction in which light first arrives at bodies.
fn directions(tree: &RayTree, bodies: &[(usize, OpticalAxis)]) -> BTreeMap<usize, DVec2> {
    let mut found = BTreeMap::new();
    for segment in tree.rays.iter().flat_map(|ray| &ray.segments) {
        if let Some(hit) = segment.hit.filter(|hit| bodies.iter().any(|(body, _)| *body == hit.body)) {
            found.entry(hit.body).or_insert(segment.direction);
            if found.len() == bodies.len() {
                break;
            }
        }
    }
    found
}

/// F and F′ of a lens, F and C of a mirror.
fn points(scene: &Scene, axis: &OpticalAxis, paraxial: &Paraxial) -> Vec<(&'static str, DVec2)> {
    if !scene.diagram.focal_points {
        return Vec::new();
    }
    let [front, back] = paraxial.focal_points;
    vec![("F", front), axis.center.map_or(("F′", back), |center| ("C", center))]
}

/// H and H′ of a lens that is not ideally thin.
fn planes(scene: &Scene, axis: &OpticalAxis, paraxial: &Paraxial) -> Vec<(&'static str, DVec2)> {
    if !scene.diagram.principal_planes || axis.imaging != Imaging::Lens {
        return Vec::new();
    }
    let [front, back] = paraxial.principal_points;
    vec![("H", front), ("H′", back)]
}
