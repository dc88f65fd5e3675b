//! From the text of a scene file to a [`Scene`](crate::scene::Scene): ron parses, and what it leaves out is done here: every
//! problem noted instead of the first, each with its place.

mod body;
mod brackets;
mod fields;
mod foreign;
mod load;
mod medium;
mod node;
mod plain;
mod reader;
mod scene;
mod settings;
mod shape;
mod source;
mod split;
#[cfg(test)]
mod stress;
mod syntax;
#[cfg(test)]
mod tests;
mod variant;

pub use foreign::text_of;
pub use load::{Loaded, load, load_within};
