//! Sums and differences of two products that do not cancel.

use glam::DVec2;

/// The cross product `a.x * b.y - a.y * b.x`, positive when `b` lies counter-clockwise of `a`.
///
/// The relative error is below 2 units in the last place however much the two products cancel, barring underflow.
///
/// # Source
/// Kahan's difference of products: Jeannerod, Louvet and Muller, "Further analysis of Kahan's algorithm for the accurate
/// computation of 2×2 determinants", Mathematics of Computation 82 (2013), 2245-2264.
#[must_use]
pub fn cross(a: DVec2, b: DVec2) -> f64 {
    let second = a.y * b.x;
    let error = (-a.y).mul_add(b.x, second);
    a.x.mul_add(b.y, -second) + error
}

/// The dot product `a.x * b.x + a.y * b.y`, with the accuracy of [`cross`]: also for vectors nearly at right angles.
#[must_use]
pub fn dot(a: DVec2, b: DVec2) -> f64 {
    cross(a, b.perp())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keeps_its_digits_where_the_products_cancel() {
        let tiny = f64::EPSILON;
        let a = DVec2::new(1.0 + tiny, 1.0);
        let b = DVec2::new(1.0 + 2.0 * tiny, 1.0 + tiny);
        // (1 + ε)² − (1 + 2ε) = ε² exactly; the plain formula gives 0.
        assert_eq!(cross(a, b), tiny * tiny);
        assert_eq!(dot(a, -b.perp()), tiny * tiny);
    }
}
