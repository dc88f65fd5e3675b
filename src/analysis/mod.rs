//! What a compiled scene and its trace tell about images and spectra, as numbers: nothing here draws.
//!
//! Points are scene coordinates; units and signs are the [crate]'s.

mod axis;
mod paraxial;

pub use axis::Axis;
pub use paraxial::{Paraxial, paraxial, paraxial_of};
