//! Values that nobody should pass, and some that one would.

use glam::DVec2;
use proptest::prelude::*;
use proptest::sample::select;
use snellius::light::Wavelength;
use snellius::numerics::pow;

const EXTREMES: [f64; 24] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    0.0,
    -0.0,
    5e-324,
    -5e-324,
    f64::MIN_POSITIVE,
    f64::MAX,
    f64::MIN,
    1e-30,
    1e30,
    1e154,
    1e155,
    -1.0,
    1.0,
    1.0 + f64::EPSILON,
    1.0 - 0.5 * f64::EPSILON,
    9_007_199_254_740_993.0,
    30.0,
    90.0,
    180.0,
    360.0,
    0.5,
];

/// Any kind of number.
pub(crate) fn number() -> impl Strategy<Value = f64> {
    let magnitude = (-308.0..308.0_f64, any::<bool>());
    let log_uniform = magnitude.prop_map(|(x, minus)| if minus { -pow(10.0, x) } else { pow(10.0, x) });
    prop_oneof![4 => select(&EXTREMES[..]), 2 => log_uniform, 3 => -50.0..50.0]
}

pub(crate) fn point() -> impl Strategy<Value = DVec2> {
    (number(), number()).prop_map(DVec2::from)
}

pub(crate) fn wavelength() -> impl Strategy<Value = Wavelength> {
    number().prop_map(|nm| Wavelength::from_nanometers(nm).unwrap_or(Wavelength::D))
}

/// A count or a number in a list, most often small.
pub(crate) fn count() -> impl Strategy<Value = u32> {
    prop_oneof![6 => 0..8_u32, 1 => select(&[u32::MAX, u32::MAX - 1, 1 << 31, 1000][..])]
}

pub(crate) fn words() -> impl Strategy<Value = String> {
    let long = "many words with no end and a wordwithoutanyspaceinit".repeat(40);
    let texts = ["", "n", "θ₁ = 30°", "<script>alert('&')</script>", "\u{0}\u{1}\u{202e}\u{feff}\n\t\"", "\u{ffff}]]>"];
    let texts: Vec<String> = texts.into_iter().map(str::to_owned).chain([long]).collect();
    select(texts)
}
