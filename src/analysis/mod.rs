//! What a compiled scene and its trace tell about images and spectra, as numbers: nothing here draws.
//!
//! Points are scene coordinates; units and signs are the [crate]'s.

mod axis;
mod bundle;
mod confusion;
mod deviation;
mod images;
mod irradiance;
mod objects;
mod paraxial;

pub use axis::Axis;
pub use bundle::{Bundle, BundleRay, Focus, ImageKind};
pub use confusion::Confusion;
pub use deviation::{deviation_degrees, turning_degrees};
pub use images::{Image, images};
pub use irradiance::{Curve, Irradiance, irradiance};
pub use objects::{ObjectImage, object_images};
pub use paraxial::{Paraxial, paraxial, paraxial_of};
