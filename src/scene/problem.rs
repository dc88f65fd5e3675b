use std::borrow::Cow;
use std::fmt;
use std::ops::Range;

use crate::scene::render_problems;

/// How bad a problem is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Severity {
    /// The scene cannot be used.
    Error,
    /// The scene works, but probably not as meant.
    Warning,
}

impl Severity {
    /// `error` or `warning`.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Error => "error",
            Self::Warning => "warning",
        }
    }
}

/// Something wrong in a scene: where, what, and what would be right.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Problem {
    /// How bad it is.
    pub severity: Severity,
    /// The value at fault, such as `bodies[2].shape.radii`; empty for the scene as a whole.
    pub path: String,
    /// Bytes of the scene's text at fault; `None` for a scene that was not read from text.
    pub span: Option<Range<usize>>,
    /// What is wrong, in one sentence without a final period.
    pub message: String,
    /// A few words for the underlined text; may be empty.
    pub label: Box<str>,
    /// What would be right.
    pub help: String,
    /// Problems that are not listed; 0 but for the last problem of a very long list, which stands for them.
    pub more: u32,
}

/// Most problems of a scene that are listed one by one.
const MOST_LISTED: usize = 1000;
/// Most characters of the scene that a problem repeats.
const MOST_REPEATED: usize = 60;

impl Problem {
    /// An error at a path.
    #[must_use]
    pub fn error(path: impl Into<String>, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self {
            severity: Severity::Error,
            path: path.into(),
            span: None,
            message: message.into(),
            label: Box::default(),
            help: help.into(),
            more: 0,
        }
    }

    /// A warning at a path.
    #[must_use]
    pub fn warning(path: impl Into<String>, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { severity: Severity::Warning, ..Self::error(path, message, help) }
    }

    /// The same problem with words for the underlined text.
    #[must_use]
    pub fn label(self, label: impl Into<Box<str>>) -> Self {
        Self { label: label.into(), ..self }
    }

    /// The same problem at a place of the text.
    #[must_use]
    pub fn at(self, span: Range<usize>) -> Self {
        Self { span: Some(span), ..self }
    }
}

/// Problems as they are found: the first of them, and how many more there are.
#[derive(Debug, Default)]
pub(super) struct Found {
    list: Vec<Problem>,
    more: u32,
}

impl Found {
    pub(super) fn push(&mut self, problem: Problem) {
        if self.is_full() {
            self.more = self.more.saturating_add(1);
        } else {
            self.list.push(problem);
        }
    }

    pub(super) fn append(&mut self, other: Self) {
        other.list.into_iter().for_each(|problem| self.push(problem));
        self.more = self.more.saturating_add(other.more);
    }

    pub(super) fn is_full(&self) -> bool {
        self.list.len() >= MOST_LISTED
    }

    /// The list, at its end one that stands for all that are not on it.
    pub(super) fn into_list(mut self) -> Vec<Problem> {
        if self.more > 0 {
            let message = format!("{} more problems are not listed", self.more);
            let rest = Problem::error("", message, "mend those that are, and check the scene again");
            self.list.push(Problem { more: self.more, ..rest });
        }
        self.list
    }
}

/// Words of a scene for a problem, cut where they are long.
pub(super) fn shortened(words: &str) -> Cow<'_, str> {
    match words.char_indices().nth(MOST_REPEATED) {
        Some((end, _)) => format!("{}…", &words[..end]).into(),
        None => words.into(),
    }
}

/// All problems of one scene with its text, so that they can be shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problems {
    list: Vec<Problem>,
    text: String,
    file: String,
}

impl Problems {
    /// Problems of the scene with this text, shown under a file name.
    #[must_use]
    pub fn new(list: Vec<Problem>, text: impl Into<String>, file: impl Into<String>) -> Self {
        Self { list, text: text.into(), file: file.into() }
    }

    /// The text that the places of the problems count in.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The problems, in the order of the text.
    #[must_use]
    pub fn list(&self) -> &[Problem] {
        &self.list
    }
}

impl fmt::Display for Problems {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&render_problems(&self.list, &self.text, &self.file))
    }
}

impl std::error::Error for Problems {}
