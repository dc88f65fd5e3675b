use std::fmt::Display;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

use super::progress;
use super::scene::name;
use crate::characters::harmless;

/// How a command went.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Status {
    /// All is done.
    Done,
    /// A scene or a file was at fault; standard error says which and why.
    Fault,
}

/// What is wrong with a scene or a file, ready to be shown.
#[derive(Debug)]
pub(super) struct Fault(pub(super) String);

/// What is wrong with the command line.
#[derive(Debug)]
pub(super) struct Mistake(pub(super) String);

impl Status {
    /// The status of a job, its fault shown.
    pub(super) fn of(result: Result<(), Fault>) -> Self {
        match result {
            Ok(()) => Self::Done,
            Err(Fault(message)) => {
                tell(message);
                Self::Fault
            }
        }
    }
}

impl From<Status> for ExitCode {
    fn from(status: Status) -> Self {
        match status {
            Status::Done => Self::SUCCESS,
            Status::Fault => Self::FAILURE,
        }
    }
}

/// Puts words on standard error; a closed stream is nobody's fault. Nothing in them steers the terminal, wherever it comes from.
pub(super) fn tell(words: impl Display) {
    drop(progress::clear());
    let lines: Vec<_> = words.to_string().split('\n').map(|line| harmless(line).into_owned()).collect();
    let _ = writeln!(io::stderr().lock(), "{}", lines.join("\n"));
}

/// A path in messages: on one line, whatever its characters.
pub(super) fn legible(path: &Path) -> String {
    harmless(&path.display().to_string()).into_owned()
}

/// The status of a job of several scenes. Those that failed are named at its end, since what was said of them may have scrolled
/// away; `outcome` tells what came of it.
pub(super) fn summarize(failed: &[&Path], scenes: usize, outcome: &str) -> Status {
    if failed.is_empty() {
        return Status::Done;
    }
    if scenes > 1 {
        let names: Vec<_> = failed.iter().map(|path| name(path)).collect();
        tell(format!("{} of {scenes} scenes failed{outcome}: {}", failed.len(), names.join(", ")));
    }
    Status::Fault
}

/// Why a file cannot be read or written, without the system's error number.
pub(super) fn reason(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "there is no such file or folder".into(),
        io::ErrorKind::PermissionDenied => "permission denied".into(),
        io::ErrorKind::IsADirectory => "this is a folder, not a file".into(),
        io::ErrorKind::NotADirectory => "part of the path is a file, not a folder".into(),
        io::ErrorKind::StorageFull => "no space is left".into(),
        io::ErrorKind::InvalidFilename => "the name is too long, or no name for a file".into(),
        io::ErrorKind::AlreadyExists => "this is a file, not a folder".into(),
        _ => error.to_string().split(" (os error").next().unwrap_or_default().into(),
    }
}
