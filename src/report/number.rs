use glam::DVec2;
use serde::{Serialize, Serializer};

/// A number in JSON or CSV: the shortest form that reads back to the same bits, never −0, and null unless finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Number(pub(super) f64);

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        // Adding 0 turns −0 into 0.
        if self.0.is_finite() { serializer.serialize_f64(self.0 + 0.0) } else { serializer.serialize_none() }
    }
}

/// A point or direction as `[x, y]`.
pub(super) fn pair(v: DVec2) -> [Number; 2] {
    [Number(v.x), Number(v.y)]
}

/// A number rounded to so many decimals, without trailing zeros and without −0.
pub(crate) fn fixed(x: f64, decimals: usize) -> String {
    let digits = format!("{x:.decimals$}");
    let short = if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { &digits };
    if short == "-0" { "0".into() } else { short.into() }
}

/// A power rounded to 6 significant digits. What is below 10⁻¹² of `whole` is rounding noise: 0 stays 0, and
/// anything more prints as `<1e-12`.
pub(super) fn share(power: f64, whole: f64) -> String {
    let share = power / whole;
    if share != 0.0 && share.abs() < 1e-12 { "<1e-12".into() } else { significant(power) }
}

/// A number rounded to 6 significant digits.
pub(crate) fn significant(x: f64) -> String {
    let exponent = decimal_exponent(x);
    if (-5..15).contains(&exponent) {
        return fixed(x, usize::try_from(5 - exponent).unwrap_or(0));
    }
    let scientific = format!("{x:.5e}");
    match scientific.split_once('e') {
        Some((digits, power)) => format!("{}e{power}", digits.trim_end_matches('0').trim_end_matches('.')),
        None => scientific,
    }
}

/// The power of ten of a number's first digit, rounded to 6 digits; 0 for 0 and what is not finite.
pub(super) fn decimal_exponent(x: f64) -> i32 {
    let scientific = format!("{x:.5e}");
    scientific.split_once('e').and_then(|(_, power)| power.parse().ok()).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_back_and_are_never_minus_zero() {
        let line = |x| serde_json::to_string(&Number(x)).unwrap();
        assert_eq!(line(-0.0), "0.0");
        assert_eq!(line(0.1 + 0.2), "0.30000000000000004");
        assert_eq!(line(f64::NAN), "null");
        assert_eq!(line(f64::NEG_INFINITY), "null");
    }

    #[test]
    fn fixed_drops_zeros_and_the_sign_of_nothing() {
        for (x, shown) in [(1.5, "1.5"), (-1e-12, "0"), (-0.0, "0"), (100.0, "100"), (-2.5, "-2.5"), (1e-6, "0.000001")]
        {
            assert_eq!(fixed(x, 6), shown);
        }
        assert_eq!(fixed(1200.0, 0), "1200");
    }

    #[test]
    fn shares_keep_six_digits_and_hide_noise() {
        for (x, shown) in [
            (1.0, "1"),
            (0.957_826_234, "0.957826"),
            (0.000_123_456_78, "0.000123457"),
            (9.999_999_9, "10"),
            (3.25e-9, "3.25e-9"),
            (2e-33, "<1e-12"),
            (0.0, "0"),
        ] {
            assert_eq!(share(x, 1.0), shown);
        }
        assert_eq!(share(2e-33, 1e-30), "2e-33", "small only against the whole");
        assert_eq!(significant(1.25e20), "1.25e20");
    }
}
