//! Figures in a real browser: no words of a scene run there, and what it shows is what the PNG shows.
//!
//! Chromium is looked for in the PATH (Debian: `apt-get install chromium`). Without it these tests say that they were skipped;
//! with `SNELLIUS_BROWSER=required` they fail.

#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

#[path = "browser/chromium.rs"]
mod chromium;
#[path = "browser/pictures.rs"]
mod pictures;
#[path = "browser/scripts.rs"]
mod scripts;
mod support;
