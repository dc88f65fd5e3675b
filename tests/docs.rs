//! What README.md and docs/ show is true: scenes compile, command lines run, outputs are those of the program, and the
//! references name every word of the scene file and every field of the trace.
//!
//! - A block marked `ron` is a whole scene. If its first line is a comment like `// prism.ron`, the command lines of the
//!   same page find it under this name.
//! - A block marked `ron,fragment` is entries of `bodies`, of `sources`, or fields of a scene.
//! - A block marked `sh` holds command lines. A page runs from top to bottom, word for word, in an empty folder of its own, in
//!   `sh -e` with the program on its path, and must not fail. So a page makes the files that it uses: by a command such as
//!   `snellius new`, or by a `ron` block with a name, which is written when its turn comes. Command lines for the project's own
//!   folder are not run; docs/commands.rs lists them.
//! - A block marked `sh fails` shows a mistake: the same, but it must fail.
//! - A block marked `text` right after one of these shows what that prints: what goes to standard output, of a mistake
//!   also what goes to standard error.
//! - A picture in a folder of the page's name, such as `first-figure/prism.svg`, is the file of that name that the page's
//!   commands write, or is drawn from the scene that lies beside it.
//! - A block marked `json` is the JSON trace of the page's scene, or a part of it, and one marked `csv` its first line.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test that cannot go on fails")]

#[path = "docs/accuracy.rs"]
mod accuracy;
#[path = "docs/commands.rs"]
mod commands;
#[path = "docs/contributing.rs"]
mod contributing;
#[path = "../benches/support/page.rs"]
mod filled_page;
#[path = "docs/links.rs"]
mod links;
#[path = "docs/page.rs"]
mod page;
#[path = "docs/pictures.rs"]
mod pictures;
#[path = "docs/reliability.rs"]
mod reliability;
#[path = "docs/scene_format.rs"]
mod scene_format;
#[path = "docs/scenes.rs"]
mod scenes;
mod support;
#[allow(dead_code, reason = "only what is read is needed")]
#[path = "../benches/support/table.rs"]
mod table;
#[path = "docs/trace_format.rs"]
mod trace_format;
