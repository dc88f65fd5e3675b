use std::collections::BTreeSet;

use crate::drawing::{Color, Fill, Items, Lines, Path, Rect, Stroke, Text};

/// A whole figure.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Drawing {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Ground; `None` is transparent.
    pub background: Option<Color>,
    /// Title for readers that show one.
    pub title: String,
    /// Longer description.
    pub description: String,
    /// What is drawn, from back to front.
    pub items: Vec<Item>,
}

/// One thing that is drawn.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Item {
    /// A path.
    Shape(Shape),
    /// Very many straight lines of one style.
    Lines(Lines),
    /// A line of text.
    Text(Text),
    /// Things that belong together.
    Group(Group),
}

/// A path with its style.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Shape {
    /// Its lines.
    pub path: Path,
    /// How it is filled; `None` leaves it empty.
    pub fill: Option<Fill>,
    /// How its lines are drawn; `None` leaves them out.
    pub stroke: Option<Stroke>,
    /// Class names, by spaces; may be empty.
    pub class: String,
    /// Attributes such as `("data-body", "prism")`. An SVG has those whose names begin with `data-` and go on with letters and
    /// dashes, each name once.
    pub data: Vec<(&'static str, String)>,
}

/// Things that belong together, such as a layer.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Group {
    /// A name that no other group of the figure has, such as `rays-0`; empty for none.
    pub name: String,
    /// Class names, by spaces; may be empty.
    pub class: String,
    /// Attributes such as `("data-body", "prism")`. An SVG has those whose names begin with `data-` and go on with letters and
    /// dashes, each name once.
    pub data: Vec<(&'static str, String)>,
    /// Nothing is drawn outside of this rectangle.
    pub clip: Option<Rect>,
    /// If given, its items are put together apart from what lies behind, and laid on that as a whole.
    pub whole: Option<Whole>,
    /// The step of a build-up that adds it; `None` is there from the start.
    pub step: Option<u32>,
    /// What is drawn, from back to front.
    pub items: Items,
}

/// How a group is laid on what lies behind it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Whole {
    /// 0 invisible to 1 solid.
    pub opacity: f64,
    /// Whether its items add up as lights do, by screening each other; else the later covers the earlier.
    pub adds_up: bool,
}

impl Shape {
    /// A path with a line.
    #[must_use]
    pub fn stroked(path: Path, stroke: Stroke, class: &str) -> Self {
        Self { path, stroke: Some(stroke), class: class.to_owned(), ..Self::default() }
    }

    /// A path with a fill.
    #[must_use]
    pub fn filled(path: Path, fill: Fill, class: &str) -> Self {
        Self { path, fill: Some(fill), class: class.to_owned(), ..Self::default() }
    }

    /// The same with an attribute more.
    #[must_use]
    pub fn with(mut self, name: &'static str, value: String) -> Self {
        self.data.push((name, value));
        self
    }
}

impl Group {
    /// A layer of things.
    #[must_use]
    pub fn layer(class: &str, items: Vec<Item>) -> Self {
        Self { class: class.to_owned(), items: items.into(), ..Self::default() }
    }

    /// The same with a name.
    #[must_use]
    pub fn named(self, name: &str) -> Self {
        Self { name: name.to_owned(), ..self }
    }

    /// The same with an attribute more.
    #[must_use]
    pub fn with(mut self, name: &'static str, value: String) -> Self {
        self.data.push((name, value));
        self
    }

    /// The same, laid on what lies behind as a whole.
    #[must_use]
    pub fn as_whole(self, whole: Whole) -> Self {
        Self { whole: Some(whole), ..self }
    }

    /// The same, drawn only inside of a rectangle.
    #[must_use]
    pub fn clipped(self, clip: Rect) -> Self {
        Self { clip: Some(clip), ..self }
    }
}

impl Drawing {
    /// Characters that the embedded font lacks and that PNG shows as boxes, in order, each once.
    #[must_use]
    pub fn missing_glyphs(&self) -> Vec<char> {
        let mut found = BTreeSet::new();
        collect_missing(&self.items, &mut found);
        found.into_iter().collect()
    }
}

fn collect_missing(items: &[Item], found: &mut BTreeSet<char>) {
    for item in items {
        match item {
            Item::Shape(_) | Item::Lines(_) => {}
            Item::Text(text) => {
                let glyphs = text.glyphs();
                found.extend(glyphs.iter().filter(|g| !text.font.has(g.character)).map(|g| g.character));
            }
            Item::Group(group) => collect_missing(&group.items, found),
        }
    }
}

impl From<Shape> for Item {
    fn from(shape: Shape) -> Self {
        Self::Shape(shape)
    }
}

impl From<Lines> for Item {
    fn from(lines: Lines) -> Self {
        Self::Lines(lines)
    }
}

impl From<Text> for Item {
    fn from(text: Text) -> Self {
        Self::Text(text)
    }
}

impl From<Group> for Item {
    fn from(group: Group) -> Self {
        Self::Group(group)
    }
}
