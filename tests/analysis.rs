//! What is computed from systems and traces, held against closed forms and against the rays themselves.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]
#![allow(clippy::float_cmp, reason = "some values are exact")]

mod support;

#[path = "analysis/bundle.rs"]
mod bundle;
#[path = "analysis/deviation.rs"]
mod deviation;
#[path = "analysis/irradiance.rs"]
mod irradiance;
#[path = "analysis/paraxial.rs"]
mod paraxial;
#[path = "analysis/unmet.rs"]
mod unmet;
