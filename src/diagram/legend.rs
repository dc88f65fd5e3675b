//! What colors, dashes, widths and opacities tell, where a figure has more than one of them.

use glam::DVec2;

use crate::diagram::Figure;
use crate::diagram::branches::{Branch, share};
use crate::diagram::key::{self, Entry};
use crate::diagram::styles::strength;
use crate::drawing::{Stroke, Text};
use crate::scene::{RayColor, Scene};
use crate::trace::{RayTree, Via};

/// More lines are a spectrum, which explains itself.
const MOST_LINES: usize = 6;
/// Shares of which a sample is shown.
const SHARES: [f64; 4] = [1.0, 0.1, 0.01, 0.001];
/// The same where all branches are stronger than a tenth.
const STRONG_SHARES: [f64; 3] = [1.0, 0.5, 0.25];

/// The entries for the lines below the figure; `spared` branches are below the faintest that is drawn.
pub(super) fn legend(figure: &Figure<'_>, spared: usize) -> Vec<Entry> {
    let Some(strongest) = figure.branches.last() else { return Vec::new() };
    let mut entries = match figure.scene.diagram.color {
        RayColor::Via => ways(figure),
        RayColor::Auto | RayColor::Wavelength => lines(figure),
        RayColor::Power => Vec::new(),
    };
    entries.extend(shares(figure, strongest));
    if spared > 0 {
        let branches = if spared == 1 { "branch" } else { "branches" };
        let faintest = 100.0 * figure.scene.diagram.faintest;
        let verb = if spared == 1 { "is" } else { "are" };
        let words = format!("{spared} {branches} below {}\u{a0}% {verb} not drawn", percent(faintest));
        entries.push(Entry { sample: None, text: text(figure, &words) });
    }
    entries
}

/// The entry for bodies whose labels are left out, if there are any.
pub(super) fn unlabeled(figure: &Figure<'_>, count: usize) -> Option<Entry> {
    let bodies = if count == 1 { "body" } else { "bodies" };
    let words = format!("too many labels: those of {count} {bodies} are not drawn");
    (count > 0).then(|| Entry { sample: None, text: text(figure, &words) })
}

/// Whether some branch carries so little that the legend will have something to tell.
pub(super) fn has_weak_branches(scene: &Scene, tree: &RayTree) -> bool {
    let weak = STRONG_SHARES[1];
    let is_weak = |share: f64| share < weak && share >= scene.diagram.faintest;
    tree.rays.iter().any(|ray| ray.segments.iter().any(|segment| is_weak(share(ray, segment))))
}

fn text(figure: &Figure<'_>, words: &str) -> Text {
    Text::new(words, DVec2::ZERO, key::SIZE, figure.palette.quiet).classed("legend")
}

/// A number of percent in its shortest form.
fn percent(number: f64) -> f64 {
    (number * 1e6).round() / 1e6
}

/// A wavelength in its shortest form to a tenth.
fn tenths(nanometers: f64) -> f64 {
    (10.0 * nanometers).round() / 10.0
}

/// The spectral lines, where they are few.
fn lines(figure: &Figure<'_>) -> Vec<Entry> {
    let mut known: Vec<&Branch<'_>> = Vec::new();
    for branch in figure.branches.iter().rev().filter(|branch| branch.blend.is_none()) {
        if !known.iter().any(|other| other.ray.wavelength == branch.ray.wavelength) {
            known.push(branch);
        }
    }
    if !(2..=MOST_LINES).contains(&known.len()) {
        return Vec::new();
    }
    known.sort_by(|a, b| a.ray.wavelength.nanometers().total_cmp(&b.ray.wavelength.nanometers()));
    let entry = |branch: &&Branch<'_>| Entry {
        sample: Some(Stroke { opacity: 1.0, ..figure.styles.stroke(branch, 1.0) }),
        text: text(figure, &format!("{}\u{a0}nm", tenths(branch.ray.wavelength.nanometers()))),
    };
    known.iter().map(entry).collect()
}

/// How branches came about, of those that there are; those of sources with a color of their own do not tell it.
fn ways(figure: &Figure<'_>) -> Vec<Entry> {
    let ways = [Via::Source, Via::Transmission, Via::Reflection, Via::TotalInternalReflection];
    let own = |branch: &Branch<'_>| figure.scene.sources.get(branch.ray.source).and_then(|source| source.color);
    let is_there = |via: &Via| figure.branches.iter().any(|branch| branch.segment.via == *via && own(branch).is_none());
    let entry =
        |via: Via| Entry { sample: Some(figure.styles.way(via)), text: text(figure, &via.word().replace('_', " ")) };
    ways.into_iter().filter(is_there).map(entry).collect()
}

/// Samples of shares, where branches differ in them by more than one sample. Dashes tell other things.
fn shares(figure: &Figure<'_>, strongest: &Branch<'_>) -> Vec<Entry> {
    let weakest = figure.branches.iter().map(|branch| branch.share).fold(f64::INFINITY, f64::min);
    let steps = if weakest > SHARES[1] { STRONG_SHARES.as_slice() } else { SHARES.as_slice() };
    let shown: Vec<_> = steps.iter().copied().filter(|share| *share >= 0.9 * weakest).collect();
    if shown.len() < 2 {
        return Vec::new();
    }
    let entry = |(place, share): (usize, &f64)| {
        let branch = Branch { share: *share, ..*strongest };
        let rest = if place + 1 == shown.len() { " of a source's ray" } else { "" };
        let words = format!("{}\u{a0}%{rest}", percent(100.0 * share));
        let sample = Stroke { dash: Vec::new(), ..figure.styles.stroke(&branch, strength(*share)) };
        Entry { sample: Some(sample), text: text(figure, &words) }
    };
    shown.iter().enumerate().map(entry).collect()
}
