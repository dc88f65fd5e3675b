//! The `snellius` command: one file a subcommand.
//!
//! Results go to standard output, everything else to standard error. The exit status is 0 when all is done, 1 when a
//! scene or a file is at fault, 2 when the command line is, 130 when a user or the system ends the command early.

mod check;
mod console;
mod explain;
mod interrupt;
mod materials;
mod new;
mod output;
mod progress;
mod render;
mod scene;
mod stats;
mod trace;

use std::process::ExitCode;

use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, Subcommand};

use console::{Mistake, Status, tell};
use output::Target;

/// Ray diagrams from the vector law of refraction.
#[derive(Parser)]
#[command(name = "snellius", version, arg_required_else_help = true, subcommand_required = true)]
#[command(after_help = "Start with 'snellius new prism > prism.ron' and 'snellius render prism.ron'.")]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Render(render::Render),
    Trace(trace::Trace),
    Explain(explain::Explain),
    Check(check::Check),
    Materials(materials::Materials),
    New(new::New),
}

impl Command {
    fn run(&self) -> Result<Status, Mistake> {
        match self {
            Self::Render(render) => render.run(),
            Self::Trace(trace) => trace.run(),
            Self::Explain(explain) => explain.run(),
            Self::Check(check) => check.run(),
            Self::Materials(materials) => materials.run(),
            Self::New(new) => Ok(new.run()),
        }
    }

    /// The word on the command line.
    fn name(&self) -> &'static str {
        match self {
            Self::Render(_) => "render",
            Self::Trace(_) => "trace",
            Self::Explain(_) => "explain",
            Self::Check(_) => "check",
            Self::Materials(_) => "materials",
            Self::New(_) => "new",
        }
    }
}

/// Runs the command that the process was started with.
#[must_use]
pub fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => return show(&error),
    };
    match cli.command.run() {
        Ok(status) => status.into(),
        Err(Mistake(message)) => show(&mistake(cli.command.name(), message)),
    }
}

/// A mistake of the command line, shown with the subcommand's usage.
fn mistake(subcommand: &str, message: String) -> clap::Error {
    let mut command = Cli::command();
    command.build();
    let mut command = command.find_subcommand_mut(subcommand).map(std::mem::take).unwrap_or(command);
    command.error(ErrorKind::ArgumentConflict, message)
}

/// Shows help, version or a mistake where each belongs.
fn show(error: &clap::Error) -> ExitCode {
    let words = error.render().to_string();
    if error.use_stderr() {
        tell(words.trim_end());
        return ExitCode::from(2);
    }
    Status::of(Target::Stdout.write(|out| out.write_all(words.as_bytes()))).into()
}
