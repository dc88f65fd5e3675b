//! Curves in the plane: straight edges and circular arcs in one form, and where they go when a body is placed.

mod curve;
mod placement;

pub use curve::Curve;
pub use placement::Placement;
