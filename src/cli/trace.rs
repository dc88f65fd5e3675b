use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::console::{Fault, Mistake, Status};
use super::limits::Allowance;
use super::output::Target;
use super::progress;
use super::scene;
use super::stats::{Stats, Stopwatch};
use crate::report;
use crate::trace::{self, RayTree};

/// Trace a scene and print what became of every ray.
#[derive(Args)]
pub(super) struct Trace {
    /// Scene file; '-' is standard input.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Form of the result; otherwise the extension of -o decides, and without one it is text.
    #[arg(long, value_enum)]
    format: Option<Format>,
    /// File to write; '-' is standard output.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Print on standard error what was done and what was skipped, where the light went, and the times.
    #[arg(long)]
    stats: bool,
    #[command(flatten)]
    allowance: Allowance,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// The ray tree by address, for reading and for snapshot tests.
    Text,
    /// One object with every field.
    Json,
    /// One row a segment.
    Csv,
    /// The JSON object without its rays, which are not stored: for millions of them.
    Summary,
}

impl Format {
    fn of_extension(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "txt" | "text" => Some(Self::Text),
            "json" => Some(Self::Json),
            "csv" => Some(Self::Csv),
            _ => None,
        }
    }
}

impl Trace {
    pub(super) fn run(&self) -> Result<Status, Mistake> {
        let target = self.output.as_deref().map_or(Target::Stdout, Target::from_argument);
        target.refuse_to_overwrite(std::slice::from_ref(&self.scene))?;
        let format = self.format(&target)?;
        Ok(Status::of(self.trace(&target, format)))
    }

    fn format(&self, target: &Target) -> Result<Format, Mistake> {
        target.form(self.format, Format::Text, Format::of_extension, "txt, json and csv")
    }

    fn trace(&self, target: &Target, format: Format) -> Result<(), Fault> {
        let mut watch = Stopwatch::start();
        let ready = scene::prepare(&self.scene, &self.allowance.limits(), &mut watch)?;
        let system = &ready.system;
        watch.begin("tracing");
        let (trace, keeps_tree) = if format == Format::Summary {
            let summary = trace::summarize_watched(system, &progress::count);
            (trace::Trace { tree: RayTree::default(), summary }, false)
        } else {
            (trace::trace_watched(system, &progress::count), true)
        };
        ready.warn_of_light(&self.scene, keeps_tree.then_some(&trace.tree));
        watch.begin("writing");
        target.write(|mut out| match format {
            Format::Csv => report::write_csv(&mut out, system, &trace.tree),
            Format::Json => report::write_json(&mut out, system, &trace),
            Format::Summary => report::write_summary_json(&mut out, system, &trace.summary),
            Format::Text => report::write_text(&mut out, system, &trace),
        })?;
        if self.stats {
            Stats { system, summary: &trace.summary, keeps_tree, figure: None }.show(&scene::name(&self.scene), &watch);
        }
        Ok(())
    }
}
