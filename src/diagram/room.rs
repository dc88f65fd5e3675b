//! Where words may stand.

use std::cell::Cell;
use std::ops::Range;

use glam::DVec2;

use crate::diagram::frame::clip;
use crate::diagram::{Figure, notes};
use crate::drawing::{Item, PathStep, Rect, Text, pixel};
use crate::numerics::cross;

/// Lines beyond this many are not kept free.
const MOST_LINES: usize = 3000;
/// Comparisons of places with what is near, for all words of a figure: some seconds.
const MOST_COMPARISONS: usize = 1_000_000_000;
/// Cost of words on words or off the frame: such a place is never taken.
const FORBIDDEN: f64 = 1e6;
/// Cost of a line through words.
pub(super) const CROSSING: f64 = 10.0;
/// Free space between words, pixels.
const APART: f64 = 3.0;

/// What is free and what is not.
pub(super) struct Room {
    pub(super) area: Rect,
    /// All lines that words keep off, and which of them are rays.
    lines: Vec<[DVec2; 2]>,
    rays: Range<usize>,
    taken: Vec<Rect>,
    /// How many comparisons the search for places took.
    effort: Cell<usize>,
    /// Points that have values about them.
    pub(super) anchors: Vec<DVec2>,
}

impl Room {
    /// Words keep off each other and the author's notes, and off lines where they can: outlines, rays and marks, which are
    /// [added](Self::keep_off_item).
    pub(super) fn new(figure: &Figure<'_>, outlines: impl Iterator<Item = [DVec2; 2]>) -> Self {
        let mut lines: Vec<[DVec2; 2]> = outlines.collect();
        let outlines = lines.len();
        lines.extend(figure.branches.iter().rev().take(MOST_LINES).map(|branch| branch.ends));
        let rays = outlines..lines.len();
        let notes = notes::notes(figure).into_iter();
        let bounds = |item| if let Item::Text(text) = item { Some(text.bounds().grown(APART)) } else { None };
        Self {
            area: figure.frame.area,
            lines,
            rays,
            taken: notes.filter_map(bounds).collect(),
            effort: Cell::new(0),
            anchors: Vec::new(),
        }
    }

    /// Takes note of comparisons.
    pub(super) fn spend(&self, comparisons: usize) {
        self.effort.set(self.effort.get().saturating_add(comparisons));
    }

    /// Whether the search for places has taken so many comparisons that more words would keep the figure waiting.
    pub(super) fn is_spent(&self) -> bool {
        self.effort.get() > MOST_COMPARISONS
    }

    /// No more words here.
    pub(super) fn take(&mut self, bounds: Rect) {
        self.taken.push(bounds.grown(APART));
    }

    /// The same where a word stands, if the item is one.
    pub(super) fn take_words(&mut self, item: &Item) {
        if let Item::Text(text) = item {
            self.take(text.bounds());
        }
    }

    /// How many words have their places.
    pub(super) fn words(&self) -> usize {
        self.taken.len()
    }

    /// Gives the places of all words back but for the first ones.
    pub(super) fn forget(&mut self, but_for: usize) {
        self.taken.truncate(but_for);
    }

    /// A line more to keep off.
    pub(super) fn keep_off(&mut self, line: [DVec2; 2]) {
        self.lines.push(line);
    }

    /// A mark more to keep off, if it is a straight line.
    pub(super) fn keep_off_item(&mut self, item: &Item) {
        self.lines.extend(straight(item));
    }

    /// Whether a place is nearer to another point with values than to `own`.
    pub(super) fn is_nearer_to_another(&self, place: &Rect, own: DVec2) -> bool {
        let apart = |p: DVec2| p.clamp(place.min, place.max).distance(p);
        self.anchors.iter().any(|other| apart(*other) < apart(own) - 1.0)
    }

    /// The rays that come within a distance of a point.
    pub(super) fn rays_near(&self, p: DVec2, distance: f64) -> Vec<[DVec2; 2]> {
        let around = Rect { min: p, max: p }.grown(distance);
        self.lines[self.rays.clone()].iter().filter(|ray| crosses(ray, &around)).copied().collect()
    }

    /// The cheapest of some middles with their costs for a text, `off` pixels from lines; `None` if every one is forbidden.
    pub(super) fn best(&self, text: &Text, places: &[(f64, DVec2)], off: f64) -> Option<(f64, DVec2)> {
        self.best_for(centered(text, DVec2::ZERO).bounds(), places, off)
    }

    /// The same for words whose rectangle about their middle is known.
    pub(super) fn best_for(&self, about: Rect, places: &[(f64, DVec2)], off: f64) -> Option<(f64, DVec2)> {
        let rects: Vec<Rect> = places.iter().map(|(_, p)| about.moved(*p)).collect();
        let all = rects.iter().copied().reduce(|a, b| Rect { min: a.min.min(b.min), max: a.max.max(b.max) })?;
        let near: Vec<_> = self.lines.iter().filter(|line| crosses(line, &all.grown(off))).collect();
        self.spend(self.lines.len() + places.len() * (near.len() + self.taken.len()));
        let costs = places.iter().zip(&rects).map(|((cost, p), rect)| (cost + self.cost(rect, &near, off), *p));
        costs.filter(|(cost, _)| *cost < FORBIDDEN).min_by(|a, b| a.0.total_cmp(&b.0))
    }

    fn cost(&self, rect: &Rect, lines: &[&[DVec2; 2]], off_lines: f64) -> f64 {
        let off = !(self.area.contains(rect.min) && self.area.contains(rect.max));
        if off || self.taken.iter().any(|other| other.overlaps(rect)) {
            return FORBIDDEN;
        }
        lines.iter().filter(|line| crosses(line, &rect.grown(off_lines))).map(|_| CROSSING).sum()
    }
}

/// A mark that is one straight line.
fn straight(item: &Item) -> Option<[DVec2; 2]> {
    match item {
        Item::Shape(shape) => match shape.path.steps() {
            [PathStep::MoveTo(a), PathStep::LineTo(b)] => Some([*a, *b]),
            _ => None,
        },
        _ => None,
    }
}

/// The text with the middle of its letters at a point.
pub(super) fn centered(text: &Text, middle: DVec2) -> Text {
    let at = middle + DVec2::new(0.0, 0.36 * text.size);
    Text { at: DVec2::new(pixel(at.x), pixel(at.y)), ..text.clone() }
}

/// Whether two lines cross each other within both.
pub(super) fn cross_each_other([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> bool {
    let sides = |from: DVec2, to: DVec2, p: DVec2, q: DVec2| cross(to - from, p - from) * cross(to - from, q - from);
    sides(c, d, a, b) < 0.0 && sides(a, b, c, d) < 0.0
}

fn crosses([a, b]: &[DVec2; 2], rect: &Rect) -> bool {
    clip(*a, *b - *a, 1.0, rect).is_some()
}
