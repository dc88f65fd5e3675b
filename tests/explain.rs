//! Worked solutions are right: from the numbers that they print, every result follows.
//!
//! A printed number stands for all that round to it. From these intervals each line is worked out anew, by laws that are
//! written down here and not taken from the program, and the printed result must lie within what comes out, to half a unit of its
//! last digit. So each line has the tolerance that its own numbers leave it.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]
#![allow(clippy::disallowed_methods, reason = "functions other than the program's own, on purpose")]

#[path = "explain/derivation.rs"]
mod derivation;
#[path = "explain/formula.rs"]
mod formula;
#[path = "explain/interval.rs"]
mod interval;
#[path = "explain/laws.rs"]
mod laws;
#[path = "explain/page.rs"]
mod page;
#[path = "explain/scenes.rs"]
mod scenes;
mod support;
