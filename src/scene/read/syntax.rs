//! What ron says about text that it cannot parse, in the words of this project.

use ron::Error;
use ron::error::{Position, SpannedError};

use super::node::skip_blank;
use crate::scene::Problem;

/// The problem at the place where parsing stopped; `offset` is where `text` begins in the file.
pub(super) fn syntax_problem(text: &str, offset: usize, error: &SpannedError) -> Problem {
    if skip_blank(text).is_empty() {
        let help = "a scene begins with `(` and ends with `)`; the smallest one is `()`";
        return Problem::error("", "the file holds no scene", help).at(offset..offset);
    }
    let (message, label, help) = words(text, error);
    // Strings and block comments that never end are shown where they begin.
    let place = match error.code {
        Error::ExpectedStringEnd => &error.span.start,
        _ => &error.span.end,
    };
    let start = byte_of(text, place);
    let length =
        text.get(start..).and_then(|rest| rest.chars().next()).filter(|c| *c != '\n').map_or(0, char::len_utf8);
    Problem::error("", message, help).label(label).at(offset + start..offset + start + length)
}

fn words(text: &str, error: &SpannedError) -> (String, &'static str, &'static str) {
    let found = found(text, byte_of(text, &error.span.end));
    match &error.code {
        Error::Eof => (
            "the text ends in the middle of a value".to_owned(),
            "ends here",
            "complete the value and close every `(` and `[`",
        ),
        Error::ExpectedComma if found == "the end of the text" => {
            ("a closing bracket is missing".to_owned(), "ends here", "close every `(` with `)` and every `[` with `]`")
        }
        Error::ExpectedComma => (
            format!("expected `,` or a closing bracket, found {found}"),
            "not expected here",
            "separate values by `,` and close every bracket; words with a dash or blank in them need quotes, as in `Catalog(\"N-BK7\")`",
        ),
        Error::ExpectedArrayEnd => {
            (format!("expected `]`, found {found}"), "not expected here", "close the list with `]`")
        }
        Error::ExpectedStructLikeEnd | Error::ExpectedOptionEnd | Error::ExpectedMapEnd => (
            format!("expected a closing bracket, found {found}"),
            "not expected here",
            "close the parenthesis with `)`",
        ),
        Error::ExpectedMapColon => (
            format!("expected `:` after the field's name, found {found}"),
            "not expected here",
            "write a field as `name: value`",
        ),
        Error::ExpectedIdentifier | Error::SuggestRawIdentifier(_) | Error::InvalidIdentifier(_) => (
            format!("expected the name of a field, found {found}"),
            "not a name",
            "write a field as `name: value`; named and unnamed values do not mix in one pair of parentheses",
        ),
        Error::ExpectedStringEnd => (
            "the text in quotes never ends".to_owned(),
            "begins here",
            "add the closing `\"`; a quote inside of the text is written `\\\"`",
        ),
        Error::InvalidEscape(_) => (
            "unknown escape in the text".to_owned(),
            "after a `\\`",
            "write a backslash as `\\\\`, a quote as `\\\"`, a line break as `\\n`",
        ),
        Error::UnclosedBlockComment => {
            ("the comment never ends".to_owned(), "ends here", "close the comment with `*/`")
        }
        Error::TrailingCharacters => (
            format!("the scene is complete, but {found} follows"),
            "not expected here",
            "a file holds one scene in one pair of parentheses; check for a `)` too many before",
        ),
        Error::ExceededRecursionLimit => (
            "the brackets are nested too deep".to_owned(),
            "too deep",
            "no scene needs more than 12 levels; check for an opening bracket too many",
        ),
        Error::UnexpectedChar(_) => (
            format!("expected a value, found {found}"),
            "not a value",
            "write a number, text in quotes, a point `(x, y)`, a list `[…]` or a word such as `Mirror`; a comment begins with `//`",
        ),
        Error::ExpectedAttribute | Error::ExpectedAttributeEnd | Error::NoSuchExtension(_) => (
            "a scene does not begin with `#`".to_owned(),
            "not expected here",
            "begin with `(`; a comment begins with `//`",
        ),
        _ => (
            format!("expected a number or another value, found {found}"),
            "not a value",
            "write a number such as `1.5` or `2e-3`, text in quotes, a point `(x, y)` or a list `[…]`",
        ),
    }
}

fn found(text: &str, at: usize) -> String {
    match text.get(at..).and_then(|rest| rest.chars().next()) {
        None => "the end of the text".to_owned(),
        Some('\n' | '\r') => "the end of the line".to_owned(),
        Some(c) if c.is_control() => "a control character".to_owned(),
        Some(c) => format!("`{c}`"),
    }
}

/// The byte at a line and column, both counted from 1, the column in characters.
fn byte_of(text: &str, place: &Position) -> usize {
    let line_start = if place.line <= 1 {
        0
    } else {
        text.match_indices('\n').nth(place.line - 2).map_or(text.len(), |(at, _)| at + 1)
    };
    let line = text.get(line_start..).unwrap_or_default();
    line_start + line.char_indices().nth(place.col.saturating_sub(1)).map_or(line.len(), |(at, _)| at)
}
