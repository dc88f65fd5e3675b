use std::collections::BTreeMap;

use glam::DVec2;

use crate::diagram::blend::Blend;
use crate::diagram::coincidence::groups;
use crate::diagram::frame::{Frame, clip};
use crate::trace::{Ending, RayTree, Segment, SegmentId, TracedRay};

/// Length of the stub that shows a branch that was not followed, pixels.
const STUB: f64 = 14.0;
/// Lines that are all within this many pixels look like one, whose color is that of the one drawn last.
const TOGETHER: f64 = 1.3;
/// Steps in which the stretch is sought where lines run together.
const STEPS: u32 = 400;
/// Lines farther apart are seen as several, pixels.
const SEEN_APART: f64 = 3.0;
/// More spectral lines side by side have one arrowhead.
const FEW_LINES: usize = 6;

/// A segment as the figure shows it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Branch<'a> {
    pub(super) ray: &'a TracedRay,
    pub(super) segment: &'a Segment,
    /// Power of all spectral lines that it stands for.
    pub(super) power: f64,
    /// The same as a share of the source ray.
    pub(super) share: f64,
    /// What it stands for, if for several coincident spectral lines.
    pub(super) blend: Option<Blend>,
    /// How many spectral lines its source ray has, those that coincide here counted once.
    pub(super) lines: usize,
    /// The bundle of lines that it is one of, if they part.
    pub(super) fan: Option<Fan>,
    /// Whether an arrowhead stands for it; of many lines fanned out, one has it for all.
    pub(super) arrow: bool,
    /// The visible part, pixels.
    pub(super) ends: [DVec2; 2],
}

/// Spectral lines of one ray that took the same path and do not coincide.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fan {
    /// Tells fans apart.
    pub(super) id: usize,
    /// How far apart its lines are half way, pixels.
    pub(super) spread: f64,
    /// What its lines are to the eye where they run together.
    pub(super) blend: Blend,
}

impl Fan {
    /// Whether the eye sees one line half way.
    pub(super) fn closed(&self) -> bool {
        self.spread < SEEN_APART
    }
}

impl<'a> Branch<'a> {
    /// A segment by itself between two points of the figure.
    pub(super) fn plain(ray: &'a TracedRay, segment: &'a Segment, ends: [DVec2; 2]) -> Self {
        let (power, share) = (segment.power.total(), share(ray, segment));
        Self { ray, segment, power, share, blend: None, lines: 1, fan: None, arrow: true, ends }
    }

    /// Its address, the first line's if it stands for several.
    pub(super) fn address(&self) -> String {
        self.ray.address(self.segment.id)
    }

    /// Length of the visible part, pixels.
    pub(super) fn length(&self) -> f64 {
        (self.ends[1] - self.ends[0]).length()
    }

    /// Direction in the figure.
    pub(super) fn direction(&self) -> DVec2 {
        (self.ends[1] - self.ends[0]).normalize_or_zero()
    }
}

/// Share of its source ray's power that a segment carries.
pub(super) fn share(ray: &TracedRay, segment: &Segment) -> f64 {
    portion(segment.power.total(), ray.power)
}

/// Path letters of all segments of a ray.
pub(super) fn paths(ray: &TracedRay) -> Vec<String> {
    let mut paths: Vec<String> = Vec::with_capacity(ray.segments.len());
    for segment in &ray.segments {
        let parent = segment.parent.and_then(|SegmentId(id)| paths.get(id as usize));
        let mut path = parent.cloned().unwrap_or_default();
        path.extend(segment.via.letter());
        paths.push(path);
    }
    paths
}

/// All branches that are seen and carry at least `faintest` of their source ray, weakest first.
pub(super) fn visible<'a>(tree: &'a RayTree, frame: &Frame, faintest: f64) -> Vec<Branch<'a>> {
    let mut branches = Vec::new();
    for lines in tree.rays.chunk_by(|a, b| (a.source, a.ray) == (b.source, b.ray)) {
        match lines {
            [ray] => branches.extend(ray.segments.iter().filter_map(|segment| single(ray, segment, 1, frame))),
            lines => several(lines, frame, &mut branches),
        }
    }
    branches.retain(|branch| branch.share >= faintest);
    branches.sort_by(|a, b| a.share.total_cmp(&b.share));
    branches
}

fn single<'a>(ray: &'a TracedRay, segment: &'a Segment, lines: usize, frame: &Frame) -> Option<Branch<'a>> {
    Some(Branch { lines, ..Branch::plain(ray, segment, ends(segment, frame)?) })
}

/// Branches of one ray's spectral lines, bundled by their paths.
fn several<'a>(lines: &'a [TracedRay], frame: &Frame, branches: &mut Vec<Branch<'a>>) {
    let mut by_path: BTreeMap<String, Vec<Branch<'a>>> = BTreeMap::new();
    for ray in lines {
        for (segment, path) in ray.segments.iter().zip(paths(ray)) {
            by_path.entry(path).or_default().extend(single(ray, segment, lines.len(), frame));
        }
    }
    for bundle in by_path.into_values() {
        // The number of branches so far is a name that no other bundle has.
        branches.extend(drawn(&bundle, branches.len()));
    }
}

/// A bundle as it is drawn: lines that coincide as one, the others as a fan.
fn drawn<'a>(bundle: &[Branch<'a>], id: usize) -> Vec<Branch<'a>> {
    let across = bundle.first().map_or(DVec2::Y, |first| first.direction().perp());
    let mut parts: Vec<_> = groups(bundle, across).iter().filter_map(|group| merged(group)).collect();
    if parts.len() == 1 && bundle.len() > 1 {
        return parts;
    }
    let doubled = bundle.len() - parts.len();
    parts.iter_mut().for_each(|part| part.lines -= doubled);
    fanned(parts, Fan { id, spread: spread(bundle, across, 0.5), blend: Blend::of(bundle) })
}

/// The same lines as a fan, the arrowhead on the middle one if they are many or hardly part.
fn fanned(mut parts: Vec<Branch<'_>>, fan: Fan) -> Vec<Branch<'_>> {
    let middle = parts.len() / 2;
    let one = parts.len() > FEW_LINES || fan.closed();
    for (i, branch) in parts.iter_mut().enumerate() {
        branch.fan = Some(fan);
        branch.arrow = !one || i == middle;
    }
    parts
}

/// How far apart lines are at a share of their way.
fn spread<'a>(bundle: impl IntoIterator<Item = &'a Branch<'a>>, across: DVec2, share: f64) -> f64 {
    let at = bundle.into_iter().map(|branch| branch.ends[0].lerp(branch.ends[1], share).dot(across));
    let (low, high) = at.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)));
    high - low
}

/// Where the lines of a fan run together: the middle of the stretch's two ends; `None` if they do nowhere.
pub(super) fn closed_stretch(fan: &[&Branch<'_>]) -> Option<[DVec2; 2]> {
    let first = fan.first()?;
    let across = first.direction().perp();
    let shares = (0..=STEPS).map(|step| f64::from(step) / f64::from(STEPS));
    // The distance is a convex function of the share: there is one stretch at most.
    let mut closed = shares.filter(|share| spread(fan.iter().copied(), across, *share) <= TOGETHER);
    let (from, to) = (closed.next()?, closed.next_back()?);
    let (low, high) = fan.iter().fold((*first, *first), |(low, high), branch| {
        let side = |branch: &Branch<'_>| branch.ends[0].lerp(branch.ends[1], to).dot(across);
        (if side(branch) < side(low) { branch } else { low }, if side(branch) > side(high) { branch } else { high })
    });
    let middle = |share: f64| 0.5 * (low.ends[0].lerp(low.ends[1], share) + high.ends[0].lerp(high.ends[1], share));
    Some([middle(from), middle(to)])
}

/// One branch for a group of lines that coincide: the first one's place, all their power.
fn merged<'a>(group: &[Branch<'a>]) -> Option<Branch<'a>> {
    let first = *group.first()?;
    if group.len() == 1 {
        return Some(first);
    }
    let power: f64 = group.iter().map(|branch| branch.power).sum();
    let emitted = group.iter().map(|branch| branch.ray.power).sum();
    Some(Branch { power, share: portion(power, emitted), blend: Some(Blend::of(group)), ..first })
}

/// The visible part of a segment: an escaped one runs to the frame, one that was not followed is a stub.
fn ends(segment: &Segment, frame: &Frame) -> Option<[DVec2; 2]> {
    let from = frame.place(segment.from);
    let ahead = frame.turn(segment.direction);
    match (segment.to, segment.ending) {
        (Some(to), _) => clip(from, frame.place(to) - from, 1.0, &frame.area),
        (None, Ending::Escaped) => clip(from, ahead, f64::INFINITY, &frame.area),
        (None, _) => clip(from, ahead, STUB, &frame.area),
    }
}

fn portion(part: f64, whole: f64) -> f64 {
    let share = part / whole;
    if share.is_finite() { share.clamp(0.0, 1.0) } else { 1.0 }
}
