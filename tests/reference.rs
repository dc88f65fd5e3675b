//! snellius against a reference tracer: the plainest loop, in 237-bit arithmetic, from the scene's numbers and the rules of
//! the scene format. It shares the scene's types and their reading with snellius, and nothing else.
//!
//! `SNELLIUS_FULL=1 cargo test --release --test reference -- --nocapture` measures at full size;
//! `SNELLIUS_UPDATE=1 cargo test --test reference every_scene` writes `tests/reference/ceilings.csv` anew.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::float_cmp,
    reason = "a test fails by panicking and compares exact bits on purpose"
)]

mod support;

#[path = "reference/bench.rs"]
mod bench;
#[path = "reference/ceilings.rs"]
mod ceilings;
#[path = "reference/compare.rs"]
mod compare;
#[path = "reference/condition.rs"]
mod condition;
#[path = "reference/curve.rs"]
mod curve;
#[path = "reference/doubts.rs"]
mod doubts;
#[path = "reference/generator.rs"]
mod generator;
#[path = "reference/laws.rs"]
mod laws;
#[path = "reference/media.rs"]
mod media;
#[path = "reference/meeting.rs"]
mod meeting;
#[path = "reference/numbers.rs"]
mod numbers;
#[path = "reference/placement.rs"]
mod placement;
#[path = "reference/proof.rs"]
mod proof;
#[path = "reference/random_scenes.rs"]
mod random_scenes;
#[path = "reference/shapes.rs"]
mod shapes;
#[path = "reference/sources.rs"]
mod sources;
#[path = "reference/stadium.rs"]
mod stadium;
#[path = "reference/tracer.rs"]
mod tracer;
