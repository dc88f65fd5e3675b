//! How the directions of a source's rays are spaced, against the error of the irradiance on a screen.
//!
//! A point source at height h over a flat screen lights it with E(x) = Φ h/(h² + x²), Φ being its power per radian, so that
//! the power between two places is Φ times the angle between them.

use std::f64::consts::FRAC_PI_3;
use std::hint::black_box;

use glam::DVec2;
use snellius::scene::{Body, Direction, Light, Shape, Substance, Surface};
use snellius::{OpticalSystem, Scene, compile, summarize};

use crate::clock::medians;
use crate::plot::{Curve, Panel};
use crate::random::Random;
use crate::scenes::source;
use crate::study::Study;
use crate::table::{Table, digits};

const HEIGHT: f64 = 10.0;
const BINS: usize = 64;
/// Places on the screen from −this to this are counted; the rays cover 60° to either side, a little more.
const REACH: f64 = 14.0;
const SPREAD: f64 = 2.0 * FRAC_PI_3;

const SPACINGS: [&str; 4] = ["uniform (Fan)", "golden ratio", "stratified", "random"];

struct Measured {
    spacing: &'static str,
    rays: u32,
    /// Root mean square of the bins' relative errors.
    rms: f64,
    worst: f64,
    seconds: f64,
}

pub(crate) fn run(study: &mut Study) {
    let (last, repeats, rounds) = (study.size(11, 17), study.size(2, 8), study.size(1, 9));
    let mut random = Random(4);
    let mut results = Vec::new();
    for exponent in 6..=last {
        let rays = 1 << exponent;
        for spacing in SPACINGS {
            let errors: Vec<_> = (0..repeats).flat_map(|_| errors(&system(spacing, rays, &mut random))).collect();
            let mean_square = errors.iter().map(|error| error * error).sum::<f64>() / errors.len() as f64;
            let worst = errors.iter().fold(0.0, |worst: f64, error| worst.max(error.abs()));
            results.push(Measured { spacing, rays, rms: mean_square.sqrt(), worst, seconds: 0.0 });
        }
        let systems = SPACINGS.map(|spacing| system(spacing, rays, &mut random));
        let seconds = medians(rounds, &mut systems.iter().map(task).collect::<Vec<_>>());
        let place = results.len() - SPACINGS.len();
        results[place..].iter_mut().zip(seconds).for_each(|(result, seconds)| result.seconds = seconds);
    }
    report(study, &results);
}

fn task(system: &OpticalSystem) -> Box<dyn FnMut() + '_> {
    Box::new(move || drop(black_box(summarize(black_box(system)))))
}

fn report(study: &mut Study, results: &[Measured]) {
    let mut table = Table::new("irradiance", &["rays", "spacing", "rms error", "worst error", "time (µs)"]);
    for result in results {
        let [rms, worst, time] = [result.rms, result.worst, 1e6 * result.seconds].map(digits);
        table.row([result.rays.to_string(), result.spacing.into(), rms, worst, time]);
    }
    study.save(&table);
    let curve = |spacing: &str, x: fn(&Measured) -> f64| {
        let shown = results.iter().filter(|result| result.spacing == spacing);
        Curve { name: spacing.into(), points: shown.map(|r| (x(r), r.rms)).collect(), is_joined: true }
    };
    let axes = ["rays", "rms relative error of 64 bins"];
    let rays = |result: &Measured| f64::from(result.rays);
    let curves: Vec<_> = SPACINGS.map(|spacing| curve(spacing, rays)).into();
    for (spacing, curve) in SPACINGS.iter().zip(&curves) {
        let order = -slope(&curve.points);
        let name = format!("irradiance: order of convergence, {spacing}");
        match *spacing {
            "random" => study.figures.counted(&name, order),
            _ => study.figures.at_least(&name, order, 0.85),
        }
    }
    study.draw("irradiance", &[Panel { title: "Irradiance on a screen".into(), axes, curves }]);
}

/// Relative errors of the power in each bin.
fn errors(system: &OpticalSystem) -> Vec<f64> {
    let summary = summarize(system);
    let mut power = [0.0; BINS];
    let width = 2.0 * REACH / BINS as f64;
    for hit in &summary.screens[0].hits {
        let place = (hit.position - SCREEN + REACH) / width;
        if (0.0..BINS as f64).contains(&place) {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a bin's number")]
            let bin = place as usize;
            power[bin] += hit.power;
        }
    }
    let edge = |k: usize| libm::atan((k as f64 * width - REACH) / HEIGHT);
    power.iter().enumerate().map(|(k, power)| power / ((edge(k + 1) - edge(k)) / SPREAD) - 1.0).collect()
}

/// Half the screen's length: its position counts from the left end.
const SCREEN: f64 = 25.0;

/// A source of power 1 whose rays are spaced so over `SPREAD`, turned a little so that no symmetry helps.
fn system(spacing: &str, rays: u32, random: &mut Random) -> OpticalSystem {
    let from = DVec2::new(0.0, HEIGHT);
    let middle = -90.0 + 2.0 * (random.unit() - 0.5);
    let phase = random.unit();
    let sources = if spacing == SPACINGS[0] {
        vec![source(Light::Fan { from, direction: Direction::Angle(middle), spread: SPREAD.to_degrees(), rays })]
    } else {
        let share = |k| match spacing {
            "golden ratio" => golden(k, phase),
            "stratified" => (f64::from(k) + random.unit()) / f64::from(rays),
            _ => random.unit(),
        };
        let degrees = (0..rays).map(share).map(|share| middle + SPREAD.to_degrees() * (share - 0.5));
        let ray = |degrees| Light::Ray { from, direction: Direction::Angle(degrees) };
        degrees
            .map(|degrees| {
                let mut source = source(ray(degrees));
                source.power = f64::from(rays).recip();
                source
            })
            .collect()
    };
    let shape = Shape::Flat { from: DVec2::new(-SCREEN, 0.0), to: DVec2::new(SCREEN, 0.0) };
    let substance = Substance::Surface(Surface::Screen);
    let screen = Body::new(shape, substance);
    compile(&Scene::new(vec![screen], sources)).unwrap().system
}

/// The fractional part of `phase` + k φ, φ the golden ratio: a sequence that fills 0 to 1 evenly at any length.
pub(crate) fn golden(k: u32, phase: f64) -> f64 {
    (phase + f64::from(k) * 0.5 * (1.0 + 5.0_f64.sqrt())).fract()
}

/// The slope of log y against log x, by least squares.
pub(crate) fn slope(points: &[(f64, f64)]) -> f64 {
    let logs: Vec<_> = points.iter().map(|(x, y)| (libm::log(*x), libm::log(*y))).collect();
    let count = logs.len() as f64;
    let mean = |part: fn(&(f64, f64)) -> f64| logs.iter().map(part).sum::<f64>() / count;
    let (x0, y0) = (mean(|p| p.0), mean(|p| p.1));
    let sum = |part: fn(f64, f64) -> f64| logs.iter().map(|(x, y)| part(x - x0, y - y0)).sum::<f64>();
    sum(|x, y| x * y) / sum(|x, _| x * x)
}
