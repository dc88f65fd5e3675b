//! Every command and flag through the real program: results, streams, files and exit statuses.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

#[cfg(unix)]
#[path = "cli/access.rs"]
mod access;
#[path = "cli/check.rs"]
mod check;
#[cfg(unix)]
#[path = "cli/crash.rs"]
mod crash;
#[path = "cli/explain.rs"]
mod explain;
#[path = "cli/files.rs"]
mod files;
#[cfg(unix)]
#[path = "cli/interrupt.rs"]
mod interrupt;
#[path = "cli/limits.rs"]
mod limits;
#[path = "cli/many.rs"]
mod many;
#[path = "cli/odd_files.rs"]
mod odd_files;
#[cfg(unix)]
#[path = "cli/paths.rs"]
mod paths;
#[path = "cli/pictures.rs"]
mod pictures;
#[path = "cli/place.rs"]
mod place;
#[path = "cli/problems.rs"]
mod problems;
#[path = "cli/program.rs"]
mod program;
#[path = "cli/render.rs"]
mod render;
#[path = "cli/stats.rs"]
mod stats;
#[cfg(unix)]
#[path = "cli/streams.rs"]
mod streams;
#[path = "cli/trace.rs"]
mod trace;
