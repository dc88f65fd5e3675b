//! `min_power` and `max_depth`: the share of the light that they leave unaccounted for, and what less of it costs.

use std::f64::consts::TAU;
use std::hint::black_box;

use glam::DVec2;
use snellius::scene::{Body, Shape, TraceSettings};
use snellius::{OpticalSystem, Scene, Summary, compile, summarize};

use crate::clock::medians;
use crate::plot::{Curve, Panel};
use crate::random::Random;
use crate::scenes::{NO_DEPTH, beam, body, prism, slabs, source};
use crate::study::Study;
use crate::table::{Table, digits};

struct Measured {
    scene: &'static str,
    sweep: &'static str,
    min_power: f64,
    max_depth: u32,
    segments_per_ray: f64,
    /// Share of the power in cut branches.
    unaccounted: f64,
    ray_seconds: f64,
}

pub(crate) fn run(study: &mut Study) {
    let scenes = [("prism", prism(64)), ("slabs", slabs(16)), ("500 polygons", polygons())];
    let most = study.size(4000, 1_000_000);
    let mut results = Vec::new();
    for (name, scene) in &scenes {
        // The polygons take minutes as it is.
        let rounds = study.size(1, if *name == "500 polygons" { 3 } else { 15 });
        let with = |min_power, max_depth| {
            let mut settings = TraceSettings::default();
            settings.min_power = min_power;
            settings.max_depth = max_depth;
            settings
        };
        let powers = (1..=8).map(|k| with(f64::from(10_u32.pow(k)).recip(), NO_DEPTH)).collect();
        results.extend(sweep(name, "min_power", scene, powers, most, rounds));
        let depths = [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64];
        let depths = depths.map(|depth| with(TraceSettings::default().min_power, depth)).into();
        results.extend(sweep(name, "max_depth", scene, depths, most, rounds));
    }
    study.save(&table(&results));
    let power =
        panel("By min_power, without max_depth", &results, "min_power", "segments per ray", |r| r.segments_per_ray);
    let depth =
        panel("By max_depth, at the default min_power", &results, "max_depth", "max_depth", |r| f64::from(r.max_depth));
    study.draw("cuts", &[power, depth]);
    for result in results.iter().filter(|result| result.sweep == "max_depth" && result.is_default()) {
        let name = format!("cuts: unaccounted with the defaults, {}", result.scene);
        study.figures.counted(&name, result.unaccounted);
    }
}

/// Traces a scene with settings one after the other, up to the first that takes more segments than `most`.
fn sweep(
    scene: &'static str,
    sweep: &'static str,
    base: &Scene,
    settings: Vec<TraceSettings>,
    most: u64,
    rounds: usize,
) -> Vec<Measured> {
    let runs = settings.into_iter().map(|settings| {
        let mut scene = base.clone();
        scene.trace = settings;
        scene.trace.max_segments = most;
        let system = compile(&scene).unwrap().system;
        let summary = summarize(&system);
        (scene.trace, system, summary)
    });
    let runs: Vec<_> = runs.take_while(|(_, _, summary)| summary.balance.cut_max_segments.value() == 0.0).collect();
    let seconds = medians(rounds, &mut runs.iter().map(|(_, system, _)| task(system)).collect::<Vec<_>>());
    let measured = |((trace, _, summary), seconds): ((TraceSettings, OpticalSystem, Summary), f64)| {
        let rays = summary.rays as f64;
        let balance = summary.balance;
        let cut = balance.cut_min_power.value() + balance.cut_max_depth.value();
        Measured {
            scene,
            sweep,
            min_power: trace.min_power,
            max_depth: trace.max_depth,
            segments_per_ray: summary.segments as f64 / rays,
            unaccounted: cut / balance.emitted.value(),
            ray_seconds: seconds / rays,
        }
    };
    runs.into_iter().zip(seconds).map(measured).collect()
}

fn task(system: &OpticalSystem) -> Box<dyn FnMut() + '_> {
    Box::new(move || drop(black_box(summarize(black_box(system)))))
}

fn table(results: &[Measured]) -> Table {
    let columns =
        ["scene", "sweep", "min_power", "max_depth", "unaccounted share", "segments per ray", "time per ray (µs)"];
    let mut table = Table::new("cuts", &columns);
    for result in results {
        let depth = if result.max_depth == NO_DEPTH { String::new() } else { result.max_depth.to_string() };
        let numbers = [result.unaccounted, result.segments_per_ray, 1e6 * result.ray_seconds];
        let [share, segments, time] = numbers.map(digits);
        table.row([result.scene.into(), result.sweep.into(), digits(result.min_power), depth, share, segments, time]);
    }
    table
}

fn panel(title: &str, results: &[Measured], sweep: &str, axis: &'static str, x: fn(&Measured) -> f64) -> Panel {
    let of_sweep = || results.iter().filter(|result| result.sweep == sweep);
    let point = |result: &Measured| (x(result), result.unaccounted);
    let of = |scene: &str| {
        let points = of_sweep().filter(|result| result.scene == scene).map(point).collect();
        Curve { name: scene.into(), points, is_joined: true }
    };
    let mut curves: Vec<_> = ["prism", "slabs", "500 polygons"].map(of).into();
    let points = of_sweep().filter(|result| result.is_default()).map(point).collect();
    curves.push(Curve { name: "the default".into(), points, is_joined: false });
    Panel { title: title.into(), axes: [axis, "share of the light unaccounted for"], curves }
}

impl Measured {
    /// Whether what is swept has its default.
    fn is_default(&self) -> bool {
        let TraceSettings { min_power, max_depth, .. } = TraceSettings::default();
        self.min_power.to_bits() == min_power.to_bits() && [max_depth, NO_DEPTH].contains(&self.max_depth)
    }
}

/// 500 convex polygons, none overlapping, that fill a fifth of their field.
fn polygons() -> Scene {
    let mut random = Random(5);
    let bodies: Vec<_> = (0..500).map(|k| polygon(k, &mut random)).collect();
    let light = beam(DVec2::new(-5.0, 10.0), 3.0, 14.0, 8);
    Scene::new(bodies, vec![source(light)])
}

/// One of 25 × 20 cells of size 1 holds a polygon on a circle.
fn polygon(k: u32, random: &mut Random) -> Body {
    let corners = 3 + u32::try_from(random.below(5)).unwrap();
    let corner = |c: u32| {
        let angle = TAU * (f64::from(c) + 0.7 * random.unit()) / f64::from(corners);
        0.36 * DVec2::new(libm::cos(angle), libm::sin(angle))
    };
    let shape = Shape::Polygon((0..corners).map(corner).collect());
    let jitter = 0.12 * DVec2::new(random.unit() - 0.5, random.unit() - 0.5);
    body(shape, DVec2::new(f64::from(k % 25) + 0.5, f64::from(k / 25) + 0.5) + jitter)
}
