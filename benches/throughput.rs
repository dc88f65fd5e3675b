//! How fast a trace is, against other ways to do the same and against the least it can cost.
//!
//! `cargo bench --bench throughput` measures, prints a line `RATIO name value` per key figure, and writes `docs/performance`:
//! a table (CSV) per study, plots (SVG), and the tables of `docs/performance.md`. With `-- --quick` it measures less, holds the
//! figures to loose bounds and writes `target/throughput` instead. Competitors are timed in turns within one run, on one
//! thread. A figure past its bound is reported, and ends the program with 1. After names of studies (`-- traces edges`) only they
//! are measured, and written to `target/throughput`.

#![allow(missing_docs, reason = "a program")]
#![allow(unreachable_pub, dead_code, clippy::unwrap_used, reason = "a measurement that cannot go on fails")]

#[path = "support/clock.rs"]
mod clock;
#[path = "throughput/contest.rs"]
mod contest;
#[path = "support/figures.rs"]
mod figures;
#[path = "throughput/flat.rs"]
mod flat;
#[path = "throughput/floor.rs"]
mod floor;
#[path = "throughput/growth.rs"]
mod growth;
#[path = "support/machine.rs"]
mod machine;
#[path = "throughput/nearest.rs"]
mod nearest;
#[path = "throughput/optics.rs"]
mod optics;
#[path = "support/page.rs"]
mod page;
#[path = "throughput/parry.rs"]
mod parry;
#[path = "throughput/pictures.rs"]
mod pictures;
#[path = "support/plot.rs"]
mod plot;
#[path = "throughput/race.rs"]
mod race;
#[path = "../tests/support/random.rs"]
mod random;
#[path = "throughput/scalar.rs"]
mod scalar;
#[path = "support/scenes.rs"]
mod scenes;
#[path = "support/study.rs"]
mod study;
#[path = "support/table.rs"]
mod table;
#[path = "throughput/traces.rs"]
mod traces;
#[path = "throughput/whole.rs"]
mod whole;

use std::process::ExitCode;

use study::Study;

/// Each may be asked for alone.
const STUDIES: [&str; 7] = ["nearest", "edges", "traces", "sweeps", "pictures", "compiling", "threads"];
/// Factor by which a quick run may miss a bound: only a slip of an order of magnitude counts.
const LOOSE: f64 = 20.0;

fn main() -> ExitCode {
    let is_asked = |name: &str| std::env::args().any(|argument| argument == name);
    // `cargo test --benches` starts this program too, but does not mean to measure.
    if !is_asked("--bench") && !is_asked("--quick") {
        println!("nothing measured: `cargo bench --bench throughput` does");
        return ExitCode::SUCCESS;
    }
    let mut study = Study::new("throughput", "performance", is_asked("--quick"));
    if STUDIES.iter().any(|name| is_asked(name)) {
        study = study.aside();
    }
    study.figures.looseness = study.size(LOOSE, 1.0);
    let one_thread = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    one_thread.install(|| run(&mut study, is_asked));
    study.save(&machine::table());
    study.finish()
}

/// Runs the studies that are asked for, or all.
fn run(study: &mut Study, is_asked: impl Fn(&str) -> bool) {
    let is_meant = |name| is_asked(name) || !STUDIES.iter().any(|name| is_asked(name));
    let mut large_is_feasible = true;
    if is_meant("nearest") {
        nearest::run(study);
    }
    if is_meant("edges") {
        large_is_feasible = growth::edges(study);
    }
    if is_meant("traces") {
        traces::run(study, large_is_feasible);
    }
    if is_meant("sweeps") {
        growth::rays_and_depth(study);
    }
    if is_meant("pictures") {
        pictures::run(study);
    }
    if is_meant("compiling") {
        whole::compiling(study, large_is_feasible);
    }
    if is_meant("threads") {
        whole::threads(study);
    }
}
