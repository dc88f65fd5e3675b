use glam::DVec2;

use crate::diagram::room::{CROSSING, Room, centered};
use crate::diagram::{Figure, bodies, outline, surfaces};
use crate::drawing::{Anchor, Color, Item, Rect, Text};
use crate::scene::{Medium, Substance, Surface};

const SIZE: f64 = 12.0;
/// Distance of the baselines of a label's two lines, pixels.
const LINE_HEIGHT: f64 = 15.0;
/// Free space between a label and what it names, pixels.
const GAP: f64 = 11.0;
/// A place that costs less needs no other.
const GOOD: f64 = 8.0;
/// Smaller indices belong to gases and to empty space, which need no words as surroundings.
const GAS: f64 = 1.01;
/// Free space between the words for the surroundings and others, pixels.
const APART: f64 = 10.0;
/// Free space between a label and lines, pixels.
const OFF_LINES: f64 = 6.0;

/// Every body's label, or else its name, inside where there is room and beside it where not.
pub(super) fn labels(figure: &Figure<'_>, shapes: &[Vec<Shape>], room: &mut Room) -> Vec<Item> {
    if !figure.scene.diagram.labels {
        return Vec::new();
    }
    let mut homes = Homes { boxes: shapes.iter().map(|shapes| seen(shapes, &room.area)).collect(), own: 0 };
    let mut items: Vec<Item> = Vec::new();
    for k in 0..shapes.len() {
        homes.own = k;
        let with_index = || {
            let [words, index] = words_with_index(figure, k)?;
            let is_named = !words.is_empty();
            let one_line = text(figure, k, &words).then(&format!("{}{index}", if is_named { ", " } else { "" }));
            let two_lines = [words, index].map(|words| text(figure, k, &words));
            let inside = |lines: &[Text]| place_inside(lines, k, shapes, room);
            inside(std::slice::from_ref(&one_line)).or_else(|| inside(&two_lines)).or_else(|| {
                let (cost, text) = place(&one_line, &homes, shapes, room)?;
                (is_named && cost < CROSSING).then(|| vec![text])
            })
        };
        let by_itself = || Some(vec![place(&text(figure, k, words(figure, k)?), &homes, shapes, room)?.1]);
        for text in with_index().or_else(by_itself).into_iter().flatten() {
            room.take(text.bounds());
            items.push(text.into());
        }
    }
    items.extend(surroundings(figure, shapes, room));
    items
}

/// What stands around the bodies, if that is not empty space or air, in a corner of the frame.
fn surroundings(figure: &Figure<'_>, shapes: &[Vec<Shape>], room: &mut Room) -> Option<Item> {
    let [line] = figure.system.wavelengths()[..] else { return None };
    let index = figure.system.index(figure.system.surroundings(), line);
    let is_told = figure.scene.notes.iter().any(|note| note.text.contains("n ="));
    if index < GAS || is_told {
        return None;
    }
    let words = match &figure.scene.surroundings {
        Medium::Catalog(name) => format!("{name}, {}", index_words(index)),
        _ => index_words(index),
    };
    let text = Text::new(&words, DVec2::ZERO, SIZE, figure.palette.outline).anchored(Anchor::Middle).classed("label");
    let half = 0.5 * text.bounds().size() + GAP;
    let Rect { min, max } = room.area;
    let corners = [0.0, 0.15, 0.3].map(|share| {
        let [left, right] = [min.x + half.x, max.x - half.x].map(|x| x + share * (0.5 * (min.x + max.x) - x));
        [max.y - half.y, min.y + half.y].map(|y| [(left, y), (right, y)])
    });
    let corners = (0..).map(f64::from).zip(corners.into_iter().flatten().flatten());
    let places: Vec<_> = corners.map(|(rank, at)| (0.1 * rank, DVec2::from(at))).collect();
    let about = centered(&text, DVec2::ZERO).bounds();
    let is_outside = |place: &&(f64, DVec2)| !shapes.iter().flatten().any(|shape| covers(shape, &about.moved(place.1)));
    let free: Vec<_> = places.iter().filter(is_outside).copied().collect();
    let (_, middle) = room.best_for(about.grown(APART), &free, OFF_LINES).filter(|(cost, _)| *cost < CROSSING)?;
    let text = centered(&text, middle);
    room.take(text.bounds());
    Some(text.into())
}

fn text(figure: &Figure<'_>, k: usize, words: &str) -> Text {
    Text::new(words, DVec2::ZERO, SIZE, color(figure, k)).anchored(Anchor::Middle).classed("label")
}

/// Lines of text, one below the other, in a good place inside of their body, if there is one.
fn place_inside(lines: &[Text], k: usize, shapes: &[Vec<Shape>], room: &Room) -> Option<Vec<Text>> {
    let about = lined_up(lines, DVec2::ZERO).iter().map(Text::bounds).reduce(union)?;
    let (cost, middle) = room.best_for(about, &inside(&shapes[k], &shapes[k + 1..], about, &room.area), OFF_LINES)?;
    (cost < GOOD).then(|| lined_up(lines, middle))
}

/// Lines of text about a common middle, one below the other.
fn lined_up(lines: &[Text], middle: DVec2) -> Vec<Text> {
    let first = 0.5 * LINE_HEIGHT * (1.0 - f64::from(u32::try_from(lines.len()).unwrap_or(1)));
    let heights = (0..).map(|row| first + LINE_HEIGHT * f64::from(row));
    lines.iter().zip(heights).map(|(line, height)| centered(line, middle + DVec2::new(0.0, height))).collect()
}

/// A text in the best place inside of its body or beside it, with its cost.
fn place(text: &Text, homes: &Homes, shapes: &[Vec<Shape>], room: &Room) -> Option<(f64, Text)> {
    let k = homes.own;
    let about = centered(text, DVec2::ZERO).bounds();
    let inside = room.best_for(about, &inside(&shapes[k], &shapes[k + 1..], about, &room.area), OFF_LINES);
    let place = inside.filter(|(cost, _)| *cost < GOOD).or_else(|| {
        let places = homes.near(beside(&shapes[k], text, &room.area), &shapes[k], text);
        let beside = room.best(text, &places, OFF_LINES);
        [inside, beside].into_iter().flatten().min_by(|a, b| a.0.total_cmp(&b.0))
    });
    place.map(|(cost, middle)| (cost, centered(text, middle)))
}

/// The outline's color, deep enough to read on the fill.
fn color(figure: &Figure<'_>, k: usize) -> Color {
    bodies::line_color(figure, k).toward(figure.palette.ink, 0.25)
}

fn words<'a>(figure: &'a Figure<'_>, k: usize) -> Option<&'a str> {
    let body = figure.scene.bodies.get(k)?;
    body.label.as_deref().or(body.name.as_deref()).filter(|words| !words.trim().is_empty())
}

/// A medium's name and its index at the scene's one wavelength; the index alone where nothing else names the medium.
fn words_with_index(figure: &Figure<'_>, k: usize) -> Option<[String; 2]> {
    let outlines = &figure.system.bodies()[k].outlines;
    let medium = outlines.first()?.medium?;
    let [line] = figure.system.wavelengths()[..] else { return None };
    let index = figure.system.index(medium, line);
    let (body, is_alike) = (figure.scene.bodies.get(k)?, outlines.iter().all(|one| one.medium == Some(medium)));
    if !is_alike || index <= 1.0 {
        return None;
    }
    let index = index_words(index);
    match words(figure, k) {
        Some(words) if words.contains('=') => None,
        Some(words) => Some([words.to_owned(), index]),
        None if body.label.is_some() || !figure.scene.notes.is_empty() => None,
        None => Some([String::new(), index]),
    }
}

/// An index to three decimals, of gases to five.
fn index_words(index: f64) -> String {
    let steps = if index < GAS { 1e5 } else { 1e3 };
    format!("n\u{a0}=\u{a0}{}", (steps * index).round() / steps)
}

/// An outline as chords.
pub(super) struct Shape {
    points: Vec<DVec2>,
    /// Whether it has an inside.
    filled: bool,
    bounds: Rect,
}

/// The outlines of every body.
pub(super) fn shapes(figure: &Figure<'_>) -> Vec<Vec<Shape>> {
    (0..figure.system.bodies().len()).map(|k| shapes_of(figure, k)).collect()
}

fn shapes_of(figure: &Figure<'_>, k: usize) -> Vec<Shape> {
    let substance = figure.scene.bodies.get(k).map(|body| &body.substance);
    // The barbs of a diverging lens reach beyond its ends.
    let barbed =
        matches!(substance, Some(Substance::Surface(Surface::ThinLens { focal_length })) if *focal_length < 0.0);
    let outlines = figure.system.bodies()[k].outlines.iter();
    let shapes = outlines.filter_map(|outline| {
        let points = outline::flatten(&figure.frame, &outline.curves);
        let [min, max] = [points.iter().copied().reduce(DVec2::min)?, points.iter().copied().reduce(DVec2::max)?];
        let bounds = Rect { min, max }.grown(if barbed { surfaces::BARB } else { 0.0 });
        Some(Shape { points, filled: outline.closed, bounds })
    });
    shapes.collect()
}

/// The chords of all outlines.
pub(super) fn chords(shapes: &[Vec<Shape>]) -> impl Iterator<Item = [DVec2; 2]> {
    shapes.iter().flatten().flat_map(|shape| shape.points.windows(2).map(|pair| [pair[0], pair[1]]))
}

/// Middles of places inside a body's outline where words with this rectangle fit as a whole and no later body covers them.
fn inside(shapes: &[Shape], later: &[Vec<Shape>], about: Rect, area: &Rect) -> Vec<(f64, DVec2)> {
    let mut places = Vec::new();
    let about = about.grown(3.0);
    for shape in shapes.iter().filter(|shape| shape.filled) {
        let Some(bounds) = seen([shape], area) else { continue };
        // A little below the middle is the natural place: light mostly crosses the middle.
        let home = bounds.center() + DVec2::new(0.0, 0.15 * bounds.size().y);
        for (column, row) in (1..12).flat_map(|column| (1..16).map(move |row| (column, row))) {
            let share = DVec2::new(f64::from(column) / 12.0, f64::from(row) / 16.0);
            let middle = bounds.min + share * bounds.size();
            let rect = about.moved(middle);
            let fits = rim(&rect).into_iter().all(|p| contains(shape, p));
            if fits && !later.iter().flatten().any(|other| covers(other, &rect)) {
                places.push(((middle - home).length() / bounds.size().max_element(), middle));
            }
        }
    }
    places
}

/// Whether a later body hides a part of a place.
fn covers(shape: &Shape, rect: &Rect) -> bool {
    shape.filled && shape.bounds.overlaps(rect) && rim(rect).into_iter().any(|p| contains(shape, p))
}

/// Middles of places beside a body, from the nearest.
fn beside(shapes: &[Shape], text: &Text, area: &Rect) -> Vec<(f64, DVec2)> {
    let Some(bounds) = seen(shapes, area) else { return Vec::new() };
    let half = 0.5 * text.bounds().size() + GAP;
    let mut places = Vec::new();
    for (i, share) in [0.5, 0.2, 0.8, 0.0, 1.0].into_iter().enumerate() {
        let along = bounds.min + share * bounds.size();
        let near = DVec2::new(along.x, bounds.max.y + half.y);
        let sides = [
            near,
            DVec2::new(along.x, bounds.min.y - half.y),
            DVec2::new(bounds.max.x + half.x, along.y),
            DVec2::new(bounds.min.x - half.x, along.y),
        ];
        let rank = [0.0, 1.0, 2.0, 3.0, 4.0][i];
        places.extend([0.0, 0.2, 0.4, 0.6].into_iter().zip(sides).map(|(side, p)| (2.0 + rank + side, p)));
    }
    // Next to the line of a bent body its box is far away.
    for (shape, share) in shapes.iter().flat_map(|shape| [0.15, 0.3, 0.45, 0.6, 0.75, 0.9].map(|share| (shape, share)))
    {
        let Some(p) = point_along(&shape.points, share) else { continue };
        let sides = [DVec2::Y, DVec2::NEG_Y, DVec2::X, DVec2::NEG_X];
        places.extend(sides.into_iter().map(|side| (7.0, p + side * half)));
    }
    places
}

/// A point at a share of a line's length.
fn point_along(points: &[DVec2], share: f64) -> Option<DVec2> {
    let length = |pair: &[DVec2]| (pair[1] - pair[0]).length();
    let mut left = share * points.windows(2).map(length).sum::<f64>();
    for pair in points.windows(2) {
        let piece = length(pair);
        if piece > 0.0 && left <= piece {
            return Some(pair[0].lerp(pair[1], left / piece));
        }
        left -= piece;
    }
    None
}

/// The box of what the frame shows of some outlines; `None` if it shows nothing.
fn seen<'a>(shapes: impl IntoIterator<Item = &'a Shape>, area: &Rect) -> Option<Rect> {
    let all = shapes.into_iter().map(|shape| shape.bounds).reduce(union)?;
    all.overlaps(area).then(|| Rect { min: all.min.max(area.min), max: all.max.min(area.max) })
}

fn union(a: Rect, b: Rect) -> Rect {
    Rect { min: a.min.min(b.min), max: a.max.max(b.max) }
}

fn rim(rect: &Rect) -> [DVec2; 8] {
    let (a, b, c) = (rect.min, rect.max, rect.center());
    [
        a,
        b,
        (a.x, b.y).into(),
        (b.x, a.y).into(),
        (c.x, a.y).into(),
        (c.x, b.y).into(),
        (a.x, c.y).into(),
        (b.x, c.y).into(),
    ]
}

/// Whether a closed polygon contains a point, by the even-odd rule.
fn contains(Shape { points: polygon, .. }: &Shape, p: DVec2) -> bool {
    let mut inside = false;
    for (i, b) in polygon.iter().enumerate() {
        let a = polygon[if i == 0 { polygon.len() - 1 } else { i - 1 }];
        if (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y)) {
            inside = !inside;
        }
    }
    inside
}

/// Bodies whose words are placed.
struct Homes {
    /// What is seen of every body.
    boxes: Vec<Option<Rect>>,
    /// The body that a place is sought for.
    own: usize,
}

impl Homes {
    /// The same places, dearer the farther they are from the body's own line, and dearer still where another body is
    /// nearer, whose the words would seem to be.
    fn near(&self, places: Vec<(f64, DVec2)>, own: &[Shape], text: &Text) -> Vec<(f64, DVec2)> {
        let about = centered(text, DVec2::ZERO).bounds();
        let priced = places.into_iter().map(|(cost, p)| {
            let rect = about.moved(p);
            let apart = |k: usize| self.boxes[k].map(|other| gap(&rect, &other));
            let others = (0..self.boxes.len()).filter(|k| *k != self.own).filter_map(apart);
            let (nearest, own_box) = (others.fold(f64::INFINITY, f64::min), apart(self.own).unwrap_or(0.0));
            let crowd = if nearest <= own_box {
                6.0
            } else if nearest < 2.0 * own_box {
                2.0
            } else {
                0.0
            };
            (cost + crowd + (to_line(&rect, own) - 2.0 * GAP).max(0.0) / 10.0, p)
        });
        priced.collect()
    }
}

/// Distance of a place from a body's line.
fn to_line(rect: &Rect, shapes: &[Shape]) -> f64 {
    let chords = shapes.iter().flat_map(|shape| shape.points.windows(2));
    let distances = chords.flat_map(|pair| rim(rect).map(|p| to_chord(p, pair[0], pair[1])));
    distances.fold(f64::INFINITY, f64::min)
}

fn to_chord(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let along = (p - a).dot(b - a) / (b - a).length_squared();
    let foot = if along.is_finite() { a.lerp(b, along.clamp(0.0, 1.0)) } else { a };
    (p - foot).length()
}

/// Distance of two rectangles, 0 where they overlap.
fn gap(a: &Rect, b: &Rect) -> f64 {
    (a.min - b.max).max(b.min - a.max).max(DVec2::ZERO).length()
}
