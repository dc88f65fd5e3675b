//! The nearest hit of random rays.

use std::cell::RefCell;

use glam::DVec2;
use parry2d_f64::partitioning::BvhBuildStrategy::{Binned, Ploc};
use snellius::scene::{Direction, Light, TraceSettings};
use snellius::{OpticalSystem, Scene, Segment, TracedRay, Visitor, compile, visit};

use crate::contest::{OURS, SCALAR};
use crate::figures::Bound;
use crate::flat::{Flat, NONE};
use crate::optics::{columns, number, scattered};
use crate::parry::Parry;
use crate::race::{Task, Times, race};
use crate::random::Random;
use crate::scalar::Loop;
use crate::scenes::source;
use crate::study::Study;
use crate::table::{Table, digits};

const PARRYS: [&str; 4] = ["binned, own test", "PLOC, own test", "binned, loop's test", "PLOC, loop's test"];

pub(crate) fn run(study: &mut Study) {
    let columns = ["edges", OURS, SCALAR, PARRYS[0], PARRYS[1], PARRYS[2], PARRYS[3]];
    let mut table = Table::new("nearest", &columns);
    for (edges, name) in [(100, "1e2"), (1000, "1e3"), (10_000, "1e4")] {
        let times = measure(study, edges);
        let time = |name| digits(times.of(name));
        let [binned_own, ploc_own, binned, ploc] = PARRYS.map(time);
        table.row([edges.to_string(), time(OURS), time(SCALAR), binned_own, ploc_own, binned, ploc]);
        let ratio = times.least(&PARRYS) / times.of(OURS);
        let bound = Bound::AtLeast { bound: 2.0, goal: 3.0 };
        study.figures.ratio(&format!("nearest_vs_parry2d_{name}"), ratio, bound);
    }
    study.save(&table);
}

fn measure(study: &Study, edges: usize) -> Times {
    let rays = study.size(300, 3000);
    let system = system(edges / 5, rays);
    let flat = Flat::new(&system, 0.0, 1);
    let scalar = Loop::new(&flat);
    let [binned, ploc] = [Binned, Ploc].map(|strategy| Parry::new(&flat.curves, strategy));
    let each = |nearest: &dyn Fn(DVec2, DVec2) -> Option<(usize, f64)>| {
        flat.starts.iter().map(|&(from, ahead, _)| nearest(from, ahead).map_or(-1.0, |hit| hit.1)).sum::<f64>()
    };
    let sum = RefCell::new(Distances(0.0));
    let ours = || {
        let mut distances = sum.borrow_mut();
        distances.0 = 0.0;
        visit(&system, &mut *distances);
        distances.0
    };
    let others = || each(&|from, ahead| scalar.nearest(from, ahead, NONE));
    assert!((ours() / others() - 1.0).abs() < 1e-6, "the same hits: {} and {}", ours(), others());
    let count = rays as u64;
    let tasks = vec![
        Task::new(OURS, count, ours),
        Task::new(SCALAR, count, others),
        Task::new(PARRYS[0], count, || each(&|from, ahead| binned.nearest_with_its_own_test(from, ahead, NONE))),
        Task::new(PARRYS[1], count, || each(&|from, ahead| ploc.nearest_with_its_own_test(from, ahead, NONE))),
        Task::new(PARRYS[2], count, || each(&|from, ahead| binned.nearest(from, ahead, NONE))),
        Task::new(PARRYS[3], count, || each(&|from, ahead| ploc.nearest(from, ahead, NONE))),
    ];
    race(study.size(3, 11), tasks)
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
    let trace = TraceSettings { max_depth: 1, ..TraceSettings::default() };
    compile(&Scene { sources, trace, ..scattered(polygons, 5, 0) }).unwrap().system
}

/// The sum of the distances to first hits, −1 for none.
struct Distances(f64);

impl Visitor for Distances {
    fn segment(&mut self, _: &TracedRay, segment: Segment) {
        if segment.parent.is_none() {
            self.0 += segment.to.map_or(-1.0, |to| to.distance(segment.from));
        }
    }
}
