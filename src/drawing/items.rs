use std::ops::Deref;

use crate::drawing::Item;

/// What is drawn in a group, from back to front: a slice of items, made [`From`] a list.
///
/// Groups stand in each other at most [`DEEPEST`](Self::DEEPEST) deep: what stands deeper is left out, so that no drawing is too
/// deep to be written, compared or dropped.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Items {
    list: Vec<Item>,
    depth: usize,
}

impl Items {
    /// The most groups in each other.
    pub const DEEPEST: usize = 64;
}

impl From<Vec<Item>> for Items {
    fn from(mut list: Vec<Item>) -> Self {
        list.retain(|item| depth(item) < Self::DEEPEST);
        let depth = list.iter().map(|item| depth(item) + 1).max().unwrap_or(0);
        Self { list, depth }
    }
}

fn depth(item: &Item) -> usize {
    match item {
        Item::Group(group) => group.items.depth,
        Item::Shape(_) | Item::Lines(_) | Item::Text(_) => 0,
    }
}

impl Deref for Items {
    type Target = [Item];

    fn deref(&self) -> &[Item] {
        &self.list
    }
}
