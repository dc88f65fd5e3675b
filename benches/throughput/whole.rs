//! Threads, and compiling.

use parry2d_f64::partitioning::BvhBuildStrategy::Binned;
use snellius::summarize;

use crate::contest::followed;
use crate::figures::Bound;
use crate::optics::{by_power, compile, scattered};
use crate::parry::boxes;
use crate::race::{Task, race};
use crate::study::Study;

/// Two threads against one.
pub(crate) fn threads(study: &mut Study) {
    let system = compile(&by_power(scattered(500, 5, study.size(4, 128)))).unwrap().system;
    let segments = followed(&system);
    assert!(study.size(true, segments >= 400_000), "{segments} segments are too few");
    let [one, two] = [1, 2].map(|threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap());
    let tasks = vec![
        Task::new("1", segments, || one.install(|| summarize(&system))),
        Task::new("2", segments, || two.install(|| summarize(&system))),
    ];
    let times = race(study, tasks);
    study.figures.ratio("threads_2", times.of("1") / times.of("2"), Bound::AtLeast { bound: 1.8, goal: 1.95 });
}

/// Compiling a scene against building parry2d's hierarchy over its edges.
pub(crate) fn compiling(study: &mut Study, is_feasible: bool) {
    let (edges, power) = study.size((10_000, 4), (1_000_000, 6));
    let name = format!("compile_vs_parry2d_1e{power}");
    let bound = Bound::AtMost { bound: 3.0, goal: 1.5 };
    if !is_feasible {
        return study.figures.unmeasured(&name, "compiling takes too long", bound);
    }
    let scene = by_power(scattered(edges / 10, 10, 1));
    let curves: Vec<_> = compile(&scene).unwrap().system.interfaces().iter().map(|one| one.curve).collect();
    let tasks = vec![
        Task::new("compile", edges as u64, || compile(&scene).unwrap()),
        Task::new("parry2d", edges as u64, || boxes(&curves, Binned)),
    ];
    let times = race(study, tasks);
    study.figures.ratio(&name, times.of("compile") / times.of("parry2d"), bound);
}
