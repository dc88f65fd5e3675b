//! Explanations in LaTeX: no word is a command.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use snellius::explain;

use crate::support::{Run, hostile, run_text};
use crate::{explained, steers};

/// What LaTeX does with the characters of a document: its commands; groups and formulas end where they begin.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Latex {
    pub(crate) commands: BTreeSet<String>,
    lines: usize,
}

impl Latex {
    pub(crate) fn read(document: &str) -> Self {
        let mut read = Self { lines: document.lines().count(), ..Self::default() };
        let mut characters = document.chars().peekable();
        let (mut depth, mut in_formula) = (0_i32, false);
        while let Some(c) = characters.next() {
            match c {
                '\\' => {
                    let mut name = String::new();
                    while let Some(letter) = characters.next_if(char::is_ascii_alphabetic) {
                        name.push(letter);
                    }
                    if name.is_empty() {
                        name.extend(characters.next());
                    }
                    read.commands.insert(name);
                }
                '{' => depth += 1,
                '}' => depth -= 1,
                '$' => in_formula = !in_formula,
                '_' | '^' => assert!(in_formula, "a formula outside of one"),
                '%' | '#' | '&' | '~' => panic!("{c} acts"),
                _ => {}
            }
            assert!(depth >= 0, "a group ends that has not begun");
        }
        assert!(depth == 0 && !in_formula);
        read
    }
}

/// Commands for characters of words.
const LETTERS: [&str; 15] = [
    "textbackslash",
    "textasciitilde",
    "textasciicircum",
    "textless",
    "textgreater",
    "textquotedbl",
    "textasciigrave",
    "textdegree",
    "{",
    "}",
    "#",
    "$",
    "%",
    "&",
    "_",
];

pub(crate) fn latex_is_tame(run: &Run) {
    static PLAIN: LazyLock<Latex> =
        LazyLock::new(|| Latex::read(&explained(&run_text(&hostile::scene("a")), explain::latex)));
    let document = explained(run, explain::latex);
    let read = Latex::read(&document);
    assert_eq!(read.lines, PLAIN.lines);
    let unknown: Vec<_> =
        read.commands.difference(&PLAIN.commands).filter(|name| !LETTERS.contains(&name.as_str())).collect();
    let is_letter = |name: &&&String| !GREEK.contains(&name.as_str());
    assert_eq!(unknown.iter().filter(is_letter).count(), 0, "{unknown:?}");
    assert!(
        document.chars().all(|c| c == '\n' || (!steers(c) && (c < '\u{180}' || "–—‘’“”…".contains(c)))),
        "{document:?}"
    );
}

/// Signs that words and formulas alike are written with.
const GREEK: [&str; 34] = [
    "alpha",
    "beta",
    "gamma",
    "delta",
    "varepsilon",
    "eta",
    "theta",
    "lambda",
    "mu",
    "nu",
    "pi",
    "rho",
    "sigma",
    "tau",
    "varphi",
    "chi",
    "psi",
    "omega",
    "Delta",
    "Sigma",
    "Omega",
    "infty",
    "to",
    "leftarrow",
    "le",
    "ge",
    "approx",
    "ne",
    "surd",
    "angle",
    "cdot",
    "perp",
    "parallel",
    "circ",
];
