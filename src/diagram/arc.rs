//! Arcs about a point, and the values beside them.

use glam::DVec2;

use crate::diagram::room::{CROSSING, Room, centered};
use crate::drawing::{Cap, Color, Item, Path, Shape, Stroke, Text};
use crate::numerics::Turn;

/// Cosines below this belong to right angles.
const RIGHT: f64 = 0.001;
/// Free space between a value and lines, pixels.
pub(super) const OFF_LINES: f64 = 4.0;
/// How far from the arc's middle a value is sought, degrees.
const ASIDE: [f64; 16] =
    [0.0, 15.0, -15.0, 30.0, -30.0, 45.0, -45.0, 60.0, -60.0, 80.0, -80.0, 110.0, -110.0, 150.0, -150.0, 180.0];
/// How far outside of the arc, pixels.
const OUTSIDE: [f64; 5] = [4.0, 9.0, 15.0, 22.0, 30.0];

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

/// A value outside of an arc, as near to where its middle points as there is room off all lines; `None` where there is
/// none.
pub(super) fn beside(text: &Text, at: DVec2, radius: f64, toward: DVec2, room: &mut Room) -> Option<Text> {
    let mut places = Vec::new();
    let size = text.bounds().size();
    for (rank, aside) in (0..).map(f64::from).zip(ASIDE) {
        for (step, outside) in (0..).map(f64::from).zip(OUTSIDE) {
            let direction = Turn::degrees(aside).apply(toward);
            let half = (0.5 * size * direction).abs().element_sum();
            places.push((0.4 * rank + 0.6 * step, at + (radius + outside + half) * direction));
        }
    }
    let (_, middle) = room.best(text, &places, OFF_LINES).filter(|(cost, _)| *cost < CROSSING)?;
    let text = centered(text, middle);
    room.take(text.bounds());
    Some(text)
}
