use glam::DVec2;

use crate::diagram::blend::Blend;
use crate::diagram::coincidence::groups;
use crate::diagram::frame::{Frame, clip};
use crate::diagram::paths::{Member, bundles};
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
    /// How many segments it stands for.
    pub(super) members: usize,
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
        Self { ray, segment, power, share, members: 1, blend: None, lines: 1, fan: None, arrow: true, ends }
    }

    /// Its address, the first line's if it stands for several.
    pub(super) fn address(&self) -> String {
        self.ray.address(self.segment.id)
    }

    /// How many hits lie behind it.
    pub(super) fn generation(&self) -> u32 {
        generation(self.ray, self.segment.id)
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

/// Path letters of a segment, from its source on.
pub(super) fn letters(ray: &TracedRay, id: SegmentId) -> String {
    let backward: Vec<char> = ray.ancestors(id).filter_map(|segment| segment.via.letter()).collect();
    backward.into_iter().rev().collect()
}

/// How many hits lie behind a segment.
pub(super) fn generation(ray: &TracedRay, id: SegmentId) -> u32 {
    u32::try_from(ray.ancestors(id).skip(1).count()).unwrap_or(u32::MAX)
}

/// Segments that are not drawn.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Spared {
    pub(super) outside_view: usize,
    pub(super) below_faintest: usize,
}

/// What of the tree is drawn, and where.
pub(super) struct Sight<'f> {
    pub(super) frame: &'f Frame,
    /// Branches below this share of their source ray are not drawn.
    pub(super) faintest: f64,
    /// Whether segments outside the view are drawn too, for tests.
    pub(super) everywhere: bool,
}

impl Sight<'_> {
    /// Hands on all branches that are drawn, in the tree's order.
    pub(super) fn visit<'a>(&self, tree: &'a RayTree, show: &mut impl FnMut(&Branch<'a>)) -> Spared {
        let mut spared = Spared::default();
        let mut fans = 0;
        for lines in tree.rays.chunk_by(|a, b| (a.source, a.ray) == (b.source, b.ray)) {
            match lines {
                [ray] => ray.segments.iter().for_each(|segment| {
                    if share(ray, segment) < self.faintest {
                        spared.below_faintest += 1;
                    } else if let Some(ends) = self.ends(segment) {
                        show(&Branch::plain(ray, segment, ends));
                    } else {
                        spared.outside_view += 1;
                    }
                }),
                lines => bundles(lines, |bundle| {
                    fans += 1;
                    self.bundle(lines, bundle, fans, &mut spared, show);
                }),
            }
        }
        spared
    }

    /// Branches of one ray's spectral lines that took the same path.
    fn bundle<'a>(
        &self,
        lines: &'a [TracedRay],
        members: &[Member],
        id: usize,
        spared: &mut Spared,
        show: &mut impl FnMut(&Branch<'a>),
    ) {
        let segments = members.iter().map(|member| {
            let ray = &lines[member.line()];
            (ray, &ray.segments[member.segment()])
        });
        // A share of several lines lies between theirs.
        if segments.clone().all(|(ray, segment)| share(ray, segment) < self.faintest) {
            spared.below_faintest += members.len();
            return;
        }
        let seen = segments.filter_map(|(ray, segment)| {
            Some(Branch { lines: lines.len(), ..Branch::plain(ray, segment, self.ends(segment)?) })
        });
        let seen: Vec<Branch<'_>> = seen.collect();
        spared.outside_view += members.len() - seen.len();
        for branch in drawn(&seen, id) {
            if branch.share < self.faintest {
                spared.below_faintest += branch.members;
            } else {
                show(&branch);
            }
        }
    }

    /// The visible part of a segment: an escaped one runs to the frame, one that was not followed is a stub.
    fn ends(&self, segment: &Segment) -> Option<[DVec2; 2]> {
        let from = self.frame.place(segment.from);
        let (ahead, end) = match (segment.to, segment.ending) {
            (Some(to), _) => (self.frame.place(to) - from, 1.0),
            (None, Ending::Escaped) => (self.frame.turn(segment.direction), f64::INFINITY),
            (None, _) => (self.frame.turn(segment.direction), STUB),
        };
        let outside = || self.everywhere.then(|| [from, from + ahead * end.min(1e4)]);
        clip(from, ahead, end, &self.frame.area).or_else(outside)
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
    parts.iter_mut().for_each(|part| part.lines = part.lines.saturating_sub(doubled));
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
    Some(Branch { power, share: portion(power, emitted), members: group.len(), blend: Some(Blend::of(group)), ..first })
}

fn portion(part: f64, whole: f64) -> f64 {
    let share = part / whole;
    if share.is_finite() { share.clamp(0.0, 1.0) } else { 1.0 }
}
