use std::path::{Path, PathBuf};

use clap::Args;

use super::console::{Mistake, Status, summarize};
use super::output::Target;
use super::scene::{self, refuse_two_stdins};
use super::stats::Stopwatch;

/// Check scenes and show every problem in them.
#[derive(Args)]
pub(super) struct Check {
    /// Scene files; '-' is standard input.
    #[arg(value_name = "SCENE", required = true)]
    scenes: Vec<PathBuf>,
}

impl Check {
    pub(super) fn run(&self) -> Result<Status, Mistake> {
        refuse_two_stdins(&self.scenes)?;
        let fails = |path: &&Path| {
            let checked = scene::prepare(path, &mut Stopwatch::start()).and_then(|ready| {
                let verdict = match ready.warnings {
                    0 => "ok".into(),
                    1 => "ok, 1 warning".into(),
                    many => format!("ok, {many} warnings"),
                };
                Target::Stdout.write(|out| writeln!(out, "{}: {verdict}", scene::name(path)))
            });
            Status::of(checked) == Status::Fault
        };
        let failed: Vec<_> = self.scenes.iter().map(PathBuf::as_path).filter(fails).collect();
        Ok(summarize(&failed, self.scenes.len(), ""))
    }
}
