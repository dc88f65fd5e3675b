use super::fields::Fields;
use super::node::{Kind, Node};
use super::reader::{Read, Reader};

/// What to add where there are more numbers than there should be.
pub(super) const POINT: &str = "; a decimal number has a point, as in `4.5`";

/// A way to write a value that starts with a word: the word, and an example that is right.
pub(super) type Form = (&'static str, &'static str);

/// `Name` or `Name(…)`, its name known to be one of the forms.
pub(super) struct Variant<'a> {
    pub(super) name: &'static str,
    example: &'static str,
    arguments: Option<Node<'a>>,
    node: Node<'a>,
}

impl<'a> Variant<'a> {
    pub(super) fn new(form: Form, node: Node<'a>, arguments: Option<Node<'a>>) -> Self {
        Self { name: form.0, example: form.1, arguments, node }
    }

    /// Nothing may follow the name.
    pub(super) fn alone(&self, r: &mut Reader) {
        if self.arguments.is_some() {
            let message = format!("`{}` stands alone, without parentheses", self.name);
            r.refuse(&self.node, message, "takes no values", format!("write `{}`", self.name));
        }
    }

    /// The unnamed values, under the names that they have in paths.
    pub(super) fn values<const N: usize>(&self, r: &mut Reader, names: [&str; N]) -> Option<[Node<'a>; N]> {
        let arguments = self.arguments.as_ref();
        let Some(mut values) = arguments.and_then(Node::group_of) else {
            let found = arguments.filter(|node| node.kind() == Kind::Group).map(Node::size);
            let are_numbers = arguments.is_some_and(Node::holds_only_numbers);
            let message = self.wrong_values(found, N);
            let help = if found > Some(N) && are_numbers && !self.example.contains("((") { POINT } else { "" };
            r.refuse(&self.node, message, "not in this form", format!("write it like `{}`{help}", self.example));
            return None;
        };
        for (value, name) in values.iter_mut().zip(names) {
            value.path = self.node.field_path(name);
        }
        r.note_places(&values);
        Some(values)
    }

    /// The one unnamed value.
    pub(super) fn value<T: Read>(&self, r: &mut Reader, name: &str) -> Option<T> {
        let [value] = self.values(r, [name])?;
        Some(r.read(&value))
    }

    fn wrong_values(&self, found: Option<usize>, needed: usize) -> String {
        let values = |n| if n == 1 { "one value".to_owned() } else { format!("{n} values") };
        match found {
            Some(found) => format!("`{}` takes {} in parentheses, not {}", self.name, values(needed), found),
            None if self.arguments.is_some() => format!("`{}` takes {} without names", self.name, values(needed)),
            None => format!("`{}` needs {} in parentheses", self.name, values(needed)),
        }
    }

    /// The named fields.
    pub(super) fn fields(&self, r: &mut Reader, valid: &[&str]) -> Option<Fields<'a>> {
        let Some(arguments) = &self.arguments else {
            self.refuse(r, &format!("`{}` needs its fields in parentheses", self.name), "fields are missing");
            return None;
        };
        if arguments.kind() == Kind::Group && arguments.size() > 0 {
            self.refuse(r, &format!("the values of `{}` need their names", self.name), "names are missing");
            return None;
        }
        r.fields(arguments, &format!("`{}`", self.name), valid, self.example)
    }

    fn refuse(&self, r: &mut Reader, message: &str, label: &str) {
        r.refuse(&self.node, message, label, format!("write it like `{}`", self.example));
    }
}
