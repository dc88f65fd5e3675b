use glam::DVec2;

use crate::diagram::Figure;
use crate::drawing::{Cap, Fill, Item, Path, Shape, Stroke};
use crate::system::RayStart;

/// Radius of the dot, pixels.
const RADIUS: f64 = 3.0;
/// How far the bar of a beam stands out beyond its outermost rays, pixels.
const BEYOND: f64 = 5.0;
/// Cosines below one by less belong to parallel rays.
const PARALLEL: f64 = 1e-12;

/// A dot at every point that rays start from, and a thin bar across the start of parallel ones; objects are arrows.
pub(super) fn sources(figure: &Figure<'_>) -> Vec<Item> {
    let sources = figure.system.sources().iter().filter(|source| source.object.is_none());
    sources.filter_map(|source| dot(figure, &source.starts).or_else(|| bar(figure, &source.starts))).collect()
}

fn dot(figure: &Figure<'_>, starts: &[RayStart]) -> Option<Item> {
    let [first, rest @ ..] = starts else { return None };
    let at = place(figure, first);
    let is_point = rest.iter().all(|start| start.from == first.from);
    let dot = || Shape::filled(Path::circle(at, RADIUS), Fill::solid(figure.palette.ink), "source").into();
    (is_point && figure.frame.area.contains(at)).then(dot)
}

fn bar(figure: &Figure<'_>, starts: &[RayStart]) -> Option<Item> {
    let [first, .., last] = starts else { return None };
    let is_beam = starts.iter().all(|start| start.direction.dot(first.direction) > 1.0 - PARALLEL);
    let [a, b] = [first, last].map(|start| place(figure, start));
    let out = BEYOND * (b - a).normalize_or_zero();
    let is_seen = figure.frame.area.contains(a) && figure.frame.area.contains(b);
    let stroke = || Stroke::solid(figure.palette.quiet, 1.0).capped(Cap::Butt);
    (is_beam && is_seen).then(|| Shape::stroked(Path::line(a - out, b + out), stroke(), "source").into())
}

fn place(figure: &Figure<'_>, start: &RayStart) -> DVec2 {
    figure.frame.place(start.from + figure.system.origin())
}
