//! Angle arcs at the hits, with their values.

use glam::DVec2;

use crate::diagram::arc::{Around, OFF_LINES, arc, is_right, square, stroked};
use crate::diagram::badge::Badge;
use crate::diagram::generations::Aged;
use crate::diagram::hits::{Case, MarkedHit};
use crate::diagram::room::{CROSSING, Room, centered};
use crate::diagram::{Figure, key};
use crate::drawing::{Anchor, Color, Font, Group, Item, Path, Shape, Stroke, Text};
use crate::numerics::Turn;

const SIZE: f64 = 11.5;
/// Radius of an arc, pixels, where there is room for it.
const RADIUS: f64 = 28.0;
const SMALLEST_RADIUS: f64 = 12.0;
/// Side of a right-angle mark, pixels.
const SQUARE: f64 = 9.0;
/// Length of the grazing ray that carries nothing, pixels.
const GRAZING: f64 = 110.0;
/// A critical angle is shown if the angle of incidence is at least this share of it.
const NEAR_CRITICAL: f64 = 0.6;
/// Where the whole figure has no more marked hits than this, shares are written too.
const FEW: usize = 3;
/// How far from the hit along a branch the middle of its share is sought, pixels.
const SHARE_PLACES: [f64; 9] = [74.0, 88.0, 104.0, 122.0, 142.0, 60.0, 164.0, 188.0, 214.0];
/// Free space between a branch and its share, pixels.
const SHARE_APART: f64 = 6.0;
/// Total internal reflection in short.
const TOTAL: &str = "TIR";
/// Radius of the ring around a number, pixels.
const RING: f64 = 7.0;

/// The marks, a group a hit for the light that arrives and one for the light that leaves, and what stands below the figure
/// for the hits that are only numbered.
pub(super) fn angles(figure: &Figure<'_>, hits: &[MarkedHit<'_>], room: &mut Room) -> (Vec<Aged>, Vec<Text>) {
    let mut groups: Vec<Marks> = hits.iter().map(|_| Marks::default()).collect();
    let mut unlabelled = Vec::new();
    // Badges are the widest.
    let (total, others): (Vec<usize>, Vec<usize>) =
        (0..hits.len()).partition(|place| matches!(hits[*place].case, Case::Total(_)));
    for place in total.into_iter().chain(others) {
        let hit = &hits[place];
        let is_crowded = hits[..place].iter().any(|other| (other.at - hit.at).length() < 2.0 * RADIUS);
        let drawer = Drawer::new(figure, hit);
        let mut marks = if is_crowded { Marks::default() } else { drawer.lines(room) };
        let values = if is_crowded { None } else { drawer.values(room) };
        match values {
            Some((first, second)) => {
                marks.arriving.extend(first);
                marks.leaving.extend(second.map(Item::from));
            }
            None => unlabelled.push(place),
        }
        groups[place] = marks;
    }
    unlabelled.sort_unstable();
    let mut below = Vec::new();
    for (number, place) in (1..).zip(unlabelled.iter().copied()) {
        let drawer = Drawer::new(figure, &hits[place]);
        groups[place].arriving.extend(drawer.number(number, room));
        below.push(drawer.line_below(number));
    }
    if hits.len() <= FEW {
        for place in (0..hits.len()).filter(|place| !unlabelled.contains(place)) {
            let shares = Drawer::new(figure, &hits[place]).shares(room);
            groups[place].leaving.extend(shares.into_iter().map(Item::from));
        }
    }
    (hits.iter().zip(groups).flat_map(|(hit, marks)| marks.grouped(hit)).collect(), below)
}

/// Marks of one hit.
#[derive(Default)]
struct Marks {
    /// Of the light that arrives there.
    arriving: Vec<Item>,
    /// Of the light that leaves it, which is shown when that is.
    leaving: Vec<Item>,
}

impl Marks {
    fn grouped(self, hit: &MarkedHit<'_>) -> impl Iterator<Item = Aged> {
        let generation = hit.branch.generation();
        let address = hit.branch.address();
        let groups = [(generation, self.arriving), (generation.saturating_add(1), self.leaving)].into_iter();
        groups.filter(|(_, items)| !items.is_empty()).map(move |(generation, items)| {
            let data = vec![("data-address", address.clone())];
            (generation, Group { data, ..Group::layer("angle", items) }.into())
        })
    }
}

/// Draws the marks of one hit.
struct Drawer<'a> {
    figure: &'a Figure<'a>,
    hit: &'a MarkedHit<'a>,
    radius: f64,
}

impl<'a> Drawer<'a> {
    fn new(figure: &'a Figure<'_>, hit: &'a MarkedHit<'_>) -> Self {
        Self { figure, hit, radius: (0.45 * hit.branch.length()).clamp(SMALLEST_RADIUS, RADIUS) }
    }

    fn color(&self) -> Color {
        match self.hit.case {
            Case::Plain(_) | Case::Mirror => self.figure.palette.ink,
            Case::Total(_) | Case::Critical | Case::Brewster => self.figure.palette.accent,
        }
    }

    /// Arcs and the lines that explain them.
    fn lines(&self, room: &mut Room) -> Marks {
        let MarkedHit { normal, back, reflected, transmitted, along, theta_1, case, .. } = *self.hit;
        let palette = &self.figure.palette;
        let mut arriving = vec![self.arc(normal, back, self.color(), room)];
        let mut leaving: Vec<Item> = Vec::new();
        leaving.extend(reflected.map(|reflected| self.arc(normal, reflected, self.color(), room)));
        leaving.extend(transmitted.map(|transmitted| self.arc(-normal, transmitted, palette.ink, room)));
        let dotted = |path, width: f64| {
            let dots = [1.5 * width, 3.0 * width];
            Shape::stroked(path, Stroke::solid(palette.accent, width).dashed(&dots), "").into()
        };
        match case {
            Case::Total(critical) | Case::Plain(Some(critical)) if theta_1 >= NEAR_CRITICAL * critical => {
                let limit = self.aside(critical);
                arriving.push(dotted(arc(self.hit.at, self.radius, back, limit), 1.0));
                let tick = [-4.0, 4.0].map(|by| self.hit.at + (self.radius + by) * limit);
                arriving.push(stroked(Path::line(tick[0], tick[1]), palette.accent));
            }
            Case::Critical => leaving.push(dotted(Path::line(self.hit.at, self.hit.at + GRAZING * along), 2.4)),
            Case::Plain(_) | Case::Total(_) | Case::Mirror | Case::Brewster => {}
        }
        leaving.extend(reflected.and_then(|reflected| self.right_angle(back, reflected)));
        leaving.extend(reflected.zip(transmitted).and_then(|(one, other)| self.right_angle(one, other)));
        Marks { arriving, leaving }
    }

    fn arc(&self, from: DVec2, to: DVec2, color: Color, room: &mut Room) -> Item {
        let at = self.hit.at;
        room.keep_off([at + self.radius * from, at + self.radius * to]);
        stroked(arc(at, self.radius, from, to), color)
    }

    /// Where light at an angle from the normal would come from, degrees.
    fn aside(&self, angle: f64) -> DVec2 {
        let MarkedHit { normal, back, .. } = *self.hit;
        Turn::degrees(angle.copysign(normal.perp_dot(back))).apply(normal)
    }

    /// The mark between two rays at right angles.
    fn right_angle(&self, one: DVec2, other: DVec2) -> Option<Item> {
        is_right(one, other).then(|| stroked(square(self.hit.at, SQUARE, one, other), self.color()))
    }

    /// The values of the light that arrives and of that which goes through, in their places; `None` where they do not fit.
    fn values(&self, room: &mut Room) -> Option<(Vec<Item>, Option<Text>)> {
        let MarkedHit { normal, back, transmitted, theta_2, .. } = *self.hit;
        let before = room.words();
        let first = self.put_first(normal + back, room)?;
        let Some((theta, transmitted)) = theta_2.zip(transmitted) else { return Some((first, None)) };
        let second = angle(self.text("", self.figure.palette.ink), "2", theta);
        let second = self.around(transmitted - normal).put(&second, room);
        if second.is_none() {
            room.forget(before);
        }
        Some((first, Some(second?)))
    }

    /// The value of the light that arrives, behind a badge if all of it is reflected.
    fn put_first(&self, toward: DVec2, room: &mut Room) -> Option<Vec<Item>> {
        let text = self.first(self.text("", self.color()));
        if !matches!(self.hit.case, Case::Total(_)) {
            return Some(vec![self.around(toward).put(&text, room)?.into()]);
        }
        let badge = Badge::new(TOTAL, text, self.color(), self.figure.palette.ground);
        Some(badge.items(self.around(toward).middle(badge.bounds(), room)?).into())
    }

    /// What share of the light that arrives is reflected and what goes through, beside the branches that leave where there is
    /// room.
    fn shares(&self, room: &mut Room) -> Vec<Text> {
        let MarkedHit { reflected, transmitted, shares, .. } = *self.hit;
        let all = shares.into_iter().zip([reflected, transmitted]).filter(|(share, _)| *share < 1.0);
        all.filter_map(|(share, along)| self.share(share, along?, room)).collect()
    }

    fn share(&self, share: f64, along: DVec2, room: &mut Room) -> Option<Text> {
        let text = self.text(&format!("{:.1}\u{202f}%", 100.0 * share), self.figure.palette.quiet);
        let half = 0.5 * text.bounds().size();
        let off = |across: DVec2| across * (SHARE_APART + (half * across).abs().element_sum());
        let place = |(step, distance): (f64, f64)| {
            [along.perp(), -along.perp()].map(|across| (step, self.hit.at + distance * along + off(across)))
        };
        let places: Vec<_> = (0..).map(f64::from).zip(SHARE_PLACES).flat_map(place).collect();
        let (_, middle) = room.best(&text, &places, OFF_LINES).filter(|(cost, _)| *cost < CROSSING)?;
        let text = centered(&text, middle);
        room.take(text.bounds());
        Some(text.classed("share"))
    }

    fn around(&self, toward: DVec2) -> Around {
        let MarkedHit { at, transmitted, .. } = *self.hit;
        Around { at, radius: self.radius, toward: toward.normalize_or_zero(), shares: transmitted.is_some() }
    }

    /// A number beside the hit.
    fn number(&self, number: u32, room: &mut Room) -> Vec<Item> {
        let color = self.color();
        let text = self.text(&number.to_string(), color).in_font(Font::Bold);
        let around = |distance: f64| {
            let at = move |step: u32| self.hit.at + distance * Turn::degrees(30.0 * f64::from(step)).direction();
            (0..12).map(move |step| (distance / 10.0, at(step)))
        };
        let places: Vec<_> = [14.0, 20.0, 28.0, 40.0, 56.0, 80.0].into_iter().flat_map(around).collect();
        let Some((_, middle)) = room.best(&text, &places, OFF_LINES) else { return Vec::new() };
        let text = centered(&text, middle);
        room.take(text.bounds().grown(2.0));
        let mut items = vec![stroked(Path::circle(middle, RING), color)];
        if (middle - self.hit.at).length() > 24.0 {
            let toward = (middle - self.hit.at).normalize_or_zero();
            items.push(stroked(Path::line(self.hit.at, middle - RING * toward), color));
        }
        items.push(text.into());
        items
    }

    /// Number and values for the lines below the figure.
    fn line_below(&self, number: u32) -> Text {
        let is_total = matches!(self.hit.case, Case::Total(_));
        let words = format!("{number}:\u{a0}{}", if is_total { format!("{TOTAL},\u{a0}") } else { String::new() });
        let text = Text::new(&words, DVec2::ZERO, key::SIZE, self.color()).classed("angle-value");
        let text = self.first(text);
        self.hit.theta_2.map_or(text.clone(), |theta| angle(text.then(",\u{a0}"), "2", theta))
    }

    fn text(&self, words: &str, color: Color) -> Text {
        Text::new(words, DVec2::ZERO, SIZE, color).anchored(Anchor::Middle).classed("angle-value")
    }

    /// Adds the angle of incidence and what it is beside.
    fn first(&self, text: Text) -> Text {
        let equal = |text: Text, subscript: &str| {
            let text = text.then("θ").subscript("1").then("\u{202f}=\u{202f}θ").subscript(subscript);
            value(text, self.hit.theta_1)
        };
        match self.hit.case {
            Case::Critical => equal(text, "c"),
            Case::Brewster => equal(text, "B"),
            Case::Total(critical) => angle(angle(text, "1", self.hit.theta_1).then("\u{202f}>\u{202f}"), "c", critical),
            Case::Plain(_) | Case::Mirror => angle(text, "1", self.hit.theta_1),
        }
    }
}

/// Adds an angle in degrees by its letter.
fn angle(text: Text, subscript: &str, degrees: f64) -> Text {
    value(text.then("θ").subscript(subscript), degrees)
}

fn value(text: Text, degrees: f64) -> Text {
    text.then(&format!("\u{202f}=\u{202f}{degrees:.1}°"))
}
