//! Reads plain values out of nodes; every refusal is noted as a problem and reading goes on.

use std::ops::Range;

use glam::DVec2;

use super::fields::Fields;
use super::node::{Kind, Node};
use crate::scene::names::{listed, suggestion};
use crate::scene::{Places, Problem};

/// What has been found out about a file while it is read.
#[derive(Debug, Default)]
pub(super) struct Reader {
    pub(super) problems: Vec<Problem>,
    pub(super) places: Places,
}

/// A way to write a value that starts with a word: the word, and an example that is right.
pub(super) type Form = (&'static str, &'static str);

/// `Name` or `Name(…)`, its name known to be one of the forms.
pub(super) struct Variant<'a> {
    pub(super) name: &'static str,
    example: &'static str,
    arguments: Option<Node<'a>>,
    node: Node<'a>,
}

impl Reader {
    /// Notes an error at a node.
    pub(super) fn refuse(&mut self, node: &Node<'_>, message: impl Into<String>, label: &str, help: impl Into<String>) {
        self.refuse_at(&node.path, node.span(), message, label, help);
    }

    pub(super) fn refuse_at(
        &mut self,
        path: &str,
        span: Range<usize>,
        message: impl Into<String>,
        label: &str,
        help: impl Into<String>,
    ) {
        self.problems.push(Problem::error(path, message, help).label(label).at(span));
    }

    fn expected(&mut self, node: &Node<'_>, what: &str, help: impl Into<String>) {
        let found = node.kind().words();
        self.refuse(node, format!("expected {what}, found {found}"), &format!("not {what}"), help);
    }

    pub(super) fn note_places(&mut self, nodes: &[Node<'_>]) {
        for node in nodes {
            self.places.insert(&node.path, node.span());
        }
    }

    /// The named fields of a value; unknown and repeated ones are refused and left out.
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
        let Some(entries) = entries else {
            self.expected(node, &format!("the named fields of {what}"), format!("write `{example}`"));
            return None;
        };
        let mut fields = Fields::new(node.clone(), what, example);
        for entry in entries {
            if !valid.contains(&entry.name) {
                let message = format!("{what} has no field `{}`", entry.name);
                self.refuse_at(
                    &entry.value.path,
                    entry.name_span,
                    message,
                    "unknown field",
                    suggestion(entry.name, valid),
                );
            } else if fields.has(entry.name) {
                let message = format!("the field `{}` is given twice", entry.name);
                self.refuse_at(&entry.value.path, entry.name_span, message, "second time", "keep one of the two");
            } else {
                self.places.insert(&entry.value.path, entry.value.span());
                fields.add(entry);
            }
        }
        Some(fields)
    }

    /// The word that a value starts with, out of the valid forms.
    pub(super) fn variant<'a>(&mut self, node: &Node<'a>, what: &str, forms: &[Form]) -> Option<Variant<'a>> {
        let names: Vec<&str> = forms.iter().map(|form| form.0).collect();
        let Some((word, arguments)) = node.word().filter(|_| node.kind() == Kind::Name) else {
            self.expected(node, what, self.first_word_help(node, &names));
            return None;
        };
        let Some((name, example)) = forms.iter().find(|form| form.0 == word) else {
            let message = format!("there is no {what} `{word}`").replace("no a ", "no ").replace("no an ", "no ");
            self.refuse_at(&node.path, node.word_span(), message, "unknown name", suggestion(word, &names));
            return None;
        };
        Some(Variant { name, example, arguments, node: node.clone() })
    }

    fn first_word_help(&self, node: &Node<'_>, names: &[&str]) -> String {
        match node.plain::<String>().filter(|text| names.contains(&text.as_str())) {
            Some(text) => format!("write `{text}` without quotes"),
            None => format!("valid here: {}", listed(names)),
        }
    }

    /// The elements of a list.
    pub(super) fn list<'a>(&mut self, node: &Node<'a>, of: &str) -> Option<Vec<Node<'a>>> {
        let elements = (node.kind() == Kind::List).then(|| node.list()).flatten();
        match elements {
            Some(elements) => {
                self.note_places(&elements);
                Some(elements)
            }
            None => {
                self.expected(
                    node,
                    &format!("a list of {of}"),
                    format!("put {of} in brackets: `[…]`, also a single one"),
                );
                None
            }
        }
    }

    /// A finite number.
    pub(super) fn number(&mut self, node: &Node<'_>) -> Option<f64> {
        let value = self.number_or_inf(node)?;
        if value.is_infinite() {
            self.refuse(node, "an infinite number has no meaning here", "not finite", "write a finite number");
            return None;
        }
        Some(value)
    }

    /// A number, `inf` and `-inf` included.
    pub(super) fn number_or_inf(&mut self, node: &Node<'_>) -> Option<f64> {
        let Some(value) = (node.kind() == Kind::Number).then(|| node.plain::<f64>()).flatten() else {
            let help = "write a number such as `1.5` or `2e-3`, without a unit and without quotes";
            self.expected(node, "a number", help);
            return None;
        };
        if value.is_nan() {
            self.refuse(node, "`NaN` is not a number", "not a number", "write a finite number");
            return None;
        }
        if value.is_infinite() && !node.text().contains("inf") {
            let message = format!("`{}` is too large for a number", node.text());
            self.refuse(node, message, "too large", "write a number below 1.7e308");
            return None;
        }
        Some(value)
    }

    /// A whole number from 0 to `most`.
    pub(super) fn count(&mut self, node: &Node<'_>, most: u64) -> Option<u64> {
        let whole = node.plain::<u64>().or_else(|| whole(node.plain::<f64>()?));
        match whole {
            Some(value) if value <= most => Some(value),
            _ if node.kind() != Kind::Number => {
                self.expected(node, "a whole number", "write a whole number such as `8`");
                None
            }
            _ => {
                let message = format!("`{}` is not a whole number from 0 to {most}", node.text());
                self.refuse(node, message, "not a valid count", format!("write a whole number, at most {most}"));
                None
            }
        }
    }

    /// A whole number that fits 32 bits.
    pub(super) fn count32(&mut self, node: &Node<'_>) -> Option<u32> {
        let value = self.count(node, u64::from(u32::MAX))?;
        u32::try_from(value).ok()
    }

    /// Text in quotes.
    pub(super) fn text(&mut self, node: &Node<'_>) -> Option<String> {
        let text = node.plain::<String>();
        if text.is_none() {
            self.expected(node, "text in quotes", "put the text in double quotes: `\"…\"`");
        }
        text
    }

    /// `true` or `false`.
    pub(super) fn switch(&mut self, node: &Node<'_>) -> Option<bool> {
        let switch = node.plain::<bool>();
        if switch.is_none() {
            self.expected(node, "`true` or `false`", "write `true` or `false`, without quotes");
        }
        switch
    }

    /// A point `(x, y)`.
    pub(super) fn point(&mut self, node: &Node<'_>) -> Option<DVec2> {
        let [x, y] = self.pair(node, "a point `(x, y)`", "write a point as two numbers in parentheses: `(3, 4)`")?;
        let (x, y) = (self.number(&x), self.number(&y));
        Some(DVec2::new(x?, y?))
    }

    /// Two values in parentheses.
    pub(super) fn pair<'a>(&mut self, node: &Node<'a>, what: &str, help: &str) -> Option<[Node<'a>; 2]> {
        let elements = (node.kind() == Kind::Group).then(|| node.group()).flatten();
        let pair: Option<[Node<'a>; 2]> = elements.and_then(|elements| elements.try_into().ok());
        match &pair {
            Some(pair) => self.note_places(pair),
            None => self.expected(node, what, help),
        }
        pair
    }

    /// Points in a list; the quick way first, one by one where one of them is at fault.
    pub(super) fn points(&mut self, node: &Node<'_>) -> Option<Vec<DVec2>> {
        if let Some(points) = node.plain::<Vec<(f64, f64)>>() {
            let points: Vec<DVec2> = points.into_iter().map(DVec2::from).collect();
            if points.iter().all(|p| p.is_finite()) {
                return Some(points);
            }
        }
        self.each(node, "points", Self::point)
    }

    /// Every element of a list; `None` if one was refused.
    pub(super) fn each<T>(
        &mut self,
        node: &Node<'_>,
        of: &str,
        mut read: impl FnMut(&mut Self, &Node<'_>) -> Option<T>,
    ) -> Option<Vec<T>> {
        let elements = self.list(node, of)?;
        let read: Vec<Option<T>> = elements.iter().map(|element| read(self, element)).collect();
        read.into_iter().collect()
    }

    /// Numbers in a list.
    pub(super) fn numbers(&mut self, node: &Node<'_>) -> Option<Vec<f64>> {
        self.each(node, "numbers", Self::number)
    }
}

impl<'a> Variant<'a> {
    /// Nothing may follow the name.
    pub(super) fn alone(&self, r: &mut Reader) -> Option<()> {
        if self.arguments.is_some() {
            let message = format!("`{}` stands alone, without parentheses", self.name);
            r.refuse(&self.node, message, "takes no values", format!("write `{}`", self.name));
            return None;
        }
        Some(())
    }

    /// The unnamed values, under the names that they have in paths.
    pub(super) fn values<const N: usize>(&self, r: &mut Reader, names: [&str; N]) -> Option<[Node<'a>; N]> {
        let arguments = self.arguments.as_ref();
        let values = arguments.filter(|node| node.kind() == Kind::Group).and_then(Node::group);
        let found = values.as_ref().map(Vec::len);
        let Some(mut values) = values.and_then(|values| <[Node<'a>; N]>::try_from(values).ok()) else {
            r.refuse(&self.node, self.wrong_values(found, N), "not in this form", format!("write `{}`", self.example));
            return None;
        };
        for (value, name) in values.iter_mut().zip(names) {
            value.path = self.node.field_path(name);
        }
        r.note_places(&values);
        Some(values)
    }

    /// The one unnamed value.
    pub(super) fn value(&self, r: &mut Reader, name: &str) -> Option<Node<'a>> {
        self.values(r, [name]).map(|[value]| value)
    }

    fn wrong_values(&self, found: Option<usize>, needed: usize) -> String {
        let values = if needed == 1 { "one value".to_owned() } else { format!("{needed} values") };
        match found {
            Some(found) => format!("`{}` takes {values}, here are {found}", self.name),
            None if self.arguments.is_some() => format!("`{}` takes {values} without names", self.name),
            None => format!("`{}` needs {values} in parentheses", self.name),
        }
    }

    /// The named fields.
    pub(super) fn fields(&self, r: &mut Reader, valid: &[&str]) -> Option<Fields<'a>> {
        match &self.arguments {
            Some(arguments) if matches!(arguments.kind(), Kind::Fields | Kind::Group) => {
                if arguments.kind() == Kind::Group && arguments.group().is_some_and(|values| !values.is_empty()) {
                    let message = format!("the values of `{}` need their names", self.name);
                    r.refuse(&self.node, message, "names are missing", format!("write `{}`", self.example));
                    return None;
                }
                r.fields(arguments, &format!("`{}`", self.name), valid, self.example)
            }
            _ => {
                let message = format!("`{}` needs its fields in parentheses", self.name);
                r.refuse(&self.node, message, "fields are missing", format!("write `{}`", self.example));
                None
            }
        }
    }
}

/// A float that is a whole number which it holds exactly.
fn whole(value: f64) -> Option<u64> {
    let exact = value.fract() == 0.0 && (0.0..=9_007_199_254_740_992.0).contains(&value);
    // Formatting keeps clear of a lossy cast.
    if exact { format!("{value:.0}").parse().ok() } else { None }
}
