//! Sums and differences of two products that do not cancel.

use glam::DVec2;

/// The product of two numbers rounded, and what rounding took from it, exactly, barring over- and underflow. It needs no fused
/// multiply-add, which not every processor has.
///
/// # Source
/// Dekker, "A Floating-Point Technique for Extending the Available Precision", Numerische Mathematik 18 (1971), 224-242,
/// section 5; the halves are Veltkamp's.
#[inline]
#[must_use]
pub fn product_parts(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (halves(a), halves(b));
    (product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low)
}

/// A number as the sum of two with half its digits each.
#[inline]
fn halves(a: f64) -> (f64, f64) {
    // 2^27 + 1
    let shifted = 134_217_729.0 * a;
    let high = shifted - (shifted - a);
    (high, a - high)
}

/// The cross product `a.x * b.y - a.y * b.x`, positive when `b` lies counter-clockwise of `a`.
///
/// The relative error is below 2 units in the last place however much the two products cancel, barring underflow: the products
/// are taken exactly, as in [`product_parts`].
#[inline]
#[must_use]
pub fn cross(a: DVec2, b: DVec2) -> f64 {
    let ((first, first_rest), (second, second_rest)) = (product_parts(a.x, b.y), product_parts(a.y, b.x));
    (first - second) + (first_rest - second_rest)
}

/// The dot product `a.x * b.x + a.y * b.y`, with the accuracy of [`cross`]: also for vectors nearly at right angles.
#[inline]
#[must_use]
pub fn dot(a: DVec2, b: DVec2) -> f64 {
    cross(a, b.perp())
}

/// The cross product `a.x * b.y - a.y * b.x` as a number and what rounding took from it: their sum is within 2 u² of the
/// larger product, u = 2^-53.
///
/// # Source
/// Dekker as in [`product_parts`] for the sum of two doubled numbers; Møller and Knuth for the rest of a sum (Knuth, "The Art of
/// Computer Programming", vol. 2, section 4.2.2, theorem B).
#[inline]
#[must_use]
pub fn cross_parts(a: DVec2, b: DVec2) -> (f64, f64) {
    let ((first, first_rest), (second, second_rest)) = (product_parts(a.x, b.y), product_parts(a.y, b.x));
    let (total, lost) = sum_parts(first, -second);
    (total, lost + (first_rest - second_rest))
}

/// The sum of two numbers rounded, and what rounding took from it, exactly.
#[inline]
pub(crate) fn sum_parts(a: f64, b: f64) -> (f64, f64) {
    let total = a + b;
    let part = total - a;
    (total, (a - (total - part)) + (b - part))
}

/// How far the squared length of a vector is above 1, to 1e-31, for one whose length is 1 but for rounding.
#[inline]
#[must_use]
pub fn excess_length(v: DVec2) -> f64 {
    let ((x, x_rest), (y, y_rest)) = (product_parts(v.x, v.x), product_parts(v.y, v.y));
    let (total, lost) = sum_parts(x, y);
    // What is near 1 less 1 is exact.
    (total - 1.0) + (lost + (x_rest + y_rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    const DIAGONAL: f64 = -8.053393020570264e-16;

    #[test]
    fn keeps_its_digits_where_the_products_cancel() {
        let tiny = f64::EPSILON;
        let a = DVec2::new(1.0 + tiny, 1.0);
        let b = DVec2::new(1.0 + 2.0 * tiny, 1.0 + tiny);
        // (1 + ε)² − (1 + 2ε) = ε² exactly; the plain formula gives 0.
        assert_eq!(cross(a, b), tiny * tiny);
        assert_eq!(dot(a, -b.perp()), tiny * tiny);
    }

    #[test]
    fn the_parts_of_a_product_are_exact() {
        let tiny = f64::EPSILON;
        // (1 + ε)² = 1 + 2ε + ε².
        assert_eq!(product_parts(1.0 + tiny, 1.0 + tiny), (1.0 + 2.0 * tiny, tiny * tiny));
        for (a, b) in [(0.1, 0.7), (-1.0 / 3.0, 1e100 / 7.0), (1e-100 / 3.0, -3.3), (0.0, 5.0)] {
            let (product, rest) = product_parts(a, b);
            assert_eq!((product, rest), (a * b, a.mul_add(b, -product)));
        }
    }

    #[test]
    fn the_parts_of_a_cross_product_hold_what_rounding_took() {
        let (a, b) = (DVec2::new(0.1, 0.7), DVec2::new(0.3, -0.2));
        let (total, rest) = cross_parts(a, b);
        assert!((total - cross(a, b)).abs() <= f64::EPSILON * total.abs());
        assert!(rest != 0.0 && rest.abs() <= 0.5 * f64::EPSILON * total.abs());
        // −0.1·0.2 − 0.7·0.3 of the numbers nearest to these, less −0.23 of its nearest, by exact decimals.
        assert!((total + rest + 0.23).abs() <= f64::EPSILON);
        let tiny = f64::EPSILON;
        assert_eq!(cross_parts(DVec2::new(1.0, tiny), DVec2::new(tiny * tiny, 1.0)), (1.0, -tiny * tiny * tiny));
    }

    #[test]
    fn the_excess_of_a_rounded_unit_vector() {
        // 0.6² + 0.8² of the nearest numbers is 1 + 2 (0.8·4.44e-17 − 0.6·2.22e-17) = 1 + 4.44e-17.
        for v in [DVec2::new(0.6, 0.8), DVec2::new(-0.8, 0.6)] {
            assert!((excess_length(v) - 4.440_892_098_500_626e-17).abs() < 1e-31, "{:e}", excess_length(v));
        }
        // Both squares below 1/2: 2·0.7071067811865472² of the nearest number less 1, by exact fractions.
        let diagonal = excess_length(DVec2::splat(0.707_106_781_186_547_2));
        assert!((diagonal / DIAGONAL - 1.0).abs() < 1e-15, "{diagonal:e}");
        assert_eq!(excess_length(DVec2::new(1e-170, 1.0)), 0.0);
        assert_eq!(
            excess_length(DVec2::new(1.0 + f64::EPSILON, 0.0)),
            2.0 * f64::EPSILON + f64::EPSILON * f64::EPSILON
        );
    }
}
