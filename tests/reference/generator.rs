//! Random scenes: bodies beside, over and inside each other, cemented pairs, surfaces, turned and far from the origin.

use glam::DVec2;
use snellius::Scene;
use snellius::scene::{
    Body, Direction, Element, Light, Medium, PathStep, Polarization, SecondaryRays, Shape, Source, Spectrum, Substance,
    Surface, TraceSettings,
};

use crate::bench::Wall;
use crate::placement::{direction, turned};
use crate::support::random::Random;
use crate::support::wide::{narrow, wide};

/// Makes scenes, one after the other.
pub(crate) struct Generator {
    random: Random,
    /// Whether sizes and places of bodies are multiples of one half and turns are quarters, so that faces coincide.
    is_lattice: bool,
}

impl Generator {
    pub(crate) fn new(seed: u64) -> Self {
        Self { random: Random(seed), is_lattice: false }
    }

    pub(crate) fn scene(&mut self) -> Scene {
        let place = self.place();
        self.is_lattice = self.random.below(3) == 0;
        let mut bodies: Vec<_> = (0..1 + self.random.below(5)).flat_map(|_| self.bodies(place)).collect();
        self.is_lattice = false;
        if self.random.below(6) == 0 {
            bodies.insert(self.random.below(bodies.len()), self.room(place));
        }
        let sources = (0..2 + self.random.below(3)).map(|_| self.source(place)).collect();
        let mut scene = Scene::new(bodies, sources);
        scene.surroundings = self.medium();
        scene.trace = self.settings();
        scene
    }

    /// Where the whole scene stands.
    fn place(&mut self) -> DVec2 {
        let reach = [0.0, 0.0, 1e3, 1e6][self.random.below(4)];
        DVec2::new(self.within(reach), self.within(reach))
    }

    fn within(&mut self, reach: f64) -> f64 {
        self.between(-reach, reach)
    }

    fn between(&mut self, least: f64, most: f64) -> f64 {
        let x = least + (most - least) * self.random.unit();
        let rounded = 0.5 * (2.0 * x).round();
        if self.is_lattice && least <= rounded && rounded <= most { rounded } else { x }
    }

    fn point(&mut self, reach: f64) -> DVec2 {
        DVec2::new(self.within(reach), self.within(reach))
    }

    /// A body, one inside another, or two that are cemented.
    fn bodies(&mut self, place: DVec2) -> Vec<Body> {
        let at = place + self.point(8.0);
        let rotate = if self.is_lattice || self.random.below(4) == 0 {
            90.0 * self.within(2.0).round()
        } else {
            self.within(180.0)
        };
        let body = |shape, substance| Body::new(shape, substance).placed(at, rotate);
        match self.random.below(6) {
            0 => {
                let radius = self.between(2.0, 5.0);
                let inner = body(Shape::Disk { radius: radius * self.between(0.2, 0.8) }, self.filling());
                vec![body(Shape::Disk { radius }, self.filling()), inner]
            }
            1 => {
                // Face to face along their hypotenuses, up to the rounding of their places.
                let leg = self.between(2.0, 6.0);
                let across = turned(DVec2::splat(leg).into(), direction(wide(rotate))).narrow();
                let prism = || Shape::RightAnglePrism { leg };
                let other = body(prism(), self.filling()).placed(at + across, rotate + 180.0);
                vec![body(prism(), self.filling()), other]
            }
            2 => {
                let (shape, surface) = self.screenlike();
                vec![body(shape, Substance::Surface(surface))]
            }
            3 => {
                // A coated face.
                let (width, height) = (self.between(1.0, 6.0), self.between(1.0, 6.0));
                let corner = 0.5 * DVec2::new(width, height);
                let face = Shape::Flat { from: corner, to: DVec2::new(-corner.x, corner.y) };
                let coating = body(face, Substance::Surface(self.surface()));
                vec![body(Shape::Rectangle { width, height }, self.filling()), coating]
            }
            _ => {
                let shape = self.closed();
                let is_group = matches!(shape, Shape::LensGroup { .. });
                let substance = match self.random.below(8) {
                    _ if is_group => Substance::Elements,
                    0 => Substance::Surface(self.surface()),
                    _ => self.filling(),
                };
                vec![body(shape, substance)]
            }
        }
    }

    /// Mirrors all round, from which little escapes.
    fn room(&mut self, at: DVec2) -> Body {
        let shape = match self.random.below(3) {
            0 => Shape::Disk { radius: self.between(15.0, 30.0) },
            1 => Shape::Rectangle { width: self.between(20.0, 60.0), height: self.between(20.0, 60.0) },
            _ => Shape::RegularPolygon { sides: 5, radius: self.between(15.0, 30.0) },
        };
        let (rotate, substance) = (self.within(180.0), Substance::Surface(Surface::Mirror));
        Body::new(shape, substance).placed(at, rotate)
    }

    fn filling(&mut self) -> Substance {
        Substance::Medium(self.medium())
    }

    fn medium(&mut self) -> Medium {
        match self.random.below(12) {
            0 => Medium::Catalog(["N-BK7", "N-SF11", "water", "air", "PMMA", "diamond"][self.random.below(6)].into()),
            1 => Medium::Cauchy(vec![self.between(1.3, 1.7), 0.005]),
            2 => Medium::Speed(self.between(1.5e8, 2.9e8)),
            3 => Medium::Sellmeier { b: [self.between(0.5, 1.5), 0.2, 1.0], c: [0.006, 0.02, 100.0] },
            4 | 5 => Medium::Index(1.0),
            6 | 7 => Medium::Index(1.5),
            _ => Medium::Index(self.between(1.0, 2.5)),
        }
    }

    fn surface(&mut self) -> Surface {
        match self.random.below(5) {
            0 => Surface::Absorber,
            1 => Surface::Screen,
            2 => Surface::BeamSplitter { reflect: self.between(0.0, 0.5), transmit: self.between(0.0, 0.5) },
            _ => Surface::Mirror,
        }
    }

    /// An open shape and what it does.
    fn screenlike(&mut self) -> (Shape, Surface) {
        match self.random.below(4) {
            0 => {
                let (from, to) = (self.point(5.0), self.point(5.0));
                let focal_length = self.between(3.0, 20.0) * [1.0, -1.0][self.random.below(2)];
                (Shape::Flat { from, to }, Surface::ThinLens { focal_length })
            }
            1 => (Shape::Flat { from: self.point(5.0), to: self.point(5.0) }, self.surface()),
            2 => {
                let (from, through, to) = (self.point(5.0), self.point(5.0), self.point(5.0));
                (Shape::Arc { from, through, to }, self.surface())
            }
            _ => (Shape::Stop { opening: self.between(0.5, 2.0), height: self.between(2.5, 8.0) }, self.surface()),
        }
    }

    fn closed(&mut self) -> Shape {
        match self.random.below(10) {
            0 => self.polygon(),
            1 => Shape::Rectangle { width: self.between(0.5, 6.0), height: self.between(0.5, 6.0) },
            2 => Shape::RegularPolygon {
                sides: 3 + u32::try_from(self.random.below(6)).unwrap(),
                radius: self.between(1.0, 5.0),
            },
            3 => Shape::Prism { apex_angle: self.between(20.0, 120.0), side: self.between(1.0, 6.0) },
            4 => Shape::RightAnglePrism { leg: self.between(1.0, 6.0) },
            5 => Shape::Disk { radius: self.between(0.5, 5.0) },
            6 => Shape::HalfDisk { radius: self.between(0.5, 5.0) },
            7 => self.lens(),
            8 => self.lens_group(),
            _ => self.outline(),
        }
    }

    /// Star-shaped, in either orientation.
    fn polygon(&mut self) -> Shape {
        let corners = 3 + self.random.below(6);
        let step = 360.0 / f64::from(u32::try_from(corners).unwrap());
        let mut angle = 0.0;
        let corner = |_| {
            angle += step * self.between(0.7, 1.0);
            self.between(1.0, 5.0) * direction(wide(angle)).narrow()
        };
        let mut points: Vec<_> = (0..corners).map(corner).collect();
        if self.random.below(2) == 0 {
            points.reverse();
        }
        Shape::Polygon(points)
    }

    /// Radius of a face that reaches up to half the diameter 4, or a plane one.
    fn radius(&mut self) -> f64 {
        if self.random.below(5) == 0 {
            f64::INFINITY
        } else {
            self.between(2.5, 30.0) * [1.0, -1.0][self.random.below(2)]
        }
    }

    /// A distance between two faces that they do not cross in.
    fn thickness(&mut self, left: f64, right: f64) -> f64 {
        let sag = |r: f64| if r.is_finite() { r - r.signum() * (r * r - 4.0).sqrt() } else { 0.0 };
        (sag(left) - sag(right)).max(0.0) + self.between(0.1, 2.0)
    }

    fn lens(&mut self) -> Shape {
        let radii = [self.radius(), self.radius()];
        let facets = (self.random.below(4) == 0).then(|| 1 + u32::try_from(self.random.below(8)).unwrap());
        Shape::Lens { radii, thickness: self.thickness(radii[0], radii[1]), diameter: 4.0, facets }
    }

    fn lens_group(&mut self) -> Shape {
        let radii = [self.radius(), self.radius(), self.radius()];
        let inner = |this: &mut Self, k: usize| {
            let thickness = Some(this.thickness(radii[k], radii[k + 1]));
            Element::new(radii[k], thickness, Some(this.medium()))
        };
        let surfaces = vec![inner(self, 0), inner(self, 1), Element::new(radii[2], None, None)];
        Shape::LensGroup { diameter: 4.0, surfaces }
    }

    /// A rectangle of which some sides bulge or cave in.
    fn outline(&mut self) -> Shape {
        let (width, height) = (self.between(2.0, 5.0), self.between(2.0, 5.0));
        let corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height), (0.0, 0.0)].map(DVec2::from);
        let mut step = |k: usize| {
            let (from, to) = (corners[k], corners[k + 1]);
            let bulge = [0.0, self.between(-0.2, 0.5)][self.random.below(2)];
            let through = 0.5 * (from + to) - bulge * (to - from).perp();
            if bulge == 0.0 { PathStep::LineTo(to) } else { PathStep::ArcTo { through, to } }
        };
        Shape::Outline { start: corners[0], path: (0..4).map(&mut step).collect() }
    }

    fn source(&mut self, place: DVec2) -> Source {
        let from = place + self.point(20.0);
        let towards = Direction::Towards(place + self.point(8.0));
        let direction = if self.random.below(4) == 0 { Direction::Angle(self.within(180.0)) } else { towards };
        let rays = 1 + u32::try_from(self.random.below(4)).unwrap();
        let light = match self.random.below(6) {
            0 => Light::Beam { center: from, direction, width: self.between(0.5, 4.0), rays },
            1 => Light::Fan { from, direction, spread: self.between(1.0, 40.0), rays },
            2 => Light::Point { at: place + self.point(8.0), rays: 3 * rays },
            _ => Light::Ray { from, direction },
        };
        let spectrum = match self.random.below(6) {
            0 => Spectrum::Lines(vec![486.1327, 656.2725]),
            1 => Spectrum::White { samples: 2 },
            _ => Spectrum::default(),
        };
        let polarization = [Polarization::Unpolarized, Polarization::S, Polarization::P][self.random.below(3)];
        let mut source = Source::new(light);
        source.spectrum = spectrum;
        source.power = self.between(0.1, 3.0);
        source.polarization = polarization;
        source
    }

    /// A ray that all but meets an end of a curve, or all but touches it, by 1e-14 to 1e-4.
    pub(crate) fn aimed(&mut self, walls: &[Wall]) -> Source {
        let curve = walls[self.random.below(walls.len())].curve();
        let off = libm::exp10(self.between(-14.0, -4.0)) * [1.0, -1.0][self.random.below(2)];
        let ends = curve.ends();
        let along = direction(wide(self.within(180.0))).narrow();
        let goal = match curve.circle {
            Some(circle) if ends.is_empty() || self.random.below(2) == 0 => {
                circle.center.narrow() + (narrow(circle.radius) + off) * along.perp()
            }
            _ => ends[self.random.below(ends.len())].narrow() + off * along.perp(),
        };
        let light = Light::Ray { from: goal - self.between(5.0, 20.0) * along, direction: Direction::Towards(goal) };
        Source::new(light)
    }

    fn settings(&mut self) -> TraceSettings {
        let secondary_rays = match self.random.below(6) {
            0 => SecondaryRays::TransmittedOnly,
            1 => SecondaryRays::Fixed { kr: self.between(0.0, 0.5), kt: self.between(0.0, 0.5) },
            _ => SecondaryRays::Fresnel,
        };
        let max_depth = 2 + u32::try_from(self.random.below(11)).unwrap();
        let min_power = [0.0, 1e-3, 1e-3, 1e-2][self.random.below(4)];
        let max_depth = if min_power == 0.0 { max_depth.min(6) } else { max_depth };
        let mut settings = TraceSettings::default();
        settings.secondary_rays = secondary_rays;
        settings.max_depth = max_depth;
        settings.min_power = min_power;
        settings
    }
}
