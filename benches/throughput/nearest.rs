//! The nearest hit of random rays.

use glam::DVec2;
use parry2d_f64::partitioning::BvhBuildStrategy::{Binned, Ploc};
use snellius::light::Power;
use snellius::scene::{Direction, Light};
use snellius::system::RayStart;
use snellius::trace::{Ray, Search};
use snellius::{OpticalSystem, compile};

use crate::contest::{OURS, SCALAR};
use crate::figures::Bound;
use crate::flat::{Flat, NONE, Nearest};
use crate::optics::{columns, number, scattered};
use crate::parry::Parry;
use crate::race::{Task, Times, race};
use crate::random::Random;
use crate::scalar::Loop;
use crate::scenes::source;
use crate::study::Study;
use crate::table::{Table, digits};

/// Its ray cast with either way to build its hierarchy, and with its own test of an edge or the scalar loop's.
const PARRYS: [&str; 4] = ["binned, own test", "PLOC, own test", "binned, loop's test", "PLOC, loop's test"];
/// Its hierarchy without its ray cast.
const BOXES: &str = "binned, all tests ours";

pub(crate) fn run(study: &mut Study) {
    let columns = ["edges", OURS, SCALAR, PARRYS[0], PARRYS[1], PARRYS[2], PARRYS[3], BOXES];
    let mut table = Table::new("nearest", &columns);
    for (edges, name) in [(100, "1e2"), (1000, "1e3"), (10_000, "1e4")] {
        let times = measure(study, edges);
        let time = |name| digits(times.of(name));
        let [binned_own, ploc_own, binned, ploc] = PARRYS.map(time);
        table.row([edges.to_string(), time(OURS), time(SCALAR), binned_own, ploc_own, binned, ploc, time(BOXES)]);
        let ratio = times.least(&PARRYS) / times.of(OURS);
        let bound = Bound::AtLeast { bound: 2.0, goal: 3.0 };
        study.figures.ratio(&format!("nearest_vs_parry2d_{name}"), ratio, bound);
    }
    study.save(&table);
}

fn measure(study: &Study, edges: usize) -> Times {
    let system = system(edges / 5, study.size(300, 3000));
    let (flat, rays) = (Flat::new(&system, 0.0, 1), rays(&system));
    let scalar = Loop::new(&flat);
    let [binned, ploc] = [Binned, Ploc].map(|strategy| Parry::new(&flat.curves, strategy));
    let tasks = vec![
        Task::new(OURS, flat.starts.len() as u64, || ours(&system, &rays)),
        task(SCALAR, &system, &flat, |from, ahead, last| scalar.nearest(from, ahead, last)),
        task(PARRYS[0], &system, &flat, |from, ahead, last| binned.nearest_with_its_own_test(from, ahead, last)),
        task(PARRYS[1], &system, &flat, |from, ahead, last| ploc.nearest_with_its_own_test(from, ahead, last)),
        task(PARRYS[2], &system, &flat, |from, ahead, last| binned.nearest(from, ahead, last)),
        task(PARRYS[3], &system, &flat, |from, ahead, last| ploc.nearest(from, ahead, last)),
        task(BOXES, &system, &flat, |from, ahead, last| binned.nearest_with_our_tests(from, ahead, last)),
    ];
    race(study, tasks)
}

/// A search that was seen to find what we find.
fn task<'a>(name: &'static str, system: &OpticalSystem, flat: &'a Flat, nearest: impl Nearest + 'a) -> Task<'a> {
    let found = move || {
        let distance =
            |(from, ahead, _): &(DVec2, DVec2, Power)| nearest(*from, *ahead, NONE).map_or(-1.0, |hit| hit.1);
        flat.starts.iter().map(distance).sum::<f64>()
    };
    let (sum, expected) = (found(), ours(system, &rays(system)));
    assert!((sum / expected - 1.0).abs() < 1e-6, "{name}: distances add up to {sum}, not {expected}");
    Task::new(name, flat.starts.len() as u64, found)
}

/// All rays of a system, side by side as those of the other searches are.
fn rays(system: &OpticalSystem) -> Vec<Ray> {
    let starts = system.sources().iter().flat_map(|source| &source.starts);
    starts.map(|&RayStart { from, direction, medium, start, .. }| Ray { from, direction, medium, start }).collect()
}

/// The sum of the distances of rays to what they meet first, −1 for nothing.
fn ours(system: &OpticalSystem, rays: &[Ray]) -> f64 {
    let mut search = Search::new(system);
    rays.iter().map(|ray| search.nearest(ray).map_or(-1.0, |crossing| crossing.distance)).sum()
}

/// Random rays from random points of a field of polygons, followed to their first hit.
fn system(polygons: usize, rays: usize) -> OpticalSystem {
    let mut random = Random(11);
    let across = number(columns(polygons));
    let mut ray = || {
        let from = across * DVec2::new(random.unit(), random.unit());
        source(Light::Ray { from, direction: Direction::Angle(360.0 * random.unit()) })
    };
    let sources = (0..rays).map(|_| ray()).collect();
    let mut scene = scattered(polygons, 5, 0);
    scene.sources = sources;
    compile(&scene).unwrap().system
}
