//! What ron says about text that it cannot parse, in the words of this project.

use ron::Error;
use ron::error::{Position, SpannedError};

use super::brackets::{Open, innermost_open};
use super::node::skip_blank;
use crate::scene::Problem;

/// What to say about a place where parsing stopped.
struct Fault {
    at: usize,
    message: String,
    label: &'static str,
    help: &'static str,
}

/// The problem at the place where parsing stopped; `offset` is where `text` begins in the file.
pub(super) fn syntax_problem(text: &str, offset: usize, error: &SpannedError) -> Problem {
    if skip_blank(text).is_empty() {
        let help = "a scene begins with `(` and ends with `)`; the smallest one is `()`";
        return Problem::error("", "the file holds no scene", help).at(offset..offset);
    }
    let Fault { at, message, label, help } = fault(text, error);
    let length = char_at(text, at).filter(|c| *c != '\n').map_or(0, char::len_utf8);
    Problem::error("", message, help).label(label).at(offset + at..offset + at + length)
}

fn fault(text: &str, error: &SpannedError) -> Fault {
    let at = byte_of(text, &error.span.end);
    let open = innermost_open(text, at);
    match &error.code {
        Error::UnclosedBlockComment => Fault {
            at: text.rfind("/*").unwrap_or(at),
            message: "the comment never ends".to_owned(),
            label: "begins here",
            help: "close the comment with `*/`",
        },
        Error::ExpectedStringEnd => Fault {
            at: byte_of(text, &error.span.start),
            message: "the text in quotes never ends".to_owned(),
            label: "begins here",
            help: "add the closing `\"`; a quote inside of the text is written `\\\"`",
        },
        Error::ExpectedChar => Fault {
            at: text[..at].rfind('\'').unwrap_or(at),
            message: "text does not stand in single quotes".to_owned(),
            label: "not a value",
            help: "put the text in double quotes: `\"…\"`",
        },
        Error::ExceededRecursionLimit => Fault {
            at,
            message: "the brackets are nested too deep".to_owned(),
            label: "too deep",
            help: "no scene needs more than 12 levels; check for an opening bracket too many",
        },
        _ if text[at..].is_empty() => unclosed(at, open),
        Error::ExpectedComma => separator(text, at, open),
        code => other_fault(text, at, code),
    }
}

fn other_fault(text: &str, at: usize, code: &Error) -> Fault {
    let found = found(text, at);
    let (message, help) = match code {
        Error::ExpectedArrayEnd => (format!("expected `]`, found {found}"), "close the list with `]`"),
        Error::ExpectedStructLikeEnd | Error::ExpectedOptionEnd | Error::ExpectedMapEnd => {
            (format!("expected a closing bracket, found {found}"), "close the parenthesis with `)`")
        }
        Error::ExpectedMapColon => {
            (format!("expected `:` after the field's name, found {found}"), "write a field as `name: value`")
        }
        Error::ExpectedIdentifier | Error::SuggestRawIdentifier(_) | Error::InvalidIdentifier(_) => (
            format!("expected the name of a field, found {found}"),
            "write a field as `name: value`; named and unnamed values do not mix in one pair of parentheses",
        ),
        Error::InvalidEscape(_) => (
            "the `\\` in this text begins no character".to_owned(),
            "write a backslash as `\\\\`, a quote as `\\\"`, a line break as `\\n`",
        ),
        Error::TrailingCharacters => (
            format!("the scene is complete, but {found} follows"),
            "a file holds one scene in one pair of parentheses; check for a `)` too many before",
        ),
        Error::ExpectedAttribute | Error::ExpectedAttributeEnd | Error::NoSuchExtension(_) => {
            ("a scene does not begin with `#`".to_owned(), "begin with `(`; a comment begins with `//`")
        }
        _ => (
            format!("expected a value, found {found}"),
            "write a number, text in double quotes, a point `(x, y)`, a list `[…]` or a word such as `Mirror`",
        ),
    };
    Fault { at, message, label: "not expected here", help }
}

/// The text ended in the middle of something.
fn unclosed(at: usize, open: Option<Open>) -> Fault {
    let Some(open) = open else {
        let message = "the text ends in the middle of a value".to_owned();
        return Fault { at, message, label: "ends here", help: "complete the value" };
    };
    let (bracket, help) = match open.bracket {
        '[' => ('[', "add the closing `]`"),
        other => (other, "add the closing `)`"),
    };
    Fault { at: open.at, message: format!("this `{bracket}` is never closed"), label: "opens here", help }
}

/// What is wrong, the label at its place, and what would be right.
type Words = (String, &'static str, &'static str);

/// Neither a comma nor the right closing bracket follows a value; what was probably meant shows in the text around.
fn separator(text: &str, at: usize, open: Option<Open>) -> Fault {
    let before = &text[..at];
    let (last, next) = (before.chars().next_back().unwrap_or(' '), char_at(text, at).unwrap_or(' '));
    let words = match next {
        ']' | ')' | '}' | ':' => Some(out_of_place(text, at, open)),
        _ => broken_off(last, next),
    };
    match words {
        Some((message, label, help)) => Fault { at, message, label, help },
        None => missing_comma(text, before.trim_end().len(), found(text, at)),
    }
}

/// A closing bracket of the wrong kind, or a colon where no field's name can stand before it.
fn out_of_place(text: &str, at: usize, open: Option<Open>) -> Words {
    let inside = open.map_or('(', |open| open.bracket);
    let line = open.map_or(1, |open| 1 + text[..open.at].matches('\n').count());
    match (char_at(text, at), inside) {
        (Some(':'), '[') => (
            format!("a field in the middle of the list from line {line}"),
            "not expected here",
            "close the list with `]` before, or put its fields in parentheses",
        ),
        (Some(':'), _) => (
            "a value with a name among values without names".to_owned(),
            "not expected here",
            "name all values in one pair of parentheses, or none, as the form asks for",
        ),
        _ => (
            format!("{} does not close the `{inside}` from line {line}", found(text, at)),
            "does not match",
            "close every `(` with `)` and every `[` with `]`, the inner ones first",
        ),
    }
}

/// A number, a word or text in quotes that breaks off before what belongs to it.
fn broken_off(last: char, next: char) -> Option<Words> {
    match (last, next) {
        ('0'..='9' | '.', c) if c.is_alphabetic() || "°µ%\"'".contains(c) => Some((
            format!("a number is followed by `{c}`"),
            "not part of a number",
            "write numbers without a unit: lengths in one unit of your choice, angles in degrees, wavelengths in nm",
        )),
        (c, '-') if c.is_alphanumeric() => Some((
            "a word breaks off at a dash".to_owned(),
            "not part of a word",
            "put names with a dash in quotes, as in `Catalog(\"N-BK7\")`",
        )),
        ('"', c) if c.is_alphanumeric() => Some((
            "text in quotes ends just before this".to_owned(),
            "outside of the quotes",
            "check whether a `\"` is missing further up; a quote inside of the text is written `\\\"`",
        )),
        _ => None,
    }
}

fn missing_comma(text: &str, at: usize, found: String) -> Fault {
    let value_begins = char_at(text, at + 1) == Some('"') && text[..at].ends_with(char::is_alphanumeric);
    if value_begins {
        let message = format!("expected `:` between the field's name and its value, found {found}");
        return Fault { at, message, label: "`:` is missing", help: "write a field as `name: value`" };
    }
    let message = format!("expected `,` between two values, found {found}");
    Fault { at, message, label: "`,` is missing", help: "separate values by `,`" }
}

fn char_at(text: &str, at: usize) -> Option<char> {
    text.get(at..).and_then(|rest| rest.chars().next())
}

fn found(text: &str, at: usize) -> String {
    match char_at(text, at) {
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
