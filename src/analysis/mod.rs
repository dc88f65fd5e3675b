//! What a compiled scene and its trace tell about images: nothing here draws.

mod image;

pub use image::{Image, images};
