//! From the text of a scene file to a [`Scene`](crate::scene::Scene): ron parses, and what it leaves out is done here: every
//! problem noted instead of the first, each with its place.

mod body;
mod fields;
mod load;
mod medium;
mod node;
mod reader;
mod scene;
mod shape;
mod source;
mod syntax;
#[cfg(test)]
mod tests;

pub use load::{Loaded, load};
