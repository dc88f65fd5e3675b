use glam::DVec2;

use crate::diagram::{Figure, nice, notes};
use crate::drawing::{Item, Path, Shape, Stroke, Text};

/// Lines are at least a third of this apart, pixels.
const SPACING: f64 = 90.0;
const NUMBER_SIZE: f64 = 10.0;

/// Lines at round coordinates, with numbers at the left and the foot.
pub(super) fn grid(figure: &Figure<'_>) -> Vec<Item> {
    let area = figure.frame.area;
    let shown = figure.frame.shown();
    let Some(step) = nice::at_most(SPACING / figure.frame.scale()) else { return Vec::new() };
    let notes = notes::notes(figure);
    let mut items: Vec<Item> = Vec::new();
    let mut free = area.min.x;
    for x in nice::multiples(step, shown.min.x, shown.max.x) {
        let at = figure.frame.place(DVec2::new(x, 0.0)).x;
        items.push(line(figure, DVec2::new(at, area.min.y), DVec2::new(at, area.max.y), x));
        let number = number(figure, x, DVec2::new(at + 3.0, area.max.y - 3.0));
        let bounds = number.bounds();
        let is_free = |item: &Item| !matches!(item, Item::Text(other) if other.bounds().overlaps(&bounds.grown(2.0)));
        if bounds.min.x >= free && bounds.max.x <= area.max.x && notes.iter().all(is_free) {
            free = bounds.max.x + 8.0;
            items.push(number.into());
        }
    }
    for y in nice::multiples(step, shown.min.y, shown.max.y) {
        let at = figure.frame.place(DVec2::new(0.0, y)).y;
        items.push(line(figure, DVec2::new(area.min.x, at), DVec2::new(area.max.x, at), y));
        let number = number(figure, y, DVec2::new(area.min.x + 3.0, at - 3.0));
        let bounds = number.bounds();
        let is_free = |item: &Item| !matches!(item, Item::Text(other) if other.bounds().overlaps(&bounds.grown(2.0)));
        if area.contains(bounds.min) && items.iter().chain(&notes).all(is_free) {
            items.push(number.into());
        }
    }
    items
}

/// A line of the grid; the axes are a little stronger.
fn line(figure: &Figure<'_>, from: DVec2, to: DVec2, value: f64) -> Item {
    let opacity = if value == 0.0 { 0.5 } else { 0.2 };
    Shape::stroked(Path::line(from, to), Stroke::solid(figure.palette.quiet, 0.8).faded(opacity), "").into()
}

fn number(figure: &Figure<'_>, value: f64, at: DVec2) -> Text {
    Text::new(&nice::label(value), at, NUMBER_SIZE, figure.palette.quiet)
}
