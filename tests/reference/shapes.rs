//! The outline of every shape, about its own origin.

use f256::f256;
use glam::DVec2;
use snellius::scene::{Element, Medium, PathStep, Shape};

use crate::curve::Curve;
use crate::placement::direction;
use crate::support::wide::{Wide2, wide};

/// One connected line of a shape.
pub(crate) struct Path {
    pub(crate) curves: Vec<Curve>,
    /// What an element of a lens group is filled with.
    pub(crate) medium: Option<Medium>,
}

pub(crate) fn paths(shape: &Shape) -> Vec<Path> {
    let curves = match shape {
        Shape::LensGroup { diameter, surfaces } => return lens_group(*diameter, surfaces),
        Shape::Stop { opening, height } => return stop(*opening, *height),
        Shape::Polygon(points) => polygon(&points.iter().map(|p| Wide2::from(*p)).collect::<Vec<_>>()),
        Shape::Rectangle { width, height } => rectangle(half(*width), half(*height)),
        Shape::RegularPolygon { sides, radius } => regular_polygon(*sides, wide(*radius)),
        Shape::Prism { apex_angle, side } => prism(wide(*apex_angle), wide(*side)),
        Shape::RightAnglePrism { leg } => polygon(&[at(0.0, 0.0), at(*leg, 0.0), at(0.0, *leg)]),
        Shape::Disk { radius } => vec![Curve::whole(Wide2::ZERO, wide(*radius))],
        Shape::HalfDisk { radius } => {
            let (top, bottom) = (at(0.0, *radius), at(0.0, -*radius));
            vec![Curve::about(Wide2::ZERO, bottom, top, true), Curve::line(top, bottom)]
        }
        Shape::Lens { radii, thickness, diameter, facets } => {
            let [left, right] = [(-*thickness, radii[0]), (*thickness, radii[1])]
                .map(|(x, radius)| Face { vertex: half(x), radius });
            element(&left, &right, half(*diameter), *facets)
        }
        Shape::Outline { start, path } => outline(*start, path),
        Shape::Flat { from, to } => vec![Curve::line((*from).into(), (*to).into())],
        Shape::Arc { from, through, to } => vec![Curve::through((*from).into(), (*through).into(), (*to).into())],
    };
    vec![Path { curves, medium: None }]
}

fn at(x: f64, y: f64) -> Wide2 {
    DVec2::new(x, y).into()
}

fn half(x: f64) -> f256 {
    wide(0.5) * wide(x)
}

fn polygon(points: &[Wide2]) -> Vec<Curve> {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(a, b)| Curve::line(*a, *b)).collect()
}

fn rectangle(x: f256, y: f256) -> Vec<Curve> {
    polygon(&[(-x, -y), (x, -y), (x, y), (-x, y)].map(|(x, y)| Wide2 { x, y }))
}

fn regular_polygon(sides: u32, radius: f256) -> Vec<Curve> {
    let step = wide(360.0) / wide(f64::from(sides));
    let vertex = |k: u32| radius * direction(wide(90.0) + wide(f64::from(k)) * step);
    polygon(&(0..sides).map(vertex).collect::<Vec<_>>())
}

fn prism(apex_angle: f256, side: f256) -> Vec<Curve> {
    let half = side * direction(wide(0.5) * apex_angle);
    let third = half.x / wide(3.0);
    polygon(&[(-half.y, -third), (half.y, -third), (f256::ZERO, wide(2.0) * third)].map(|(x, y)| Wide2 { x, y }))
}

/// A face of a lens: where it crosses the axis, and its radius, positive when its center lies to the right.
struct Face {
    vertex: f256,
    radius: f64,
}

impl Face {
    fn at(&self, height: f256) -> Wide2 {
        let sag = if self.radius.is_infinite() {
            f256::ZERO
        } else {
            let radius = wide(self.radius.abs());
            let depth = radius - (radius * radius - height * height).max(f256::ZERO).sqrt();
            if self.radius > 0.0 { depth } else { -depth }
        };
        Wide2 { x: self.vertex + sag, y: height }
    }

    /// From the bottom to the top, as one arc or as chords of equal angle.
    fn upward(&self, half_height: f256, facets: Option<u32>) -> Vec<Curve> {
        let (bottom, top) = (self.at(-half_height), self.at(half_height));
        match facets {
            _ if self.radius.is_infinite() => vec![Curve::line(bottom, top)],
            None => {
                let center = Wide2 { x: self.vertex + wide(self.radius), y: f256::ZERO };
                // A center on the right makes an upward arc turn right.
                vec![Curve::about(center, bottom, top, self.radius < 0.0)]
            }
            Some(count) => self.chords(half_height, count),
        }
    }

    fn chords(&self, half_height: f256, count: u32) -> Vec<Curve> {
        let radius = wide(self.radius.abs());
        let half_angle = (half_height / radius).asin();
        let height = |k: u32| {
            let share = wide(2.0 * f64::from(k)) / wide(f64::from(count)) - f256::ONE;
            if k == 0 || k == count { share * half_height } else { radius * (share * half_angle).sin() }
        };
        (0..count).map(|k| Curve::line(self.at(height(k)), self.at(height(k + 1)))).collect()
    }
}

/// Between two faces, with straight rims.
fn element(left: &Face, right: &Face, half_height: f256, facets: Option<u32>) -> Vec<Curve> {
    let mut curves = right.upward(half_height, facets);
    curves.push(Curve::line(right.at(half_height), left.at(half_height)));
    curves.extend(left.upward(half_height, facets).into_iter().rev().map(Curve::reversed));
    curves.push(Curve::line(left.at(-half_height), right.at(-half_height)));
    curves
}

fn lens_group(diameter: f64, surfaces: &[Element]) -> Vec<Path> {
    let mut vertex = f256::ZERO;
    let path = |pair: &[Element]| {
        let left = Face { vertex, radius: pair[0].radius };
        vertex += wide(pair[0].thickness.unwrap());
        let right = Face { vertex, radius: pair[1].radius };
        Path { curves: element(&left, &right, half(diameter), None), medium: pair[0].medium.clone() }
    };
    surfaces.windows(2).map(path).collect()
}

fn outline(start: DVec2, path: &[PathStep]) -> Vec<Curve> {
    let mut at = start;
    let mut curves = Vec::new();
    for step in path {
        let (curve, to) = match *step {
            PathStep::LineTo(to) => (Curve::line(at.into(), to.into()), to),
            PathStep::ArcTo { through, to } => (Curve::through(at.into(), through.into(), to.into()), to),
        };
        curves.push(curve);
        at = to;
    }
    if at != start {
        curves.push(Curve::line(at.into(), start.into()));
    }
    curves
}

fn stop(opening: f64, height: f64) -> Vec<Path> {
    let (inner, outer) = (half(opening), half(height));
    let point = |y: f256| Wide2 { x: f256::ZERO, y };
    let jaw = |from, to| Path { curves: vec![Curve::line(point(from), point(to))], medium: None };
    vec![jaw(-outer, -inner), jaw(inner, outer)]
}
