use std::collections::BTreeMap;

use crate::diagram::{Figure, outline};
use crate::drawing::{Color, Fill, Group, Item, Path, Rect, Shape, Stroke};
use crate::geometry::{Bounds, BoxTree, Curve};
use crate::light::Wavelength;
use crate::scene::Substance;
use crate::system::{Action, Interface, MediumId, Outline};

/// Width of the boundary between two media, pixels.
const INTERFACE_WIDTH: f64 = 1.4;
/// Width of an outline where both sides are the same medium, pixels.
const OUTLINE_WIDTH: f64 = 0.6;

/// The media: the surroundings, every body's fill, thin outlines, and strong lines where light can turn.
pub(super) fn bodies(figure: &Figure<'_>) -> Vec<Item> {
    let mut items: Vec<Item> = surroundings(figure).into_iter().collect();
    let bodies: Vec<_> = figure.system.bodies().iter().map(|body| filled(&body.outlines)).collect();
    let turns = outline_turns(&bodies);
    let mut by_turn: Vec<usize> = (0..bodies.len()).collect();
    by_turn.sort_by_key(|k| turns[*k]);
    let mut waiting = by_turn.into_iter().peekable();
    for turn in 0..=bodies.len() {
        while let Some(k) = waiting.next_if(|k| turns[*k] == turn) {
            items.extend(outlines(figure, k, &bodies[k]));
        }
        if bodies.get(turn).is_some_and(|body| !body.is_empty()) {
            items.push(fills(figure, turn, &bodies[turn]));
        }
    }
    items.extend(interfaces(figure));
    items
}

/// A part of a body that a medium fills.
struct Filled<'a> {
    outline: &'a Outline,
    medium: MediumId,
    /// Its box in the scene.
    bounds: Rect,
}

fn filled(outlines: &[Outline]) -> Vec<Filled<'_>> {
    let filled = outlines.iter().filter_map(|outline| Some((outline, outline.medium?)));
    filled.map(|(outline, medium)| Filled { outline, medium, bounds: bounds(outline) }).collect()
}

/// Before which body's fill the outlines of every body are drawn: before the first later one of another medium that may
/// cover it. A later body of the same medium leaves them visible, since there the boundary vanishes but the shape stays.
fn outline_turns(bodies: &[Vec<Filled<'_>>]) -> Vec<usize> {
    let parts: Vec<_> = (0..).zip(bodies).flat_map(|(k, body)| body.iter().map(move |part| (k, part))).collect();
    let in_tree = |rect: Rect| Bounds { min: rect.min, max: rect.max };
    let tree = BoxTree::new(&parts.iter().map(|(_, part)| in_tree(part.bounds)).collect::<Vec<_>>());
    let mut turns = vec![bodies.len(); bodies.len()];
    for &(k, own) in &parts {
        tree.meeting(in_tree(own.bounds), |place| {
            let (later, other) = parts[place];
            if later > k && own.medium != other.medium && own.bounds.overlaps(&other.bounds) {
                turns[k] = turns[k].min(later);
            }
        });
    }
    turns
}

fn bounds(outline: &Outline) -> Rect {
    let points = outline.curves.iter().flat_map(outline::samples);
    let none = Rect { min: glam::DVec2::INFINITY, max: glam::DVec2::NEG_INFINITY };
    points.fold(none, |rect, p| Rect { min: rect.min.min(p), max: rect.max.max(p) })
}

/// The whole frame, unless it is empty space.
fn surroundings(figure: &Figure<'_>) -> Option<Item> {
    let color = tint(figure, figure.system.surroundings());
    let area = Path::rect(figure.frame.area);
    (color != figure.palette.ground).then(|| Shape::filled(area, Fill::solid(color), "surroundings").into())
}

fn fills(figure: &Figure<'_>, k: usize, body: &[Filled<'_>]) -> Item {
    let own = own_color(figure, k);
    let shapes = body.iter().map(|Filled { outline, medium, .. }| {
        let path = outline::path(&figure.frame, &outline.curves, outline.closed);
        Shape::filled(path, Fill::solid(own.unwrap_or_else(|| tint(figure, *medium))), "").into()
    });
    named(figure, k, shapes.collect())
}

fn outlines(figure: &Figure<'_>, k: usize, body: &[Filled<'_>]) -> Vec<Item> {
    let stroke = Stroke::solid(line_color(figure, k), OUTLINE_WIDTH).faded(0.7);
    // The space between the elements of a lens group has no shape of its own.
    let group = figure.scene.bodies.get(k).is_some_and(|body| body.substance == Substance::Elements);
    let shaped = body.iter().filter(|part| !group || part.medium != figure.system.surroundings());
    let lines = shaped.map(|Filled { outline, .. }| {
        let path = outline::path(&figure.frame, &outline.curves, outline.closed);
        Shape::stroked(path, stroke.clone(), "outline").into()
    });
    lines.collect()
}

/// A body's group, which carries its name.
pub(super) fn named(figure: &Figure<'_>, k: usize, items: Vec<Item>) -> Item {
    let name = figure.system.bodies().get(k).map_or_else(|| format!("#{k}"), |body| body.name.clone());
    Group { data: vec![("data-body", name)], ..Group::layer("body", items) }.into()
}

/// Boundaries between different media, by the body that they belong to.
fn interfaces(figure: &Figure<'_>) -> Vec<Item> {
    let mut by_body: BTreeMap<usize, Vec<&Interface>> = BTreeMap::new();
    for interface in figure.system.interfaces().iter().filter(|interface| interface.action == Action::Refract) {
        by_body.entry(interface.body).or_default().push(interface);
    }
    let lines = by_body.into_iter().map(|(k, own)| {
        let mut path = Path::new();
        for chain in chains(own.into_iter(), figure) {
            path.append(outline::path(&figure.frame, &chain, false));
        }
        Shape::stroked(path, Stroke::solid(line_color(figure, k), INTERFACE_WIDTH), "interface")
    });
    lines.filter(|shape| !shape.path.is_empty()).map(Item::from).collect()
}

/// Pieces in scene coordinates, those in one chain that continue each other.
fn chains<'a>(pieces: impl Iterator<Item = &'a Interface>, figure: &Figure<'_>) -> Vec<Vec<Curve>> {
    let mut chains: Vec<Vec<Curve>> = Vec::new();
    let mut last = None;
    for piece in pieces {
        let curve = moved(&piece.curve, figure.system.origin());
        match chains.last_mut().filter(|_| last == Some(piece.ends[0])) {
            Some(chain) => chain.push(curve),
            None => chains.push(vec![curve]),
        }
        last = Some(piece.ends[1]);
    }
    chains
}

fn moved(curve: &Curve, by: glam::DVec2) -> Curve {
    Curve { a: curve.a + by, b: curve.b + by, m: curve.m + by, ..*curve }
}

fn own_color(figure: &Figure<'_>, k: usize) -> Option<Color> {
    figure.scene.bodies.get(k)?.color.map(|own| figure.palette.own_body(own))
}

/// Color of a body's lines and words: its own, deepened, or the theme's.
pub(super) fn line_color(figure: &Figure<'_>, k: usize) -> Color {
    let palette = &figure.palette;
    own_color(figure, k).map_or(palette.outline, |own| own.toward(palette.ink, 0.55))
}

fn tint(figure: &Figure<'_>, medium: MediumId) -> Color {
    let lines = figure.system.wavelengths();
    let middle = lines.get(lines.len() / 2).copied().unwrap_or(Wavelength::D);
    figure.palette.medium(figure.system.index(medium, middle))
}
