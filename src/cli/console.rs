use std::fmt::Display;
use std::io::{self, Write};
use std::process::ExitCode;

use super::progress;

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

    /// Done only where both are.
    pub(super) fn and(self, other: Self) -> Self {
        if self == Self::Done { other } else { self }
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

/// Puts words on standard error; a closed stream is nobody's fault.
pub(super) fn tell(words: impl Display) {
    drop(progress::clear());
    let _ = writeln!(io::stderr().lock(), "{words}");
}

/// Why a file cannot be read or written, without the system's error number.
pub(super) fn reason(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "there is no such file or folder".into(),
        io::ErrorKind::PermissionDenied => "permission denied".into(),
        io::ErrorKind::IsADirectory => "this is a folder, not a file".into(),
        io::ErrorKind::NotADirectory => "part of the path is a file, not a folder".into(),
        io::ErrorKind::StorageFull => "no space is left".into(),
        io::ErrorKind::AlreadyExists => "this is a file, not a folder".into(),
        _ => error.to_string().split(" (os error").next().unwrap_or_default().into(),
    }
}
