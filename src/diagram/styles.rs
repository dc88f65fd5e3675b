use std::collections::BTreeSet;

use crate::diagram::blend::Blend;
use crate::diagram::branches::Branch;
use crate::diagram::palette::Palette;
use crate::drawing::{Color, Stroke};
use crate::light::Wavelength;
use crate::scene::{RayColor, Scene, Theme};
use crate::trace::{RayTree, Via};

/// No ray is fainter, so that a share of 1 % is still seen on a projector; on a dark ground faint lines are lost sooner.
const FAINTEST: f64 = 0.22;
const FAINTEST_ON_DARK: f64 = 0.36;
/// More source rays than this are drawn thinner.
const UNCROWDED: f64 = 14.0;
/// More spectral lines than this are drawn thinner, so that a spectrum shows its colors.
const THICK_LINES: f64 = 1.5;
/// Dashes that tell up to six kinds of rays apart without color.
const PRINT_DASHES: [&[f64]; 6] = [&[], &[9.0, 3.0], &[3.0, 3.0], &[9.0, 3.0, 2.0, 3.0], &[14.0, 4.0], &[1.5, 2.5]];

/// A branch as it looks where all lines of its fan run together.
pub(super) fn together<'a>(branch: &Branch<'a>) -> Branch<'a> {
    Branch { blend: branch.fan.map(|fan| fan.blend).or(branch.blend), fan: None, ..*branch }
}

/// How strong a branch looks, 0 to 1: the power's share to 3/8, so that 1 % still differs from nothing.
pub(super) fn strength(share: f64) -> f64 {
    let quarter = share.sqrt().sqrt();
    quarter * quarter.sqrt()
}

/// How rays are drawn in this figure.
pub(super) struct Styles<'a> {
    scene: &'a Scene,
    palette: Palette,
    /// Bits of every wavelength in nanometers; for numbers above 0 their order is the numbers'.
    lines: BTreeSet<u64>,
    /// The authors' colors of sources, in the order of the sources; `None` for those without.
    own_colors: Vec<Option<[u8; 3]>>,
    /// Factor on all widths.
    crowding: f64,
}

impl<'a> Styles<'a> {
    pub(super) fn new(scene: &'a Scene, palette: Palette, tree: &RayTree) -> Self {
        let rays = &tree.rays;
        let lines: BTreeSet<u64> = rays.iter().map(|ray| ray.wavelength.nanometers().to_bits()).collect();
        let strong = rays.chunk_by(|a, b| (a.source, a.ray) == (b.source, b.ray)).count();
        let mut own_colors = Vec::new();
        for source in &scene.sources {
            if !own_colors.contains(&source.color) {
                own_colors.push(source.color);
            }
        }
        Self { scene, palette, lines, own_colors, crowding: (UNCROWDED / number(strong)).sqrt().clamp(0.45, 1.0) }
    }

    /// Opacity of a branch of a given strength.
    pub(super) fn opacity(&self, strength: f64) -> f64 {
        match self.scene.diagram.theme {
            Theme::Light | Theme::Print => strength.clamp(FAINTEST, 1.0),
            Theme::Dark => FAINTEST_ON_DARK + (1.0 - FAINTEST_ON_DARK) * strength.clamp(0.0, 1.0),
        }
    }

    /// The dotted line of what a branch does not do.
    pub(super) fn extension(&self, branch: &Branch<'_>) -> Stroke {
        Stroke::solid(self.color(branch), 1.3).faded(0.8).dashed(&[2.0, 4.0])
    }

    /// The line of a branch whose strength was rounded to `strength`.
    pub(super) fn stroke(&self, branch: &Branch<'_>, strength: f64) -> Stroke {
        let alone = branch.blend.is_some() && branch.fan.is_none();
        let fanning = if alone { 1.0 } else { (THICK_LINES / number(branch.lines)).sqrt().clamp(0.45, 1.0) };
        let width = (0.8 + 1.6 * strength) * (self.crowding * fanning).max(0.4);
        let stroke = Stroke::solid(self.color(branch), width).faded(self.opacity(strength));
        match PRINT_DASHES[self.dash(branch)] {
            [] => stroke,
            dash => stroke.dashed(dash),
        }
    }

    /// A line of a spectral line's color and dashes.
    pub(super) fn line(&self, wavelength: Wavelength, width: f64) -> Stroke {
        let is_alone = self.scene.diagram.color == RayColor::Auto && self.lines.len() < 2;
        let color = if is_alone { self.palette.ray } else { self.palette.wavelength(wavelength) };
        let stroke = Stroke::solid(color, width);
        match PRINT_DASHES[self.dash_of(wavelength)] {
            [] => stroke,
            dash => stroke.dashed(dash),
        }
    }

    pub(super) fn color(&self, branch: &Branch<'_>) -> Color {
        let palette = &self.palette;
        let wavelength = branch.ray.wavelength;
        let own = self.scene.sources.get(branch.ray.source).and_then(|source| source.color);
        match (own, self.scene.diagram.color, branch.blend) {
            (Some(own), ..) => palette.own_light(own),
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
    pub(super) fn spectral(&self, branch: &Branch<'_>) -> bool {
        let own = self.scene.sources.get(branch.ray.source).is_some_and(|source| source.color.is_some());
        let by_wavelength = matches!(self.scene.diagram.color, RayColor::Auto | RayColor::Wavelength);
        branch.fan.is_some() && by_wavelength && !own
    }

    /// Whether colors add up where they overlap, as light does on a dark ground. On a light one adding would end in the
    /// ground's own white: there lines cover each other, and ink covers them where they run together.
    pub(super) fn add_up(&self) -> bool {
        self.scene.diagram.theme == Theme::Dark
    }

    /// Which dashes a branch has: solid, but in print, where dashes stand for colors: the authors' if there are several,
    /// else those of a few lines, or of the ways that light came about.
    pub(super) fn dash(&self, branch: &Branch<'_>) -> usize {
        if self.scene.diagram.theme != Theme::Print {
            return 0;
        }
        let own = self.scene.sources.get(branch.ray.source).and_then(|source| source.color);
        let has_kinds = few(self.own_colors.len());
        let kind = if has_kinds && (own.is_some() || self.scene.diagram.color != RayColor::Via) {
            self.own_colors.iter().position(|color| *color == own)
        } else if self.scene.diagram.color == RayColor::Via {
            Some(via_dash(branch.segment.via))
        } else if branch.blend == Some(Blend::Whole) {
            None
        } else {
            Some(self.dash_of(branch.ray.wavelength))
        };
        kind.unwrap_or(0)
    }

    /// Which dashes stand for a line.
    fn dash_of(&self, wavelength: Wavelength) -> usize {
        if !few(self.lines.len()) || self.scene.diagram.theme != Theme::Print {
            return 0;
        }
        let bits = wavelength.nanometers().to_bits();
        self.lines.iter().position(|line| *line == bits).unwrap_or(0)
    }

    /// A sample of the line of rays that came about in one way.
    pub(super) fn way(&self, via: Via) -> Stroke {
        let stroke = Stroke::solid(self.palette.via(via), 2.0);
        let is_dashed = self.scene.diagram.theme == Theme::Print && via_dash(via) > 0;
        if is_dashed { stroke.dashed(PRINT_DASHES[via_dash(via)]) } else { stroke }
    }
}

/// Whether so many kinds of rays are told apart by dashes.
fn few(kinds: usize) -> bool {
    (2..=PRINT_DASHES.len()).contains(&kinds)
}

/// In print dashes tell the ways of light apart; gray tells its power.
fn via_dash(via: Via) -> usize {
    match via {
        Via::Source => 0,
        Via::Transmission => 4,
        Via::Reflection => 1,
        Via::TotalInternalReflection => 3,
    }
}

fn number(count: usize) -> f64 {
    u32::try_from(count).map_or(f64::INFINITY, f64::from)
}
