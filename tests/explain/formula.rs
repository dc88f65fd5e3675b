//! A reader of printed formulas, in letters or in numbers.

use std::collections::BTreeMap;

use crate::interval::{Interval, Value};

/// What the letters stand for.
pub(crate) type Known = BTreeMap<String, Value>;

/// The value of a formula; its numbers are exact.
pub(crate) fn value(text: &str, known: &Known) -> Value {
    let mut reader = Reader { rest: text, known };
    let value = reader.sum();
    assert!(reader.rest.is_empty(), "{:?} is left of {text:?}", reader.rest);
    value
}

struct Reader<'a> {
    rest: &'a str,
    known: &'a Known,
}

impl Reader<'_> {
    fn takes(&mut self, sign: &str) -> bool {
        let rest = self.rest.strip_prefix(sign);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }

    fn expects(&mut self, sign: &str) {
        assert!(self.takes(sign), "{sign:?} is missing before {:?}", self.rest);
    }

    fn sum(&mut self) -> Value {
        let mut sum = if self.takes("-") { -self.product() } else { self.product() };
        loop {
            if self.takes(" + ") {
                sum = sum + self.product();
            } else if self.takes(" - ") {
                sum = sum - self.product();
            } else {
                return sum;
            }
        }
    }

    fn product(&mut self) -> Value {
        let mut product = self.power();
        loop {
            let is_sum = [" + ", " - ", " × "].iter().any(|sign| self.rest.starts_with(sign));
            if self.takes("/") {
                product = product / self.power();
            } else if self.takes("·") || (!is_sum && self.takes(" ")) {
                product = product * self.power();
            } else {
                return product;
            }
        }
    }

    fn power(&mut self) -> Value {
        let base = self.one();
        if self.takes("²") { Value::Number(base.number().square()) } else { base }
    }

    fn one(&mut self) -> Value {
        let all = (f64::NEG_INFINITY, f64::INFINITY);
        if self.takes("√") {
            return Value::Number(self.one().number().map((0.0, f64::INFINITY), f64::sqrt));
        }
        if self.takes("arcsin") {
            return Value::Number(self.one().number().map((-1.0, 1.0), |x| x.asin().to_degrees()));
        }
        if self.takes("arccos") {
            return Value::Number(self.one().number().map((-1.0, 1.0), |x| x.acos().to_degrees()));
        }
        if self.takes("arctan") {
            return Value::Number(self.one().number().map(all, |x| x.atan().to_degrees()));
        }
        if self.takes("∠(") {
            let from = self.sum();
            self.expects(", ");
            let to = self.sum();
            self.expects(")");
            return from.angle_to(to);
        }
        if self.takes("|") {
            let first = self.sum();
            let value = if self.takes(" × ") { first.cross(self.sum()) } else { Value::Number(first.number().size()) };
            self.expects("|");
            return value;
        }
        if self.takes("(") { self.bracket() } else { self.word() }
    }

    /// What stands in brackets: a formula, or a vector.
    fn bracket(&mut self) -> Value {
        let first = self.sum();
        let value = if self.takes(", ") { Value::Vector(first.number(), self.sum().number()) } else { first };
        self.expects(")");
        value
    }

    /// A number or a letter.
    fn word(&mut self) -> Value {
        let mut end = 0;
        for (at, c) in self.rest.char_indices() {
            let in_exponent =
                c == '-' && self.rest[..at].ends_with('e') && self.rest.starts_with(|c: char| c.is_ascii_digit());
            if !(c.is_alphanumeric() && c != '²' || "._".contains(c) || in_exponent) {
                break;
            }
            end = at + c.len_utf8();
        }
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        let number = || Value::Number(Interval::exactly(word.parse().unwrap_or_else(|_| panic!("unknown: {word:?}"))));
        self.known.get(word).copied().unwrap_or_else(number)
    }
}
