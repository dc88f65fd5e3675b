//! Every command and flag through the real program: results, streams, files and exit statuses.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

#[path = "cli/check.rs"]
mod check;
#[path = "cli/explain.rs"]
mod explain;
#[path = "cli/files.rs"]
mod files;
#[cfg(unix)]
#[path = "cli/interrupt.rs"]
mod interrupt;
#[path = "cli/odd_files.rs"]
mod odd_files;
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
#[path = "cli/trace.rs"]
mod trace;
