use glam::DVec2;

use crate::drawing::{Stroke, hundredths};

/// Very many straight lines of one style, drawn as one: where they cross, nothing is painted twice.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Lines {
    /// Both ends of every line as x, y, x, y, hundredths of a pixel.
    pub ends: Vec<[i32; 4]>,
    /// How they are drawn.
    pub stroke: Stroke,
    /// Class names, by spaces; may be empty.
    pub class: String,
}

impl Lines {
    /// None yet.
    #[must_use]
    pub fn new(stroke: Stroke, class: &str) -> Self {
        Self { ends: Vec::new(), stroke, class: class.to_owned() }
    }

    /// Adds a line between two points, pixels.
    pub fn push(&mut self, from: DVec2, to: DVec2) {
        self.ends.push([from.x, from.y, to.x, to.y].map(hundredths));
    }
}
