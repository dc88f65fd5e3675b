//! Printed worked solutions, read back.

use crate::formula::{self, Known};
use crate::interval::{Interval, Value};

/// One ray's worked solution.
pub(crate) struct Solution {
    /// Where and along which direction it starts.
    pub(crate) start: Known,
    pub(crate) hits: Vec<PrintedHit>,
    pub(crate) end: String,
}

#[derive(Default)]
pub(crate) struct PrintedHit {
    pub(crate) heading: String,
    /// Share of the ray's power that arrives.
    pub(crate) arriving: Option<Value>,
    pub(crate) given: Known,
    pub(crate) lines: Vec<PrintedLine>,
}

/// `LETTER = FORMULA = NUMBERS = RESULT, REMARK`, not all of them always there.
pub(crate) struct PrintedLine {
    pub(crate) letter: String,
    pub(crate) formula: Option<String>,
    pub(crate) numbers: Option<String>,
    pub(crate) result: Option<Value>,
    pub(crate) remark: String,
}

/// Lengths among the letters.
const LENGTHS: [&str; 5] = ["P0", "P", "M", "h", "s"];
/// Smaller numbers print as 0.
const NOISE: f64 = 1e-12;

pub(crate) fn solutions(text: &str) -> Vec<Solution> {
    text.split("\nRay ").skip(1).map(solution).collect()
}

fn solution(text: &str) -> Solution {
    let decimals = between(text, "Lengths are rounded to ", " decimals").parse().unwrap();
    let starts = text.lines().find(|line| line.starts_with("The ray starts at ")).unwrap();
    let start = letters(&starts.replacen("The ray starts at ", "", 1).replace(" along ", ", "), decimals);
    let mut parts = text.split("\nHit ");
    parts.next();
    let hits: Vec<_> = parts.map(|part| hit(part.split("\nEnd\n").next().unwrap(), decimals)).collect();
    Solution { start, hits, end: text.split("\nEnd\n").nth(1).unwrap().trim().into() }
}

fn hit(text: &str, decimals: i32) -> PrintedHit {
    let mut hit = PrintedHit { heading: text.lines().next().unwrap().into(), ..PrintedHit::default() };
    for line in text.lines().skip(1) {
        if let Some(given) = line.strip_prefix("Given: ") {
            hit.given = letters(given, decimals);
        } else if line.starts_with("Light arrives: ") {
            hit.arriving = Some(share(line));
        } else if let Some(item) = line.strip_prefix("  ") {
            hit.lines.push(item_line(item.split_once(' ').unwrap().1.trim(), decimals));
        }
    }
    hit
}

/// The share of the ray's power that a sentence tells.
pub(crate) fn share(sentence: &str) -> Value {
    printed(&between(sentence, ", with ", " of the ray's power").replace("all", "1"), None)
}

pub(crate) fn between<'a>(text: &'a str, before: &str, after: &str) -> &'a str {
    let rest = text.split_once(before).unwrap_or_else(|| panic!("{before:?} in {text:?}")).1;
    rest.split(after).next().unwrap()
}

fn item_line(item: &str, decimals: i32) -> PrintedLine {
    // The comma of a remark is not one of a vector.
    let cut = item.match_indices(", ").find(|(at, _)| depth(&item[..*at]) == 0).map(|(at, _)| at);
    let (math, remark) = cut.map_or((item, ""), |at| (&item[..at], &item[at + 2..]));
    let mut sides: Vec<_> = math.split(" = ").collect();
    let letter = sides.remove(0).to_owned();
    let length = LENGTHS.contains(&letter.as_str()).then_some(decimals);
    let result = if remark.starts_with("none: ") { None } else { Some(printed(sides.pop().unwrap(), length)) };
    let mut sides = sides.into_iter().map(str::to_owned);
    PrintedLine { letter, formula: sides.next(), numbers: sides.next(), result, remark: remark.into() }
}

fn depth(text: &str) -> usize {
    text.matches('(').count() - text.matches(')').count()
}

/// `X = …` in a sentence, between commas.
fn letters(sentence: &str, decimals: i32) -> Known {
    let mut known = Known::new();
    let mut rest = sentence;
    while let Some((before, after)) = rest.split_once(" = ") {
        let letter = before.rsplit(' ').next().unwrap();
        let vector = after.starts_with('(').then(|| after.find(')').unwrap() + 1);
        let end = vector.unwrap_or_else(|| after.find([',', ' ']).unwrap_or(after.len()));
        let length = LENGTHS.contains(&letter).then_some(decimals);
        known.insert(letter.into(), printed(after[..end].trim_end_matches('.'), length));
        rest = &after[end..];
    }
    known
}

/// All that a printed value may stand for: a length has so many decimals, all else 6 digits.
pub(crate) fn printed(text: &str, decimals: Option<i32>) -> Value {
    let blur = |x: Interval| {
        let x = x.middle();
        let last_digit = match decimals {
            Some(decimals) => 10_f64.powi(-decimals),
            None if x == 0.0 => 2.0 * NOISE,
            None => 10_f64.powf(x.abs().log10().floor() - 5.0),
        };
        Interval::around(x, 0.5 * last_digit * (1.0 + 1e-9))
    };
    match formula::value(text.trim_end_matches('°'), &Known::new()) {
        Value::Number(x) => Value::Number(blur(x)),
        Value::Vector(x, y) => Value::Vector(blur(x), blur(y)),
    }
}
