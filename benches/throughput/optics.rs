//! The scenes whose traces are timed: fixed, and with few enough words that what is measured is the trace.

use std::f64::consts::TAU;

use glam::DVec2;
use snellius::Scene;
use snellius::compile::{Compiled, compile_within};
use snellius::scene::{
    Body, Direction, Light, Limit, Limits, Medium, Problems, Shape, Source, Spectrum, Substance, TraceSettings,
};

use crate::random::Random;
use crate::scenes::{NO_DEPTH, beam, body, prism, source};

/// Branches below this share of their ray are not followed.
const MIN_POWER: f64 = 1e-4;
/// Hits of a ray in the light guide.
pub(crate) const BOUNCES: u32 = 1000;

/// Segments that no scene here comes near to.
const NO_END: u64 = 1_000_000_000;

/// Compiles a scene that may take so many segments.
pub(crate) fn compile(scene: &Scene) -> Result<Compiled, Problems> {
    compile_within(scene, &Limits::default().with(Limit::Segments, NO_END))
}

/// The scene, cut by power alone.
pub(crate) fn by_power(mut scene: Scene) -> Scene {
    scene.trace = TraceSettings::default();
    (scene.trace.min_power, scene.trace.max_depth) = (MIN_POWER, NO_DEPTH);
    scene.trace.max_segments = NO_END;
    scene
}

/// The scene, cut by depth too.
pub(crate) fn to_depth(scene: Scene, max_depth: u32) -> Scene {
    let mut scene = by_power(scene);
    scene.trace.max_depth = max_depth;
    scene
}

/// The Cooke triplet of the gallery without stop and film, a beam over its first face.
pub(crate) fn triplet(rays: u32) -> Scene {
    let mut scene = Scene::from_ron(include_str!("../../scenes/lenses/cooke-triplet.ron")).unwrap();
    scene.bodies.truncate(1);
    scene.sources = vec![source(beam(DVec2::new(-14.0, 0.0), 3.0, 7.35, rays))];
    scene.notes.clear();
    scene
}

/// A prism of N-BK7, lit by 64 lines.
pub(crate) fn spectrum(rays: u32) -> Scene {
    let mut scene = prism(rays);
    scene.bodies[0].substance = Substance::Medium(Medium::Catalog("N-BK7".into()));
    scene.sources[0].spectrum = Spectrum::White { samples: 64 };
    scene
}

/// A bar in which light is totally reflected, 60° from the normal, from end to end.
pub(crate) fn guide(rays: u32) -> Scene {
    let length = 1.8 * f64::from(BOUNCES);
    let bar = body(Shape::Rectangle { width: length, height: 1.0 }, DVec2::new(0.5 * length, 0.0));
    let light = Light::Fan { from: DVec2::new(0.1, 0.05), direction: Direction::Angle(30.0), spread: 1.0, rays };
    Scene::new(vec![bar], vec![source(light)])
}

/// Convex polygons of different sizes and indices, none overlapping, one to a cell of size 1 of a square field; rays from
/// corners of random cells to the polygons there. Five polygons have five times `corners` edges, each from two fewer to two
/// more.
pub(crate) fn scattered(polygons: usize, corners: usize, rays: usize) -> Scene {
    let mut random = Random(5);
    let across = columns(polygons);
    let bodies = (0..polygons).map(|k| polygon(k, across, corners, &mut random)).collect();
    let sources = (0..rays).map(|_| ray(random.below(polygons), across, &mut random)).collect();
    Scene::new(bodies, sources)
}

/// Polygons in a row of a field of so many.
pub(crate) fn columns(polygons: usize) -> usize {
    (1..).find(|side| side * side >= polygons).unwrap()
}

/// Middle of a polygon's cell.
fn cell(k: usize, across: usize) -> DVec2 {
    DVec2::new(number(k % across) + 0.5, number(k / across) + 0.5)
}

fn polygon(k: usize, across: usize, corners: usize, random: &mut Random) -> Body {
    let corners = corners + [2, 1, 3, 0, 4][k % 5] - 2;
    let radius = 0.3 + 0.18 * random.unit();
    let corner = |c: usize| {
        let angle = TAU * (number(c) + 0.7 * random.unit()) / number(corners);
        radius * DVec2::new(libm::cos(angle), libm::sin(angle))
    };
    let shape = Shape::Polygon((0..corners).map(corner).collect());
    let jitter = (0.98 - 2.0 * radius) * DVec2::new(random.unit() - 0.5, random.unit() - 0.5);
    let index = 1.3 + 0.04 * number(random.below(16));
    Body::new(shape, Medium::Index(index)).placed(cell(k, across) + jitter, 0.0)
}

fn ray(k: usize, across: usize, random: &mut Random) -> Source {
    let center = cell(k, across);
    let corner = DVec2::new(0.5, 0.5).rotate([DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y][random.below(4)]);
    let aside = 0.3 * DVec2::new(random.unit() - 0.5, random.unit() - 0.5);
    source(Light::Ray { from: center + corner, direction: Direction::Towards(center + aside) })
}

pub(crate) fn number(n: usize) -> f64 {
    n as f64
}
