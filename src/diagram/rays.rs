use std::collections::{BTreeMap, BTreeSet};

use crate::diagram::Figure;
use crate::diagram::blend::Blend;
use crate::diagram::branches::{Branch, closed_stretch};
use crate::drawing::{Color, Group, Item, Path, Shape, Stroke, Whole, shortest};
use crate::scene::{RayColor, Theme};

/// With more branches than this, those of one style share a path.
const MOST_SINGLE: usize = 2000;
/// Steps of power that are told apart where branches share paths.
const LEVELS: f64 = 24.0;
/// No ray is fainter, so that a share of 1 % is still seen on a projector.
const FAINTEST: f64 = 0.22;
/// More source rays than this are drawn thinner.
const UNCROWDED: f64 = 14.0;
/// More spectral lines than this are drawn thinner, so that a spectrum shows its colors.
const THICK_LINES: f64 = 1.5;
/// Dashes that tell up to six lines apart without color.
const PRINT_DASHES: [&[f64]; 6] = [&[], &[9.0, 3.0], &[3.0, 3.0], &[9.0, 3.0, 2.0, 3.0], &[14.0, 4.0], &[1.5, 2.5]];

/// All branches, each with its address and power, or by style if there are very many.
pub(super) fn rays(figure: &Figure<'_>) -> Vec<Item> {
    let styles = Styles::new(figure);
    if figure.branches.len() > MOST_SINGLE {
        return by_style(figure, &styles);
    }
    let mut fans: BTreeMap<usize, Vec<&Branch<'_>>> = BTreeMap::new();
    for branch in &figure.branches {
        if let Some(fan) = branch.fan.filter(|_| styles.spectral(branch)) {
            fans.entry(fan.id).or_default().push(branch);
        }
    }
    let items = figure.branches.iter().filter_map(|branch| {
        match branch.fan.and_then(|fan| fans.get(&fan.id)) {
            None => Some(single(branch, styles.stroke(branch, strength(branch.share))).into()),
            // A fan stands where its strongest line would.
            Some(fan) => fan.last().is_some_and(|last| std::ptr::eq(*last, branch)).then(|| spectrum(&styles, fan)),
        }
    });
    items.collect()
}

fn single(branch: &Branch<'_>, stroke: Stroke) -> Shape {
    let path = Path::line(branch.ends[0], branch.ends[1]);
    Shape::stroked(path, stroke, &class(branch))
        .with("data-address", branch.address())
        .with("data-power", shortest(branch.power))
}

/// The lines of one ray as a whole of the strongest line's opacity, so that many weak lines over each other stay weak.
fn spectrum(styles: &Styles<'_>, fan: &[&Branch<'_>]) -> Item {
    let strongest = fan.iter().map(|branch| strength(branch.share)).fold(0.0, f64::max);
    let mut items: Vec<Item> = Vec::new();
    for branch in fan {
        let own = strength(branch.share);
        items.push(single(branch, styles.stroke(branch, own).faded(opacity(own) / opacity(strongest))).into());
    }
    let whole = Whole { opacity: opacity(strongest), adds_up: styles.add_up() };
    if !whole.adds_up
        && let Some((first, ends)) = fan.first().zip(closed_stretch(fan))
    {
        let stroke = styles.stroke(&together(first), strongest).faded(1.0);
        items.push(Shape::stroked(Path::line(ends[0], ends[1]), stroke, "together").into());
    }
    Group::layer("spectrum", items).as_whole(whole).into()
}

fn by_style(figure: &Figure<'_>, styles: &Styles<'_>) -> Vec<Item> {
    let mut levels: BTreeMap<(u8, bool), BTreeMap<_, (Path, Stroke)>> = BTreeMap::new();
    for branch in &figure.branches {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 24")]
        let level = (strength(branch.share) * LEVELS).round() as u8;
        let stroke = || styles.stroke(branch, f64::from(level) / LEVELS);
        let paths = levels.entry((level, styles.add_up() && styles.spectral(branch))).or_default();
        let key = (branch.segment.via.word(), styles.color(branch), styles.dash(branch));
        let (path, _) = paths.entry(key).or_insert_with(|| (Path::new(), stroke()));
        path.move_to(branch.ends[0]);
        path.line_to(branch.ends[1]);
    }
    let mut items: Vec<Item> = Vec::new();
    for ((_, adds_up), paths) in levels {
        let opacity = paths.values().next().map_or(1.0, |(_, stroke)| stroke.opacity);
        let shapes = paths.into_iter().map(|((via, ..), (path, stroke))| {
            let stroke = if adds_up { stroke.faded(1.0) } else { stroke };
            Item::from(Shape::stroked(path, stroke, &format!("ray {via}")))
        });
        if adds_up {
            let whole = Whole { opacity, adds_up };
            items.push(Group::layer("spectrum", shapes.collect()).as_whole(whole).into());
        } else {
            items.extend(shapes);
        }
    }
    items
}

fn class(branch: &Branch<'_>) -> String {
    format!("ray {}", branch.segment.via.word())
}

/// A branch as it looks where all lines of its fan run together.
fn together<'a>(branch: &Branch<'a>) -> Branch<'a> {
    Branch { blend: branch.fan.map(|fan| fan.blend).or(branch.blend), fan: None, ..*branch }
}

/// How strong a branch looks, 0 to 1: the power's share to 3/8, so that 1 % still differs from nothing.
pub(super) fn strength(share: f64) -> f64 {
    let quarter = share.sqrt().sqrt();
    quarter * quarter.sqrt()
}

/// Opacity of a branch of a given strength.
pub(super) fn opacity(strength: f64) -> f64 {
    strength.clamp(FAINTEST, 1.0)
}

/// How rays are drawn in this figure.
pub(super) struct Styles<'a> {
    figure: &'a Figure<'a>,
    /// Bits of every wavelength in nanometers; for numbers above 0 their order is the numbers'.
    lines: BTreeSet<u64>,
    /// Factor on all widths.
    crowding: f64,
}

impl<'a> Styles<'a> {
    pub(super) fn new(figure: &'a Figure<'a>) -> Self {
        let rays = &figure.tree.rays;
        let lines: BTreeSet<u64> = rays.iter().map(|ray| ray.wavelength.nanometers().to_bits()).collect();
        let strong = rays.chunk_by(|a, b| (a.source, a.ray) == (b.source, b.ray)).count();
        Self { figure, lines, crowding: (UNCROWDED / number(strong)).sqrt().clamp(0.45, 1.0) }
    }

    /// The line of a branch whose strength was rounded to `strength`.
    pub(super) fn stroke(&self, branch: &Branch<'_>, strength: f64) -> Stroke {
        let alone = branch.blend.is_some() && branch.fan.is_none();
        let fanning = if alone { 1.0 } else { (THICK_LINES / number(branch.lines)).sqrt().clamp(0.45, 1.0) };
        let width = (0.8 + 1.6 * strength) * (self.crowding * fanning).max(0.4);
        let stroke = Stroke::solid(self.color(branch), width).faded(opacity(strength));
        match PRINT_DASHES[self.dash(branch)] {
            [] => stroke,
            dash => stroke.dashed(dash),
        }
    }

    pub(super) fn color(&self, branch: &Branch<'_>) -> Color {
        let palette = &self.figure.palette;
        let wavelength = branch.ray.wavelength;
        let own = self.figure.scene.sources.get(branch.ray.source).and_then(|source| source.color);
        match (own, self.figure.scene.diagram.color, branch.blend) {
            (Some(own), ..) => Color(own),
            (None, RayColor::Power, _) => palette.power(branch.share),
            (None, RayColor::Via, _) => palette.via(branch.segment.via),
            (None, RayColor::Auto | RayColor::Wavelength, Some(blend)) => palette.blend(blend),
            (None, RayColor::Auto, None) if self.lines.len() < 2 => palette.ray,
            (None, RayColor::Auto | RayColor::Wavelength, None) => palette.wavelength(wavelength),
        }
    }

    /// Color of a branch and all lines that run with it.
    pub(super) fn together(&self, branch: &Branch<'_>) -> Color {
        self.color(&together(branch))
    }

    /// Whether a branch is one of several spectral lines, each in its own color.
    fn spectral(&self, branch: &Branch<'_>) -> bool {
        let own = self.figure.scene.sources.get(branch.ray.source).is_some_and(|source| source.color.is_some());
        let by_wavelength = matches!(self.figure.scene.diagram.color, RayColor::Auto | RayColor::Wavelength);
        branch.fan.is_some() && by_wavelength && !own
    }

    /// Whether colors add up where they overlap, as light does on a dark ground. On a light one adding would end in the
    /// ground's own white: there lines cover each other, and ink covers them where they run together.
    fn add_up(&self) -> bool {
        self.figure.scene.diagram.theme == Theme::Dark
    }

    /// Which dashes a branch has: solid, but for a few lines in print, where dashes stand for colors.
    fn dash(&self, branch: &Branch<'_>) -> usize {
        let few = (2..=PRINT_DASHES.len()).contains(&self.lines.len());
        if !few || branch.blend == Some(Blend::Whole) || self.figure.scene.diagram.theme != Theme::Print {
            return 0;
        }
        let bits = branch.ray.wavelength.nanometers().to_bits();
        self.lines.iter().position(|line| *line == bits).unwrap_or(0)
    }
}

fn number(count: usize) -> f64 {
    u32::try_from(count).map_or(f64::INFINITY, f64::from)
}
