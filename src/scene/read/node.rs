//! One value of the scene file. The ron crate parses; this file asks it for one level at a time and keeps every place.

use std::fmt;
use std::ops::Range;

use ron::de::Deserializer;
use ron::value::RawValue;
use serde::Deserializer as _;
use serde::de::{IgnoredAny, Visitor};

use super::split::parts;
use crate::scene::problem::shortened;

/// What may follow a word.
const ENDS_WORD: [char; 12] = [':', ',', '(', ')', '[', ']', '{', '}', ' ', '\t', '\n', '\r'];

/// A value of the file: its text without surrounding blanks, where it begins, and its path such as `bodies[2].shape`.
#[derive(Clone, Debug)]
pub(super) struct Node<'a> {
    text: &'a str,
    offset: usize,
    /// Empty for the scene itself.
    pub(super) path: String,
}

/// A field as written: its name, the name's place, and its value.
#[derive(Clone, Debug)]
pub(super) struct Entry<'a> {
    pub(super) name: &'a str,
    pub(super) name_span: Range<usize>,
    pub(super) value: Node<'a>,
}

/// What a value looks like before it is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Number,
    Text,
    Bool,
    List,
    /// `(…)` with values, or empty.
    Group,
    /// `(name: …)`.
    Fields,
    /// `Name` or `Name(…)`.
    Name,
    /// `{…}`, which no scene uses.
    Braces,
    /// Single quotes and other forms that no scene uses.
    Other,
}

impl Kind {
    /// The kind in words, for "found …".
    pub(super) fn words(self) -> &'static str {
        match self {
            Self::Number => "a number",
            Self::Text => "text in quotes",
            Self::Bool => "`true` or `false`",
            Self::List => "a list",
            Self::Group => "values in parentheses",
            Self::Fields => "named fields in parentheses",
            Self::Name => "a word",
            Self::Braces => "braces",
            Self::Other => "a character or something else that no scene has",
        }
    }
}

impl<'a> Node<'a> {
    /// The whole file; `offset` is where `text` begins in it.
    pub(super) fn root(text: &'a str, offset: usize) -> Self {
        Self { text, offset, path: String::new() }
    }

    /// The part of a file at a place that was recorded for `path`.
    pub(super) fn at(file: &'a str, span: Range<usize>, path: &str) -> Option<Self> {
        file.get(span.clone()).map(|text| Self { text, offset: span.start, path: path.to_owned() })
    }

    /// The value as written.
    pub(super) fn text(&self) -> &'a str {
        self.text
    }

    /// Where the value stands in the file, in bytes.
    pub(super) fn span(&self) -> Range<usize> {
        self.offset..self.offset + self.text.len()
    }

    fn span_of(&self, part: &str) -> Range<usize> {
        let start = self.offset + (part.as_ptr().addr() - self.text.as_ptr().addr());
        start..start + part.len()
    }

    fn part(&self, text: &'a str, path: String) -> Self {
        Self { text, offset: self.span_of(text).start, path }
    }

    /// The path of a field of this value.
    pub(super) fn field_path(&self, name: &str) -> String {
        if self.path.is_empty() { name.to_owned() } else { format!("{}.{name}", self.path) }
    }

    pub(super) fn kind(&self) -> Kind {
        let text = skip_blank(self.text);
        match text.chars().next() {
            Some('"') => Kind::Text,
            Some('0'..='9' | '+' | '-' | '.') => Kind::Number,
            Some('[') => Kind::List,
            Some('(') => group_kind(text),
            Some('{') => Kind::Braces,
            Some('r') if text.starts_with("r\"") || text.starts_with("r#") => Kind::Text,
            _ => word(text).map_or(Kind::Other, |(word, _)| match word {
                "true" | "false" => Kind::Bool,
                "inf" | "NaN" => Kind::Number,
                _ => Kind::Name,
            }),
        }
    }

    /// The leading word of `Name` or `Name(…)` and what follows in parentheses, if anything.
    pub(super) fn word(&self) -> Option<(&'a str, Option<Self>)> {
        let (word, rest) = word(self.text)?;
        let arguments = (!rest.is_empty()).then(|| self.part(rest, self.path.clone()));
        Some((word, arguments))
    }

    /// The place of the leading word, or of the whole value if it has none.
    pub(super) fn word_span(&self) -> Range<usize> {
        word(self.text).map_or_else(|| self.span(), |(word, _)| self.span_of(word))
    }

    /// The fields of `(name: value, …)`, in order, repeated ones included.
    pub(super) fn fields(&self) -> Option<impl Iterator<Item = Entry<'a>>> {
        let is_sound = self.kind() == Kind::Fields && self.parts().all(|part| field(part).is_some());
        let entry = |(name, value)| {
            let value = self.part(trimmed(value), self.field_path(&shortened(name)));
            Entry { name, name_span: self.span_of(name), value }
        };
        is_sound.then(|| self.parts().filter_map(field).map(entry))
    }

    /// The elements of `[…]`.
    pub(super) fn list(&self) -> Option<impl Iterator<Item = Self>> {
        (self.kind() == Kind::List).then(|| self.elements())
    }

    /// The elements of `(…)`.
    pub(super) fn group(&self) -> Option<impl Iterator<Item = Self>> {
        (self.kind() == Kind::Group).then(|| self.elements())
    }

    /// The elements of `(…)` if there are so many.
    pub(super) fn group_of<const N: usize>(&self) -> Option<[Self; N]> {
        let elements: Vec<Self> = self.group()?.take(N + 1).collect();
        elements.try_into().ok()
    }

    fn elements(&self) -> impl Iterator<Item = Self> {
        let element = |(k, part): (usize, &'a str)| self.part(trimmed(part), format!("{}[{k}]", self.path));
        self.parts().enumerate().map(element)
    }

    /// What stands between the commas.
    fn parts(&self) -> impl Iterator<Item = &'a str> {
        parts(skip_blank(self.text))
    }

    /// How many elements a list or a group has.
    pub(super) fn size(&self) -> usize {
        self.parts().count()
    }

    /// Whether it is `(…)` and holds numbers and nothing else.
    pub(super) fn holds_only_numbers(&self) -> bool {
        self.group().is_some_and(|mut elements| elements.all(|element| element.kind() == Kind::Number))
    }

    /// The value as a Rust type that ron reads by itself.
    pub(super) fn plain<T: serde::Deserialize<'a>>(&self) -> Option<T> {
        ron::from_str(self.text).ok()
    }
}

/// Whether the text turns on a part of ron other than leaving out `Some`, which would change what values mean.
pub(super) fn enables_extensions(text: &str) -> bool {
    reader(text).is_some_and(|de| de.extensions() != ron::extensions::Extensions::IMPLICIT_SOME)
}

/// Checks the whole text as ron.
pub(super) fn check_syntax(text: &str) -> Result<(), ron::error::SpannedError> {
    options().from_str::<IgnoredAny>(text).map(|_| ())
}

/// The text of a value without blanks and comments around it. Finding its end takes a parse, which only a comment makes needed.
fn trimmed(text: &str) -> &str {
    let text = skip_blank(text);
    if text.is_ascii() && !text.contains('/') {
        return text.trim_end();
    }
    let has_more = text.ends_with(char::is_whitespace) || text.ends_with("*/");
    let raw = has_more.then(|| RawValue::from_ron(text).ok()).flatten();
    raw.map_or(text, |raw| raw.trim().get_ron())
}

fn options() -> ron::Options {
    ron::Options::default().with_default_extension(ron::extensions::Extensions::IMPLICIT_SOME)
}

fn reader(text: &str) -> Option<Deserializer<'_>> {
    Deserializer::from_str_with_options(text, &options()).ok()
}

/// The text after leading blanks and comments.
pub(super) fn skip_blank(text: &str) -> &str {
    let begins = text.trim_ascii_start();
    match begins.as_bytes().first() {
        Some(b'/' | b'#' | 0x0b | 0x80..) => reader(text).map_or(text, |de| de.remainder()),
        _ => begins,
    }
}

/// The name and the value of `name: value`.
fn field(part: &str) -> Option<(&str, &str)> {
    let (name, rest) = word(part)?;
    Some((name, rest.strip_prefix(':')?))
}

/// The word that a text begins with, and what follows.
fn word(text: &str) -> Option<(&str, &str)> {
    let text = skip_blank(text);
    if text.starts_with(|c: char| c.is_ascii_digit() || "([{\"+-.".contains(c)) {
        return None;
    }
    let plain = text.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(text.len());
    let (word, rest) = text.split_at(plain);
    // Words with other characters and what stands in quotes behind a letter are left to ron.
    if word.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') && rest.starts_with(ENDS_WORD) | rest.is_empty()
    {
        return Some((word, skip_blank(rest)));
    }
    let mut de = reader(text)?;
    let word = de.deserialize_identifier(Word).ok()?;
    Some((word, skip_blank(de.remainder())))
}

fn group_kind(text: &str) -> Kind {
    let named = word(skip_blank(&text[1..])).is_some_and(|(_, rest)| rest.starts_with(':'));
    if named { Kind::Fields } else { Kind::Group }
}

struct Word;

impl<'de> Visitor<'de> for Word {
    type Value = &'de str;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a word")
    }

    fn visit_borrowed_str<E>(self, word: &'de str) -> Result<Self::Value, E> {
        Ok(word)
    }
}
