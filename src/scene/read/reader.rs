//! Reads nodes level by level; what cannot be read is noted as a problem and replaced by a stand-in, and reading goes on.

use std::collections::HashSet;
use std::ops::Range;

use super::fields::Fields;
use super::node::{Kind, Node};
use super::variant::{Form, POINT, Variant};
use crate::scene::names::{listed, nearest, suggestion};
use crate::scene::places::parent;
use crate::scene::problem::{Found, shortened};
use crate::scene::{Limit, Limits, Places, Problem};

/// What can be read from one value of a file.
pub(super) trait Read: Sized {
    /// The value; `None` after noting what is wrong with it.
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self>;

    /// Takes the place of what cannot be read, so that the rest of the scene is still checked.
    fn stand_in() -> Self;
}

/// What has been found out about a file while it is read. When there are more problems than are kept, nothing else is noted.
#[derive(Debug)]
pub(super) struct Reader {
    pub(super) problems: Found,
    pub(super) places: Places,
    stand_ins: HashSet<String>,
    pub(super) limits: Limits,
    /// Points of all outlines so far.
    points: u64,
}

impl Reader {
    pub(super) fn new(limits: Limits) -> Self {
        let (problems, places) = (Found::default(), Places::default());
        Self { problems, places, stand_ins: HashSet::new(), limits, points: 0 }
    }

    /// Notes the place of a value.
    pub(super) fn place(&mut self, path: &str, span: Range<usize>) {
        if !self.problems.is_full() {
            self.places.insert(path, span);
        }
    }

    /// A value, or its stand-in.
    pub(super) fn read<T: Read>(&mut self, node: &Node<'_>) -> T {
        T::read(self, node).unwrap_or_else(|| self.stand_in(&node.path))
    }

    /// The stand-in for the value at a path.
    pub(super) fn stand_in<T: Read>(&mut self, path: &str) -> T {
        if !self.problems.is_full() {
            self.stand_ins.insert(path.to_owned());
        }
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
            self.place(&node.path, node.span());
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
        let entries = node.fields();
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
                format!("leave `{}` out: write `(…)`", shortened(word)),
            );
            return None;
        }
        if entries.is_none() && !(node.kind() == Kind::Group && node.size() == 0) {
            self.expected(node, &format!("the named fields of {what}"), format!("write them like `{example}`"));
            return None;
        }
        let mut fields = Fields::new(node.clone(), what, example);
        for entry in entries.into_iter().flatten() {
            let (path, span) = (&entry.value.path, entry.name_span.clone());
            if !valid.contains(&entry.name) {
                fields.meant.extend(nearest(entry.name, valid).map(str::to_owned));
                let message = format!("{what} has no field `{}`", shortened(entry.name));
                self.note(path, span, message, "unknown field", suggestion(entry.name, valid));
            } else if fields.has(entry.name) {
                let message = format!("the field `{}` is given twice", entry.name);
                self.note(path, span, message, "second time", "keep one of the two");
            } else {
                self.place(path, entry.value.span());
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
            let message = format!("there is no {kind} `{}`", shortened(word));
            self.note(&node.path, node.word_span(), message, "unknown name", suggestion(word, &names));
            return None;
        };
        Some(Variant::new(*form, node.clone(), arguments))
    }

    /// Every element of a list, if there are no more than the limit allows.
    pub(super) fn each<T: Read>(&mut self, node: &Node<'_>, of: &str, limit: Limit) -> Option<Vec<T>> {
        let has_room = self.has_room(node, of, limit);
        let read = |r: &mut Self, element: &Node<'_>| {
            r.place(&element.path, element.span());
            r.read(element)
        };
        has_room.then(|| self.elements(node, of, read)).flatten()
    }

    /// Every element of a list of which the places are not noted one by one.
    pub(super) fn elements<T>(
        &mut self,
        node: &Node<'_>,
        of: &str,
        mut read: impl FnMut(&mut Self, &Node<'_>) -> T,
    ) -> Option<Vec<T>> {
        let Some(elements) = node.list() else {
            let help = format!("put {of} in brackets: `[…]`, also a single one");
            self.expected(node, &format!("a list of {of}"), help);
            return None;
        };
        Some(elements.map(|element| read(self, &element)).collect())
    }

    /// Whether a list is no longer than allowed, before memory is taken for it; points count in all of the scene.
    pub(super) fn has_room(&mut self, node: &Node<'_>, of: &str, limit: Limit) -> bool {
        if node.kind() != Kind::List {
            return true;
        }
        let (size, most) = (node.size() as u64, self.limits.of(limit));
        let before = if limit == Limit::Points { self.points } else { 0 };
        let total = before.saturating_add(size);
        if total > most {
            let problem = too_many(&node.path, of, total, before, limit, most);
            self.problems.push(problem.at(node.span()));
            return false;
        }
        if limit == Limit::Points {
            self.points = total;
        }
        true
    }

    /// Two values in parentheses.
    pub(super) fn pair<T: Read>(&mut self, node: &Node<'_>, what: &str, help: &str) -> Option<[T; 2]> {
        let Some(pair) = node.group_of() else {
            let are_many = node.size() > 2 && node.holds_only_numbers();
            self.expected(node, what, format!("{help}{}", if are_many { POINT } else { "" }));
            return None;
        };
        self.note_places(&pair);
        Some(pair.map(|node| self.read(&node)))
    }
}

/// A list that takes a resource over its limit.
fn too_many(path: &str, of: &str, total: u64, before: u64, limit: Limit, most: u64) -> Problem {
    let message = match before {
        0 => format!("the list has {total} {of}; at most {most} are read"),
        _ => format!("the scene has {total} points so far, all outlines together; at most {most} are read"),
    };
    Problem::error(path, message, format!("write fewer {of}; {}", limit.cure())).label("too many")
}

/// What may be written: examples, or the names alone where they are many.
fn listed_forms(forms: &[Form]) -> String {
    let examples: Vec<&str> = forms.iter().map(|form| if forms.len() > 5 { form.0 } else { form.1 }).collect();
    format!("valid here: {}", listed(&examples))
}
