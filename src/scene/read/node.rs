//! One value of the scene file. The ron crate parses; this file asks it for one level at a time and keeps every place.

use std::fmt;
use std::ops::Range;

use ron::de::Deserializer;
use ron::value::RawValue;
use serde::Deserializer as _;
use serde::de::{IgnoredAny, MapAccess, SeqAccess, Visitor};

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
    /// Braces, single quotes and other forms that no scene uses.
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
            Self::Other => "braces or single quotes",
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
    pub(super) fn fields(&self) -> Option<Vec<Entry<'a>>> {
        let mut de = reader(self.text)?;
        let entries = de.deserialize_struct("", &[], Entries).ok()?;
        let entry = |(name, raw): (&'a str, &'a RawValue)| Entry {
            name,
            name_span: self.span_of(name),
            value: self.part(trimmed(raw), self.field_path(name)),
        };
        Some(entries.into_iter().map(entry).collect())
    }

    /// The elements of `[…]`.
    pub(super) fn list(&self) -> Option<Vec<Self>> {
        self.elements(reader(self.text)?.deserialize_seq(Elements).ok()?)
    }

    /// The elements of `(…)`.
    pub(super) fn group(&self) -> Option<Vec<Self>> {
        self.elements(reader(self.text)?.deserialize_tuple(0, Elements).ok()?)
    }

    fn elements(&self, raw: Vec<&'a RawValue>) -> Option<Vec<Self>> {
        let element = |(k, raw): (usize, &&'a RawValue)| self.part(trimmed(raw), format!("{}[{k}]", self.path));
        Some(raw.iter().enumerate().map(element).collect())
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
fn trimmed(raw: &RawValue) -> &str {
    let text = skip_blank(raw.get_ron());
    if text.ends_with(char::is_whitespace) || text.ends_with("*/") { raw.trim().get_ron() } else { text }
}

fn options() -> ron::Options {
    ron::Options::default().with_default_extension(ron::extensions::Extensions::IMPLICIT_SOME)
}

fn reader(text: &str) -> Option<Deserializer<'_>> {
    Deserializer::from_str_with_options(text, &options()).ok()
}

/// The text after leading blanks and comments.
pub(super) fn skip_blank(text: &str) -> &str {
    reader(text).map_or(text, |de| de.remainder())
}

fn word(text: &str) -> Option<(&str, &str)> {
    let mut de = reader(text)?;
    let word = de.deserialize_identifier(Word).ok()?;
    Some((word, skip_blank(de.remainder())))
}

fn group_kind(text: &str) -> Kind {
    let named = word(skip_blank(&text[1..])).is_some_and(|(_, rest)| rest.starts_with(':'));
    if named { Kind::Fields } else { Kind::Group }
}

struct Word;
struct Entries;
struct Elements;

impl<'de> Visitor<'de> for Word {
    type Value = &'de str;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a word")
    }

    fn visit_borrowed_str<E>(self, word: &'de str) -> Result<Self::Value, E> {
        Ok(word)
    }
}

impl<'de> Visitor<'de> for Entries {
    type Value = Vec<(&'de str, &'de RawValue)>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("named fields")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        let mut entries = Vec::new();
        while let Some(entry) = map.next_entry()? {
            entries.push(entry);
        }
        Ok(entries)
    }
}

impl<'de> Visitor<'de> for Elements {
    type Value = Vec<&'de RawValue>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("values")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Self::Value, A::Error> {
        let mut elements = Vec::new();
        while let Some(element) = seq.next_element()? {
            elements.push(element);
        }
        Ok(elements)
    }
}
