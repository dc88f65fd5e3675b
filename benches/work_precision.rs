//! Time against error: how much accuracy a form of the law, a facet, a cut or a ray buys, and what it costs.
//!
//! `cargo bench --bench work_precision` measures and writes `docs/accuracy`: a table (CSV) and a plot (SVG) per study, and
//! the tables of `docs/accuracy.md`. With `-- --quick` it measures less and writes `target/work_precision` instead.
//! Competitors are timed in turns within one run. A key figure past its bound is reported, and ends the program with 1.

#![allow(missing_docs, reason = "a program")]
#![allow(unreachable_pub, dead_code, clippy::unwrap_used, reason = "a measurement that cannot go on fails")]

#[path = "support/clock.rs"]
mod clock;
#[path = "work_precision/cuts.rs"]
mod cuts;
#[path = "work_precision/double_double.rs"]
mod double_double;
#[path = "support/figures.rs"]
mod figures;
#[path = "work_precision/forms.rs"]
mod forms;
#[path = "work_precision/incidences.rs"]
mod incidences;
#[path = "work_precision/irradiance.rs"]
mod irradiance;
#[path = "work_precision/lens.rs"]
mod lens;
#[path = "support/machine.rs"]
mod machine;
#[path = "support/page.rs"]
mod page;
#[path = "support/plot.rs"]
mod plot;
#[path = "../tests/support/random.rs"]
mod random;
#[path = "support/scenes.rs"]
mod scenes;
#[path = "support/study.rs"]
mod study;
#[path = "support/table.rs"]
mod table;
#[path = "work_precision/truth.rs"]
mod truth;
#[path = "../tests/support/wide.rs"]
mod wide;

use std::process::ExitCode;

use study::Study;

fn main() -> ExitCode {
    let is_asked = |name: &str| std::env::args().any(|argument| argument == name);
    // `cargo test --benches` starts this program too, but does not mean to measure.
    if !is_asked("--bench") && !is_asked("--quick") {
        println!("nothing measured: `cargo bench --bench work_precision` does");
        return ExitCode::SUCCESS;
    }
    let mut study = Study::new("work_precision", "accuracy", is_asked("--quick"));
    forms::run(&mut study);
    lens::run(&mut study);
    cuts::run(&mut study);
    irradiance::run(&mut study);
    study.save(&machine::table());
    study.finish()
}
