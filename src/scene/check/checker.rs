use std::fmt::Display;

use glam::DVec2;

use crate::scene::problem::Found;
use crate::scene::{Limit, Limits, MAX_LENGTH, MIN_LENGTH, Problem};

/// What is written out only for a problem: the path of a value, or words for it.
pub(super) trait Text: Display + Copy {}

impl<T: Display + Copy> Text for T {}

/// Collects problems; the methods tell whether a value passed.
pub(super) struct Checker<'a> {
    pub(super) found: Found,
    pub(super) limits: &'a Limits,
    /// Comparisons of curves with each other, to see whether outlines meet themselves.
    pub(super) comparisons: usize,
    /// Whether what is wrong at a path is to be passed over.
    ignored: &'a dyn Fn(&str) -> bool,
    /// Whether a body is at fault, passed over or not.
    pub(super) has_faulty_body: bool,
}

impl<'a> Checker<'a> {
    pub(super) fn new(limits: &'a Limits, ignored: &'a dyn Fn(&str) -> bool) -> Self {
        Self { found: Found::default(), limits, comparisons: 0, ignored, has_faulty_body: false }
    }

    pub(super) fn push(&mut self, problem: Problem) {
        self.has_faulty_body |= problem.path.starts_with("bodies");
        if !(self.ignored)(&problem.path) {
            self.found.push(problem);
        }
    }

    /// Notes an error unless `ok`, and returns `ok`.
    pub(super) fn require(&mut self, ok: bool, problem: impl FnOnce() -> Problem) -> bool {
        if !ok {
            self.push(problem());
        }
        ok
    }

    /// A count from `low` to a limit.
    pub(super) fn limited(&mut self, path: impl Text, what: impl Text, value: u64, low: u64, limit: Limit) -> bool {
        let most = self.limits.of(limit);
        self.require(value >= low, || {
            let message = format!("{what} must be at least {low}, not {value}");
            Problem::error(path.to_string(), message, format!("write a whole number from {low} to {most}"))
                .label("out of range")
        }) && self.require(value <= most, || {
            let message = format!("{what} must be at most {most}, not {value}");
            let help = format!("write a whole number from {low} to {most}; {}", limit.cure());
            Problem::error(path.to_string(), message, help).label("out of range")
        })
    }

    /// A finite number.
    pub(super) fn finite(&mut self, path: impl Text, what: impl Text, value: f64) -> bool {
        self.require(value.is_finite(), || {
            Problem::error(
                path.to_string(),
                format!("{what} must be a finite number, not {}", show(value)),
                "write a finite number",
            )
            .label("not finite")
        })
    }

    /// A coordinate or a length of either sign.
    pub(super) fn coordinate(&mut self, path: impl Text, what: impl Text, value: f64) -> bool {
        self.finite(path, what, value) && self.require(value.abs() <= MAX_LENGTH, || too_far(path, what, value))
    }

    /// A point whose coordinates can be computed with.
    pub(super) fn point(&mut self, path: impl Text, what: impl Text, point: DVec2) -> bool {
        self.coordinate(format_args!("{path}[0]"), format_args!("the x of {what}"), point.x)
            & self.coordinate(format_args!("{path}[1]"), format_args!("the y of {what}"), point.y)
    }

    /// A length above 0.
    pub(super) fn length(&mut self, path: impl Text, what: impl Text, value: f64) -> bool {
        self.coordinate(path, what, value) && self.require(value >= MIN_LENGTH, || not_positive(path, what, value))
    }

    /// A number within bounds, both included.
    pub(super) fn within(&mut self, path: impl Text, what: impl Text, value: f64, bounds: [f64; 2]) -> bool {
        self.require((bounds[0]..=bounds[1]).contains(&value), || {
            let [low, high] = bounds.map(show);
            let message = format!("{what} must lie between {low} and {high}, not be {}", show(value));
            Problem::error(path.to_string(), message, format!("write a number from {low} to {high}"))
                .label("out of range")
        })
    }

    /// A count within bounds, both included.
    pub(super) fn count(&mut self, path: impl Text, what: impl Text, value: u64, bounds: [u64; 2]) -> bool {
        let [low, high] = bounds;
        let count = |message: String| {
            Problem::error(path.to_string(), message, format!("write a whole number from {low} to {high}"))
                .label("out of range")
        };
        self.require(value >= low, || count(format!("{what} must be at least {low}, not {value}")))
            && self.require(value <= high, || count(format!("{what} must be at most {high}, not {value}")))
    }

    /// How many entries a list has at least.
    pub(super) fn at_least(&mut self, path: impl Text, owner: &str, what: &str, size: usize, low: usize) -> bool {
        self.require(size >= low, || {
            let message = match size {
                0 => format!("{owner} needs {what}, but has none"),
                _ => format!("{owner} needs at least {low} {what}, but has {size}"),
            };
            Problem::error(path.to_string(), message, format!("write {low} or more {what}")).label("too few")
        })
    }

    /// How many entries a list has at most.
    pub(super) fn at_most(&mut self, path: impl Text, owner: &str, what: &str, size: u64, limit: Limit) -> bool {
        let most = self.limits.of(limit);
        self.require(size <= most, || {
            let message = format!("{owner} may have {most} {what}, but has {size}");
            let help = format!("write at most {most} {what}; {}", limit.cure());
            Problem::error(path.to_string(), message, help).label("too many")
        })
    }

    /// Words that a figure or a result repeats.
    pub(super) fn words(&mut self, path: impl Text, words: &str) {
        let most = self.limits.of(Limit::Letters);
        // Counted only where there may be too many.
        let size = if words.len() as u64 <= most { 0 } else { words.chars().count() as u64 };
        self.at_most(path, "a text", "characters", size, Limit::Letters);
    }
}

fn too_far(path: impl Text, what: impl Text, value: f64) -> Problem {
    let message = format!("{what} is {}, too large to compute with", show(value));
    Problem::error(path.to_string(), message, format!("stay within ±{}", show(MAX_LENGTH))).label("too large")
}

fn not_positive(path: impl Text, what: impl Text, value: f64) -> Problem {
    if value > 0.0 {
        let message = format!("{what} is {}, too small to compute with", show(value));
        return Problem::error(path.to_string(), message, format!("write at least {}", show(MIN_LENGTH)))
            .label("too small");
    }
    let message = format!("{what} must be above 0, not {}", show(value));
    Problem::error(path.to_string(), message, "write a positive length, in the unit of all lengths")
        .label("not above 0")
}

/// A number for people: shortest form, with an exponent where it would be long.
pub(super) fn show(value: f64) -> String {
    let size = value.abs();
    let plain = size == 0.0 || !value.is_finite() || (1e-4..1e9).contains(&size);
    if plain { format!("{}", value + 0.0) } else { format!("{value:e}") }
}

/// A computed number for people, to six digits.
pub(super) fn show_rounded(value: f64) -> String {
    show(rounded(value))
}

/// A number of at most seven digits that is not below `value` and close to it.
pub(super) fn show_at_least(value: f64) -> String {
    let near = rounded(value);
    show(if near < value { rounded(near + 1e-5 * near.abs()) } else { near })
}

fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

/// A point for people.
pub(super) fn show_point(p: DVec2) -> String {
    format!("({}, {})", show(p.x), show(p.y))
}
