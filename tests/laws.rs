//! Laws that hold in every scene: properties over random scenes, symmetries, each rule of the scene format by a case of its
//! own, and rays aimed where a tracer leaks.
//!
//! `SNELLIUS_TIMES=100 cargo test --release --test laws` runs a hundred times as many cases.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::float_cmp,
    reason = "a test fails by panicking and compares exact bits on purpose"
)]

mod support;

#[path = "laws/endings.rs"]
mod endings;
#[path = "laws/finds.rs"]
mod finds;
#[path = "laws/leaks.rs"]
mod leaks;
#[path = "laws/oracle.rs"]
mod oracle;
#[path = "laws/overlaps.rs"]
mod overlaps;
#[path = "laws/properties.rs"]
mod properties;
#[path = "laws/scenes.rs"]
mod scenes;
#[path = "laws/sources.rs"]
mod sources;
#[path = "laws/surfaces.rs"]
mod surfaces;
#[path = "laws/symmetries.rs"]
mod symmetries;

use proptest::test_runner::{Config, RngSeed};

/// Half an ulp of 1: the relative error of one rounding.
pub(crate) const U: f64 = 0.5 * f64::EPSILON;

/// How many times the usual number of cases to run.
pub(crate) fn times() -> u32 {
    std::env::var("SNELLIUS_TIMES").ok().and_then(|times| times.parse().ok()).unwrap_or(1)
}

/// The same cases in every run, `cases` of them.
pub(crate) fn config(cases: u32) -> Config {
    Config {
        cases: cases * times(),
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(1621),
        max_shrink_iters: 4000,
        ..Config::default()
    }
}
