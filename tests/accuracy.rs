//! How accurate the laws and the tracer are, measured against 237-bit arithmetic. Every figure is printed with its bound.
//!
//! `SNELLIUS_FULL=1 cargo test --release --test accuracy -- --nocapture` measures at full size.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::float_cmp,
    reason = "a test fails by panicking and compares exact bits on purpose"
)]

mod support;

#[path = "accuracy/backward.rs"]
mod backward;
#[path = "accuracy/kernel.rs"]
mod kernel;
#[path = "accuracy/long_runs.rs"]
mod long_runs;
#[path = "accuracy/wide.rs"]
mod wide;

#[path = "laws/scenes.rs"]
#[allow(dead_code, reason = "the laws' tests use all of it")]
mod scenes;
