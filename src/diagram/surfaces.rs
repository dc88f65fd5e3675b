use std::collections::BTreeMap;

use glam::DVec2;

use crate::diagram::{Figure, bodies, outline};
use crate::drawing::{Cap, Color, Fill, Item, Path, Shape, Stroke};
use crate::geometry::Curve;
use crate::numerics::cross;
use crate::scene::{Substance, Surface};
use crate::system::{Outline, PlacedBody};

/// Distance of the strokes on a mirror's back, pixels.
const HATCH_STEP: f64 = 7.0;
/// Length of those strokes, pixels.
const HATCH_LENGTH: f64 = 7.0;
/// A longer mirror is drawn without them, pixels.
const LONGEST_HATCHED: f64 = 1e4;
/// Length of the barbs at the ends of an ideal lens, pixels.
pub(super) const BARB: f64 = 10.0;

/// Mirrors, screens, absorbers, beam splitters and ideal lenses, each in its textbook sign.
pub(super) fn surfaces(figure: &Figure<'_>) -> Vec<Item> {
    let bodies = figure.scene.bodies.iter().zip(figure.system.bodies()).enumerate();
    let surfaces = bodies.filter_map(|(k, (body, placed))| match body.substance {
        Substance::Surface(surface) => Some((k, surface, placed)),
        Substance::Medium(_) | Substance::Elements => None,
    });
    let surfaces: Vec<_> = surfaces.collect();
    let lit = lit_sides(
        figure,
        surfaces.iter().filter(|(_, surface, placed)| has_dark_side(*surface, placed)).map(|(k, ..)| *k),
    );
    let named = surfaces.into_iter().map(|(k, surface, placed)| {
        let lit = lit.get(&k).map_or(&[][..], Vec::as_slice);
        bodies::named(figure, k, marks(figure, k, surface, placed, lit))
    });
    named.collect()
}

/// Whether the sign of a surface tells where no light comes from.
fn has_dark_side(surface: Surface, placed: &PlacedBody) -> bool {
    surface == Surface::Mirror || placed.outlines.iter().any(|outline| outline.closed)
}

fn marks(figure: &Figure<'_>, k: usize, surface: Surface, placed: &PlacedBody, lit: &[Sides]) -> Vec<Item> {
    let stroke = stroke(figure, k, surface);
    let mut items = Vec::new();
    for (i, outline) in placed.outlines.iter().enumerate() {
        let lit = lit.get(i).copied().unwrap_or_default();
        if surface == Surface::Mirror {
            items.extend(hatching(figure, lit, outline, stroke.color));
        }
        let line = outline::path(&figure.frame, &outline.curves, outline.closed);
        items
            .extend(filling(lit, outline, stroke.color).map(|fill| Shape::filled(line.clone(), fill, "opaque").into()));
        items.push(Shape::stroked(line, stroke.clone(), class(surface)).into());
        if let Surface::ThinLens { focal_length } = surface {
            let heads = heads(figure, outline, focal_length);
            items.push(Shape::stroked(heads, stroke.clone(), class(surface)).into());
        }
    }
    items
}

fn stroke(figure: &Figure<'_>, k: usize, surface: Surface) -> Stroke {
    let palette = &figure.palette;
    let own = figure.scene.bodies.get(k).and_then(|body| body.color).map(Color);
    let color = |theme: Color| own.unwrap_or(theme);
    match surface {
        Surface::Mirror => Stroke::solid(color(palette.mirror), 2.6),
        Surface::Absorber => Stroke::solid(color(palette.ink), 4.0).capped(Cap::Butt),
        Surface::Screen => Stroke::solid(color(palette.screen), 4.0).capped(Cap::Butt),
        Surface::BeamSplitter { .. } => Stroke::solid(color(palette.mirror), 2.0).dashed(&[7.0, 3.0]),
        Surface::ThinLens { .. } => Stroke::solid(color(palette.outline), 1.8),
    }
}

fn class(surface: Surface) -> &'static str {
    match surface {
        Surface::Mirror => "surface mirror",
        Surface::Absorber => "surface absorber",
        Surface::Screen => "surface screen",
        Surface::BeamSplitter { .. } => "surface beam-splitter",
        Surface::ThinLens { .. } => "surface thin-lens",
    }
}

/// Fill of a closed surface that light does not get into, so that it looks solid; none where its inside is lit.
fn filling(lit: Sides, outline: &Outline, color: Color) -> Option<Fill> {
    if !outline.closed {
        return None;
    }
    // Shoelace: above 0 the inside is on the left.
    let points: Vec<DVec2> = outline.curves.iter().flat_map(outline::samples).collect();
    let middle = points.iter().copied().reduce(DVec2::min)?;
    let area: f64 = points.windows(2).map(|pair| cross(pair[0] - middle, pair[1] - middle)).sum();
    let inside_lit = lit[usize::from(area > 0.0)];
    (!inside_lit).then_some(Fill { color, opacity: 0.16 })
}

/// Barbs at both ends of an ideal lens: outward tips converge light, inward ones diverge it.
fn heads(figure: &Figure<'_>, outline: &Outline, focal_length: f64) -> Path {
    let mut path = Path::new();
    let (Some(first), Some(last)) = (outline.curves.first(), outline.curves.last()) else { return path };
    let [a, b] = [figure.frame.place(first.a), figure.frame.place(last.b)];
    let back = (b - a).normalize_or_zero() * if focal_length > 0.0 { 1.0 } else { -1.0 };
    for (tip, back) in [(a, back), (b, -back)] {
        let side = 0.55 * BARB * back.perp();
        path.move_to(tip + 0.8 * BARB * back + side);
        path.line_to(tip);
        path.line_to(tip + 0.8 * BARB * back - side);
    }
    path
}

/// Short strokes on the side of a mirror that no light reaches; none if both sides or neither are lit.
fn hatching(figure: &Figure<'_>, lit: Sides, outline: &Outline, color: Color) -> Option<Item> {
    let points = outline::flatten(&figure.frame, &outline.curves);
    let length: f64 = points.windows(2).map(|pair| (pair[1] - pair[0]).length()).sum();
    let dark_left = dark_side_is_left(lit)?;
    if length > LONGEST_HATCHED {
        return None;
    }
    let mut path = Path::new();
    let mut next = 0.5 * HATCH_STEP;
    for pair in points.windows(2) {
        let piece = (pair[1] - pair[0]).length();
        let along = (pair[1] - pair[0]).normalize_or_zero();
        // On the screen, y down, `perp` points to the right of the direction of travel.
        let away = if dark_left { -along.perp() } else { along.perp() };
        while next < piece {
            let foot = pair[0] + along * next;
            path.move_to(foot);
            path.line_to(foot + (away - 0.6 * along) * (HATCH_LENGTH * 0.8));
            next += HATCH_STEP;
        }
        next -= piece;
    }
    let stroke = Stroke::solid(color, 1.0).capped(Cap::Butt).faded(0.8);
    Some(Shape::stroked(path, stroke, "surface mirror-back").into())
}

fn dark_side_is_left(lit: Sides) -> Option<bool> {
    match lit {
        [true, false] => Some(true),
        [false, true] => Some(false),
        _ => None,
    }
}

/// Whether light comes from the right of an outline's direction of travel, and from the left.
type Sides = [bool; 2];

/// The lit sides of the outlines of some bodies.
fn lit_sides(figure: &Figure<'_>, bodies: impl Iterator<Item = usize>) -> BTreeMap<usize, Vec<Sides>> {
    let outlines = |k: usize| figure.system.bodies()[k].outlines.as_slice();
    let mut lit: BTreeMap<_, _> = bodies.map(|k| (k, vec![Sides::default(); outlines(k).len()])).collect();
    if lit.is_empty() {
        return lit;
    }
    for segment in figure.tree.rays.iter().flat_map(|ray| &ray.segments) {
        let (Some(hit), Some(at)) = (segment.hit, segment.to) else { continue };
        let Some(sides) = lit.get_mut(&hit.body) else { continue };
        for (sides, outline) in sides.iter_mut().zip(outlines(hit.body)).filter(|(sides, _)| **sides != [true; 2]) {
            let nearest = outline.curves.iter().min_by(|a, b| distance(a, at).total_cmp(&distance(b, at)));
            let from_left = nearest.is_some_and(|curve| curve.normal_at(at).dot(hit.normal) > 0.0);
            sides[usize::from(from_left)] = true;
        }
    }
    lit
}

/// Distance of a point from a curve, its ends included.
fn distance(curve: &Curve, p: DVec2) -> f64 {
    let along = curve.along(p);
    let within = along >= 0.0 && along <= (curve.b - curve.a).length_squared();
    if within || curve.spans_more_than_half() {
        curve.offset(p).abs()
    } else {
        (p - curve.a).length().min((p - curve.b).length())
    }
}
