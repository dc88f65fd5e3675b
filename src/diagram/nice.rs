/// The largest of 1, 2 and 5 times a power of ten that is not above `value`; `None` unless `value` is above 0.
pub(super) fn at_most(value: f64) -> Option<f64> {
    if !(value.is_finite() && value > 0.0) {
        return None;
    }
    // The printed form splits off the power of ten without a logarithm, and reading it back is exact.
    let text = format!("{value:e}");
    let (digits, exponent) = text.split_once('e')?;
    let mantissa: f64 = digits.parse().ok()?;
    let step = [5.0, 2.0, 1.0].into_iter().find(|step| *step <= mantissa)?;
    format!("{step}e{exponent}").parse().ok().filter(|nice: &f64| *nice > 0.0)
}

/// A number as people write it, without the noise of binary fractions.
pub(super) fn label(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 {
        return "0".into();
    }
    let rounded: f64 = format!("{value:.9e}").parse().unwrap_or(value);
    let text = if (1e-4..1e7).contains(&size) { format!("{rounded}") } else { format!("{rounded:e}") };
    text.replace('-', "−")
}

/// Multiples of a step within an interval; none where the step is lost in rounding.
pub(super) fn multiples(step: f64, min: f64, max: f64) -> Vec<f64> {
    let first = (min / step).ceil();
    let count = (max / step).floor() - first;
    if !(count.is_finite() && (0.0..1000.0).contains(&count)) || first.abs() > 1e15 {
        return Vec::new();
    }
    (0..=1000_u32).map(f64::from).take_while(|i| *i <= count).map(|i| (first + i) * step).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nice_numbers() {
        for (value, nice) in [(9.9, 5.0), (1.0, 1.0), (0.31, 0.2), (7e-300, 5e-300), (3.2e12, 2e12)] {
            assert_eq!(at_most(value), Some(nice));
        }
        for value in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(at_most(value), None);
        }
    }

    #[test]
    fn labels() {
        assert_eq!(label(0.1 + 0.2), "0.3");
        assert_eq!(label(-20.0), "−20");
        assert_eq!(label(-0.0), "0");
        assert_eq!(label(2e-12), "2e−12");
    }

    #[test]
    fn multiples_stay_inside() {
        assert_eq!(multiples(2.0, -3.0, 4.5), [-2.0, 0.0, 2.0, 4.0]);
        assert!(multiples(1.0, 1e300, 1e301).is_empty());
        assert!(multiples(1e-12, 1e12, 1e12 + 1.0).is_empty());
        assert!(multiples(1.0, f64::NEG_INFINITY, f64::INFINITY).is_empty());
    }
}
