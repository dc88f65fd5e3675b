//! The outlines of shapes, about their own origins.

use glam::DVec2;

use crate::geometry::Curve;
use crate::numerics::{Turn, asin_degrees};
use crate::scene::{Element, Medium, PathStep, Shape};

/// One connected line of a shape, before placement.
#[derive(Clone, Debug)]
pub(crate) struct Path {
    pub(crate) curves: Vec<Curve>,
    pub(crate) closed: bool,
    /// The element's own medium in a lens group; `None` elsewhere.
    pub(crate) medium: Option<Medium>,
}

/// The lines of a shape in the order written.
pub(crate) fn outlines(shape: &Shape) -> Vec<Path> {
    match shape {
        Shape::Polygon(points) => vec![polygon(points)],
        Shape::Rectangle { width, height } => vec![rectangle(*width, *height)],
        Shape::RegularPolygon { sides, radius } => vec![regular_polygon(*sides, *radius)],
        Shape::Prism { apex_angle, side } => vec![prism(*apex_angle, *side)],
        Shape::RightAnglePrism { leg } => vec![polygon(&[DVec2::ZERO, *leg * DVec2::X, *leg * DVec2::Y])],
        Shape::Disk { radius } => vec![closed(disk(*radius))],
        Shape::HalfDisk { radius } => vec![closed(half_disk(*radius))],
        Shape::Lens { radii, thickness, diameter, facets } => {
            let half = 0.5 * thickness;
            let left = Face { vertex: -half, curvature: radii[0].recip() };
            let right = Face { vertex: half, curvature: radii[1].recip() };
            vec![closed(element(left, right, 0.5 * diameter, *facets))]
        }
        Shape::Outline { start, path } => vec![closed(outline(*start, path))],
        Shape::LensGroup { diameter, surfaces } => lens_group(*diameter, surfaces),
        Shape::Flat { from, to } => vec![open(vec![Curve::line(*from, *to)])],
        Shape::Arc { from, through, to } => vec![open(vec![arc_or_line(*from, *through, *to)])],
        Shape::Stop { opening, height } => stop(*opening, *height),
    }
}

fn closed(curves: Vec<Curve>) -> Path {
    Path { curves: curves.into_iter().filter(|curve| curve.a != curve.b).collect(), closed: true, medium: None }
}

fn open(curves: Vec<Curve>) -> Path {
    Path { curves, closed: false, medium: None }
}

fn polygon(points: &[DVec2]) -> Path {
    let next = points.iter().cycle().skip(1);
    closed(points.iter().zip(next).map(|(a, b)| Curve::line(*a, *b)).collect())
}

fn rectangle(width: f64, height: f64) -> Path {
    let corner = 0.5 * DVec2::new(width, height);
    polygon(&[-corner, DVec2::new(corner.x, -corner.y), corner, DVec2::new(-corner.x, corner.y)])
}

fn regular_polygon(sides: u32, radius: f64) -> Path {
    let vertex = |k: u32| radius * Turn::degrees(90.0 + 360.0 * (f64::from(k) / f64::from(sides))).direction();
    polygon(&(0..sides).map(vertex).collect::<Vec<_>>())
}

fn prism(apex_angle: f64, side: f64) -> Path {
    let half = Turn::degrees(0.5 * apex_angle);
    let (height, half_base) = (side * half.cos, side * half.sin);
    let (top, base) = (2.0 * height / 3.0, -height / 3.0);
    polygon(&[DVec2::new(-half_base, base), DVec2::new(half_base, base), DVec2::new(0.0, top)])
}

fn disk(radius: f64) -> Vec<Curve> {
    let right = DVec2::new(radius, 0.0);
    let upper = Curve { a: right, b: -right, m: right, n: -DVec2::X, curvature: radius.recip() };
    vec![upper, Curve { a: -right, b: right, ..upper }]
}

fn half_disk(radius: f64) -> Vec<Curve> {
    let (top, bottom) = (DVec2::new(0.0, radius), DVec2::new(0.0, -radius));
    let arc = Curve { a: bottom, b: top, m: DVec2::new(radius, 0.0), n: -DVec2::X, curvature: radius.recip() };
    vec![arc, Curve::line(top, bottom)]
}

/// A lens face: where it crosses the axis, and its curvature, positive when its center lies to the right.
#[derive(Clone, Copy)]
struct Face {
    vertex: f64,
    curvature: f64,
}

impl Face {
    /// The face's point at a height; its sag is c h²/(1 + √(1 − c²h²)), which a plane and a long radius keep.
    fn at(self, height: f64) -> DVec2 {
        let bent = self.curvature * height;
        DVec2::new(self.vertex + bent * height / (1.0 + (1.0 - bent * bent).max(0.0).sqrt()), height)
    }

    /// From the bottom to the top.
    fn upward(self, half_height: f64) -> Curve {
        Curve {
            a: self.at(-half_height),
            b: self.at(half_height),
            m: DVec2::new(self.vertex, 0.0),
            n: -DVec2::X,
            curvature: -self.curvature,
        }
    }

    /// The face as chords of equal angle with their ends on it.
    fn facets(self, half_height: f64, count: u32) -> Vec<Curve> {
        if self.curvature == 0.0 || count < 2 {
            return vec![Curve::line(self.at(-half_height), self.at(half_height))];
        }
        let half_angle = asin_degrees((self.curvature.abs() * half_height).min(1.0));
        let radius = self.curvature.abs().recip();
        let point = |k: u32| match k {
            0 => self.at(-half_height),
            k if k == count => self.at(half_height),
            k => self.at(radius * Turn::degrees(half_angle * (2.0 * f64::from(k) / f64::from(count) - 1.0)).sin),
        };
        (0..count).map(|k| Curve::line(point(k), point(k + 1))).collect()
    }
}

/// The counter-clockwise outline between two faces, with straight rims.
fn element(left: Face, right: Face, half_height: f64, facets: Option<u32>) -> Vec<Curve> {
    let face = |face: Face| facets.map_or_else(|| vec![face.upward(half_height)], |n| face.facets(half_height, n));
    let mut curves = face(right);
    curves.push(Curve::line(right.at(half_height), left.at(half_height)));
    curves.extend(face(left).iter().rev().map(Curve::reversed));
    curves.push(Curve::line(left.at(-half_height), right.at(-half_height)));
    curves
}

fn lens_group(diameter: f64, surfaces: &[Element]) -> Vec<Path> {
    let mut vertex = 0.0;
    let mut paths = Vec::new();
    for pair in surfaces.windows(2) {
        let left = Face { vertex, curvature: pair[0].radius.recip() };
        vertex += pair[0].thickness.unwrap_or(0.0);
        let right = Face { vertex, curvature: pair[1].radius.recip() };
        let path = closed(element(left, right, 0.5 * diameter, None));
        paths.push(Path { medium: pair[0].medium.clone(), ..path });
    }
    paths
}

fn outline(start: DVec2, path: &[PathStep]) -> Vec<Curve> {
    let mut curves = Vec::new();
    let mut at = start;
    for step in path {
        let (curve, to) = match *step {
            PathStep::LineTo(to) => (Curve::line(at, to), to),
            PathStep::ArcTo { through, to } => (arc_or_line(at, through, to), to),
        };
        curves.push(curve);
        at = to;
    }
    curves.push(Curve::line(at, start));
    curves
}

fn arc_or_line(from: DVec2, through: DVec2, to: DVec2) -> Curve {
    Curve::arc(from, through, to).unwrap_or_else(|| Curve::line(from, to))
}

fn stop(opening: f64, height: f64) -> Vec<Path> {
    let (inner, outer) = (0.5 * opening, 0.5 * height);
    let jaw = |from: f64, to: f64| open(vec![Curve::line(DVec2::new(0.0, from), DVec2::new(0.0, to))]);
    vec![jaw(-outer, -inner), jaw(inner, outer)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_are_counted_without_making_them() {
        let points = vec![DVec2::ZERO, DVec2::X, DVec2::Y];
        let lens = |facets| Shape::Lens { radii: [9.0, -9.0], thickness: 2.0, diameter: 4.0, facets };
        let element = |radius| Element { radius, thickness: Some(2.0), medium: Some(Medium::Index(1.5)) };
        let step = PathStep::ArcTo { through: DVec2::new(1.0, -1.0), to: 2.0 * DVec2::X };
        for (shape, count) in [
            (Shape::Polygon(points), 3),
            (Shape::Rectangle { width: 2.0, height: 1.0 }, 4),
            (Shape::RegularPolygon { sides: 7, radius: 1.0 }, 7),
            (Shape::Prism { apex_angle: 60.0, side: 1.0 }, 3),
            (Shape::RightAnglePrism { leg: 1.0 }, 3),
            (Shape::Disk { radius: 1.0 }, 2),
            (Shape::HalfDisk { radius: 1.0 }, 2),
            (lens(None), 4),
            (lens(Some(5)), 12),
            (Shape::Outline { start: DVec2::ZERO, path: vec![step, PathStep::LineTo(3.0 * DVec2::Y)] }, 3),
            (Shape::LensGroup { diameter: 4.0, surfaces: [9.0, -9.0, 8.0].map(element).to_vec() }, 8),
            (Shape::Flat { from: DVec2::ZERO, to: DVec2::X }, 1),
            (Shape::Arc { from: DVec2::ZERO, through: DVec2::ONE, to: 2.0 * DVec2::X }, 1),
            (Shape::Stop { opening: 1.0, height: 2.0 }, 2),
        ] {
            let made: usize = outlines(&shape).iter().map(|path| path.curves.len()).sum();
            assert_eq!((made as u64, shape.curves()), (count, count), "{shape:?}");
        }
    }
}
