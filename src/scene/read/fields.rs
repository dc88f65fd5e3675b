use std::collections::HashMap;

use super::node::{Entry, Node};
use super::reader::{Read, Reader};

/// The known named fields of one value of the file.
pub(super) struct Fields<'a> {
    node: Node<'a>,
    what: String,
    example: String,
    values: HashMap<&'a str, Node<'a>>,
    /// Fields that misspelt ones are probably meant for.
    pub(super) meant: Vec<String>,
}

impl<'a> Fields<'a> {
    pub(super) fn new(node: Node<'a>, what: &str, example: &str) -> Self {
        Self { node, what: what.to_owned(), example: example.to_owned(), values: HashMap::new(), meant: Vec::new() }
    }

    pub(super) fn add(&mut self, entry: Entry<'a>) {
        self.values.insert(entry.name, entry.value);
    }

    /// Whether the field is written, with whatever value.
    pub(super) fn has(&self, name: &str) -> bool {
        self.values.contains_key(name)
    }

    /// Whether a misspelt field is probably meant for this one.
    pub(super) fn is_meant(&self, name: &str) -> bool {
        self.meant.iter().any(|meant| meant == name)
    }

    /// The value that carries the fields.
    pub(super) fn node(&self) -> &Node<'a> {
        &self.node
    }

    /// A field that must be there.
    pub(super) fn required<T: Read>(&self, r: &mut Reader, name: &str) -> T {
        if let Some(value) = self.values.get(name) {
            return r.read(value);
        }
        if self.is_meant(name) {
            return r.stand_in(&self.node.field_path(name));
        }
        let message = format!("{} needs the field `{name}`", self.what);
        let help = format!("write it like `{}`", self.example);
        r.note(&self.node.field_path(name), self.node.span(), message, &format!("`{name}` is missing"), help);
        r.stand_in(&self.node.field_path(name))
    }

    /// A field that may be left out; `None` and `Some(…)` may be written for it.
    pub(super) fn optional<T: Read>(&self, r: &mut Reader, name: &str) -> Option<T> {
        let value = self.values.get(name)?;
        if let Some(("None", None)) = value.word() {
            return None;
        }
        let inner = inside_some(value);
        let value = inner.as_ref().unwrap_or(value);
        r.place(&value.path, value.span());
        Some(r.read(value))
    }

    /// A field that has a default.
    pub(super) fn or<T: Read>(&self, r: &mut Reader, name: &str, default: T) -> T {
        self.optional(r, name).unwrap_or(default)
    }
}

/// The value in `Some(value)`.
fn inside_some<'a>(value: &Node<'a>) -> Option<Node<'a>> {
    let ("Some", Some(arguments)) = value.word()? else { return None };
    let [mut inner] = arguments.group_of()?;
    inner.path.clone_from(&value.path);
    Some(inner)
}
