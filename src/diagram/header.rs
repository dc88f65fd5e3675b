use glam::DVec2;

use crate::diagram::palette::Palette;
use crate::diagram::wrap::wrap;
use crate::drawing::{Font, Item, Text};
use crate::scene::Scene;

const TITLE_SIZE: f64 = 20.0;
const CAPTION_SIZE: f64 = 13.0;

/// Free space at the sides of the words, pixels; less in a small figure.
pub(super) fn margin(scene: &Scene) -> f64 {
    (f64::from(scene.diagram.size[0]) / 20.0).min(32.0)
}

/// Factor on the sizes of the words: 1, less in a small figure.
fn shrink(scene: &Scene) -> f64 {
    let [width, height] = scene.diagram.size.map(f64::from);
    (width / 560.0).min(height / 320.0).clamp(0.5, 1.0)
}

/// Title and caption, and the height at which the rest may start.
pub(super) fn header(scene: &Scene, palette: &Palette) -> (Vec<Item>, f64) {
    let (left, shrink) = (margin(scene), shrink(scene));
    let (title_size, caption_size) = (TITLE_SIZE * shrink, CAPTION_SIZE * shrink);
    let width = f64::from(scene.diagram.size[0]) - 2.0 * left;
    let mut items: Vec<Item> = Vec::new();
    let mut y = left;
    for words in wrap(&scene.title, Font::Bold, width / title_size) {
        y += shrink * if items.is_empty() { 12.0 } else { 26.0 };
        let text = Text::new(&words, DVec2::new(left, y), title_size, palette.ink);
        items.push(text.in_font(Font::Bold).classed("title").into());
    }
    y += shrink * if items.is_empty() { 6.0 } else { 24.0 };
    let mut below = y - 22.0 * shrink;
    for words in wrap(&scene.caption, Font::Regular, width / caption_size) {
        items.push(Text::new(&words, DVec2::new(left, y), caption_size, palette.quiet).classed("caption").into());
        below = y;
        y += 18.0 * shrink;
    }
    (items, below + 18.0 * shrink)
}
