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

/// Circles of degrees about marked hits, counted from both ends of the normal; of hits that stand close the one with the
/// most light has one.
pub(super) fn protractors(figure: &Figure<'_>, hits: &[MarkedHit<'_>], room: &mut Room) -> Vec<Aged> {
    let side = figure.frame.area.size().min_element();
    let radius = (SHARE * side).clamp(RADII[0], RADII[1]);
    let mut chosen: Vec<&MarkedHit<'_>> = Vec::new();
    for hit in hits {
        if chosen.iter().all(|other| (other.at - hit.at).length() >= 2.0 * radius + APART) {
            chosen.push(hit);
        }
    }
    let aged = |hit: &MarkedHit<'_>| {
        let items = protractor(figure, hit, radius, room).into_iter();
        items.map(|item| (hit.branch.generation(), item)).collect::<Vec<_>>()
    };
    chosen.into_iter().flat_map(aged).collect()
}

fn protractor(figure: &Figure<'_>, hit: &MarkedHit<'_>, radius: f64, room: &mut Room) -> Vec<Item> {
    let color = figure.palette.quiet;
    let stroke = Stroke::solid(color, 0.8).capped(Cap::Butt).faded(0.8);
    let mut path = Path::circle(hit.at, radius);
    let mut numbers: Vec<Item> = Vec::new();
    for step in 0..72_u32 {
        let out = Turn::degrees(f64::from(5 * step)).apply(hit.normal);
        let rank = usize::from(step % 2 == 0) + usize::from(step % 6 == 0);
        path.append(Path::line(hit.at + (radius - TICKS[rank]) * out, hit.at + radius * out));
        room.keep_off([out, Turn::degrees(5.0).apply(out)].map(|out| hit.at + (radius - 0.5 * TICKS[1]) * out));
        if step % 6 == 0 {
            let text = Text::new(&format!("{}°", from_normal(5 * step)), DVec2::ZERO, SIZE, color);
            let text = text.anchored(Anchor::Middle).classed("protractor-value");
            let places =
                OUTSIDE.map(|outside| ((outside - OUTSIDE[0]).abs() / 10.0, hit.at + (radius + outside) * out));
            if let Some((_, middle)) = room.best(&text, &places, 0.0) {
                let text = centered(&text, middle);
                room.take(text.bounds());
                numbers.push(text.into());
            }
        }
    }
    numbers.insert(0, Shape::stroked(path, stroke, "").into());
    numbers
}

/// The angle to the nearer end of the normal, of one around the circle, degrees.
fn from_normal(around: u32) -> u32 {
    let half = around % 180;
    half.min(180 - half)
}
