use glam::DVec2;

use crate::diagram::Figure;
use crate::diagram::generations::Aged;
use crate::diagram::hits::MarkedHit;
use crate::diagram::room::{Room, centered};
use crate::drawing::{Anchor, Cap, Item, Path, Shape, Stroke, Text};
use crate::numerics::Turn;

const SIZE: f64 = 9.5;
/// Radius as a share of the frame's smaller side, and its bounds, pixels.
const SHARE: f64 = 0.24;
const RADII: [f64; 2] = [48.0, 110.0];
/// Free space between two protractors, pixels.
const APART: f64 = 30.0;
/// Lengths of the ticks at every 5, 10 and 30 degrees, pixels.
const TICKS: [f64; 3] = [3.0, 6.0, 10.0];
/// Middles of a number outside of the circle, the next where a line runs through the one before, pixels.
const OUTSIDE: [f64; 3] = [11.0, 21.0, -21.0];

/// A circle of degrees about a hit, counted from both ends of the normal.
pub(super) struct Protractor {
    at: DVec2,
    normal: DVec2,
    radius: f64,
    generation: u32,
}

/// Those of marked hits; of hits that stand close the one with the most light has one.
pub(super) fn chosen(figure: &Figure<'_>, hits: &[MarkedHit<'_>]) -> Vec<Protractor> {
    let side = figure.frame.area.size().min_element();
    let radius = (SHARE * side).clamp(RADII[0], RADII[1]);
    let mut chosen: Vec<Protractor> = Vec::new();
    for hit in hits {
        if chosen.iter().all(|other| (other.at - hit.at).length() >= 2.0 * radius + APART) {
            let generation = hit.branch.generation();
            chosen.push(Protractor { at: hit.at, normal: hit.normal, radius, generation });
        }
    }
    chosen
}

impl Protractor {
    /// Words keep off its circle.
    pub(super) fn keep_off(&self, room: &mut Room) {
        let rim = |step: u32| self.at + (self.radius - 0.5 * TICKS[1]) * self.out(step);
        (0..72).for_each(|step| room.keep_off([rim(step), rim(step + 1)]));
    }

    /// Away from the hit, so many times 5 degrees from the normal.
    fn out(&self, step: u32) -> DVec2 {
        Turn::degrees(f64::from(5 * step)).apply(self.normal)
    }

    pub(super) fn items(&self, figure: &Figure<'_>, room: &mut Room) -> Vec<Aged> {
        let color = figure.palette.quiet;
        let stroke = Stroke::solid(color, 0.8).capped(Cap::Butt).faded(0.8);
        let mut path = Path::circle(self.at, self.radius);
        for step in 0..72 {
            let rank = usize::from(step % 2 == 0) + usize::from(step % 6 == 0);
            let out = self.out(step);
            path.append(Path::line(self.at + (self.radius - TICKS[rank]) * out, self.at + self.radius * out));
        }
        let circle: Item = Shape::stroked(path, stroke, "").into();
        let numbers = (0..72).step_by(6).filter_map(|step| self.number(figure, step, room));
        [circle].into_iter().chain(numbers).map(|item| (self.generation, item)).collect()
    }

    fn number(&self, figure: &Figure<'_>, step: u32, room: &mut Room) -> Option<Item> {
        let text = Text::new(&format!("{}°", from_normal(5 * step)), DVec2::ZERO, SIZE, figure.palette.quiet);
        let text = text.anchored(Anchor::Middle).classed("protractor-value");
        let out = self.out(step);
        let places =
            OUTSIDE.map(|outside| ((outside - OUTSIDE[0]).abs() / 10.0, self.at + (self.radius + outside) * out));
        let (_, middle) = room.best(&text, &places, 0.0)?;
        let text = centered(&text, middle);
        room.take(text.bounds());
        Some(text.into())
    }
}

/// The angle to the nearer end of the normal, of one around the circle, degrees.
fn from_normal(around: u32) -> u32 {
    let half = around % 180;
    half.min(180 - half)
}
