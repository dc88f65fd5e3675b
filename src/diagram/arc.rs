//! Arcs about a point, and the values beside them.

use glam::DVec2;

use crate::diagram::room::{CROSSING, Room, centered, cross_each_other};
use crate::drawing::{Cap, Color, Item, Path, Rect, Shape, Stroke, Text};
use crate::numerics::Turn;

/// Cosines below this belong to right angles.
const RIGHT: f64 = 0.001;
/// Free space between a value and lines, pixels.
pub(super) const OFF_LINES: f64 = 4.0;
/// How far from the arc's middle a value is sought, degrees.
const ASIDE: [f64; 16] =
    [0.0, 15.0, -15.0, 30.0, -30.0, 45.0, -45.0, 60.0, -60.0, 80.0, -80.0, 110.0, -110.0, 150.0, -150.0, 180.0];
/// Cost of a ray between an arc and its value, which would seem to be another's.
const BEYOND: f64 = 4.0;
/// Cost of a value that is nearer to another point with values.
const STRANGE: f64 = 2.0;
/// How far outside of the arc, pixels.
const OUTSIDE: [f64; 6] = [4.0, 9.0, 15.0, 22.0, 30.0, 40.0];

/// The smaller arc about a point between two unit directions of the figure.
pub(super) fn arc(at: DVec2, radius: f64, from: DVec2, to: DVec2) -> Path {
    let mut path = Path::new();
    path.move_to(at + radius * from);
    path.arc_to(radius, false, from.perp_dot(to) > 0.0, at + radius * to);
    path
}

/// Whether two unit directions stand at right angles.
pub(super) fn is_right(one: DVec2, other: DVec2) -> bool {
    one.dot(other).abs() < RIGHT
}

/// The mark of a right angle between two unit directions.
pub(super) fn square(at: DVec2, side: f64, one: DVec2, other: DVec2) -> Path {
    let mut path = Path::new();
    path.move_to(at + side * one);
    path.line_to(at + side * (one + other));
    path.line_to(at + side * other);
    path
}

/// A thin line of a mark.
pub(super) fn stroked(path: Path, color: Color) -> Item {
    Shape::stroked(path, Stroke::solid(color, 1.0).capped(Cap::Butt), "").into()
}

/// A point that values stand about.
#[derive(Clone, Copy)]
pub(super) struct Around {
    pub(super) at: DVec2,
    /// Of the arc, pixels.
    pub(super) radius: f64,
    /// Unit direction to the arc's middle.
    pub(super) toward: DVec2,
    /// Whether values of its own stand on the other side.
    pub(super) shares: bool,
}

impl Around {
    /// A value outside of the arc, as near to its middle as there is room off all lines; `None` where there is none.
    pub(super) fn put(&self, text: &Text, room: &mut Room) -> Option<Text> {
        let middle = self.middle(centered(text, DVec2::ZERO).bounds(), room)?;
        Some(centered(text, middle))
    }

    /// The same for words whose rectangle about their middle is known: where that is.
    pub(super) fn middle(&self, about: Rect, room: &mut Room) -> Option<DVec2> {
        let mut places = Vec::new();
        let farthest = self.radius + OUTSIDE.into_iter().fold(0.0, f64::max) + about.size().length();
        let rays = room.rays_near(self.at, farthest);
        // Where the other side has values of its own, none of this side stands there.
        let reach = if self.shares { 90.0 } else { 180.0 };
        for (rank, aside) in (0..).map(f64::from).zip(ASIDE).filter(|(_, aside)| aside.abs() <= reach) {
            for (step, outside) in (0..).map(f64::from).zip(OUTSIDE) {
                let direction = Turn::degrees(aside).apply(self.toward);
                let half = (0.5 * about.size() * direction).abs().element_sum();
                let middle = self.at + (self.radius + outside + half) * direction;
                let way = [self.at + (self.radius + 2.0) * direction, middle];
                let beyond: f64 = rays.iter().filter(|ray| cross_each_other(**ray, way)).map(|_| BEYOND).sum();
                let strange = if room.is_nearer_to_another(&about.moved(middle), self.at) { STRANGE } else { 0.0 };
                places.push((0.4 * rank + 0.6 * step + beyond + strange, middle));
            }
        }
        let (_, middle) = room.best_for(about, &places, OFF_LINES).filter(|(cost, _)| *cost < CROSSING)?;
        room.take(about.moved(middle));
        Some(middle)
    }
}
