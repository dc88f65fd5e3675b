//! Reads nodes level by level; what cannot be read is noted as a problem and replaced by a stand-in, and reading goes on.

use std::collections::HashSet;
use std::ops::Range;

use super::fields::Fields;
use super::node::{Kind, Node};
use super::variant::{Form, POINT, Variant};
use crate::scene::names::{listed, nearest, suggestion};
use crate::scene::places::parent;
use crate::scene::{Places, Problem};

/// What can be read from one value of a file.
pub(super) trait Read: Sized {
    /// The value; `None` after noting what is wrong with it.
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self>;

    /// Takes the place of what cannot be read, so that the rest of the scene is still checked.
    fn stand_in() -> Self;
}

/// What has been found out about a file while it is read.
#[derive(Debug, Default)]
pub(super) struct Reader {
    pub(super) problems: Vec<Problem>,
    pub(super) places: Places,
    stand_ins: HashSet<String>,
}

impl Reader {
    /// A value, or its stand-in.
    pub(super) fn read<T: Read>(&mut self, node: &Node<'_>) -> T {
        T::read(self, node).unwrap_or_else(|| self.stand_in(&node.path))
    }

    /// The stand-in for the value at a path.
    pub(super) fn stand_in<T: Read>(&mut self, path: &str) -> T {
        self.stand_ins.insert(path.to_owned());
        T::stand_in()
    }

    /// Whether a value, or one around it, is but a stand-in.
    pub(super) fn is_stand_in(&self, path: &str) -> bool {
        let around = std::iter::successors(Some(path), |path| parent(path));
        !self.stand_ins.is_empty() && around.into_iter().any(|path| self.stand_ins.contains(path))
    }

    /// Whether some value within a path is but a stand-in.
    pub(super) fn has_stand_in(&self, path: &str) -> bool {
        self.stand_ins.iter().any(|inner| inner.strip_prefix(path).is_some_and(|rest| rest.starts_with(['.', '['])))
    }

    /// Notes an error at a node.
    pub(super) fn refuse(&mut self, node: &Node<'_>, message: impl Into<String>, label: &str, help: impl Into<String>) {
        self.note(&node.path, node.span(), message, label, help);
    }

    /// Notes an error at a place.
    pub(super) fn note(
        &mut self,
        path: &str,
        span: Range<usize>,
        message: impl Into<String>,
        label: &str,
        help: impl Into<String>,
    ) {
        self.problems.push(Problem::error(path, message, help).label(label).at(span));
    }

    /// Notes that a value is not of the kind that belongs here.
    pub(super) fn expected(&mut self, node: &Node<'_>, what: &str, help: impl Into<String>) {
        let found = node.kind().words();
        self.refuse(node, format!("expected {what}, found {found}"), &format!("not {what}"), help);
    }

    pub(super) fn note_places(&mut self, nodes: &[Node<'_>]) {
        for node in nodes {
            self.places.insert(&node.path, node.span());
        }
    }

    /// The named fields of a value; unknown and repeated ones are noted and left out.
    pub(super) fn fields<'a>(
        &mut self,
        node: &Node<'a>,
        what: &str,
        valid: &[&str],
        example: &str,
    ) -> Option<Fields<'a>> {
        let entries = match node.kind() {
            Kind::Fields => node.fields(),
            Kind::Group if node.group().is_some_and(|elements| elements.is_empty()) => Some(Vec::new()),
            _ => None,
        };
        if let Some((word, Some(arguments))) = node.word()
            && entries.is_none()
            && arguments.kind() == Kind::Fields
        {
            let message = format!("{what} has no name before its fields");
            self.note(
                &node.path,
                node.word_span(),
                message,
                "no name here",
                format!("leave `{word}` out: write `(…)`"),
            );
            return None;
        }
        let Some(entries) = entries else {
            self.expected(node, &format!("the named fields of {what}"), format!("write them like `{example}`"));
            return None;
        };
        let mut fields = Fields::new(node.clone(), what, example);
        for entry in entries {
            let (path, span) = (&entry.value.path, entry.name_span.clone());
            if !valid.contains(&entry.name) {
                fields.meant.extend(nearest(entry.name, valid).map(str::to_owned));
                let message = format!("{what} has no field `{}`", entry.name);
                self.note(path, span, message, "unknown field", suggestion(entry.name, valid));
            } else if fields.has(entry.name) {
                let message = format!("the field `{}` is given twice", entry.name);
                self.note(path, span, message, "second time", "keep one of the two");
            } else {
                self.places.insert(path, entry.value.span());
                fields.add(entry);
            }
        }
        Some(fields)
    }

    /// The word that a value starts with, out of the valid forms.
    pub(super) fn variant<'a>(&mut self, node: &Node<'a>, what: &str, forms: &[Form]) -> Option<Variant<'a>> {
        let names: Vec<&str> = forms.iter().map(|form| form.0).collect();
        let Some((word, arguments)) = node.word().filter(|_| node.kind() == Kind::Name) else {
            let help = match node.plain::<String>().filter(|text| names.contains(&text.as_str())) {
                Some(text) => format!("write `{text}` without quotes"),
                None => listed_forms(forms),
            };
            self.expected(node, what, help);
            return None;
        };
        let Some(form) = forms.iter().find(|form| form.0 == word) else {
            let kind = what.trim_start_matches("a ");
            let message = format!("there is no {kind} `{word}`");
            self.note(&node.path, node.word_span(), message, "unknown name", suggestion(word, &names));
            return None;
        };
        Some(Variant::new(*form, node.clone(), arguments))
    }

    /// Every element of a list.
    pub(super) fn each<T: Read>(&mut self, node: &Node<'_>, of: &str) -> Option<Vec<T>> {
        let elements = (node.kind() == Kind::List).then(|| node.list()).flatten();
        let Some(elements) = elements else {
            let help = format!("put {of} in brackets: `[…]`, also a single one");
            self.expected(node, &format!("a list of {of}"), help);
            return None;
        };
        self.note_places(&elements);
        Some(elements.iter().map(|element| self.read(element)).collect())
    }

    /// Two values in parentheses.
    pub(super) fn pair<T: Read>(&mut self, node: &Node<'_>, what: &str, help: &str) -> Option<[T; 2]> {
        let elements = (node.kind() == Kind::Group).then(|| node.group()).flatten();
        let are_many = elements.as_ref().is_some_and(|elements| {
            elements.len() > 2 && elements.iter().all(|element| element.kind() == Kind::Number)
        });
        let Some(pair) = elements.and_then(|elements| <[Node<'_>; 2]>::try_from(elements).ok()) else {
            self.expected(node, what, format!("{help}{}", if are_many { POINT } else { "" }));
            return None;
        };
        self.note_places(&pair);
        Some(pair.map(|node| self.read(&node)))
    }
}

/// What may be written: examples, or the names alone where they are many.
fn listed_forms(forms: &[Form]) -> String {
    let examples: Vec<&str> = forms.iter().map(|form| if forms.len() > 5 { form.0 } else { form.1 }).collect();
    format!("valid here: {}", listed(&examples))
}
