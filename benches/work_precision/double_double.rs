use std::ops::{Add, Div, Mul, Neg, Sub};

/// The unevaluated sum of two f64, some 106 bits.
///
/// # Source
/// Hida, Li and Bailey, "Library for Double-Double and Quad-Double Arithmetic", 2007; the root is Karp and Markstein's.
#[derive(Clone, Copy)]
pub(crate) struct Double {
    pub(crate) high: f64,
    low: f64,
}

impl Double {
    /// a + b, for |a| ≥ |b|.
    fn ordered_sum(a: f64, b: f64) -> Self {
        let high = a + b;
        Self { high, low: b - (high - a) }
    }

    fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let part = high - a;
        Self { high, low: (a - (high - part)) + (b - part) }
    }

    fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        Self { high, low: a.mul_add(b, -high) }
    }

    /// The root of a number above 0.
    pub(crate) fn sqrt(self) -> Self {
        let inverse = 1.0 / self.high.sqrt();
        let root = self.high * inverse;
        Self::ordered_sum(root, (self - Self::product(root, root)).high * (0.5 * inverse))
    }
}

impl From<f64> for Double {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

impl Add for Double {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (high, low) = (Self::sum(self.high, other.high), Self::sum(self.low, other.low));
        let part = Self::ordered_sum(high.high, high.low + low.high);
        Self::ordered_sum(part.high, part.low + low.low)
    }
}

impl Neg for Double {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for Double {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let Self { high, low } = Self::product(self.high, other.high);
        Self::ordered_sum(high, low + (self.high * other.low + self.low * other.high))
    }
}

impl Div for Double {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other * first.into();
        let second = rest.high / other.high;
        let rest = rest - other * second.into();
        Self::ordered_sum(first, second) + (rest.high / other.high).into()
    }
}
