//! The items of a layer by the generation of the light that they belong to, so that a figure can be built up hit by hit.

use std::collections::BTreeMap;

use crate::drawing::{Group, Item};

/// An item, and how many hits lie behind the light that it belongs to.
pub(super) type Aged = (u32, Item);

/// A group a generation, the light of the sources at the back.
pub(super) fn by_generation(layer: &str, items: Vec<Aged>) -> Vec<Item> {
    let mut generations: BTreeMap<u32, Vec<Item>> = BTreeMap::new();
    for (generation, item) in items {
        generations.entry(generation).or_default().push(item);
    }
    let group = |(generation, items): (u32, Vec<Item>)| {
        let name = format!("{layer}-{generation}");
        let data = vec![("data-generation", generation.to_string())];
        Group { name, data, step: Some(generation), ..Group::layer("generation", items) }.into()
    };
    generations.into_iter().map(group).collect()
}

/// The items without their generations.
pub(super) fn together(items: Vec<Aged>) -> Vec<Item> {
    items.into_iter().map(|(_, item)| item).collect()
}
