//! Curves in the plane: straight edges and circular arcs in one form, and where they go when a body is placed.

mod bounds;
mod box_split;
mod box_tree;
mod circle_roots;
mod curve;
mod placement;

pub use bounds::Bounds;
pub(crate) use box_tree::{BoxTree, Waiting};
pub use circle_roots::CircleRoots;
pub use curve::Curve;
pub use placement::Placement;
