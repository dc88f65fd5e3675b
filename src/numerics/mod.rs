//! Arithmetic without optics: trigonometry with the same bits on every machine, products that do not cancel, sums that close.

mod cross;
mod predicates;
mod sum;
mod trig;

pub use cross::{cross, cross_parts, dot, excess_length, product_parts};
pub use predicates::{side, side_of_ray};
pub use sum::Sum;
pub use trig::{Turn, acos_degrees, asin_degrees, atan, atan2_degrees, exp, pow, sin, tan_degrees};
