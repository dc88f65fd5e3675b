//! Formulas that are written in letters or with numbers in their place, in plain text or in LaTeX.

use glam::DVec2;

use crate::report::{fixed, significant};

/// How a formula is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Notation {
    Plain,
    Latex,
}

/// What stands for a letter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reading {
    Letters,
    Numbers,
}

/// A value as it is printed.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    Number(String),
    Vector(String, String),
}

/// A letter and its value, if it has one.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Letter {
    pub(super) plain: &'static str,
    pub(super) latex: &'static str,
    pub(super) value: Option<Value>,
}

/// A formula.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Formula {
    Letter(Letter),
    /// A number that the law itself contains.
    Constant(&'static str),
    /// A formula whose value is known.
    Known(Box<Self>, Value),
    Minus(Box<Self>),
    /// Two formulas with a sign between.
    Pair(Box<Self>, Sign, Box<Self>),
    Quotient(Box<Self>, Box<Self>),
    Root(Box<Self>),
    Square(Box<Self>),
    /// The size of a number.
    Size(Box<Self>),
    /// Length of the vector product.
    Cross(Box<Self>, Box<Self>),
    /// The angle from one vector to the other.
    Angle(Box<Self>, Box<Self>),
    /// `arcsin`, `arccos` or `arctan`.
    Arc(&'static str, Box<Self>),
}

/// What stands between two formulas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sign {
    Plus,
    Less,
    Times,
    Dot,
}

/// How tightly a formula holds together: what is looser than its place allows stands in brackets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Hold {
    Sum,
    Product,
    One,
}

/// Numbers below are rounding.
const NOISE: f64 = 1e-12;

impl Value {
    /// A number to 6 digits.
    pub(super) fn number(x: f64) -> Self {
        Self::Number(digits(x))
    }

    /// A number to 6 digits, however small.
    pub(super) fn exact(x: f64) -> Self {
        Self::Number(significant(x))
    }

    /// A length with so many decimals.
    pub(super) fn length(x: f64, decimals: usize) -> Self {
        Self::Number(fixed(x, decimals))
    }

    /// A vector without a unit, 6 digits each.
    pub(super) fn vector(v: DVec2) -> Self {
        Self::Vector(digits(v.x), digits(v.y))
    }

    /// A point.
    pub(super) fn point(p: DVec2, decimals: usize) -> Self {
        Self::Vector(fixed(p.x, decimals), fixed(p.y, decimals))
    }

    pub(super) fn write(&self, notation: Notation) -> String {
        match self {
            Self::Number(x) => number(x, notation),
            Self::Vector(x, y) => format!("({}, {})", number(x, notation), number(y, notation)),
        }
    }

    fn hold(&self) -> Hold {
        match self {
            Self::Number(x) if x.starts_with('-') => Hold::Sum,
            Self::Number(x) if x.contains('e') => Hold::Product,
            _ => Hold::One,
        }
    }
}

fn digits(x: f64) -> String {
    if x.abs() < NOISE { "0".into() } else { significant(x) }
}

fn number(shown: &str, notation: Notation) -> String {
    match shown.split_once('e') {
        Some((digits, power)) if notation == Notation::Latex => format!(r"{digits} \cdot 10^{{{power}}}"),
        _ => shown.into(),
    }
}

impl Letter {
    pub(super) fn new(plain: &'static str, latex: &'static str, value: Option<Value>) -> Self {
        Self { plain, latex, value }
    }

    pub(super) fn write(&self, notation: Notation) -> &'static str {
        if notation == Notation::Plain { self.plain } else { self.latex }
    }
}

impl From<&Letter> for Formula {
    fn from(letter: &Letter) -> Self {
        Self::Letter(letter.clone())
    }
}

impl Formula {
    fn pair(self, sign: Sign, other: impl Into<Self>) -> Self {
        Self::Pair(Box::new(self), sign, Box::new(other.into()))
    }

    pub(super) fn plus(self, other: impl Into<Self>) -> Self {
        self.pair(Sign::Plus, other)
    }

    pub(super) fn less(self, other: impl Into<Self>) -> Self {
        self.pair(Sign::Less, other)
    }

    pub(super) fn times(self, other: impl Into<Self>) -> Self {
        self.pair(Sign::Times, other)
    }

    pub(super) fn dot(self, other: impl Into<Self>) -> Self {
        self.pair(Sign::Dot, other)
    }

    pub(super) fn over(self, other: impl Into<Self>) -> Self {
        Self::Quotient(Box::new(self), Box::new(other.into()))
    }

    pub(super) fn minus(self) -> Self {
        Self::Minus(Box::new(self))
    }

    pub(super) fn root(self) -> Self {
        Self::Root(Box::new(self))
    }

    pub(super) fn square(self) -> Self {
        Self::Square(Box::new(self))
    }

    /// Whether every letter has a value.
    pub(super) fn has_numbers(&self) -> bool {
        match self {
            Self::Letter(letter) => letter.value.is_some(),
            Self::Constant(_) | Self::Known(..) => true,
            Self::Minus(a) | Self::Root(a) | Self::Square(a) | Self::Size(a) | Self::Arc(_, a) => a.has_numbers(),
            Self::Pair(a, _, b) | Self::Quotient(a, b) | Self::Cross(a, b) | Self::Angle(a, b) => {
                a.has_numbers() && b.has_numbers()
            }
        }
    }

    pub(super) fn write(&self, reading: Reading, notation: Notation) -> String {
        Writer { reading, notation }.write(self, Hold::Sum)
    }
}

#[derive(Clone, Copy)]
struct Writer {
    reading: Reading,
    notation: Notation,
}

impl Writer {
    /// A formula in a place that wants it to hold together.
    fn write(self, formula: &Formula, wanted: Hold) -> String {
        let (written, hold) = self.bare(formula);
        match (hold < wanted, self.notation) {
            (false, _) => written,
            (true, Notation::Plain) => format!("({written})"),
            (true, Notation::Latex) => format!(r"\left({written}\right)"),
        }
    }

    fn bare(self, formula: &Formula) -> (String, Hold) {
        let latex = self.notation == Notation::Latex;
        let sum = |a| self.write(a, Hold::Sum);
        match formula {
            Formula::Letter(letter) => self.letter(letter),
            Formula::Constant(digits) => ((*digits).into(), Hold::One),
            Formula::Known(_, value) if self.reading == Reading::Numbers => (value.write(self.notation), value.hold()),
            Formula::Known(formula, _) => self.bare(formula),
            Formula::Minus(a) => (format!("-{}", self.write(a, Hold::Product)), Hold::Sum),
            Formula::Pair(a, sign, b) => self.pair(a, *sign, b),
            Formula::Quotient(a, b) if latex => (format!(r"\frac{{{}}}{{{}}}", sum(a), sum(b)), Hold::Product),
            Formula::Quotient(a, b) => {
                (format!("{}/{}", self.write(a, Hold::Product), self.write(b, Hold::One)), Hold::Product)
            }
            Formula::Root(a) if latex => (format!(r"\sqrt{{{}}}", sum(a)), Hold::One),
            Formula::Root(a) => (format!("√{}", self.write(a, Hold::One)), Hold::One),
            Formula::Square(a) => {
                (format!("{}{}", self.write(a, Hold::One), if latex { "^2" } else { "²" }), Hold::One)
            }
            Formula::Size(a) => (format!("|{}|", sum(a)), Hold::One),
            Formula::Cross(a, b) => {
                (format!("|{} {} {}|", sum(a), if latex { r"\times" } else { "×" }, sum(b)), Hold::One)
            }
            Formula::Angle(a, b) => {
                (format!("{}({}, {})", if latex { r"\angle" } else { "∠" }, sum(a), sum(b)), Hold::One)
            }
            Formula::Arc(name, a) => (format!("{}{name}({})", if latex { r"\" } else { "" }, sum(a)), Hold::One),
        }
    }

    fn letter(self, letter: &Letter) -> (String, Hold) {
        match &letter.value {
            Some(value) if self.reading == Reading::Numbers => (value.write(self.notation), value.hold()),
            _ => (letter.write(self.notation).into(), Hold::One),
        }
    }

    fn pair(self, a: &Formula, sign: Sign, b: &Formula) -> (String, Hold) {
        let dot = if self.notation == Notation::Latex { r" \cdot " } else { "·" };
        let (sign, hold, right) = match sign {
            Sign::Plus => (" + ", Hold::Sum, Hold::Product),
            Sign::Less => (" - ", Hold::Sum, Hold::Product),
            Sign::Times if self.reading == Reading::Letters => (" ", Hold::Product, Hold::One),
            Sign::Times | Sign::Dot => (dot, Hold::Product, Hold::One),
        };
        (format!("{}{sign}{}", self.write(a, hold), self.write(b, right)), hold)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn both(formula: &Formula, notation: Notation) -> [String; 2] {
        [Reading::Letters, Reading::Numbers].map(|reading| formula.write(reading, notation))
    }

    fn letter(plain: &'static str, x: f64) -> Formula {
        Formula::Letter(Letter::new(plain, plain, Some(Value::exact(x))))
    }

    #[test]
    fn brackets_stand_where_they_must() {
        let (a, b, c) = (letter("a", 2.0), letter("b", -3.0), letter("c", 4e-9));
        let plain = |formula| both(&formula, Notation::Plain);
        assert_eq!(plain(a.clone().less(b.clone())), ["a - b", "2 - (-3)"]);
        assert_eq!(plain(a.clone().plus(b.clone()).times(c.clone())), ["(a + b) c", "(2 + (-3))·(4e-9)"]);
        assert_eq!(plain(a.clone().over(b.clone().times(c.clone()))), ["a/(b c)", "2/((-3)·(4e-9))"]);
        assert_eq!(plain(b.clone().square().minus()), ["-b²", "-(-3)²"]);
        assert_eq!(plain(a.clone().plus(c.clone()).root()), ["√(a + c)", "√(2 + 4e-9)"]);
        let latex = |formula| both(&formula, Notation::Latex);
        assert_eq!(
            latex(a.clone().less(b.clone()).over(c.clone())),
            [r"\frac{a - b}{c}", r"\frac{2 - \left(-3\right)}{4 \cdot 10^{-9}}"]
        );
        assert_eq!(latex(a.over(b).square()), [r"\left(\frac{a}{b}\right)^2", r"\left(\frac{2}{-3}\right)^2"]);
        assert_eq!(latex(c.square())[1], r"\left(4 \cdot 10^{-9}\right)^2");
    }

    #[test]
    fn rounding_prints_as_nothing() {
        let vector = |x, y| Value::vector(DVec2::new(x, y)).write(Notation::Plain);
        assert_eq!(vector(-6e-17, 1.0 - 1e-16), "(0, 1)");
        assert_eq!(vector(0.123_456_78, -1.5e-7), "(0.123457, -1.5e-7)");
        assert_eq!(Value::exact(-5e-16).write(Notation::Plain), "-5e-16");
    }

    #[test]
    fn a_letter_without_a_value_leaves_no_numbers() {
        let unknown = Letter::new("C2", "C_2", None);
        assert!(!letter("a", 1.0).times(&unknown).has_numbers());
        assert!(letter("a", 1.0).root().has_numbers());
    }
}
