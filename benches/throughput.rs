//! How fast a trace is, against other ways to do the same and against the least it can cost.
//!
//! `cargo bench --bench throughput` measures, prints a line `RATIO name value` per key figure, and writes `docs/performance`:
//! a table (CSV) per study, plots (SVG), and the tables of `docs/performance.md`. With `-- --quick` it measures less, holds the
//! figures to loose bounds and writes `target/throughput` instead. Competitors are timed in turns within one run, on one
//! thread. A figure past its bound is reported, and ends the program with 1.

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
    study.figures.looseness = study.size(LOOSE, 1.0);
    let one_thread = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    one_thread.install(|| {
        nearest::run(&mut study);
        let large_is_feasible = growth::edges(&mut study);
        traces::run(&mut study, large_is_feasible);
        growth::rays_and_depth(&mut study);
        pictures::run(&mut study);
        whole::compiling(&mut study, large_is_feasible);
    });
    whole::threads(&mut study);
    study.save(&machine::table());
    study.finish()
}
