//! Every shape of the format, made so that most are valid.

use snellius::glam::DVec2;
use snellius::numerics::Turn;
use snellius::scene::{Element, PathStep, Shape};

use super::generator::Generator;

impl Generator<'_> {
    pub fn shape(&mut self) -> Shape {
        match self.below(14) {
            0 => Shape::Rectangle { width: self.length(), height: self.length() },
            1 => Shape::Disk { radius: self.length() },
            2 => Shape::Polygon(vec![self.point(), self.point(), self.point()]),
            3 => self.star(),
            4 => Shape::RegularPolygon { sides: 2 + self.count(8), radius: self.length() },
            5 => Shape::Prism { apex_angle: [60.0, 90.0, 1e-6, 179.9][self.below(4)], side: self.length() },
            6 => Shape::RightAnglePrism { leg: self.length() },
            7 => Shape::HalfDisk { radius: self.length() },
            8 => self.lens(),
            9 => self.lens_group(),
            10 => self.outline(),
            11 => Shape::Flat { from: self.point(), to: self.point() },
            12 => Shape::Arc { from: self.point(), through: self.point(), to: self.point() },
            _ => {
                let opening = self.length();
                let height = opening * [2.0, 10.0, 1.0 + 1e-12][self.below(3)];
                Shape::Stop { opening, height }
            }
        }
    }

    /// Corners in order around a center, in either orientation; convex where all distances are the same.
    fn star(&mut self) -> Shape {
        let corners = 2 + self.count(9);
        let (center, radius, is_round) = (self.point(), self.length(), self.one_in(2));
        let corner = |k: u32| {
            let distance = if is_round { radius } else { radius * self.between(0.2, 1.0) };
            center + distance * Turn::degrees(360.0 * f64::from(k) / f64::from(corners)).direction()
        };
        let mut points: Vec<_> = (0..corners).map(corner).collect();
        if self.one_in(2) {
            points.reverse();
        }
        Shape::Polygon(points)
    }

    /// Radius of a face that reaches up to half the diameter, or a plane one.
    fn face(&mut self, diameter: f64) -> f64 {
        let radius = match self.below(4) {
            0 => diameter,
            1 => f64::INFINITY,
            2 => diameter * self.between(0.5, 20.0),
            _ => 0.5 * diameter,
        };
        radius * [1.0, -1.0][self.below(2)]
    }

    /// A distance between two faces that they do not cross in, often the least.
    fn thickness(&mut self, [left, right]: [f64; 2], diameter: f64) -> f64 {
        let half = 0.5 * diameter;
        let sag = |radius: f64| {
            let slope = half / radius;
            half * slope / (1.0 + (1.0 - slope * slope).max(0.0).sqrt())
        };
        let least = (sag(left) - sag(right)).max(0.0);
        let more = [0.2, 0.0, 1e-9, self.unit()][self.below(4)] * diameter;
        if least + more > 0.0 { least + more } else { diameter }
    }

    fn lens(&mut self) -> Shape {
        let diameter = self.length();
        let radii = [self.face(diameter), self.face(diameter)];
        let facets = self.one_in(6).then(|| self.count(9));
        Shape::Lens { radii, thickness: self.thickness(radii, diameter), diameter, facets }
    }

    fn lens_group(&mut self) -> Shape {
        let diameter = self.length();
        let radii: Vec<f64> = (0..2 + self.below(3)).map(|_| self.face(diameter)).collect();
        let element = |k: usize| {
            let pair = radii.get(k..k + 2).map(|pair| [pair[0], pair[1]]);
            let thickness = pair.map(|pair| self.thickness(pair, diameter));
            Element::new(radii[k], thickness, pair.map(|_| self.medium()))
        };
        Shape::LensGroup { diameter, surfaces: (0..radii.len()).map(element).collect() }
    }

    /// A rectangle of which some sides bulge or cave in.
    fn outline(&mut self) -> Shape {
        let (start, size) = (self.point(), DVec2::new(self.length(), self.length()));
        let corners = [DVec2::ZERO, DVec2::new(size.x, 0.0), size, DVec2::new(0.0, size.y), DVec2::ZERO];
        let step = |k: usize| {
            let (from, to) = (start + corners[k], start + corners[k + 1]);
            let bulge = [0.0, 0.5, 1e-9, self.between(-0.2, 0.5)][self.below(4)];
            let through = 0.5 * (from + to) - bulge * (to - from).perp();
            if bulge == 0.0 { PathStep::LineTo(to) } else { PathStep::ArcTo { through, to } }
        };
        Shape::Outline { start, path: (0..4).map(step).collect() }
    }
}
