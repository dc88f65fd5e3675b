//! Exact geometric predicates.

use glam::DVec2;
use robust::{Coord, orient2d};

use crate::numerics::product_parts;

/// Side of the line through `from` along `direction` on which `p` lies, its sign exact barring underflow: positive left,
/// negative right, 0 on the line.
///
/// # Source
/// Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", Discrete & Computational
/// Geometry 18 (1997), 305-363: Grow-Expansion, theorem 10.
#[must_use]
pub fn side_of_ray(from: DVec2, direction: DVec2, p: DVec2) -> f64 {
    let (d, f) = (direction, from);
    let products = [(d.x, p.y), (-d.x, f.y), (-d.y, p.x), (d.y, f.x)];
    let mut sum = [0.0; 8];
    for (k, (a, b)) in products.into_iter().enumerate() {
        let (product, rest) = product_parts(a, b);
        grow(&mut sum[..=2 * k], rest);
        grow(&mut sum[..=2 * k + 1], product);
    }
    // The largest component of a sum without overlap has its sign.
    sum.into_iter().rev().find(|part| *part != 0.0).unwrap_or(0.0)
}

/// Adds a term to an exact sum, whose last place is free (Grow-Expansion).
fn grow(sum: &mut [f64], term: f64) {
    let mut carry = term;
    let Some((last, parts)) = sum.split_last_mut() else { return };
    for part in parts {
        let total = carry + *part;
        let virtual_part = total - carry;
        *part = (carry - (total - virtual_part)) + (*part - virtual_part);
        carry = total;
    }
    *last = carry;
}

/// Side of the directed line `a` → `b` on which `p` lies, its sign exact: positive left, negative right, 0 on the line.
///
/// # Source
/// Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", Discrete & Computational
/// Geometry 18 (1997), 305-363: orient2d, as in the crate `robust`.
#[must_use]
pub fn side(a: DVec2, b: DVec2, p: DVec2) -> f64 {
    let coord = |p: DVec2| Coord { x: p.x, y: p.y };
    orient2d(coord(a), coord(b), coord(p))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_within_less_than_an_ulp_of_a_ray_has_a_side() {
        let (from, direction) = (DVec2::new(0.1, 0.7), DVec2::new(3.0, 1.0) / f64::sqrt(10.0));
        for k in [1e-3, 1.0, 12.0] {
            let on = from + k * direction;
            let above = side_of_ray(from, direction, DVec2::new(on.x, on.y.next_up()));
            let below = side_of_ray(from, direction, DVec2::new(on.x, on.y.next_down()));
            assert!(above > 0.0 && below < 0.0, "{above:e} {below:e}");
        }
        assert_eq!(side_of_ray(DVec2::new(0.1, 0.3), DVec2::X, DVec2::new(1e17, 0.3)), 0.0);
        assert_eq!(side_of_ray(DVec2::new(1.0, 1.0), DVec2::ONE, DVec2::new(1e17, 1e17)), 0.0);
    }
}
