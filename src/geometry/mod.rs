//! Curves in the plane: straight edges and circular arcs in one form, and where they go when a body is placed.

mod bounds;
mod box_split;
mod box_tree;
mod circle_roots;
mod crossings;
mod curve;
mod curve_tree;
mod placement;
mod run_tree;

pub use bounds::Bounds;
pub(crate) use box_tree::{BoxTree, Waiting};
pub use circle_roots::CircleRoots;
pub(crate) use crossings::{crossings, lies_on};
pub use curve::Curve;
pub(crate) use curve_tree::CurveTree;
pub use placement::Placement;
pub(crate) use run_tree::RunTree;
