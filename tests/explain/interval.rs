//! Numbers that are known to their printed digits, and vectors of them.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// All numbers between two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Interval {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

/// What a letter stands for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Value {
    Number(Interval),
    Vector(Interval, Interval),
}

use Value::{Number, Vector};

impl Interval {
    pub(crate) fn exactly(x: f64) -> Self {
        Self { low: x, high: x }
    }

    pub(crate) fn around(x: f64, half: f64) -> Self {
        Self { low: x - half, high: x + half }
    }

    fn of(ends: impl IntoIterator<Item = f64>) -> Self {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for end in ends {
            low = low.min(end);
            high = high.max(end);
        }
        // The test's own arithmetic rounds too.
        let slack = 1e-13 * low.abs().max(high.abs());
        Self { low: low - slack, high: high + slack }
    }

    pub(crate) fn middle(self) -> f64 {
        0.5 * (self.low + self.high)
    }

    pub(crate) fn width(self) -> f64 {
        self.high - self.low
    }

    pub(crate) fn meets(self, other: Self) -> bool {
        self.low <= other.high && other.low <= self.high
    }

    /// A rising function of it, where that is defined.
    pub(crate) fn map(self, within: (f64, f64), f: impl Fn(f64) -> f64) -> Self {
        Self::of([self.low, self.high].map(|x| f(x.clamp(within.0, within.1))))
    }

    pub(crate) fn square(self) -> Self {
        let size = self.size();
        Self::of([size.low * size.low, size.high * size.high])
    }

    pub(crate) fn size(self) -> Self {
        if self.low <= 0.0 && self.high >= 0.0 {
            return Self { low: 0.0, high: self.high.max(-self.low) };
        }
        Self::of([self.low.abs(), self.high.abs()])
    }

    fn corners(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self::of([self.low, self.high].into_iter().flat_map(|a| [other.low, other.high].map(|b| f(a, b))))
    }
}

impl Value {
    pub(crate) fn number(self) -> Interval {
        match self {
            Number(x) => x,
            Vector(..) => panic!("a vector where a number belongs"),
        }
    }

    pub(crate) fn vector(self) -> [Interval; 2] {
        match self {
            Vector(x, y) => [x, y],
            Number(_) => panic!("a number where a vector belongs"),
        }
    }

    pub(crate) fn meets(self, other: Self) -> bool {
        match (self, other) {
            (Number(a), Number(b)) => a.meets(b),
            (Vector(a, b), Vector(c, d)) => a.meets(c) && b.meets(d),
            _ => false,
        }
    }

    /// The values in the middle of the intervals.
    pub(crate) fn middle(self) -> Self {
        match self {
            Number(x) => Number(Interval::exactly(x.middle())),
            Vector(x, y) => Vector(Interval::exactly(x.middle()), Interval::exactly(y.middle())),
        }
    }

    /// The size of the vector product.
    pub(crate) fn cross(self, other: Self) -> Self {
        let ([a, b], [c, d]) = (self.vector(), other.vector());
        Number((a.times(d) - b.times(c)).size())
    }

    /// The angle in degrees to another unit vector, counter-clockwise.
    pub(crate) fn angle_to(self, other: Self) -> Self {
        let ([a, b], [c, d]) = (self.vector(), other.vector());
        let [x, y, u, v] = [a, b, c, d].map(Interval::middle);
        let blur = [a, b, c, d].map(Interval::width).iter().sum::<f64>();
        Number(Interval::around((x * v - y * u).atan2(x * u + y * v).to_degrees(), blur.to_degrees() + 1e-12))
    }
}

impl Interval {
    fn times(self, other: Self) -> Self {
        self.corners(other, |a, b| a * b)
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::of([self.low + other.low, self.high + other.high])
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::of([self.low - other.high, self.high - other.low])
    }
}

impl Add for Value {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        match (self, other) {
            (Number(a), Number(b)) => Number(a + b),
            (a, b) => {
                let ([a, b], [c, d]) = (a.vector(), b.vector());
                Vector(a + c, b + d)
            }
        }
    }
}

impl Neg for Value {
    type Output = Self;
    fn neg(self) -> Self {
        Number(Interval::exactly(-1.0)) * self
    }
}

impl Sub for Value {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

/// The scalar product of two vectors.
impl Mul for Value {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        match (self, other) {
            (Number(a), Number(b)) => Number(a.times(b)),
            (Number(a), Vector(x, y)) | (Vector(x, y), Number(a)) => Vector(a.times(x), a.times(y)),
            (Vector(a, b), Vector(c, d)) => [a.times(c), b.times(d)].map(Number).into_iter().reduce(Add::add).unwrap(),
        }
    }
}

impl Div for Value {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let b = other.number();
        assert!(b.low > 0.0 || b.high < 0.0, "division by what may be 0");
        let inverse = Number(Interval::of([1.0 / b.low, 1.0 / b.high]));
        self * inverse
    }
}
