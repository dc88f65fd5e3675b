//! The one place that calls transcendental functions, through libm: the standard library's differ between platforms.

use glam::DVec2;

const DEGREES_PER_RADIAN: f64 = 180.0 / std::f64::consts::PI;
const RADIANS_PER_DEGREE: f64 = std::f64::consts::PI / 180.0;

/// A rotation, counter-clockwise positive, as cosine and sine of its angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// Cosine of the angle.
    pub cos: f64,
    /// Sine of the angle.
    pub sin: f64,
}

impl Turn {
    /// The turn by an angle in degrees. Multiples of 90° and halves such as sin 30° are exact, and angles that mirror each other give the same bits.
    #[must_use]
    pub fn degrees(angle: f64) -> Self {
        let reduced = angle % 360.0;
        let quarter = (reduced / 90.0).round_ties_even();
        let rest = reduced - quarter * 90.0;
        let (sin, cos) = libm::sincos(rest * RADIANS_PER_DEGREE);
        // The radian of 30° is rounded; its sine is a half.
        #[expect(clippy::float_cmp, reason = "30° itself")]
        let sin = if rest.abs() == 30.0 { 0.5_f64.copysign(rest) } else { sin };
        let (cos, sin) = match quarter.rem_euclid(4.0) {
            0.0 => (cos, sin),
            1.0 => (-sin, cos),
            2.0 => (-cos, -sin),
            _ => (sin, -cos),
        };
        // Adding 0 turns −0 into 0, so that no direction prints as −0.
        Self { cos: cos + 0.0, sin: sin + 0.0 }
    }

    /// The vector turned about the origin.
    #[must_use]
    pub fn apply(self, v: DVec2) -> DVec2 {
        DVec2::new(self.cos * v.x - self.sin * v.y, self.sin * v.x + self.cos * v.y)
    }

    /// The unit vector at this angle from +x.
    #[must_use]
    pub fn direction(self) -> DVec2 {
        DVec2::new(self.cos, self.sin)
    }
}

/// Angle of the vector `(x, y)` from +x in degrees, −180 to 180; 0 for the zero vector.
#[must_use]
pub fn atan2_degrees(y: f64, x: f64) -> f64 {
    libm::atan2(y, x) * DEGREES_PER_RADIAN
}

/// Arc sine in degrees, −90 to 90; NaN outside −1 to 1.
#[must_use]
pub fn asin_degrees(x: f64) -> f64 {
    libm::asin(x) * DEGREES_PER_RADIAN
}

/// Arc cosine in degrees, 0 to 180; NaN outside −1 to 1.
#[must_use]
pub fn acos_degrees(x: f64) -> f64 {
    libm::acos(x) * DEGREES_PER_RADIAN
}

/// Tangent of an angle in degrees.
#[must_use]
pub fn tan_degrees(angle: f64) -> f64 {
    let turn = Turn::degrees(angle);
    turn.sin / turn.cos
}

/// Arc tangent in radians.
#[must_use]
pub fn atan(x: f64) -> f64 {
    libm::atan(x)
}

/// Sine of an angle in radians.
#[must_use]
pub fn sin(x: f64) -> f64 {
    libm::sin(x)
}

/// The exponential function.
#[must_use]
pub fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// `x` to the power `y`; NaN for negative `x` unless `y` is whole.
#[must_use]
pub fn pow(x: f64, y: f64) -> f64 {
    libm::pow(x, y)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_turns_are_exact() {
        for (angle, cos, sin) in [(0.0, 1.0, 0.0), (90.0, 0.0, 1.0), (-180.0, -1.0, 0.0), (630.0, 0.0, -1.0)] {
            assert_eq!(Turn::degrees(angle), Turn { cos, sin }, "{angle}°");
        }
    }

    #[test]
    fn halves_are_exact() {
        for (angle, sin) in [(30.0, 0.5), (150.0, 0.5), (-30.0, -0.5), (210.0, -0.5)] {
            assert_eq!(Turn::degrees(angle).sin, sin, "sin {angle}°");
            assert_eq!(Turn::degrees(angle - 90.0).cos, sin, "cos {}°", angle - 90.0);
        }
    }

    #[test]
    fn mirrored_angles_share_their_bits() {
        for angle in [1.0, 30.0, 44.5, 45.0, 63.25] {
            let (plus, minus, across) = (Turn::degrees(angle), Turn::degrees(-angle), Turn::degrees(180.0 - angle));
            assert_eq!((plus.cos, plus.sin), (minus.cos, -minus.sin));
            assert_eq!((plus.cos, plus.sin), (-across.cos, across.sin));
        }
    }
}
