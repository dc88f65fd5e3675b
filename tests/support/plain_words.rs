//! Messages in words that mean something to the author of a scene.

use snellius::scene::Problem;

/// Words of the parser and of the machinery around it.
const INNER_WORDS: [&str; 21] = [
    "serde",
    "RON",
    "struct",
    "enum",
    "tuple",
    "newtype",
    "identifier",
    " raw ",
    "deserializ",
    "visitor",
    "f64",
    "u32",
    "u64",
    "usize",
    "EOF",
    "variant",
    "r#",
    "recursion",
    "Option",
    "Vec",
    "sequence",
];

/// A problem says what is wrong and what would be right, without inner words, but for those of the scene itself.
#[track_caller]
pub(crate) fn is_in_plain_words(problem: &Problem, text: &str) {
    assert!(problem.message.len() > 10 && problem.help.len() > 10, "{problem:?}");
    let words = format!("{} {} {}", problem.message, problem.label, problem.help);
    let inner: Vec<_> = INNER_WORDS.iter().filter(|word| words.contains(**word) && !text.contains(**word)).collect();
    assert!(inner.is_empty(), "{inner:?} in: {words}");
}
