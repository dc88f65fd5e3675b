//! The outline of every shape, about its own origin.

use f256::f256;
use glam::DVec2;
use snellius::scene::{Element, Medium, PathStep, Shape};

use crate::curve::Curve;
use crate::numbers::Numbers;
use crate::placement::direction;
use crate::support::wide::{Wide2, wide};

/// One connected line of a shape.
pub(crate) struct Path {
    pub(crate) curves: Vec<Curve>,
    /// What an element of a lens group is filled with.
    pub(crate) medium: Option<Medium>,
}

/// The paths of a shape.
pub(crate) fn paths(shape: &Shape, numbers: &Numbers) -> Vec<Path> {
    let [length, half] = [f256::ONE, wide(0.5)].map(|part| move |x: f64| part * numbers.length(x));
    let at = |x, y| Wide2 { x, y };
    let point = |p: DVec2| at(length(p.x), length(p.y));
    let angle = |degrees: f64| numbers.number(wide(degrees));
    let zero = f256::ZERO;
    let curves = match shape {
        Shape::LensGroup { diameter, surfaces } => return lens_group(half(*diameter), surfaces, numbers),
        Shape::Stop { opening, height } => return stop(half(*opening), half(*height)),
        Shape::Polygon(points) => polygon(&points.iter().map(|p| point(*p)).collect::<Vec<_>>()),
        Shape::Rectangle { width, height } => rectangle(half(*width), half(*height)),
        Shape::RegularPolygon { sides, radius } => regular_polygon(*sides, length(*radius)),
        Shape::Prism { apex_angle, side } => prism(angle(*apex_angle), length(*side)),
        Shape::RightAnglePrism { leg } => polygon(&[Wide2::ZERO, at(length(*leg), zero), at(zero, length(*leg))]),
        Shape::Disk { radius } => vec![Curve::whole(Wide2::ZERO, length(*radius))],
        Shape::HalfDisk { radius } => {
            let (top, bottom) = (at(zero, length(*radius)), at(zero, -length(*radius)));
            vec![Curve::about(Wide2::ZERO, bottom, top, true), Curve::line(top, bottom)]
        }
        Shape::Lens { radii, thickness, diameter, facets } => {
            let [left, right] = [(-half(*thickness), radii[0]), (half(*thickness), radii[1])]
                .map(|(vertex, radius)| Face::new(vertex, radius, numbers));
            element(&left, &right, half(*diameter), *facets)
        }
        Shape::Outline { start, path } => outline(*start, path, point),
        Shape::Flat { from, to } => vec![Curve::line(point(*from), point(*to))],
        Shape::Arc { from, through, to } => vec![Curve::through(point(*from), point(*through), point(*to))],
        other => panic!("the reference knows no {other:?}"),
    };
    vec![Path { curves, medium: None }]
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

/// A face of a lens: where it crosses the axis, and its radius, positive when its center lies to the right; `None` is plane.
struct Face {
    vertex: f256,
    radius: Option<f256>,
}

impl Face {
    fn new(vertex: f256, radius: f64, numbers: &Numbers) -> Self {
        Self { vertex, radius: radius.is_finite().then(|| numbers.length(radius)) }
    }

    fn at(&self, height: f256) -> Wide2 {
        let sag = |radius: f256| {
            let to_center = (radius * radius - height * height).max(f256::ZERO).sqrt();
            radius - to_center.copysign(radius)
        };
        Wide2 { x: self.vertex + self.radius.map_or(f256::ZERO, sag), y: height }
    }

    /// From the bottom to the top, as one arc or as chords of equal angle.
    fn upward(&self, half_height: f256, facets: Option<u32>) -> Vec<Curve> {
        let (bottom, top) = (self.at(-half_height), self.at(half_height));
        match (self.radius, facets) {
            (None, _) => vec![Curve::line(bottom, top)],
            (Some(radius), None) => {
                let center = Wide2 { x: self.vertex + radius, y: f256::ZERO };
                // A center on the right makes an upward arc turn right.
                vec![Curve::about(center, bottom, top, radius < f256::ZERO)]
            }
            (Some(radius), Some(count)) => self.chords(radius.abs(), half_height, count),
        }
    }

    fn chords(&self, radius: f256, half_height: f256, count: u32) -> Vec<Curve> {
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

fn lens_group(half_height: f256, surfaces: &[Element], numbers: &Numbers) -> Vec<Path> {
    let mut vertex = f256::ZERO;
    let path = |pair: &[Element]| {
        let left = Face::new(vertex, pair[0].radius, numbers);
        vertex += numbers.length(pair[0].thickness.unwrap());
        let right = Face::new(vertex, pair[1].radius, numbers);
        Path { curves: element(&left, &right, half_height, None), medium: pair[0].medium.clone() }
    };
    surfaces.windows(2).map(path).collect()
}

fn outline(start: DVec2, path: &[PathStep], point: impl Fn(DVec2) -> Wide2) -> Vec<Curve> {
    let mut at = start;
    let mut curves = Vec::new();
    for step in path {
        let (curve, to) = match *step {
            PathStep::LineTo(to) => (Curve::line(point(at), point(to)), to),
            PathStep::ArcTo { through, to } => (Curve::through(point(at), point(through), point(to)), to),
            other => panic!("the reference knows no {other:?}"),
        };
        curves.push(curve);
        at = to;
    }
    if at != start {
        curves.push(Curve::line(point(at), point(start)));
    }
    curves
}

fn stop(inner: f256, outer: f256) -> Vec<Path> {
    let point = |y: f256| Wide2 { x: f256::ZERO, y };
    let jaw = |from, to| Path { curves: vec![Curve::line(point(from), point(to))], medium: None };
    vec![jaw(-outer, -inner), jaw(inner, outer)]
}
