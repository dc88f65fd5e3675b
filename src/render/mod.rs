//! Display list to file formats. Nothing here knows what a ray is.

mod png;
mod svg;

pub use png::{RenderError, png};
pub use svg::svg;
