use glam::DVec2;

use crate::diagram::{Figure, nice};
use crate::drawing::{Anchor, Cap, Item, Path, Shape, Stroke, Text};

/// Height that the bar takes below the scene, pixels.
pub(super) const HEIGHT: f64 = 28.0;
const LONGEST: f64 = 130.0;

/// A bar of a round length at the right foot of the figure.
pub(super) fn scale_bar(figure: &Figure<'_>) -> Vec<Item> {
    let frame = &figure.frame;
    let longest = LONGEST.min(0.4 * frame.area.size().x);
    let Some(length) = nice::at_most(longest / frame.scale()) else { return Vec::new() };
    let right = DVec2::new(frame.area.max.x - 8.0, frame.area.max.y + HEIGHT);
    let left = right - DVec2::new(length * frame.scale(), 0.0);
    let tick = DVec2::new(0.0, 4.0);
    let mut path = Path::line(left, right);
    path.append(Path::line(left - tick, left + tick));
    path.append(Path::line(right - tick, right + tick));
    let stroke = Stroke::solid(figure.palette.quiet, 1.5).capped(Cap::Butt);
    let middle = 0.5 * (left + right) - DVec2::new(0.0, 8.0);
    let words = Text::new(&format!("{} mm", nice::label(length)), middle, 11.5, figure.palette.quiet);
    vec![Shape::stroked(path, stroke, "").into(), words.anchored(Anchor::Middle).into()]
}
