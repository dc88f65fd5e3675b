//! What README.md and docs/ show is true: scenes compile, command lines run, outputs are those of the program, and the
//! references name every word of the scene file and every field of the trace.
//!
//! - A block marked `ron` is a whole scene. If its first line is a comment like `// prism.ron`, the command lines of the
//!   same page find it under this name.
//! - A block marked `ron,fragment` is entries of `bodies`, of `sources`, or fields of a scene.
//! - A block marked `sh` holds command lines; they run one after the other in a folder of the page's own. A block marked
//!   `text` right after it shows what the last of them prints.
//! - A block marked `json` is the JSON trace of the page's scene, or a part of it, and one marked `csv` its first line.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test that cannot go on fails")]

#[path = "docs/accuracy.rs"]
mod accuracy;
#[path = "docs/commands.rs"]
mod commands;
#[path = "../benches/support/page.rs"]
mod filled_page;
#[path = "docs/links.rs"]
mod links;
#[path = "docs/page.rs"]
mod page;
#[path = "docs/scene_format.rs"]
mod scene_format;
#[path = "docs/scenes.rs"]
mod scenes;
#[allow(dead_code, reason = "only what is read is needed")]
#[path = "../benches/support/table.rs"]
mod table;
#[path = "docs/trace_format.rs"]
mod trace_format;
