//! Laws that hold in every scene: properties over random scenes, symmetries, each rule of the scene format by a case of its
//! own, and rays aimed where a tracer leaks.
//!
//! `SNELLIUS_FULL=1 cargo test --release --test laws -- --nocapture` runs at full size.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::float_cmp,
    reason = "a test fails by panicking and compares exact bits on purpose"
)]

mod support;

#[path = "laws/adversary.rs"]
mod adversary;
#[path = "laws/arrangement.rs"]
mod arrangement;
#[path = "laws/curvature.rs"]
mod curvature;
#[path = "laws/endings.rs"]
mod endings;
#[path = "laws/finds.rs"]
mod finds;
#[path = "laws/hits.rs"]
mod hits;
#[path = "laws/leaks.rs"]
mod leaks;
#[path = "laws/oracle.rs"]
mod oracle;
#[path = "laws/overlaps.rs"]
mod overlaps;
#[path = "laws/properties.rs"]
mod properties;
#[path = "laws/scale.rs"]
mod scale;
#[path = "laws/scenes.rs"]
mod scenes;
#[path = "laws/slivers.rs"]
mod slivers;
#[path = "laws/sources.rs"]
mod sources;
#[path = "laws/surfaces.rs"]
mod surfaces;
#[path = "laws/symmetries.rs"]
mod symmetries;
#[path = "laws/vertices.rs"]
mod vertices;

use proptest::test_runner::{Config, RngSeed};
use support::figures::size;

/// Half an ulp of 1: the relative error of one rounding.
pub(crate) const U: f64 = 0.5 * f64::EPSILON;

/// The same cases in every run, `cases` of them, ten times as many at full size.
pub(crate) fn config(cases: u32) -> Config {
    Config {
        cases: size(cases, 10 * cases),
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(1621),
        max_shrink_iters: 4000,
        ..Config::default()
    }
}
