//! Measured figures: each is printed, and fails its test when it is past its bound.

/// Half an ulp of 1: the relative error of one rounding.
pub const U: f64 = 0.5 * f64::EPSILON;

/// Whether the full sizes are asked for, by `SNELLIUS_FULL=1`.
pub fn is_full() -> bool {
    std::env::var_os("SNELLIUS_FULL").is_some_and(|value| !value.is_empty() && value != "0")
}

/// The size of a measurement: the quick one, or the full one where that is asked for.
pub fn size(quick: u32, full: u32) -> u32 {
    if is_full() { full } else { quick }
}

/// Prints a measured figure and fails where it is above its bound.
#[track_caller]
pub fn at_most(name: &str, value: f64, bound: f64) {
    println!("FIGURE|{name}|{value:.3e}|at most|{bound:.3e}");
    assert!(value <= bound, "{name}: {value:e} is above {bound:e}");
}

/// Prints a measured figure and fails where it is below its bound.
#[track_caller]
pub fn at_least(name: &str, value: f64, bound: f64) {
    println!("FIGURE|{name}|{value:.3e}|at least|{bound:.3e}");
    assert!(value >= bound, "{name}: {value:e} is below {bound:e}");
}

/// Prints a measured figure that has no bound.
pub fn counted(name: &str, value: f64) {
    println!("FIGURE|{name}|{value:.3e}||");
}
