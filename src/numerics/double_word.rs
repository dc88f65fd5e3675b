//! Numbers of twice the precision, where plain ones would cancel.

use std::ops::{Add, Mul, Neg, Sub};

/// An unevaluated sum of two numbers, the second at most half an ulp of the first: about 106 bits.
///
/// Every operation has a relative error of a few u², u = 2^-53, barring underflow and overflow; what overflows is NaN or
/// infinite.
///
/// # Source
/// Joldes, Muller and Popescu, "Tight and Rigorous Error Bounds for Basic Building Blocks of Double-Word Arithmetic", ACM
/// Transactions on Mathematical Software 44 (2017), article 15: algorithms 6, 12 and 15; the root: Lefèvre, Louvet, Muller,
/// Picot and Rideau, "Accurate Calculation of Euclidean Norms Using Double-Word Arithmetic", ibid. 49 (2023).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleWord {
    high: f64,
    low: f64,
}

impl DoubleWord {
    /// The product of two numbers, exactly.
    #[must_use]
    pub fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        Self { high, low: a.mul_add(b, -high) }
    }

    /// The sum of two numbers of which the second is no larger, exactly.
    fn ordered(large: f64, small: f64) -> Self {
        let high = large + small;
        Self { high, low: small - (high - large) }
    }

    /// The sum of two numbers, exactly.
    #[must_use]
    pub fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let part = high - a;
        Self { high, low: (a - (high - part)) + (b - part) }
    }

    /// The nearest plain number.
    #[must_use]
    pub fn value(self) -> f64 {
        self.high
    }

    /// The quotient by a plain number.
    #[must_use]
    pub fn divided_by(self, divisor: f64) -> Self {
        let quotient = self.high / divisor;
        let product = Self::product(quotient, divisor);
        let rest = (self.high - product.high) + (self.low - product.low);
        Self::ordered(quotient, rest / divisor)
    }

    /// The square root; of 0 it is 0, of a negative number NaN.
    #[must_use]
    pub fn sqrt(self) -> Self {
        let root = self.high.sqrt();
        if root == 0.0 {
            return Self { high: 0.0, low: 0.0 };
        }
        let rest = (-root).mul_add(root, self.high) + self.low;
        Self::ordered(root, rest / (2.0 * root))
    }
}

impl From<f64> for DoubleWord {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

impl Add for DoubleWord {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (high, low) = (Self::sum(self.high, other.high), Self::sum(self.low, other.low));
        let first = Self::ordered(high.high, high.low + low.high);
        Self::ordered(first.high, low.low + first.low)
    }
}

impl Neg for DoubleWord {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for DoubleWord {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleWord {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = Self::product(self.high, other.high);
        let crossed = self.low.mul_add(other.high, self.high.mul_add(other.low, self.low * other.low));
        Self::ordered(product.high, product.low + crossed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TINY: f64 = 1e-25;

    #[test]
    fn sums_and_products_keep_what_plain_numbers_lose() {
        let one = DoubleWord::sum(1.0, TINY);
        assert_eq!((one - DoubleWord::from(1.0)).value(), TINY);
        // (1 + t)² − 1 = 2t + t².
        assert_eq!((one * one - DoubleWord::from(1.0)).value(), 2.0 * TINY);
        let difference = DoubleWord::product(0.1, 0.3) - DoubleWord::product(0.3, 0.1);
        assert_eq!(difference.value(), 0.0);
    }

    #[test]
    fn roots_and_quotients_are_undone_by_products() {
        for x in [2.0, 0.1, 1e-30, 7e12] {
            let root = DoubleWord::from(x).sqrt();
            assert!(((root * root - DoubleWord::from(x)).value() / x).abs() < 1e-31, "root of {x}");
            let third = DoubleWord::from(x).divided_by(3.0);
            assert!(((third * DoubleWord::from(3.0) - DoubleWord::from(x)).value() / x).abs() < 1e-31, "{x}/3");
        }
        assert_eq!(DoubleWord::from(0.0).sqrt().value(), 0.0);
        assert!(DoubleWord::from(-1.0).sqrt().value().is_nan());
    }
}
