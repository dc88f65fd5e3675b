use std::collections::HashMap;

use super::node::{Entry, Node};
use super::reader::Reader;

/// The known named fields of one value of the file.
pub(super) struct Fields<'a> {
    node: Node<'a>,
    what: String,
    example: String,
    values: HashMap<&'a str, Node<'a>>,
}

impl<'a> Fields<'a> {
    pub(super) fn new(node: Node<'a>, what: &str, example: &str) -> Self {
        Self { node, what: what.to_owned(), example: example.to_owned(), values: HashMap::new() }
    }

    pub(super) fn add(&mut self, entry: Entry<'a>) {
        self.values.insert(entry.name, entry.value);
    }

    /// Whether the field is written, with whatever value.
    pub(super) fn has(&self, name: &str) -> bool {
        self.values.contains_key(name)
    }

    /// The value that carries the fields.
    pub(super) fn node(&self) -> &Node<'a> {
        &self.node
    }

    /// A field that must be there; `None` if it is not or was refused.
    pub(super) fn required<T>(
        &self,
        r: &mut Reader,
        name: &str,
        read: impl FnOnce(&mut Reader, &Node<'a>) -> Option<T>,
    ) -> Option<T> {
        let Some(value) = self.values.get(name) else {
            let message = format!("{} needs the field `{name}`", self.what);
            r.refuse(&self.node, message, &format!("`{name}` is missing"), format!("write `{}`", self.example));
            return None;
        };
        read(r, value)
    }

    /// A field that may be left out; `None` also if it was refused. `None` and `Some(…)` may be written.
    pub(super) fn optional<T>(
        &self,
        r: &mut Reader,
        name: &str,
        read: impl FnOnce(&mut Reader, &Node<'a>) -> Option<T>,
    ) -> Option<T> {
        let value = self.values.get(name)?;
        if let Some(("None", None)) = value.word() {
            return None;
        }
        let inner = inside_some(value);
        let value = inner.as_ref().unwrap_or(value);
        r.places.insert(&value.path, value.span());
        read(r, value)
    }

    /// A field that has a default, which also stands in for a refused value while reading goes on.
    pub(super) fn or<T>(
        &self,
        r: &mut Reader,
        name: &str,
        default: T,
        read: impl FnOnce(&mut Reader, &Node<'a>) -> Option<T>,
    ) -> T {
        self.optional(r, name, read).unwrap_or(default)
    }
}

/// The value in `Some(value)`.
fn inside_some<'a>(value: &Node<'a>) -> Option<Node<'a>> {
    let ("Some", Some(arguments)) = value.word()? else { return None };
    let [mut inner] = <[Node<'a>; 1]>::try_from(arguments.group()?).ok()?;
    inner.path.clone_from(&value.path);
    Some(inner)
}
