//! The rays from the tip of an object arrow, and those that find the foot of its image.

use glam::DVec2;

use crate::compile::centered::Centered;
use crate::compile::sources::{Ground, unit};
use crate::light::Wavelength;
use crate::numerics::Turn;
use crate::scene::{Imaging, OpticalAxis, Source, facing};
use crate::system::PlacedObject;

/// Rays that are drawn.
const RAYS: usize = 3;
/// A ray that passes farther out than this share of the half height counts as missing the element.
const APERTURE: f64 = 0.95;
/// Rays that pass the element closer together than this share of its half height are one.
const ONE: f64 = 1e-6;
/// Heights at which the element is met where a principal ray misses it, shares of its half height, in the order in which
/// they are tried.
const SPREAD: [f64; 7] = [0.0, 0.5, -0.5, 0.25, -0.25, 0.75, -0.75];
/// Such a ray keeps this share of the half height off the others.
const APART: f64 = 0.2;
/// The angle between the two rays whose meeting is the image of the foot, degrees: so small that their aberration is not seen.
const NARROW: f64 = 1e-4;

/// An element as the tip of an object sees it: lengths along the axis of the light from the first vertex, heights from the axis.
struct Sight<'a> {
    axis: OpticalAxis,
    /// `None` where the element is not a centered system; its rays are spread out then.
    centered: Option<&'a Centered>,
    /// How far in front of the first vertex the tip stands, above 0, and its height.
    ahead: f64,
    height: f64,
}

impl Ground<'_> {
    /// Directions of the rays from an object's tip, and what is known about it. Without an element, as in no scene that was
    /// found free of errors, there are none.
    pub(crate) fn object(&self, source: &Source, from: DVec2, to: DVec2) -> Option<(Vec<DVec2>, PlacedObject)> {
        let (body, axis) = facing(self.bodies, from)?;
        let axis = axis.along_light(to)?;
        let lines: Vec<f64> = source.spectrum.lines().collect();
        let line = lines.get(lines.len() / 2).copied().and_then(Wavelength::from_nanometers)?;
        let centered = Centered::new(self.walls, self.origin, &axis, |medium| self.media[medium.place()].index(line));
        let [tip, foot] = [to, from].map(|point| Sight::new(axis, centered.as_ref(), point));
        let toward_foot = foot.center_ray();
        let on_axis = axis.vertices[0] - tip.ahead * axis.direction;
        let probe = |point: DVec2, direction| self.start(point - self.origin, direction);
        let probes = [
            probe(on_axis, axis.direction),
            probe(from, toward_foot),
            probe(from, Turn::degrees(NARROW).apply(toward_foot)),
        ];
        Some((tip.rays(), PlacedObject { foot: from, tip: to, body, axis, probes }))
    }
}

impl<'a> Sight<'a> {
    fn new(axis: OpticalAxis, centered: Option<&'a Centered>, point: DVec2) -> Self {
        let apart = point - axis.vertices[0];
        let (ahead, height) = (-apart.dot(axis.direction), apart.dot(axis.direction.perp()));
        Self { axis, centered, ahead, height }
    }

    /// The principal rays that meet the element, and others in place of those that miss it.
    ///
    /// # Source
    /// Hecht, "Optics", 4th ed., sections 5.2.3 (thin lenses), 5.4.3 (mirrors) and 6.1 (principal planes and nodal points).
    fn rays(&self) -> Vec<DVec2> {
        let half = self.axis.half_height;
        let mut slopes: Vec<f64> = Vec::new();
        let spread = SPREAD.iter().map(|share| ((share * half - self.height) / self.ahead, APART));
        for (slope, apart) in self.principal().into_iter().map(|slope| (slope, ONE)).chain(spread) {
            let is_new = slopes.iter().all(|other| ((slope - other) * self.ahead).abs() > apart * half);
            if slopes.len() < RAYS && is_new && self.meets(slope) {
                slopes.push(slope);
            }
        }
        if slopes.is_empty() {
            return vec![self.center_ray()];
        }
        slopes.into_iter().map(|slope| self.direction(slope)).collect()
    }

    /// Slopes of the principal rays: parallel to the axis, through or toward a center, and through or toward a focal point.
    fn principal(&self) -> Vec<f64> {
        let points = self.centered.and_then(Centered::cardinal_points);
        let focus = points.filter(|_| self.axis.imaging != Imaging::FlatMirror).map(|points| points.front_focal_point);
        let center = self.center().filter(|_| self.axis.imaging != Imaging::FlatMirror);
        let through = [center, focus].into_iter().flatten().map(|at| self.slope_through(at));
        [0.0].into_iter().chain(through).filter(|slope| slope.is_finite()).collect()
    }

    /// Where the ray is aimed that goes straight on behind a lens or comes straight back from a mirror: the front nodal point,
    /// or the center of curvature.
    fn center(&self) -> Option<f64> {
        let OpticalAxis { vertices: [vertex, _], direction, center, .. } = self.axis;
        let nodal = || Some(self.centered?.cardinal_points()?.front_nodal_point);
        center.map(|center| (center - vertex).dot(direction)).or_else(nodal)
    }

    /// The ray through the center where it can be; else that to the first vertex.
    fn center_ray(&self) -> DVec2 {
        let slope = self.center().map(|at| self.slope_through(at)).filter(|slope| self.meets(*slope));
        self.direction(slope.unwrap_or(-self.height / self.ahead))
    }

    /// Slope of the line through the tip and a point of the axis; not finite where it stands across the axis.
    fn slope_through(&self, at: f64) -> f64 {
        -self.height / (at + self.ahead)
    }

    fn meets(&self, slope: f64) -> bool {
        let (height, within) = (self.height + slope * self.ahead, APERTURE * self.axis.half_height);
        match self.centered {
            Some(centered) => centered.passes(height, slope, within),
            None => height.abs() <= within,
        }
    }

    fn direction(&self, slope: f64) -> DVec2 {
        let ahead = self.axis.direction;
        let turned = unit(ahead + slope * ahead.perp());
        if slope == 0.0 || turned == DVec2::ZERO { ahead } else { turned }
    }
}
