//! A scene laid out: every curve in its place, and the medium at every point.

use f256::f256;
use glam::DVec2;
use snellius::Scene;
use snellius::scene::{Body, Medium, Shape, Substance, Surface, TraceSettings};

use crate::curve::Curve;
use crate::media::Formula;
use crate::numbers::{Numbers, PATTERNS};
use crate::placement::Placement;
use crate::shapes::{Path, paths};
use crate::sources::starts;
use crate::support::figures::U;
use crate::support::wide::{Wide2, wide};

/// One curve of a body.
pub(crate) struct Wall {
    /// Where it runs, and where it would with disturbed numbers.
    pub(crate) curves: Vec<Curve>,
    /// Largest absolute coordinate.
    pub(crate) reach: f64,
    pub(crate) body: usize,
    pub(crate) surface: Option<Surface>,
}

impl Wall {
    pub(crate) fn curve(&self) -> &Curve {
        &self.curves[0]
    }
}

/// What a closed outline is filled with.
struct Filling {
    walls: std::ops::Range<usize>,
    medium: Formula,
}

pub(crate) struct Bench {
    /// In painter's order.
    pub(crate) walls: Vec<Wall>,
    fillings: Vec<Filling>,
    surroundings: Formula,
    pub(crate) settings: TraceSettings,
    /// Largest absolute coordinate of any curve or ray start about the origin that snellius computes with.
    pub(crate) size: f64,
    /// Far more than the distance within which two boundaries are one, far less than any feature.
    pub(crate) step: f256,
}

impl Bench {
    pub(crate) fn new(scene: &Scene, origin: DVec2) -> Self {
        let mut bench = Self {
            walls: Vec::new(),
            fillings: Vec::new(),
            surroundings: Formula::of(&scene.surroundings),
            settings: scene.trace,
            size: 0.0,
            step: f256::ZERO,
        };
        for (number, body) in scene.bodies.iter().enumerate() {
            bench.add(number, body);
        }
        let around_bodies = bench.walls.iter().flat_map(|wall| wall.curve().extremes());
        let around_starts = scene.sources.iter().flat_map(|source| starts(&source.light)).map(|(from, _)| from);
        let from_origin = |p: Wide2| (p - origin.into()).narrow().abs().max_element();
        bench.size = around_bodies.chain(around_starts).map(from_origin).fold(0.0, f64::max);
        let reach = bench.walls.iter().map(|wall| wall.reach).fold(0.0, f64::max);
        bench.step = wide(1e-12 * bench.size + 4.0 * coincidence(reach));
        bench.disturb(&scene.bodies);
        bench
    }

    fn add(&mut self, number: usize, body: &Body) {
        let numbers = Numbers { state: 0, size: 0.0 };
        for path in placed(body, &numbers) {
            let first = self.walls.len();
            let (medium, surface) = substance(body, path.medium);
            let wall = |curve: Curve| Wall { reach: curve.reach(), curves: vec![curve], body: number, surface };
            self.walls.extend(path.curves.into_iter().map(wall));
            if let Some(medium) = medium {
                self.fillings.push(Filling { walls: first..self.walls.len(), medium: Formula::of(&medium) });
            }
        }
    }

    /// Where the walls would run with disturbed numbers.
    fn disturb(&mut self, bodies: &[Body]) {
        for state in 1..=PATTERNS {
            let numbers = Numbers { state, size: self.size };
            let curves = bodies.iter().flat_map(|body| placed(body, &numbers)).flat_map(|path| path.curves);
            self.walls.iter_mut().zip(curves).for_each(|(wall, curve)| wall.curves.push(curve));
        }
    }

    /// The medium of the last filled body that holds a point, which is on no curve.
    pub(crate) fn medium_at(&self, p: Wide2) -> &Formula {
        let holds = |filling: &&Filling| {
            // In a direction of no scene's, so that no vertex is met.
            let d = Wide2 { x: wide(0.739_085_133_215), y: wide(0.673_612_029_183) }.unit();
            let crossings = self.walls[filling.walls.clone()].iter().flat_map(|wall| wall.curve().crossings(p, d));
            crossings.filter(|crossing| crossing.distance > f256::ZERO).count() % 2 == 1
        };
        self.fillings.iter().rev().find(holds).map_or(&self.surroundings, |filling| &filling.medium)
    }

    /// The walls that are one boundary with a wall at a point of it, the earliest first.
    pub(crate) fn boundary(&self, wall: usize, p: Wide2) -> Vec<usize> {
        let reach = self.walls[wall].reach;
        let is_near = |other: &&usize| {
            let other = &self.walls[**other];
            other.curve().distance(p) <= wide(coincidence(reach.max(other.reach)))
        };
        let all: Vec<usize> = (0..self.walls.len()).collect();
        all.iter().filter(is_near).copied().collect()
    }
}

/// Distance within which boundaries with this largest coordinate are one.
pub(crate) fn coincidence(reach: f64) -> f64 {
    16.0 * U * reach
}

fn placed(body: &Body, numbers: &Numbers) -> Vec<Path> {
    let placement = Placement::of(body, numbers);
    let given = paths(&body.shape, &Numbers { state: 0, size: 0.0 });
    let placed = |(path, given): (Path, &Path)| {
        let pairs = path.curves.into_iter().zip(&given.curves);
        let curves =
            pairs.filter(|(_, given)| !given.is_rounding()).map(|(curve, _)| curve.placed(&placement)).collect();
        Path { curves, ..path }
    };
    paths(&body.shape, numbers).into_iter().zip(&given).map(placed).collect()
}

fn substance(body: &Body, element: Option<Medium>) -> (Option<Medium>, Option<Surface>) {
    match (&body.substance, &body.shape) {
        (Substance::Surface(surface), _) => (None, Some(*surface)),
        (Substance::Medium(medium), _) => (Some(medium.clone()), None),
        (Substance::Elements, Shape::LensGroup { .. }) => (element, None),
        (other, _) => panic!("the reference knows no {other:?} here"),
    }
}
