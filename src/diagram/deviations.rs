//! The deviation δ between two branches, as the angle between their lines where these meet.

use glam::DVec2;

use crate::analysis::deviation_degrees;
use crate::diagram::arc::{Around, arc, is_right, square, stroked};
use crate::diagram::branches::{Branch, generation};
use crate::diagram::generations::Aged;
use crate::diagram::room::Room;
use crate::diagram::{Figure, key};
use crate::drawing::{Anchor, Group, Item, Path, Shape, Text};
use crate::explain::find;
use crate::numerics::{Turn, cross};
use crate::scene::{Problem, Scene};
use crate::trace::{RayTree, Segment, SegmentId, TracedRay};

const SIZE: f64 = 12.5;
/// Radius of the arc, pixels, grown up to the second where the angle is so small that the arc would be shorter than the
/// third.
const RADII: [f64; 2] = [46.0, 150.0];
const SHORTEST_ARC: f64 = 16.0;
/// Side of the mark of a right angle, pixels.
const SQUARE: f64 = 18.0;
/// How far the first branch's line goes on past the arc, pixels.
const BEYOND: f64 = 26.0;
/// No arc is drawn between directions closer than this, degrees.
const SMALLEST: f64 = 0.05;
/// Chords that words keep off in place of the arc.
const PIECES: u32 = 8;
/// Lines that meet farther away than this many sizes of the frame count as parallel.
const FAR: f64 = 4.0;

/// The deviations that a scene asks for, of branches that there are. All words keep off their lines.
pub(super) fn found<'a>(figure: &'a Figure<'_>, room: &mut Room) -> Vec<Deviation<'a>> {
    let pairs = figure.scene.diagram.deviations.iter();
    let found = pairs.filter_map(|[first, second]| {
        let [first, second] = [find(figure.tree, first).ok()?, find(figure.tree, second).ok()?];
        Deviation::of(figure, first, second)
    });
    let found: Vec<Deviation<'_>> = found.collect();
    for deviation in found.iter().filter(|deviation| deviation.is_seen) {
        deviation.lines(figure).iter().for_each(|item| room.keep_off_item(item));
        deviation.pieces().into_iter().for_each(|piece| room.keep_off(piece));
    }
    found
}

/// The marks, and what stands below the figure for those without room for their value.
pub(super) fn deviations(figure: &Figure<'_>, found: &[Deviation<'_>], room: &mut Room) -> (Vec<Aged>, Vec<Text>) {
    let (mut items, mut below) = (Vec::new(), Vec::new());
    for (place, deviation) in found.iter().enumerate() {
        let number = if found.len() > 1 { (place + 1).to_string() } else { String::new() };
        let placed = deviation.placed(figure, &number, room);
        if placed.is_none() {
            below.push(deviation.value(figure, &number, key::SIZE));
        }
        if deviation.is_seen {
            items.push((deviation.generation, deviation.draw(figure, placed)));
        }
    }
    (items, below)
}

/// Warnings about marks that a scene asks for and its light does not allow: a deviation of a branch that there is not.
#[must_use]
pub fn problems(scene: &Scene, tree: &RayTree) -> Vec<Problem> {
    let addresses = |(k, pair)| (0..2).zip(pair).map(move |(which, address)| (k, which, address));
    let all = scene.diagram.deviations.iter().enumerate().flat_map(addresses);
    let wrong = all.filter_map(|(k, which, address): (usize, usize, &String)| {
        let unknown = find(tree, address).err()?;
        let message = format!("this deviation is not marked: there is no ray \"{address}\": {}", unknown.reason);
        let close: Vec<_> = unknown.close.iter().map(|address| format!("\"{address}\"")).collect();
        let help = if close.is_empty() {
            "the scene has no light".into()
        } else {
            format!("these are close: {}", close.join(", "))
        };
        Some(Problem::warning(format!("diagram.deviations[{k}][{which}]"), message, help).label("no such ray"))
    });
    wrong.collect()
}

/// Two branches and where their lines meet. Directions are unit vectors of the figure.
pub(super) struct Deviation<'a> {
    name: String,
    /// The second one's, or the first one's if that is later.
    generation: u32,
    first: (&'a TracedRay, &'a Segment),
    /// Where the first branch ends, and where the second begins, pixels.
    ends: [DVec2; 2],
    /// Where their lines meet, or else where the second begins.
    at: DVec2,
    directions: [DVec2; 2],
    degrees: f64,
    /// Whether the frame shows where they meet.
    is_seen: bool,
}

impl<'a> Deviation<'a> {
    /// `None` if a branch is not in its ray.
    fn of(figure: &Figure<'_>, first: (&'a TracedRay, SegmentId), second: (&'a TracedRay, SegmentId)) -> Option<Self> {
        let generation = generation(first.0, first.1).max(generation(second.0, second.1));
        let name = format!("{} {}", first.0.address(first.1), second.0.address(second.1));
        let [a, b] = [first, second].map(|(ray, id)| ray.segments.get(id.index()));
        let (a, b) = (a?, b?);
        let directions = [a, b].map(|segment| figure.frame.turn(segment.direction).normalize_or_zero());
        let ends = [a.to.unwrap_or(a.from), b.from].map(|p| figure.frame.place(p));
        let degrees = deviation_degrees(a.direction, b.direction).abs();
        let at = meeting(figure, ends, directions).unwrap_or(ends[1]);
        let is_seen = figure.frame.area.contains(at);
        Some(Self { name, generation, first: (first.0, a), ends, at, directions, degrees, is_seen })
    }

    fn is_right(&self) -> bool {
        is_right(self.directions[0], self.directions[1])
    }

    /// Of the arc, or of what the mark of a right angle takes.
    fn radius(&self) -> f64 {
        if self.is_right() {
            return SQUARE;
        }
        (SHORTEST_ARC / self.degrees.max(SMALLEST).to_radians()).clamp(RADII[0], RADII[1])
    }

    /// Its arc as short chords.
    fn pieces(&self) -> Vec<[DVec2; 2]> {
        let [first, second] = self.directions;
        let sense = cross(first, second).signum();
        let turned = |share: f64| Turn::degrees(sense * share * self.degrees).apply(first);
        let point = |step: u32| self.at + self.radius() * turned(f64::from(step) / f64::from(PIECES));
        (0..PIECES).map(|step| [point(step), point(step + 1)]).collect()
    }

    fn value(&self, figure: &Figure<'_>, number: &str, size: f64) -> Text {
        let text = Text::new("δ", DVec2::ZERO, size, figure.palette.accent).classed("angle-value");
        let text = if number.is_empty() { text } else { text.subscript(number) };
        text.then(&format!("\u{a0}=\u{a0}{:.1}°", self.degrees))
    }

    fn placed(&self, figure: &Figure<'_>, number: &str, room: &mut Room) -> Option<Text> {
        let [first, second] = self.directions;
        let toward = (first + second).normalize_or(first.perp());
        let text = self.value(figure, number, SIZE).anchored(Anchor::Middle);
        let around = Around { at: self.at, radius: self.radius(), toward, shares: false };
        if self.is_seen { around.put(&text, room) } else { None }
    }

    fn draw(&self, figure: &Figure<'_>, value: Option<Text>) -> Item {
        let (radius, [first, second]) = (self.radius(), self.directions);
        let mut items = self.lines(figure);
        if self.degrees >= SMALLEST {
            let mark = if self.is_right() { square } else { arc };
            items.push(stroked(mark(self.at, radius, first, second), figure.palette.accent));
        }
        items.extend(value.map(Item::from));
        let data = vec![("data-address", self.name.clone())];
        Group { data, ..Group::layer("deviation angle", items) }.into()
    }

    /// The first branch's line on past the meeting point, and the second's back to it.
    fn lines(&self, figure: &Figure<'_>) -> Vec<Item> {
        let (ray, segment) = self.first;
        let stroke = figure.styles.extension(&Branch::plain(ray, segment, self.ends));
        let is_ahead = (self.at - self.ends[0]).dot(self.directions[0]) >= 0.0;
        let from = if is_ahead && self.at != self.ends[1] { self.ends[0] } else { self.at };
        let on = [from, self.at + (self.radius() + BEYOND) * self.directions[0]];
        let back = [self.at, self.ends[1]];
        let line = |[a, b]: [DVec2; 2]| Shape::stroked(Path::line(a, b), stroke.clone(), "extension").into();
        [on, back].into_iter().filter(|[a, b]| a != b).map(line).collect()
    }
}

/// Where the first line, on from its end, meets the second, back from its start; both in view.
fn meeting(figure: &Figure<'_>, [a, b]: [DVec2; 2], [d, e]: [DVec2; 2]) -> Option<DVec2> {
    let turn = cross(d, e);
    let [s, t] = [cross(b - a, e) / turn, cross(b - a, d) / turn];
    let far = FAR * figure.frame.area.size().max_element();
    let meets = s.abs() <= far && (-far..=1e-9).contains(&t);
    let at = a + s * d;
    (meets && s >= -1e-9 && figure.frame.area.contains(at)).then_some(at)
}
