use std::time::{Duration, Instant};

use super::console::tell;
use crate::system::OpticalSystem;
use crate::trace::{Ending, RayTree, Summary};

/// The time of each phase of a job.
pub(super) struct Stopwatch {
    since: Instant,
    phases: Vec<(&'static str, Duration)>,
}

impl Stopwatch {
    /// Starts the first phase.
    pub(super) fn start() -> Self {
        Self { since: Instant::now(), phases: Vec::new() }
    }

    /// Ends a phase and starts the next.
    pub(super) fn lap(&mut self, phase: &'static str) {
        let now = Instant::now();
        self.phases.push((phase, now - self.since));
        self.since = now;
    }
}

/// Puts the numbers of a job on standard error: what was traced, where the power went, how long each phase took.
pub(super) fn show(name: &str, system: &OpticalSystem, summary: &Summary, tree: Option<&RayTree>, watch: &Stopwatch) {
    let mut lines = vec![format!("stats of {name}")];
    let mut line = |what: &str, value: String| lines.push(format!("  {what:18}{value}"));
    line("bodies", system.bodies().len().to_string());
    line(
        "interfaces",
        format!("{}, {} pieces of boundary dropped", system.interfaces().len(), system.dropped_boundaries()),
    );
    line("rays", summary.rays.to_string());
    let followed = tree.map_or_else(String::new, |tree| format!(", {} followed", followed(tree)));
    line("segments", format!("{}{followed}", summary.segments));
    let emitted = summary.balance.emitted.value();
    for (ending, sum) in endings(summary) {
        let number = tree.map_or_else(String::new, |tree| format!("{}, ", segments(count(tree, ending))));
        line(
            ending.word(),
            format!("{number}{:.4} % of the power", if emitted > 0.0 { 100.0 * sum / emitted } else { 0.0 }),
        );
    }
    line("residual", format!("{:e}", summary.balance.residual()));
    for (phase, time) in &watch.phases {
        line(phase, format!("{:.3} ms", 1000.0 * time.as_secs_f64()));
    }
    tell(lines.join("\n"));
}

/// The endings at which power leaves a tree, and how much.
fn endings(summary: &Summary) -> [(Ending, f64); 6] {
    let balance = &summary.balance;
    [
        (Ending::Escaped, balance.escaped.value()),
        (Ending::Absorbed, balance.absorbed.value()),
        (Ending::Detected, balance.detected.value()),
        (Ending::CutMinPower, balance.cut_min_power.value()),
        (Ending::CutMaxDepth, balance.cut_max_depth.value()),
        (Ending::CutMaxSegments, balance.cut_max_segments.value()),
    ]
}

fn count(tree: &RayTree, ending: Ending) -> usize {
    tree.rays.iter().flat_map(|ray| &ray.segments).filter(|segment| segment.ending == ending).count()
}

fn followed(tree: &RayTree) -> usize {
    let cut = [Ending::CutMinPower, Ending::CutMaxDepth, Ending::CutMaxSegments];
    tree.rays.iter().flat_map(|ray| &ray.segments).filter(|segment| !cut.contains(&segment.ending)).count()
}

fn segments(number: usize) -> String {
    format!("{number} segment{}", if number == 1 { "" } else { "s" })
}
