//! The library takes any value: no public function panics, runs on or takes memory without end, whatever it is given, and
//! results that belong to different scenes, edited trees and drawings made by hand do no harm.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test fails by panicking")]

#[path = "public_api/drawings.rs"]
mod drawings;
#[path = "public_api/hostile.rs"]
mod hostile;
#[path = "public_api/numbers.rs"]
mod numbers;
#[path = "public_api/scenes.rs"]
mod scenes;
#[path = "public_api/trees.rs"]
mod trees;
#[path = "public_api/types.rs"]
mod types;

use proptest::test_runner::{Config, RngSeed};

/// The same cases in every run, `cases` of them, a hundred times as many with `SNELLIUS_FULL`.
pub(crate) fn config(cases: u32) -> Config {
    let cases = if std::env::var_os("SNELLIUS_FULL").is_some() { 100 * cases } else { cases };
    Config { cases, failure_persistence: None, rng_seed: RngSeed::Fixed(1621), ..Config::default() }
}
