//! What ron says about text that it cannot parse, in the words of this project.

use ron::Error;
use ron::error::{Position, SpannedError};

use super::brackets::{Before, Open};
use super::node::skip_blank;
use crate::characters::is_unseen;
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
    let path = Before::new(text, at).path();
    Problem::error(path, message, help).label(label).at(offset + at..offset + at + length)
}

fn fault(text: &str, error: &SpannedError) -> Fault {
    let at = byte_of(text, &error.span.end);
    let before = Before::new(text, at);
    let open = before.innermost();
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
        Error::InvalidEscape(_) => Fault {
            at: text[..at].rfind('\\').unwrap_or(at),
            message: "the `\\` in this text begins no character".to_owned(),
            label: "no such character",
            help: "write a backslash as `\\\\`, a quote as `\\\"`, a line break as `\\n`",
        },
        Error::ExceededRecursionLimit => Fault {
            at,
            message: "the brackets are nested too deep".to_owned(),
            label: "too deep",
            help: "no scene needs more than 12 levels; check for an opening bracket too many",
        },
        _ if text[at..].is_empty() => unclosed(at, open),
        code => odd_character(text, fraction(text, at).unwrap_or(at)).unwrap_or_else(|| match code {
            Error::TrailingCharacters => behind_the_scene(text, at),
            Error::ExpectedComma => separator(text, at, &before),
            _ if char_at(text, at) == Some('(') && is_in_fields(open) => parenthesis_left_open(text, at, open),
            code => other_fault(text, at, code),
        }),
    }
}

/// A character that is meant as another one, or that no scene has outside of text in quotes.
fn odd_character(text: &str, at: usize) -> Option<Fault> {
    let c = char_at(text, at).filter(|c| !matches!(c, ' ' | '\t' | '\n' | '\r'))?;
    let name = found(text, at);
    let (message, help) = match c {
        '“' | '”' | '„' | '‟' | '«' | '»' | '‘' | '’' | '‚' => (
            format!("{name} is no quote that a scene knows"),
            "put text in straight double quotes: `\"…\"`; word processors make others of them",
        ),
        '−' | '–' | '—' | '‐' | '‑' => {
            (format!("{name} is no minus sign that a scene knows"), "write the `-` of the keyboard: `-4`")
        }
        '，' | '、' | '；' | ';' => {
            (format!("{name} separates no values"), "write a comma between values, and a point in decimal numbers")
        }
        '=' => (format!("{name} stands between no name and its value"), "write a field as `name: value`"),
        '*' | '^' | '+' | '/' => {
            (format!("{name} stands here, but a scene does not calculate"), "write the result, such as `0.333` for 1/3")
        }
        '\0' => (
            "a NUL character, which no text has".to_owned(),
            "save the file as UTF-8; such characters come from UTF-16 or from a file that is no text",
        ),
        _ if is_unseen(c) || c.is_whitespace() => (
            format!("{name} stands here, which is not seen and is no blank that a scene knows"),
            "delete it, or write an ordinary blank; such characters come from web pages and word processors",
        ),
        _ => return None,
    };
    Some(Fault { at, message, label: "this character", help })
}

/// The slash of a fraction such as 1/3, behind which parsing stopped.
fn fraction(text: &str, at: usize) -> Option<usize> {
    let before = text[..at].trim_end_matches(|c: char| c.is_ascii_digit() || c == '.' || c == ' ');
    let number = before.strip_suffix('/')?;
    number.trim_end().ends_with(|c: char| c.is_ascii_digit()).then_some(number.len())
}

/// The text goes on after a whole value.
fn behind_the_scene(text: &str, at: usize) -> Fault {
    let start = text.len() - skip_blank(text).len();
    if !text[start..].starts_with('(') {
        return Fault {
            at: start,
            message: "a scene begins with `(`".to_owned(),
            label: "`(` is missing",
            help: "put the fields in parentheses, separated by commas: `(title: \"…\", bodies: […])`",
        };
    }
    Fault {
        at,
        message: format!("the scene is complete, but {} follows", found(text, at)),
        label: "not expected here",
        help: "a file holds one scene in one pair of parentheses; check for a `)` too many before",
    }
}

fn is_in_fields(open: Option<Open<'_>>) -> bool {
    open.is_some_and(|open| open.has_fields)
}

/// A parenthesis that begins where only a field may: the one before was not closed.
fn parenthesis_left_open(text: &str, at: usize, open: Option<Open<'_>>) -> Fault {
    let line = line_of(text, open);
    Fault {
        at,
        message: format!("the `(` from line {line} is not closed before this one"),
        label: "not a field",
        help: "close what stands before with `)` and separate it by `,`",
    }
}

/// The line of an open bracket, from 1.
fn line_of(text: &str, open: Option<Open<'_>>) -> usize {
    open.map_or(1, |open| 1 + text[..open.at].matches('\n').count())
}

fn other_fault(text: &str, at: usize, code: &Error) -> Fault {
    let found = found(text, at);
    let (message, help) = match code {
        Error::ExpectedArrayEnd => (format!("expected `]`, found {found}"), "close the list with `]`"),
        Error::ExpectedOptionEnd => (
            format!("`Some` holds one value, but {found} follows"),
            "close it with `)` after the one value; a value may also be written without `Some`",
        ),
        Error::ExpectedStructLikeEnd | Error::ExpectedMapEnd => {
            (format!("expected a closing bracket, found {found}"), "close the parenthesis with `)`")
        }
        Error::ExpectedMapColon => {
            (format!("expected `:` after the field's name, found {found}"), "write a field as `name: value`")
        }
        Error::ExpectedIdentifier | Error::SuggestRawIdentifier(_) | Error::InvalidIdentifier(_) => (
            format!("expected the name of a field, found {found}"),
            "write a field as `name: value`; named and unnamed values do not mix in one pair of parentheses",
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
fn unclosed(at: usize, open: Option<Open<'_>>) -> Fault {
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
fn separator(text: &str, at: usize, before: &Before<'_>) -> Fault {
    let open = before.innermost();
    let end = text[..at].trim_end().len();
    let (last, next) = (text[..at].chars().next_back().unwrap_or(' '), char_at(text, at).unwrap_or(' '));
    if let Some(begin) = before.quoted.clone().filter(|quoted| quoted.end == end && text[quoted.clone()].contains('\n'))
    {
        return runs_on(text, begin.start, at);
    }
    let words = match next {
        ']' | ')' | '}' | ':' => Some(out_of_place(text, at, open)),
        _ => broken_off(last, next),
    };
    match words {
        Some((message, label, help)) => Fault { at, message, label, help },
        None if next == '(' && is_in_fields(open) => parenthesis_left_open(text, at, open),
        None if open.is_some_and(|open| open.bracket == '[') && is_field(&text[at..]) => field_in_list(text, at, open),
        None => missing_comma(text, end, found(text, at)),
    }
}

/// Text in quotes that goes over several lines to a place where something follows: its end was meant before.
fn runs_on(text: &str, begin: usize, at: usize) -> Fault {
    let line = 1 + text[..at].matches('\n').count();
    Fault {
        at: begin,
        message: format!(
            "the text in quotes that begins here ends only on line {line}, and {} follows",
            found(text, at)
        ),
        label: "begins here",
        help: "add the closing `\"` where the text is to end; a quote inside of the text is written `\\\"`",
    }
}

/// A closing bracket of the wrong kind, or a colon where no field's name can stand before it.
fn out_of_place(text: &str, at: usize, open: Option<Open<'_>>) -> Words {
    let inside = open.map_or('(', |open| open.bracket);
    let line = line_of(text, open);
    match (char_at(text, at), inside) {
        (Some(':'), '[') => {
            let Fault { message, label, help, .. } = field_in_list(text, at, open);
            (message, label, help)
        }
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

/// Whether text begins with `name:`.
fn is_field(text: &str) -> bool {
    let rest = text.trim_start_matches(|c: char| c.is_ascii_alphanumeric() || c == '_');
    rest.len() < text.len() && rest.trim_start().starts_with(':')
}

fn field_in_list(text: &str, at: usize, open: Option<Open<'_>>) -> Fault {
    Fault {
        at,
        message: format!("a field in the middle of the list from line {}", line_of(text, open)),
        label: "not expected here",
        help: "close the list with `]` before, or put its fields in parentheses",
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
        Some(c) if is_unseen(c) || c.is_whitespace() => format!("the character U+{:04X}", u32::from(c)),
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
