use crate::drawing::Item;

/// Layers of marks that explain the rays.
const MARKS: [&str; 12] = [
    "axes",
    "principal-planes",
    "normals",
    "extensions",
    "protractors",
    "wavefronts",
    "deviations",
    "angles",
    "arrows",
    "objects",
    "focal-points",
    "labels",
];

/// What a figure shows and what it could spare.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Statistics {
    /// Segments that are drawn; spectral lines that coincide count each.
    pub segments_drawn: usize,
    /// Segments that were dropped because nothing of them is in the view.
    pub segments_outside_view: usize,
    /// Segments that were dropped because they carry less of their source ray than the figure shows.
    pub segments_below_faintest: usize,
    /// Normals, arrowheads, labels and all other marks that explain the rays.
    pub marks_drawn: usize,
    /// Whether the figure has words.
    pub font_used: bool,
}

impl Statistics {
    /// Counts the marks of a figure's layers and looks for words.
    pub(super) fn count(&mut self, layers: &[Item]) {
        for layer in layers {
            if let Item::Group(group) = layer
                && MARKS.contains(&group.class.as_str())
            {
                self.marks_drawn += marks(&group.items);
            }
        }
        self.font_used = layers.iter().any(has_words);
    }
}

/// How many marks a layer holds, those of all its generations.
fn marks(items: &[Item]) -> usize {
    let count = |item: &Item| match item {
        Item::Group(group) if group.step.is_some() => marks(&group.items),
        _ => 1,
    };
    items.iter().map(count).sum()
}

fn has_words(item: &Item) -> bool {
    match item {
        Item::Shape(_) | Item::Lines(_) => false,
        Item::Text(_) => true,
        Item::Group(group) => group.items.iter().any(has_words),
    }
}
