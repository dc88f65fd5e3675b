use glam::DVec2;

use crate::diagram::Figure;
use crate::diagram::frame::clip;
use crate::diagram::optics::Element;
use crate::diagram::room::{Room, centered};
use crate::drawing::{Anchor, Fill, Font, Item, Path, Shape, Stroke, Text};

const SIZE: f64 = 13.0;
/// Radius of a point, pixels.
const RADIUS: f64 = 2.6;
/// How far a principal plane stands out beyond its lens, pixels.
const BEYOND: f64 = 18.0;
/// Points closer than this are one, pixels.
const COINCIDENT: f64 = 1.0;
/// Free space between letters and lines, pixels.
const OFF_LINES: f64 = 3.0;
/// How far from its point the middle of a letter is sought, pixels.
const DISTANCES: [f64; 6] = [13.0, 17.0, 22.0, 29.0, 38.0, 50.0];
/// How far aside of the end of a principal plane, pixels.
const ASIDE: [f64; 3] = [11.0, 16.0, 22.0];
/// How far beyond that end, pixels.
const OUTWARD: [f64; 5] = [-3.0, 4.0, -9.0, -16.0, 12.0];
/// Where it is sought around the point: below first, since objects stand above the axis.
const AROUND: [DVec2; 8] = [
    DVec2::new(0.0, 1.0),
    DVec2::new(0.0, -1.0),
    DVec2::new(0.6, 0.8),
    DVec2::new(-0.6, 0.8),
    DVec2::new(0.6, -0.8),
    DVec2::new(-0.6, -0.8),
    DVec2::new(1.0, 0.3),
    DVec2::new(-1.0, 0.3),
];

/// Dashed principal planes.
pub(super) fn planes(figure: &Figure<'_>) -> Vec<Item> {
    let stroke = Stroke::solid(figure.palette.quiet, 1.1).dashed(&[4.0, 3.0]);
    let lines =
        figure.optics.elements.iter().flat_map(|element| element.planes.iter().map(move |(_, p)| (element, *p)));
    let lines = lines.filter_map(|(element, p)| {
        let [a, b] = plane(figure, element, p);
        clip(a, b - a, 1.0, &figure.frame.area)
    });
    lines.map(|[a, b]| Shape::stroked(Path::line(a, b), stroke.clone(), "principal-plane").into()).collect()
}

/// Both ends of a principal plane through a point of the axis, pixels, the upper one first.
fn plane(figure: &Figure<'_>, element: &Element, p: DVec2) -> [DVec2; 2] {
    let across = figure.frame.turn(element.axis.direction.perp());
    let across = if across.y > 0.0 { -across } else { across };
    let half = element.axis.half_height * figure.frame.scale() + BEYOND;
    let middle = figure.frame.place(p);
    [middle + half * across, middle - half * across]
}

/// The points on the axes, each once.
pub(super) fn points(figure: &Figure<'_>) -> Vec<Item> {
    let dot = |p| Shape::filled(Path::circle(p, RADIUS), Fill::solid(figure.palette.ink), "focal-point").into();
    seen_points(figure).into_iter().map(|(p, _)| dot(p)).collect()
}

/// An element and the letters of one of its points.
type Name<'a> = (&'a Element, &'static str);

/// The points in the frame, pixels, those that coincide as one with all their names.
fn seen_points<'a>(figure: &'a Figure<'_>) -> Vec<(DVec2, Vec<Name<'a>>)> {
    let mut seen: Vec<(DVec2, Vec<Name<'a>>)> = Vec::new();
    for element in &figure.optics.elements {
        for (letters, p) in &element.points {
            let p = figure.frame.place(*p);
            match seen.iter_mut().find(|(other, _)| other.distance(p) <= COINCIDENT) {
                Some((_, names)) => names.push((element, letters)),
                None if figure.frame.area.contains(p) => seen.push((p, vec![(element, letters)])),
                None => {}
            }
        }
    }
    seen
}

/// The letters of points and planes.
pub(super) fn letters(figure: &Figure<'_>, room: &mut Room) -> Vec<Item> {
    let mut items: Vec<Item> = Vec::new();
    let mut put = |text: Text, places: &[(f64, DVec2)]| {
        if let Some((_, middle)) = room.best(&text, places, OFF_LINES) {
            let text = centered(&text, middle);
            room.take(text.bounds());
            items.push(text.into());
        }
    };
    for (p, names) in seen_points(figure) {
        put(text(figure, &names), &around(p));
    }
    for element in &figure.optics.elements {
        for (k, (letters, p)) in element.planes.iter().enumerate() {
            // H stands where the light comes from, H′ where it goes.
            let along = figure.frame.turn(element.axis.direction) * if k == 0 { -1.0 } else { 1.0 };
            put(text(figure, &[(element, *letters)]), &beside_ends(plane(figure, element, *p), along));
        }
    }
    items
}

/// Middles of places around a point, from the nearest.
fn around(p: DVec2) -> Vec<(f64, DVec2)> {
    let places = (0..).map(f64::from).zip(DISTANCES).flat_map(|(step, distance)| {
        (0..).map(f64::from).zip(AROUND).map(move |(rank, side)| (1.5 * step + 0.3 * rank, p + distance * side))
    });
    places.collect()
}

/// Middles of places on one side of the two ends of a plane, those at the upper end first.
fn beside_ends([upper, lower]: [DVec2; 2], side: DVec2) -> Vec<(f64, DVec2)> {
    let out = (upper - lower).normalize_or_zero();
    let ends = [(0.0, upper, out), (3.0, lower, -out)];
    let places = ends.into_iter().flat_map(|(cost, end, out)| {
        (0..).map(f64::from).zip(OUTWARD).flat_map(move |(step, outward)| {
            ASIDE.map(|aside| (cost + step + 0.1 * aside, end + aside * side + outward * out))
        })
    });
    places.collect()
}

/// One or several names, such as F₁′, F₂.
fn text(figure: &Figure<'_>, names: &[Name<'_>]) -> Text {
    let text = Text::new("", DVec2::ZERO, SIZE, figure.palette.ink).anchored(Anchor::Middle).in_font(Font::Oblique);
    let add = |text: Text, (k, (element, letters)): (usize, &Name<'_>)| {
        let letter = letters.trim_end_matches('′');
        let text = text.then(if k > 0 { ",\u{a0}" } else { "" }).then(letter);
        let text = element.number.map_or(text.clone(), |number| text.subscript(&number.to_string()));
        if letter == *letters { text } else { text.then("′") }
    };
    names.iter().enumerate().fold(text, add).classed("cardinal")
}
