//! Ray diagrams from the vector law of refraction.

#![cfg_attr(test, allow(clippy::float_cmp, reason = "tests compare exact bits on purpose"))]

pub mod analysis;
pub mod compile;
pub mod diagram;
pub mod drawing;
pub mod geometry;
pub mod laws;
pub mod light;
pub mod media;
pub mod numerics;
pub mod render;
pub mod report;
pub mod scene;
pub mod system;
pub mod trace;

#[doc(hidden)]
pub mod cli;

pub use scene::Scene;
pub use system::OpticalSystem;
