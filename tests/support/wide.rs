//! Numbers and vectors of 237 bits (the crate `f256`), for references that shall be exact beside f64.

use std::ops::{Add, Mul, Neg, Sub};

use f256::f256;
use glam::DVec2;

/// A vector of two 237-bit numbers.
#[derive(Clone, Copy, Debug)]
pub struct Wide2 {
    pub x: f256,
    pub y: f256,
}

/// The same number, exactly.
pub fn wide(x: f64) -> f256 {
    f256::from(x)
}

/// 2 to the power `exponent`, exactly.
pub fn power_of_two(exponent: i32) -> f256 {
    // No number of f256 is near its limits here, 2^±262142.
    let biased = u128::try_from(exponent + 262_143).unwrap();
    f256::from_bits((biased << 108, 0))
}

/// The nearest f64, give or take one unit in the last place; below 2^-960 it is 0.
pub fn narrow(x: f256) -> f64 {
    let (sign, exponent, (high, low)) = x.as_sign_exp_signif();
    let (high, low) = (high as f64, low as f64);
    let magnitude = libm::scalbn(high, exponent + 128) + libm::scalbn(low, exponent);
    if sign == 1 { -magnitude } else { magnitude }
}

impl Wide2 {
    pub const ZERO: Self = Self { x: f256::ZERO, y: f256::ZERO };

    pub fn dot(self, other: Self) -> f256 {
        self.x * other.x + self.y * other.y
    }

    /// Positive when `other` lies counter-clockwise of `self`.
    pub fn cross(self, other: Self) -> f256 {
        self.x * other.y - self.y * other.x
    }

    /// Turned counter-clockwise by 90°.
    pub fn perp(self) -> Self {
        Self { x: -self.y, y: self.x }
    }

    pub fn length(self) -> f256 {
        self.dot(self).sqrt()
    }

    pub fn unit(self) -> Self {
        (f256::ONE / self.length()) * self
    }

    pub fn narrow(self) -> DVec2 {
        DVec2::new(narrow(self.x), narrow(self.y))
    }
}

impl From<DVec2> for Wide2 {
    fn from(p: DVec2) -> Self {
        Self { x: wide(p.x), y: wide(p.y) }
    }
}

impl Add for Wide2 {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y }
    }
}

impl Sub for Wide2 {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y }
    }
}

impl Neg for Wide2 {
    type Output = Self;
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y }
    }
}

impl Mul<Wide2> for f256 {
    type Output = Wide2;
    fn mul(self, v: Wide2) -> Wide2 {
        Wide2 { x: self * v.x, y: self * v.y }
    }
}
