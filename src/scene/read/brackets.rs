//! What is open where parsing stopped.

use std::ops::Range;

use super::split::token;

/// A bracket that was opened and not closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Open<'a> {
    pub(super) bracket: char,
    pub(super) at: usize,
    /// The field whose value is being written in it.
    pub(super) field: Option<&'a str>,
    /// Whether any field was written in it.
    pub(super) has_fields: bool,
    /// Number of the value that is being written in it, from 0.
    place: usize,
}

/// What was read up to a place of the text.
#[derive(Debug, Default)]
pub(super) struct Before<'a> {
    /// The open brackets, the innermost last; brackets in comments and in quotes do not count.
    pub(super) open: Vec<Open<'a>>,
    /// The last text in quotes.
    pub(super) quoted: Option<Range<usize>>,
}

impl<'a> Before<'a> {
    /// What stands before byte `end`.
    pub(super) fn new(text: &'a str, end: usize) -> Self {
        let (mut before, mut word, mut at) = (Self::default(), "", 0);
        while at < end {
            let length = token(text, at);
            let part = text.get(at..at + length).unwrap_or_default();
            match part.chars().next().unwrap_or(' ') {
                '"' => before.quoted = Some(at..at + length),
                bracket @ ('(' | '[' | '{') => {
                    before.open.push(Open { bracket, at, field: None, has_fields: false, place: 0 });
                }
                ')' | ']' | '}' => drop(before.open.pop()),
                c => before.inside(c, word),
            }
            if part.starts_with(|c: char| c.is_alphanumeric() || c == '_') {
                word = part;
            }
            at += length;
        }
        before
    }

    /// A character in the innermost bracket; `word` is the last one before.
    fn inside(&mut self, c: char, word: &'a str) {
        let Some(open) = self.open.last_mut() else { return };
        match c {
            ':' => (open.field, open.has_fields) = (Some(word), true),
            ',' => (open.field, open.place) = (None, open.place + 1),
            _ => {}
        }
    }

    pub(super) fn innermost(&self) -> Option<Open<'a>> {
        self.open.last().copied()
    }

    /// The path of what is being written, as far as it has names: `bodies[2].shape`.
    pub(super) fn path(&self) -> String {
        let mut path = String::new();
        let mut around = None;
        for open in &self.open {
            match (open.bracket, open.field) {
                ('(', Some(field)) if path.is_empty() => path += field,
                ('(', Some(field)) => path = format!("{path}.{field}"),
                ('[', _) if around.is_some() => path = format!("{path}[{}]", open.place),
                _ => break,
            }
            around = open.field;
        }
        path
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn brackets_in_quotes_and_comments_do_not_count() {
        let text = r##"(title: "a [ \" (", name: r#"("#, /* [ */ bodies: [(), // {
            "##;
        let innermost = Before::new(text, text.len()).innermost().unwrap();
        assert_eq!((innermost.bracket, innermost.at), ('[', 50));
        assert_eq!(Before::new("([])", 4).innermost(), None);
    }

    #[test]
    fn paths_go_as_far_as_there_are_names() {
        let path = |text: &str| Before::new(text, text.len()).path();
        assert_eq!(path("(title: \"a\", bodies: [(), (shape: Disk(4), medium: Index("), "bodies[1].medium");
        assert_eq!(path("(sources: [(light: Fan(from: (0, 0), rays: "), "sources[0].light.rays");
        assert_eq!(path("(bodies: [(shape: Polygon([(0, 0), (1, "), "bodies[0].shape");
        assert_eq!(path("(bodies: [(), "), "bodies[1]");
        assert_eq!(path("(title: \"a\", "), "");
        assert_eq!(path("[1, "), "");
    }
}
