//! A trace as text, JSON, CSV and summary.
//!
//! Each format writes to any [`std::io::Write`] as it goes, so that a large tree needs no second copy in memory, and
//! has a twin that returns a `String`.

mod csv;
mod json;
mod layout;
mod number;
#[cfg(test)]
mod sample;
mod text;

pub use csv::{csv, write_csv};
pub use json::{SCHEMA, json, summary_json, write_json, write_summary_json};
pub use text::{text, write_text};

use std::io;

use crate::light::Power;
use crate::system::OpticalSystem;

/// What a writer puts into memory.
fn in_memory(write: impl FnOnce(&mut Vec<u8>) -> io::Result<()>) -> String {
    let mut bytes = Vec::new();
    // A Vec takes every write and all that is written here is UTF-8: the default is never reached.
    write(&mut bytes).ok().and_then(|()| String::from_utf8(bytes).ok()).unwrap_or_default()
}

/// The name by which results refer to a body: its own, or `#k` for the k-th from 0.
fn body_name(system: &OpticalSystem, body: usize) -> String {
    system.bodies().get(body).map_or_else(|| format!("#{body}"), |placed| placed.name.clone())
}

/// The share of a segment's power that the fractions `part` take, 0 to 1; of a segment without power, their mean.
fn applied(part: Power, power: Power) -> f64 {
    let share = part.times(power).total() / power.total();
    if share.is_finite() { share } else { 0.5 * part.total() }
}
