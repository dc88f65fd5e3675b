//! Lines below the figure: what is only numbered in it, and the legend.

use glam::DVec2;

use crate::drawing::{Item, Path, Shape, Stroke, Text, pixel};

/// Size of the words, pixels.
pub(super) const SIZE: f64 = 12.0;
const LINE_HEIGHT: f64 = 18.0;
/// Height that one line of entries takes, pixels.
pub(super) const LINE: f64 = LINE_HEIGHT + BELOW;
const BELOW: f64 = 0.4 * LINE_HEIGHT;
/// Free space between two entries, pixels.
const APART: f64 = 26.0;
/// Length of a sample of a line, and the free space after it, pixels.
const SAMPLE: [f64; 2] = [30.0, 7.0];

/// Words, after a sample of what they explain if it is a line.
pub(super) struct Entry {
    pub(super) sample: Option<Stroke>,
    pub(super) text: Text,
}

impl Entry {
    /// Whether it is of the legend, not a value without room in the figure.
    pub(super) fn is_legend(&self) -> bool {
        self.text.class == "legend"
    }

    fn indent(&self) -> f64 {
        if self.sample.is_some() { SAMPLE.iter().sum() } else { 0.0 }
    }

    fn width(&self) -> f64 {
        self.indent() + self.text.width()
    }

    fn items(&self, at: DVec2) -> impl Iterator<Item = Item> {
        let words = at + DVec2::new(self.indent(), 0.0);
        let text = Text { at: DVec2::new(pixel(words.x), pixel(words.y)), ..self.text.clone() };
        let from = at - DVec2::new(0.0, 0.36 * SIZE);
        let line = |stroke: &Stroke| {
            Shape::stroked(Path::line(from, from + DVec2::new(SAMPLE[0], 0.0)), stroke.clone(), "sample").into()
        };
        self.sample.as_ref().map(line).into_iter().chain([text.into()])
    }
}

/// Height that some entries take, pixels.
pub(super) fn height(entries: &[Entry], width: f64) -> f64 {
    places(entries, width).last().map_or(0.0, |last| last.y + BELOW)
}

/// The entries side by side, in as many lines as it takes below a corner.
pub(super) fn items(entries: &[Entry], corner: DVec2, width: f64) -> Vec<Item> {
    entries.iter().zip(places(entries, width)).flat_map(|(entry, at)| entry.items(corner + at)).collect()
}

/// Where each entry begins, on its baseline.
fn places(entries: &[Entry], width: f64) -> Vec<DVec2> {
    let mut at = DVec2::new(0.0, LINE_HEIGHT);
    let mut place = |entry: &Entry| {
        if at.x > 0.0 && at.x + entry.width() > width {
            at = DVec2::new(0.0, at.y + LINE_HEIGHT);
        }
        let place = at;
        at.x += entry.width() + APART;
        place
    };
    entries.iter().map(&mut place).collect()
}
