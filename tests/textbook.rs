//! Scenes traced from their text, held against values computed in 60-digit arithmetic.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod support;

#[path = "textbook/boundary.rs"]
mod boundary;
#[path = "textbook/lenses.rs"]
mod lenses;
#[path = "textbook/media.rs"]
mod media;
#[path = "textbook/prisms.rs"]
mod prisms;
#[path = "textbook/rainbow.rs"]
mod rainbow;
#[path = "textbook/ray_trees.rs"]
mod ray_trees;
#[path = "textbook/truth.rs"]
mod truth;
