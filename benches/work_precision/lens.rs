//! A plano-convex lens as n facets against its true arc: where rays cross the axis, and the time per ray.

use std::hint::black_box;
use std::time::Instant;

use f256::f256;
use glam::DVec2;
use snellius::scene::{Body, Direction, Light, Medium, SecondaryRays, Shape, Substance};
use snellius::{Ending, OpticalSystem, Scene, Segment, TracedRay, Visitor, compile, summarize, visit};

use crate::clock::medians;
use crate::plot::{Curve, Panel};
use crate::scenes::source;
use crate::study::Study;
use crate::table::{Table, digits};
use crate::truth;
use crate::wide::{Wide2, narrow, wide};

const RADIUS: f64 = 50.0;
const THICKNESS: f64 = 6.0;
const INDEX: f64 = 1.5;
const FOCAL_LENGTH: f64 = RADIUS / (INDEX - 1.0);
const RAYS: u32 = 32;

struct Measured {
    facets: Option<u32>,
    /// Worst error of the crossing, over the focal length.
    error: f64,
    compile_seconds: f64,
    ray_seconds: f64,
}

pub(crate) fn run(study: &mut Study) {
    let most = study.size(1000, 100_000);
    let counts = [8, 16, 32, 100, 316, 1000, 3162, 10_000, 31_623, 100_000];
    let faces: Vec<_> = counts.into_iter().filter(|n| *n <= most).map(Some).chain([None]).collect();
    let (systems, compile_seconds): (Vec<_>, Vec<_>) = faces.iter().map(|facets| timed_compile(*facets)).unzip();
    let mut tasks: Vec<Box<dyn FnMut()>> = Vec::new();
    for system in &systems {
        // Many times where it is short, for the clock's sake.
        let times = (20_000 / system.interfaces().len()).max(1);
        tasks.push(Box::new(move || (0..times).for_each(|_| drop(black_box(summarize(black_box(system)))))));
    }
    let seconds = medians(study.size(3, 9), &mut tasks);
    let mut results = Vec::new();
    for (k, system) in systems.iter().enumerate() {
        let times = (20_000 / system.interfaces().len()).max(1);
        let ray_seconds = seconds[k] / (times as f64 * f64::from(RAYS));
        let error = focus_error(system);
        results.push(Measured { facets: faces[k], error, compile_seconds: compile_seconds[k], ray_seconds });
    }
    report(study, &results);
}

fn report(study: &mut Study, results: &[Measured]) {
    let mut table = Table::new("lens", &["facets", "focus error / f", "time per ray (ns)", "time to compile (ms)"]);
    for result in results {
        let facets = result.facets.map_or("true arc".into(), |n| n.to_string());
        let times = [1e9 * result.ray_seconds, 1e3 * result.compile_seconds].map(digits);
        let [ray, compile] = times;
        table.row([facets, digits(result.error), ray, compile]);
    }
    study.save(&table);
    let curve = |name: &str, is_arc: bool, x: fn(&Measured) -> f64| {
        let shown = results.iter().filter(|result| result.facets.is_none() == is_arc);
        Curve { name: name.into(), points: shown.map(|r| (x(r), r.error)).collect(), is_joined: true }
    };
    let time = |result: &Measured| 1e9 * result.ray_seconds;
    let count = |result: &Measured| f64::from(result.facets.unwrap_or(1));
    let [facets, arc] = ["facets", "true arc"];
    let error = "worst focus error / focal length";
    study.draw(
        "lens",
        &[
            panel("Facets", ["facets per face", error], vec![curve(facets, false, count)]),
            panel(
                "Time and error",
                ["time per ray (ns)", error],
                vec![curve(facets, false, time), curve(arc, true, time)],
            ),
        ],
    );
    let of_facets = results.iter().filter_map(|result| Some((f64::from(result.facets?), result.error)));
    let order = -crate::irradiance::slope(&of_facets.collect::<Vec<_>>());
    study.figures.at_least("lens: order of convergence in facets", order, 0.9);
    let arc = results.iter().filter(|result| result.facets.is_none()).map(|result| result.error).fold(0.0, f64::max);
    study.figures.at_most("lens: worst focus error of the true arc / f", arc, 1e-14);
}

fn panel(title: &str, axes: [&'static str; 2], curves: Vec<Curve>) -> Panel {
    Panel { title: title.into(), axes, curves }
}

/// Height of ray k, spread over 0.5 to 8 such that no ray meets the same part of its facet.
fn height(k: u32) -> f64 {
    0.5 + 7.5 * crate::irradiance::golden(k, 0.5)
}

fn timed_compile(facets: Option<u32>) -> (OpticalSystem, f64) {
    let scene = scene(facets);
    let start = Instant::now();
    let system = compile(&scene).unwrap().system;
    (system, start.elapsed().as_secs_f64())
}

fn scene(facets: Option<u32>) -> Scene {
    let shape = Shape::Lens { radii: [RADIUS, f64::INFINITY], thickness: THICKNESS, diameter: 20.0, facets };
    let substance = Substance::Medium(Medium::Index(INDEX));
    let lens = Body::new(shape, substance);
    let ray = |k| Light::Ray { from: DVec2::new(-20.0, height(k)), direction: Direction::Angle(0.0) };
    let mut scene = Scene::new(vec![lens], (0..RAYS).map(|k| source(ray(k))).collect());
    scene.trace.secondary_rays = SecondaryRays::TransmittedOnly;
    scene
}

/// The worst distance between a ray's crossing of the axis and where it crosses behind the true arc, over the focal length.
fn focus_error(system: &OpticalSystem) -> f64 {
    let mut crossings = Crossings(Vec::new());
    visit(system, &mut crossings);
    assert_eq!(crossings.0.len(), RAYS as usize, "every ray passes the lens");
    let error = |(k, &x): (u32, &f64)| narrow(wide(x) - exact_crossing(height(k))).abs() / FOCAL_LENGTH;
    (0..RAYS).zip(&crossings.0).map(error).fold(0.0, f64::max)
}

/// Where rays that leave the scene cross the axis.
struct Crossings(Vec<f64>);

impl Visitor for Crossings {
    fn segment(&mut self, _: &TracedRay, segment: Segment) {
        if segment.ending == Ending::Escaped {
            let Segment { from, direction, .. } = segment;
            self.0.push(from.x - from.y * direction.x / direction.y);
        }
    }
}

/// The crossing behind the true arc to 237 bits.
fn exact_crossing(height: f64) -> f256 {
    let (radius, h, half, index) = (wide(RADIUS), wide(height), wide(0.5 * THICKNESS), wide(INDEX));
    let axis = Wide2 { x: f256::ONE, y: f256::ZERO };
    let center = (radius - half) * axis;
    let hit = center + Wide2 { x: -(radius * radius - h * h).sqrt(), y: h };
    let inside = truth::refract(axis, hit - center, f256::ONE, index).unwrap();
    let exit = hit + ((half - hit.x) / inside.x) * inside;
    let outside = truth::refract(inside, -axis, index, f256::ONE).unwrap();
    exit.x - exit.y * outside.x / outside.y
}
