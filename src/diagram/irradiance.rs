//! Beside the scene, how the light on its screens is spread along them.
//!
//! Curves stand in a strip at the right, which the scene leaves free: of upright screens at the screen's own heights where they
//! find room there, of all others one below the other, along as much of the screen as is lit.

use glam::DVec2;

use crate::analysis::{self, Curve, Irradiance};
use crate::diagram::{Figure, header, nice};
use crate::drawing::{Anchor, Cap, Fill, Group, Item, Path, Rect, Shape, Stroke, Text, Whole};
use crate::scene::Scene;
use crate::system::OpticalSystem;
use crate::trace::RayTree;

/// Fewer branches on a screen make no curve.
const FEWEST: usize = 16;
/// And of one line fewer than these.
const FEWEST_OF_A_LINE: usize = 4;
/// A smaller figure has no room for curves, pixels.
const SMALLEST: [u32; 2] = [400, 240];
/// Width of the strip as a share of the figure's, and no less than this, pixels.
const STRIP: (f64, f64) = (0.2, 110.0);
/// Free space between the scene and the strip, pixels.
const APART: f64 = 12.0;
/// Width of the column of numbers at a curve's left, pixels.
const COLUMN: f64 = 42.0;
/// Height of a curve's title above it, and of the numbers below it, pixels.
pub(super) const TITLE: f64 = 14.0;
const NUMBERS: f64 = 16.0;
/// Least extent of a curve along its screen, pixels, and the most where it is not the screen's own.
const EXTENT: [f64; 2] = [70.0, 240.0];
/// A screen stands upright if it leans over by less than this share of its height.
const LEAN: f64 = 0.02;
const SIZE: f64 = 10.0;
const TICK: f64 = 3.0;
/// Letters of a name that are tried; no strip is so wide.
const LONGEST: usize = 1000;

/// The irradiance on the screens that get a curve.
pub(super) fn screens(scene: &Scene, system: &OpticalSystem, tree: &RayTree) -> Vec<Irradiance> {
    let has_room = scene.diagram.size.iter().zip(SMALLEST).all(|(size, least)| *size >= least);
    if !(scene.diagram.irradiance && has_room) {
        return Vec::new();
    }
    analysis::irradiance(system, tree).into_iter().filter(is_curve).collect()
}

fn is_curve(screen: &Irradiance) -> bool {
    screen.hits >= FEWEST && screen.curves.iter().any(|curve| curve.hits >= FEWEST_OF_A_LINE)
}

/// Width that the curves take from the scene, pixels.
pub(super) fn width(scene: &Scene, screens: &[Irradiance]) -> f64 {
    let (share, least) = STRIP;
    if screens.is_empty() { 0.0 } else { (share * f64::from(scene.diagram.size[0])).max(least) }
}

/// The curves.
pub(super) fn curves(figure: &Figure<'_>, screens: &[Irradiance]) -> Vec<Item> {
    let aligned: Option<Vec<Plot<'_>>> = screens.iter().map(|screen| aligned(figure, screen)).collect();
    let plots = aligned.filter(|plots| are_apart(plots)).unwrap_or_else(|| one_below_the_other(figure, screens));
    plots.iter().map(|plot| Group::layer("irradiance", plot.items()).into()).collect()
}

/// The strip at the right of the scene.
fn strip(figure: &Figure<'_>) -> Rect {
    let area = figure.frame.area;
    let right = f64::from(figure.scene.diagram.size[0]) - header::margin(figure.scene);
    Rect { min: DVec2::new(area.max.x + APART, area.min.y), max: DVec2::new(right, area.max.y) }
}

/// The part of the strip that a curve between two heights takes.
fn area(figure: &Figure<'_>, top: f64, bottom: f64) -> Rect {
    let strip = strip(figure);
    Rect { min: DVec2::new(strip.min.x + COLUMN, top), max: DVec2::new(strip.max.x - SIZE, bottom) }
}

/// First and last point of a screen in the figure, and whether it is one straight line.
fn course(figure: &Figure<'_>, screen: &Irradiance) -> Option<([DVec2; 2], bool)> {
    let curves = &figure.system.bodies().get(screen.body)?.outlines.first()?.curves;
    let ends = [curves.first()?.a, curves.last()?.b].map(|p| figure.frame.place(p));
    Some((ends, matches!(curves.as_slice(), [one] if one.is_straight())))
}

/// A curve at the heights of its screen; `None` where the screen does not stand upright or is too short in the figure.
fn aligned<'a>(figure: &'a Figure<'a>, screen: &'a Irradiance) -> Option<Plot<'a>> {
    let ([from, to], is_straight) = course(figure, screen)?;
    let (strip, across) = (strip(figure), to - from);
    let ends = [from.y, to.y].map(|y| y.clamp(strip.min.y, strip.max.y));
    let (top, bottom) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
    if !is_straight || across.x.abs() > LEAN * across.y.abs() || bottom - top < EXTENT[0] {
        return None;
    }
    let shown = ends.map(|y| screen.length * ((y - from.y) / across.y));
    if !shown.iter().all(|position| position.is_finite()) {
        return None;
    }
    let plot = Plot { figure, screen, is_upright: true, shown, ends, area: area(figure, top, bottom), most: 0.0 };
    Some(plot.measured())
}

fn are_apart(plots: &[Plot<'_>]) -> bool {
    let words = [TITLE, NUMBERS].map(|height| DVec2::new(0.0, height));
    let room = |plot: &Plot<'_>| Rect { min: plot.area.min - words[0], max: plot.area.max + words[1] };
    !plots.iter().enumerate().any(|(k, plot)| plots[..k].iter().any(|other| room(other).overlaps(&room(plot))))
}

/// As many curves as there is room for, along as much of their screens as is lit.
fn one_below_the_other<'a>(figure: &'a Figure<'a>, screens: &'a [Irradiance]) -> Vec<Plot<'a>> {
    let (strip, words) = (strip(figure), TITLE + NUMBERS);
    let most = (strip.size().y / (EXTENT[0] + words)).floor();
    let count = u32::try_from(screens.len()).map_or(most, |count| most.min(f64::from(count)));
    let slot = strip.size().y / count;
    let tops = (0..64_u32).map(f64::from).take_while(|k| *k < count).map(|k| strip.min.y + k * slot);
    let plots = screens.iter().zip(tops).filter_map(|(screen, top)| {
        let ([from, to], _) = course(figure, screen)?;
        let across = to - from;
        let is_upright = across.y.abs() > across.x.abs();
        let extent = (slot - words).min(if is_upright { EXTENT[1] } else { 0.75 * strip.size().x });
        let begin = top + 0.5 * (slot - words - extent) + TITLE;
        let area = area(figure, begin, begin + extent);
        let Rect { min, max } = area;
        let ends = match (is_upright, if is_upright { across.y > 0.0 } else { across.x >= 0.0 }) {
            (true, true) => [min.y, max.y],
            (true, false) => [max.y, min.y],
            (false, true) => [min.x, max.x],
            (false, false) => [max.x, min.x],
        };
        Some(Plot { figure, screen, is_upright, shown: lit(screen), ends, area, most: 0.0 }.measured())
    });
    plots.collect()
}

/// The stretch of a screen on which light landed, and a little more.
fn lit(screen: &Irradiance) -> [f64; 2] {
    let parts = screen.curves.iter().flat_map(|curve| screen.parts(curve)).filter(|(_, value)| *value > 0.0);
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    let [low, high] = parts.fold(none, |[low, high], ([begin, end], _)| [low.min(begin), high.max(end)]);
    let more = 0.06 * (high - low);
    [(low - more).max(0.0), (high + more).min(screen.length)]
}

/// A curve with its axes.
struct Plot<'a> {
    figure: &'a Figure<'a>,
    screen: &'a Irradiance,
    /// Whether the screen's length runs up or down, and values to the right; else values run up.
    is_upright: bool,
    /// Positions on the screen at the two ends of the curve.
    shown: [f64; 2],
    /// Where these stand: heights in the figure, or places from left to right.
    ends: [f64; 2],
    /// Where the curve stands, without words and numbers.
    area: Rect,
    /// The largest value that is shown.
    most: f64,
}

impl Plot<'_> {
    /// The same with its largest value.
    fn measured(self) -> Self {
        let values = self.screen.curves.iter().flat_map(|curve| self.parts(curve)).map(|(_, value)| value);
        Self { most: values.fold(f64::MIN_POSITIVE, f64::max), ..self }
    }

    fn items(&self) -> Vec<Item> {
        let lines = self.screen.curves.iter().map(|curve| Group::layer("", self.curve(curve)).into()).collect();
        let add_up = self.figure.styles.add_up().then_some(Whole { opacity: 1.0, adds_up: true });
        let lines = Group { whole: add_up, ..Group::layer("", lines) };
        let mut words = vec![self.title()];
        let value = self.value(&mut words);
        let axis = self.axis(&mut words);
        let items = value.into_iter().chain([lines.into(), axis]);
        items.chain(words.into_iter().map(Item::from)).collect()
    }

    /// Where a value stands at a position, both axes as in the figure.
    fn at(&self, position: f64, value: f64) -> DVec2 {
        let ([first, last], [begin, end]) = (self.shown, self.ends);
        let along = begin + (position - first) / (last - first) * (end - begin);
        let Rect { min, max } = self.area;
        let level = value / self.most;
        if self.is_upright {
            DVec2::new(min.x + level * (max.x - min.x), along)
        } else {
            DVec2::new(along, max.y - level * (max.y - min.y))
        }
    }

    /// The parts of a curve that are shown, cut where the plot ends, in the order of positions.
    fn parts(&self, curve: &Curve) -> impl Iterator<Item = ([f64; 2], f64)> {
        let [low, high] = [self.shown[0].min(self.shown[1]), self.shown[0].max(self.shown[1])];
        let cut = move |(part, value): ([f64; 2], f64)| (part.map(|position| position.clamp(low, high)), value);
        self.screen.parts(curve).map(cut).filter(|([begin, end], _)| begin < end)
    }

    /// A line's curve in steps, filled.
    fn curve(&self, curve: &Curve) -> Vec<Item> {
        let mut steps: Vec<(f64, f64)> = Vec::new();
        let mut last = 0.0;
        let parts = self.parts(curve).collect::<Vec<_>>();
        let end = parts.last().map(|([_, end], _)| ([*end; 2], 0.0));
        for ([begin, _], value) in parts.into_iter().chain(end) {
            #[expect(clippy::float_cmp, reason = "parts of one step hold the very same value")]
            if value != last {
                steps.extend([(begin, last), (begin, value)]);
                last = value;
            }
        }
        let mut points = steps.into_iter().map(|(position, value)| self.at(position, value));
        let mut path = Path::new();
        path.move_to(points.next().unwrap_or(self.area.min));
        points.for_each(|p| path.line_to(p));
        let stroke = self.figure.styles.line(curve.wavelength, 1.4);
        let fill = Fill { color: stroke.color, opacity: 0.16 };
        vec![Shape::filled(path.clone(), fill, "").into(), Shape::stroked(path, stroke, "curve").into()]
    }

    /// The screen's name over the curve, as much of it as there is room for.
    fn title(&self) -> Text {
        let body = self.figure.scene.bodies.get(self.screen.body);
        let name = body.and_then(|body| body.label.clone().filter(|label| !label.is_empty()).or(body.name.clone()));
        let (name, at) = (name.unwrap_or_else(|| "screen".into()), self.area.min - DVec2::new(0.0, 0.5 * SIZE));
        let text = |words: &str| Text::new(words, at, SIZE + 1.0, self.figure.palette.ink);
        let room = self.area.size().x + SIZE;
        let whole = text(&name);
        if whole.width() <= room {
            return whole;
        }
        let letters = name.chars().count();
        let cut = |count: usize| text(&format!("{}…", name.chars().take(count).collect::<String>().trim_end()));
        (0..letters.min(LONGEST)).rev().map(cut).find(|text| text.width() <= room).unwrap_or_else(|| text(""))
    }

    /// The line of a round value across the plot, and its number, with its unit below it where values run up.
    fn value(&self, words: &mut Vec<Text>) -> Option<Item> {
        let value = nice::at_most(self.most)?;
        let [from, to] = self.shown.map(|position| self.at(position, value));
        let number = nice::label(value);
        if self.is_upright {
            let foot = DVec2::new(from.x, self.area.max.y + SIZE + TICK);
            self.add(words, &format!("{number}/mm"), foot, Anchor::Middle);
        } else {
            let left = DVec2::new(self.area.min.x - 2.0 * TICK, from.y + 0.36 * SIZE);
            self.add(words, &number, left, Anchor::End);
            self.add(words, "/mm", left + DVec2::new(0.0, 1.2 * SIZE), Anchor::End);
        }
        let stroke = Stroke::solid(self.figure.palette.quiet, 0.8).faded(0.4);
        Some(Shape::stroked(Path::line(from, to), stroke, "").into())
    }

    /// The axis along the screen, and numbers at round positions.
    fn axis(&self, words: &mut Vec<Text>) -> Item {
        let mut path = Path::line(self.at(self.shown[0], 0.0), self.at(self.shown[1], 0.0));
        let [low, high] = [self.shown[0].min(self.shown[1]), self.shown[0].max(self.shown[1])];
        let apart = if self.is_upright { 50.0 } else { 64.0 };
        let step = nice::at_most((high - low) * apart / (self.ends[1] - self.ends[0]).abs());
        let mut unit = " mm";
        for position in step.map(|step| nice::multiples(step, low, high)).unwrap_or_default() {
            let at = self.at(position, 0.0);
            let (tick, number, anchor) = if self.is_upright {
                (DVec2::new(-TICK, 0.0), DVec2::new(-2.0 * TICK, 0.36 * SIZE), Anchor::End)
            } else {
                (DVec2::new(0.0, TICK), DVec2::new(0.0, SIZE + TICK), Anchor::Middle)
            };
            path.append(Path::line(at, at + tick));
            if self.add(words, &format!("{}{unit}", nice::label(position)), at + number, anchor) {
                unit = "";
            }
        }
        let stroke = Stroke::solid(self.figure.palette.quiet, 1.0).capped(Cap::Butt);
        Shape::stroked(path, stroke, "axis").into()
    }

    /// Adds a number if it stays beside the scene and clear of other words.
    fn add(&self, words: &mut Vec<Text>, number: &str, at: DVec2, anchor: Anchor) -> bool {
        let text = Text::new(number, at, SIZE, self.figure.palette.quiet).anchored(anchor);
        let (Rect { min, max }, [width, height]) = (text.bounds(), self.figure.scene.diagram.size.map(f64::from));
        let is_free = words.iter().all(|other| !other.bounds().overlaps(&text.bounds().grown(1.0)));
        let fits = is_free && min.x >= self.area.min.x - COLUMN && max.x <= width && max.y <= height;
        if fits {
            words.push(text);
        }
        fits
    }
}
