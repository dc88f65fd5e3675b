//! Any scene whatever, and what holds of it; for the ordinary tests and for the fuzzer.
#![allow(dead_code, unreachable_pub, clippy::expect_used, reason = "each user needs a part, and a test may fail")]
#![allow(clippy::field_reassign_with_default, reason = "what may get more fields is made so")]

pub mod generator;
pub mod outputs;
#[path = "../support/plain_words.rs"]
pub mod plain_words;
pub mod properties;
pub mod ron;
pub mod shapes;
