use glam::DVec2;

use crate::diagram::Figure;
use crate::diagram::wrap::wrap;
use crate::drawing::{Anchor, Font, Item, Text};

const SIZE: f64 = 13.0;
const LINE_HEIGHT: f64 = 17.0;

/// The author's words, centered on their places and held inside the frame; a line break starts a new line.
pub(super) fn notes(figure: &Figure<'_>) -> Vec<Item> {
    let mut items: Vec<Item> = Vec::new();
    for note in &figure.scene.notes {
        let middle = figure.frame.place(note.at);
        let width = figure.frame.area.size().x / SIZE;
        let lines = note.text.lines().flat_map(|line| wrap(line, Font::Oblique, width));
        let lines: Vec<String> = lines.filter(|line| !line.trim().is_empty()).collect();
        let count = u32::try_from(lines.len()).map_or(0.0, f64::from);
        let mut y = middle.y - 0.5 * LINE_HEIGHT * (count - 1.0) + 0.36 * SIZE;
        for line in lines {
            let text = Text::new(&line, DVec2::new(middle.x, y), SIZE, figure.palette.quiet);
            items.push(inside(figure, text.anchored(Anchor::Middle).in_font(Font::Oblique).classed("note")).into());
            y += LINE_HEIGHT;
        }
    }
    items
}

/// The same text, moved as far as it must be to stay inside the frame.
fn inside(figure: &Figure<'_>, mut text: Text) -> Text {
    let (area, bounds) = (figure.frame.area, text.bounds());
    let back = (bounds.max - area.max).max(DVec2::ZERO);
    let on = (area.min - bounds.min).max(DVec2::ZERO);
    // Where both ends stick out the beginning counts.
    let by = DVec2::select(on.cmpgt(DVec2::ZERO), on, -back);
    text.at = (text.at + by).clamp(DVec2::ZERO, area.max + area.min);
    text.at = DVec2::new(crate::drawing::pixel(text.at.x), crate::drawing::pixel(text.at.y));
    text
}
