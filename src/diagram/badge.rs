use glam::DVec2;

use crate::diagram::room::centered;
use crate::drawing::{Anchor, Color, Fill, Font, Item, Path, Rect, Shape, Text};

/// Size of its letters as a share of those beside it.
const SMALLER: f64 = 0.82;
/// Free space between its letters and its ends, and between it and the words beside it, pixels.
const INSIDE: f64 = 5.0;
const APART: f64 = 4.0;
const HEIGHT: f64 = 14.0;

/// A few letters on a ground of their own, and words behind them on the same line.
pub(super) struct Badge {
    letters: Text,
    words: Text,
    color: Color,
}

impl Badge {
    /// Letters in the color of the figure's ground on a color.
    pub(super) fn new(letters: &str, words: Text, color: Color, ground: Color) -> Self {
        let letters = Text::new(letters, DVec2::ZERO, SMALLER * words.size, ground).in_font(Font::Bold);
        Self { letters: letters.anchored(Anchor::Middle).classed("badge"), words, color }
    }

    /// The rectangle about its middle.
    pub(super) fn bounds(&self) -> Rect {
        let half = 0.5 * DVec2::new(self.pill() + APART + self.words.width(), HEIGHT);
        Rect { min: -half, max: half }
    }

    fn pill(&self) -> f64 {
        self.letters.width() + 2.0 * INSIDE
    }

    /// With its middle at a point.
    pub(super) fn items(&self, middle: DVec2) -> [Item; 3] {
        let left = middle.x - 0.5 * self.bounds().size().x;
        let at = DVec2::new(left + 0.5 * self.pill(), middle.y);
        let words = DVec2::new(left + self.pill() + APART + 0.5 * self.words.width(), middle.y);
        let shape = Shape::filled(pill(at, self.pill()), Fill::solid(self.color), "badge");
        [shape.into(), centered(&self.letters, at).into(), centered(&self.words, words).into()]
    }
}

/// A rectangle with round ends.
fn pill(middle: DVec2, width: f64) -> Path {
    let radius = 0.5 * HEIGHT;
    let [left, right] = [-1.0, 1.0].map(|side| middle + DVec2::new(side * (0.5 * width - radius), 0.0));
    let up = DVec2::new(0.0, -radius);
    let mut path = Path::new();
    path.move_to(left + up);
    path.line_to(right + up);
    path.arc_to(radius, false, true, right - up);
    path.line_to(left - up);
    path.arc_to(radius, false, true, left + up);
    path.close();
    path
}
