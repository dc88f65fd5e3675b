//! Exact geometric predicates: Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
//! Predicates", Discrete & Computational Geometry 18 (1997), 305-363.

use glam::DVec2;
use robust::{Coord, orient2d};

/// Side of the directed line `a` → `b` on which `p` lies, its sign exact: positive left, negative right, 0 on the line.
#[must_use]
pub fn side(a: DVec2, b: DVec2, p: DVec2) -> f64 {
    let coord = |p: DVec2| Coord { x: p.x, y: p.y };
    orient2d(coord(a), coord(b), coord(p))
}
