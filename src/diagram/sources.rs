use glam::DVec2;

use crate::diagram::Figure;
use crate::drawing::{Fill, Item, Path, Shape};

/// Radius of the dot, pixels.
const RADIUS: f64 = 3.0;

/// A dot at every point that several rays start from, but for objects, which are arrows.
pub(super) fn sources(figure: &Figure<'_>) -> Vec<Item> {
    let system = figure.system;
    let mut points: Vec<DVec2> = Vec::new();
    for source in system.sources().iter().filter(|source| source.object.is_none()) {
        if let [first, rest @ ..] = source.starts.as_slice()
            && !rest.is_empty()
            && rest.iter().all(|start| start.from == first.from)
        {
            points.push(figure.frame.place(first.from + system.origin()));
        }
    }
    points.retain(|p| figure.frame.area.contains(*p));
    let dot = |p: &DVec2| Shape::filled(Path::circle(*p, RADIUS), Fill::solid(figure.palette.ink), "source").into();
    points.iter().map(dot).collect()
}
