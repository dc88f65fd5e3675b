use std::path::PathBuf;

use clap::Args;

use super::console::{Mistake, Status};
use super::limits::Allowance;
use super::output::Target;
use super::scene::{self, refuse_two_stdins};
use super::stats::Stopwatch;

/// Check scenes and show every problem in them.
#[derive(Args)]
pub(super) struct Check {
    /// Scene files; '-' is standard input.
    #[arg(value_name = "SCENE", required = true)]
    scenes: Vec<PathBuf>,
    #[command(flatten)]
    allowance: Allowance,
}

impl Check {
    pub(super) fn run(&self) -> Result<Status, Mistake> {
        refuse_two_stdins(&self.scenes)?;
        let limits = self.allowance.limits();
        Ok(self.scenes.iter().fold(Status::Done, |status, path| {
            let checked = scene::prepare(path, &limits, &mut Stopwatch::start()).and_then(|ready| {
                let verdict = match ready.warnings {
                    0 => "ok".into(),
                    1 => "ok, 1 warning".into(),
                    many => format!("ok, {many} warnings"),
                };
                Target::Stdout.write(|out| writeln!(out, "{}: {verdict}", scene::name(path)))
            });
            status.and(Status::of(checked))
        }))
    }
}
