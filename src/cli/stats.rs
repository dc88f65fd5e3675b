use std::time::Instant;

use super::console::tell;
use super::progress;
use crate::diagram::Statistics;
use crate::numerics::Sum;
use crate::system::OpticalSystem;
use crate::trace::{Ending, Summary};

/// The time of each phase of a job, the first of which is reading.
pub(super) struct Stopwatch {
    /// When each phase began.
    phases: Vec<(&'static str, Instant)>,
}

impl Stopwatch {
    /// Starts the first phase.
    pub(super) fn start() -> Self {
        let mut watch = Self { phases: Vec::with_capacity(8) };
        watch.begin("reading");
        watch
    }

    /// Ends a phase and starts the next.
    pub(super) fn begin(&mut self, phase: &'static str) {
        let now = Instant::now();
        self.phases.push((phase, now));
        progress::begin(phase, self.phases[0].1);
    }

    /// Seconds of each phase, the last one until now.
    fn seconds(&self) -> impl Iterator<Item = (&'static str, f64)> {
        let ends = self.phases.iter().skip(1).map(|(_, end)| *end).chain([Instant::now()]);
        self.phases.iter().zip(ends).map(|((phase, begin), end)| (*phase, (end - *begin).as_secs_f64()))
    }
}

impl Drop for Stopwatch {
    fn drop(&mut self) {
        drop(progress::clear());
    }
}

/// What a job did, and what it could skip.
pub(super) struct Stats<'a> {
    pub(super) system: &'a OpticalSystem,
    pub(super) summary: &'a Summary,
    /// Whether every segment was kept.
    pub(super) keeps_tree: bool,
    /// What was drawn.
    pub(super) figure: Option<Statistics>,
}

/// A name and what there is to say.
type Line = (&'static str, String);

impl Stats<'_> {
    /// Puts the numbers and the times on standard error.
    pub(super) fn show(&self, name: &str, watch: &Stopwatch) {
        let seconds: Vec<_> = watch.seconds().collect();
        let times = seconds.into_iter().map(|(phase, time)| (phase, format!("{:.3} ms", 1000.0 * time)));
        let lines = self.scene().into_iter().chain(self.work()).chain(self.endings()).chain(self.drawn()).chain(times);
        let lines: Vec<_> = lines.map(|(what, value)| format!("  {what:18}{value}")).collect();
        tell(format!("stats of {name}\n{}", lines.join("\n")));
    }

    fn scene(&self) -> [Line; 3] {
        let dropped = count(self.system.dropped_boundaries(), "piece");
        [
            ("bodies", self.system.bodies().len().to_string()),
            ("interfaces", self.system.interfaces().len().to_string()),
            ("dropped", format!("{dropped} of boundary, between equal media")),
        ]
    }

    fn work(&self) -> [Line; 6] {
        let Summary { rays, segments, work, .. } = self.summary;
        let without = work.hits() - work.fresnel;
        let search = if self.system.tree.is_none() {
            "without a search tree, which so few interfaces do not need".into()
        } else {
            let per_segment = ratio(work.nodes, work.followed);
            format!("{} of the search tree visited, {per_segment:.2} a followed segment", count(work.nodes, "node"))
        };
        let kept = if self.keeps_tree { "stored" } else { "not stored, only its sums" };
        [
            ("rays", rays.to_string()),
            ("segments", format!("{segments}, {} followed", work.followed)),
            (
                "spared",
                format!("{}, copied from another spectral line that goes the same way", count(work.spared, "segment")),
            ),
            ("hits", format!("{}, Fresnel's equations evaluated at {}, not at {without}", work.hits(), work.fresnel)),
            ("search", search),
            ("ray tree", kept.into()),
        ]
    }

    /// Where the power went.
    fn endings(&self) -> impl Iterator<Item = Line> {
        let Summary { balance, work, .. } = self.summary;
        let emitted = balance.emitted.value();
        let endings = [
            (Ending::Escaped, balance.escaped),
            (Ending::Absorbed, balance.absorbed),
            (Ending::Detected, balance.detected),
            (Ending::CutMinPower, balance.cut_min_power),
            (Ending::CutMaxDepth, balance.cut_max_depth),
            (Ending::CutMaxSegments, balance.cut_max_segments),
        ];
        let line = move |(ending, power): (Ending, Sum)| {
            let share = if emitted > 0.0 { 100.0 * power.value() / emitted } else { 0.0 };
            (ending.word(), format!("{}, {share:.4} % of the power", count(work.ended(ending), "segment")))
        };
        endings.into_iter().map(line).chain([("residual", format!("{:e}", balance.residual()))])
    }

    fn drawn(&self) -> Vec<Line> {
        let Some(figure) = self.figure else { return vec![("drawn", "nothing".into())] };
        let (segments, marks) = (count(figure.segments_drawn, "segment"), count(figure.marks_drawn, "mark"));
        let (outside, faint) = (figure.segments_outside_view, figure.segments_below_faintest);
        vec![
            ("drawn", format!("{segments}, {marks}")),
            ("not drawn", format!("{} outside the view, {faint} below faintest", count(outside, "segment"))),
            ("font", if figure.font_used { "used" } else { "not loaded" }.into()),
        ]
    }
}

fn ratio(part: u64, whole: u64) -> f64 {
    #[allow(clippy::cast_precision_loss, reason = "a number to read")]
    let ratio = part as f64 / whole.max(1) as f64;
    ratio
}

fn count<T: std::fmt::Display + PartialEq + From<u8>>(number: T, what: &str) -> String {
    format!("{number} {what}{}", if number == T::from(1) { "" } else { "s" })
}
