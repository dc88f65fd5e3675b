/// Beyond this many pixels nothing is visible, and single precision renderers still place a tenth of a pixel.
const FAR: f64 = 1e6;

/// A pixel coordinate fit for output: finite, at most 10⁶ in size, rounded to 1/100, never −0; NaN becomes 0.
#[must_use]
pub fn pixel(value: f64) -> f64 {
    f64::from(hundredths(value)) / 100.0
}

/// The same as a whole number of hundredths of a pixel.
#[must_use]
pub fn hundredths(value: f64) -> i32 {
    let value = value.clamp(-FAR, FAR) * 100.0;
    // The largest number below a half: with a half, the one just below it would round up.
    let half = 0.499_999_999_999_999_94_f64.copysign(value);
    #[allow(clippy::cast_possible_truncation, reason = "at most 1e8 in size; NaN becomes 0")]
    let rounded = (value + half) as i32;
    rounded
}

/// A width or another size fit for output: at least 0 and at most 10⁶; NaN becomes 0.
pub(crate) fn extent(value: f64) -> f64 {
    if value.is_nan() { 0.0 } else { value.clamp(0.0, FAR) }
}

/// The shortest decimal form that reads back to the same number; exponents below 10⁻⁵ and from 10¹⁶ on.
#[must_use]
pub fn shortest(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-5..1e16).contains(&size) { format!("{value:e}") } else { format!("{}", value + 0.0) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_are_finite_and_rounded() {
        assert_eq!(pixel(1.234_567), 1.23);
        assert!(pixel(-0.001).is_sign_positive());
        assert_eq!(pixel(f64::NAN), 0.0);
        assert_eq!(pixel(f64::NEG_INFINITY), -FAR);
        assert_eq!(pixel(0.004_999_999_999_999_999), 0.0);
        assert_eq!([0.125, -0.125, 2.5, -7.375].map(hundredths), [13, -13, 250, -738], "halves go away from 0");
    }

    #[test]
    fn shortest_reads_back() {
        for (value, text) in [(1.0, "1"), (0.1, "0.1"), (1e-20, "1e-20"), (-0.0, "0"), (2.5e17, "2.5e17")] {
            assert_eq!(shortest(value), text);
            assert_eq!(text.parse::<f64>().unwrap(), value);
        }
    }
}
