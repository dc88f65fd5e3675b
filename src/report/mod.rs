//! A trace as text, JSON, CSV and summary.
//!
//! Each format writes to any [`std::io::Write`] as it goes, so that a large tree needs no second copy in memory, and
//! has a twin that returns a `String`.

mod course;
mod csv;
mod json;
mod layout;
mod number;
#[cfg(test)]
mod sample;
mod text;

pub use csv::{csv, write_csv};
pub use json::{SCHEMA, json, summary_json, write_json, write_summary_json};
pub(crate) use number::{fixed, significant};
pub(crate) use text::length_decimals;
pub use text::{text, write_text};

use std::io;

use crate::light::Power;
use crate::system::OpticalSystem;

/// What a writer puts into memory.
pub(crate) fn in_memory(write: impl FnOnce(&mut Vec<u8>) -> io::Result<()>) -> String {
    let mut bytes = Vec::new();
    // A Vec takes every write and all that is written here is UTF-8: the default is never reached.
    write(&mut bytes).ok().and_then(|()| String::from_utf8(bytes).ok()).unwrap_or_default()
}

/// The name by which results refer to a body: its own, or `#k` for the k-th from 0.
pub(crate) fn body_name(system: &OpticalSystem, body: usize) -> String {
    system.bodies().get(body).map_or_else(|| format!("#{body}"), |placed| placed.name.clone())
}

/// The share of a segment's power that the fractions `part` take, 0 to 1; of a segment without power, their mean.
pub(crate) fn applied(part: Power, power: Power) -> f64 {
    // What acts alike on s and p is shown as it is, not rounded by the weights.
    if part.s.to_bits() == part.p.to_bits() {
        return part.s;
    }
    let weight = power.s / power.total();
    if weight.is_finite() {
        part.times(Power { s: weight, p: power.p / power.total() }).total()
    } else {
        0.5 * part.total()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_alike_on_s_and_p_stay_exact() {
        let power = Power { s: 0.1 / 7.0, p: 0.3 / 11.0 };
        for fraction in [0.0, 0.1, 0.3, 1.0 / 3.0, 1.0] {
            assert_eq!(applied(Power::both(fraction), power), fraction);
        }
    }

    #[test]
    fn fractions_are_weighted_by_the_power_in_each_polarization() {
        let part = Power { s: 0.5, p: 0.25 };
        assert_eq!(applied(part, Power { s: 2e-3, p: 0.0 }), 0.5);
        assert_eq!(applied(part, Power { s: 0.0, p: 7.0 }), 0.25);
        assert_eq!(applied(part, Power { s: 0.75, p: 0.25 }), 0.4375);
        assert_eq!(applied(part, Power::default()), 0.375);
    }
}
