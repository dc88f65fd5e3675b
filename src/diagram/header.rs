use glam::DVec2;

use crate::diagram::palette::Palette;
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

/// Breaks text into lines of at most `width` ems, between words where it can.
fn wrap(text: &str, font: Font, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let mut line = String::new();
    for word in text.split_whitespace() {
        let longer = if line.is_empty() { word.to_owned() } else { format!("{line} {word}") };
        if font.width(&longer) <= width {
            line = longer;
            continue;
        }
        lines.extend(Some(std::mem::take(&mut line)).filter(|line| !line.is_empty()));
        line = break_word(word, font, width, &mut lines);
    }
    lines.extend(Some(line).filter(|line| !line.is_empty()));
    lines
}

/// Puts full lines of a word that is too long into `lines` and returns the rest.
fn break_word(word: &str, font: Font, width: f64, lines: &mut Vec<String>) -> String {
    let mut line = String::new();
    let mut length = 0.0;
    for character in word.chars() {
        let advance = font.advance(character);
        if length + advance > width && !line.is_empty() {
            lines.push(std::mem::take(&mut line));
            length = 0.0;
        }
        line.push(character);
        length += advance;
    }
    line
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_line_is_longer_than_the_width() {
        let text = "Light meets the hypotenuse at 45°. Donaudampfschifffahrtsgesellschaft is long.";
        let lines = wrap(text, Font::Regular, 12.0);
        assert!(lines.len() > 3);
        assert!(lines.iter().all(|line| Font::Regular.width(line) <= 12.0));
        assert_eq!(lines.concat().replace(' ', ""), text.replace(' ', ""));
        assert!(wrap(" \n", Font::Bold, 12.0).is_empty());
        assert_eq!(wrap("ab", Font::Bold, 0.0), ["a", "b"], "never stuck");
    }
}
