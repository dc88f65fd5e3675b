//! What light does not do: where rays that spread seem to come from, and where a turned ray would have gone.

use std::collections::BTreeMap;

use glam::DVec2;

use crate::diagram::Figure;
use crate::diagram::blend::Blend;
use crate::diagram::branches::{Branch, generation, letters, share};
use crate::diagram::frame::{Extent, Frame, clip};
use crate::diagram::generations::Aged;
use crate::drawing::{Path, Shape};
use crate::numerics::cross;
use crate::scene::{Light, Scene, Source};
use crate::trace::{Ending, RayTree, Segment, TracedRay};

/// Rays that meet farther behind than this many sizes of the scene count as parallel.
const REACH: f64 = 4.0;
/// Weaker segments are not extended, share of the source ray.
const STRONG: f64 = 0.2;
/// A way that a ray did not go is drawn on by this many pixels, so that the angle between the two is seen.
const BEYOND: f64 = 200.0;
/// Normals of one face have a cosine above this.
const SAME_FACE: f64 = 0.7;
/// A shorter extension is not drawn, pixels.
const SHORTEST: f64 = 3.0;
/// More would be noise.
const MOST: usize = 400;

/// A line that no light follows, from a segment's end backward or forward.
#[derive(Clone, Copy)]
pub(super) struct Extension<'a> {
    ray: &'a TracedRay,
    segment: &'a Segment,
    /// The light that it is compared with, itself or what became of it.
    turned: &'a Segment,
    from: DVec2,
    to: DVec2,
    /// Whether it goes on past its end as far as the figure allows, up to [`BEYOND`].
    open: bool,
}

/// Dashed lines of the extensions, each in the color of its ray.
pub(super) fn extensions(figure: &Figure<'_>) -> Vec<Aged> {
    let all = found(figure.scene, figure.tree);
    let blends = if all.is_empty() { BTreeMap::new() } else { blends(figure) };
    let items = all.iter().filter_map(|extension| {
        let [a, b] = ends(extension, &figure.frame)?;
        // It continues the branch of its segment, or of the same path if that stands for several lines.
        let blend = blends.get(&way(extension.ray, extension.segment)).copied().flatten();
        let ray = Branch { blend, ..Branch::plain(extension.ray, extension.segment, [a, b]) };
        let shape = Shape::stroked(Path::line(a, b), figure.styles.extension(&ray), "extension");
        Some((generation(extension.ray, extension.turned.id), shape.into()))
    });
    items.take(MOST).collect()
}

/// A source ray and the letters of a path, whatever the line.
pub(super) type AnyLine = (usize, usize, String);

pub(super) fn way(ray: &TracedRay, segment: &Segment) -> AnyLine {
    (ray.source, ray.ray, letters(ray, segment.id))
}

/// What the branches of rays of several lines stand for, of equal paths the weakest.
pub(super) fn blends(figure: &Figure<'_>) -> BTreeMap<AnyLine, Option<Blend>> {
    let several = figure.branches.iter().rev().filter(|branch| branch.ray.one_of_several_lines);
    several.map(|branch| (way(branch.ray, branch.segment), branch.blend)).collect()
}

/// Points that the figure should show if it can: ends of the extensions of rays that spread.
pub(super) fn points(scene: &Scene, tree: &RayTree) -> Vec<DVec2> {
    found(scene, tree).iter().filter(|extension| !extension.open).map(|extension| extension.to).collect()
}

fn ends(extension: &Extension<'_>, frame: &Frame) -> Option<[DVec2; 2]> {
    let [from, mut to] = [extension.from, extension.to].map(|p| frame.place(p));
    if extension.open {
        to += (to - from).normalize_or_zero() * BEYOND;
    }
    let ends = clip(from, to - from, 1.0, &frame.area)?;
    ((ends[1] - ends[0]).length() >= SHORTEST).then_some(ends)
}

/// All extensions of a scene that asks for them, but for rays of objects, whose images are drawn with lines of their own.
fn found<'a>(scene: &Scene, tree: &'a RayTree) -> Vec<Extension<'a>> {
    if !scene.diagram.extensions {
        return Vec::new();
    }
    let is_object =
        |ray: &TracedRay| matches!(scene.sources.get(ray.source), Some(Source { light: Light::Object { .. }, .. }));
    let ways: Vec<Way<'_>> = middle_lines(tree).filter(|ray| !is_object(ray)).filter_map(Way::of).collect();
    let size = Extent::of(ways.iter().flat_map(Way::points)).map_or(0.0, |extent| extent.size().max_element());
    let mut all = Vec::new();
    for (i, way) in ways.iter().enumerate() {
        let before = i.checked_sub(1).and_then(|before| ways.get(before));
        let beside = [before, ways.get(i + 1)].into_iter().flatten().filter(|other| way.beside(other));
        let beside: Vec<&Way<'_>> = beside.collect();
        all.extend(way.virtual_origins(&beside, REACH * size));
        if beside.is_empty() {
            all.extend(way.turned(size));
        }
    }
    all
}

/// Of every source ray the line in the middle of its spectrum.
fn middle_lines(tree: &RayTree) -> impl Iterator<Item = &TracedRay> {
    let rays = tree.rays.chunk_by(|a, b| (a.source, a.ray) == (b.source, b.ray));
    rays.filter_map(|lines| lines.get(lines.len() / 2))
}

/// The way that most of a ray's power takes.
struct Way<'a> {
    ray: &'a TracedRay,
    segments: Vec<&'a Segment>,
    /// Path letters of the last segment.
    letters: String,
}

impl<'a> Way<'a> {
    /// `None` if the ray meets nothing.
    fn of(ray: &'a TracedRay) -> Option<Self> {
        let stronger = |a: &'a Segment, b: &'a Segment| if a.power.total() > b.power.total() { a } else { b };
        let strongest = ray.children().into_iter().map(|children| children.into_iter().reduce(stronger));
        let strongest: Vec<Option<&Segment>> = strongest.collect();
        let first = ray.segments.first();
        let segments: Vec<_> = std::iter::successors(first, |last| *strongest.get(last.id.index())?).collect();
        let letters = letters(ray, segments.last()?.id);
        (segments.len() > 1).then_some(Self { ray, segments, letters })
    }

    fn points(&self) -> impl Iterator<Item = DVec2> {
        self.segments.iter().flat_map(|segment| [Some(segment.from), segment.to]).flatten()
    }

    /// Whether two ways are neighbors: side by side in one source, or from one point, and through the same hits.
    fn beside(&self, other: &Self) -> bool {
        let near = if self.ray.source == other.ray.source {
            self.ray.ray.abs_diff(other.ray.ray) == 1
        } else {
            self.segments.first().map(|s| s.from) == other.segments.first().map(|s| s.from)
        };
        near && self.letters == other.letters
            && self.segments.iter().zip(&other.segments).all(|(a, b)| meet_one_face(a, b))
    }

    /// For every segment in the medium that the light came from: back to where its line meets the farther neighbor's.
    fn virtual_origins(&self, beside: &[&Self], reach: f64) -> Vec<Extension<'a>> {
        let Some(outside) = self.segments.first().map(|first| first.medium_index.to_bits()) else { return Vec::new() };
        let last = self.segments.len() - 1;
        let mut found = Vec::new();
        for (i, segment) in self.segments.iter().enumerate().skip(1) {
            if (segment.medium_index.to_bits() != outside && i != last) || share(self.ray, segment) < STRONG {
                continue;
            }
            let others = beside.iter().filter_map(|other| other.segments.get(i));
            let back = others.filter_map(|other| back_to_meeting(segment, other, reach)).fold(0.0, f64::max);
            if back > 0.0 {
                found.push(self.line(segment, segment.from, segment.from - segment.direction * back, false));
            }
        }
        found
    }

    fn line(&self, segment: &'a Segment, from: DVec2, to: DVec2, open: bool) -> Extension<'a> {
        Extension { ray: self.ray, segment, turned: segment, from, to, open }
    }

    /// For a ray of its own that was turned or displaced: where it would have gone and where it seems to come from.
    fn turned(&self, size: f64) -> Vec<Extension<'a>> {
        let (Some(first), Some(last)) = (self.segments.first(), self.segments.last()) else { return Vec::new() };
        let Some(hit) = first.to.filter(|_| share(self.ray, last) >= STRONG) else { return Vec::new() };
        let lines = match last.ending {
            Ending::Detected => self.seen(first, last),
            Ending::Escaped => self.deviated(first, hit, last, size),
            _ => Vec::new(),
        };
        lines.into_iter().map(|line| Extension { turned: last, ..line }).collect()
    }

    /// What sees a turned ray seeks its start on the line on which it arrives, beside the true one.
    fn seen(&self, first: &'a Segment, last: &'a Segment) -> Vec<Extension<'a>> {
        let Some(eye) = last.to else { return Vec::new() };
        let sight = first.from - eye;
        let toward = -last.direction.dot(sight);
        let length = sight.length_squared() / toward;
        let turned = cross(sight, last.direction).abs() > 1e-6 * sight.length();
        let before = (eye - last.from).length();
        if !(turned && toward > 0.0 && length.is_finite() && length > before && length < REACH * sight.length()) {
            return Vec::new();
        }
        vec![self.line(last, last.from, eye - last.direction * length, false)]
    }

    /// Both lines up to where they cross, the incoming one beyond it.
    fn deviated(&self, first: &'a Segment, hit: DVec2, last: &'a Segment, size: f64) -> Vec<Extension<'a>> {
        let apart = last.from - hit;
        let turn = cross(first.direction, last.direction);
        if cross(first.direction, apart).abs() <= 1e-6 * size && turn.abs() <= 1e-6 {
            return Vec::new();
        }
        let [ahead, behind] = [cross(apart, last.direction) / turn, cross(apart, first.direction) / turn];
        if turn.abs() > 1e-6 && ahead > 0.0 && behind < 0.0 && ahead.max(-behind) <= REACH * size {
            let crossing = hit + first.direction * ahead;
            return vec![self.line(first, hit, crossing, true), self.line(last, last.from, crossing, false)];
        }
        // They are parallel or cross elsewhere: the incoming line as far as the outgoing one starts.
        let along = first.direction.dot(apart);
        if along <= 0.0 {
            return Vec::new();
        }
        vec![self.line(first, hit, hit + first.direction * along, true)]
    }
}

/// Whether two segments end at one face of a body, or at two that continue each other.
fn meet_one_face(a: &Segment, b: &Segment) -> bool {
    match (a.hit, b.hit) {
        (Some(a), Some(b)) => a.body == b.body && a.normal.dot(b.normal) > SAME_FACE,
        (a, b) => a.is_none() == b.is_none(),
    }
}

/// How far behind the start of a segment its line meets a neighbor's that spreads from it.
fn back_to_meeting(own: &Segment, other: &Segment, reach: f64) -> Option<f64> {
    let turn = cross(own.direction, other.direction);
    let apart = other.from - own.from;
    let [s, t] = [cross(apart, other.direction) / turn, cross(apart, own.direction) / turn];
    let behind = |t: f64| t < 0.0 && t >= -reach;
    (turn.abs() > 1e-6 && behind(s) && behind(t)).then_some(-s)
}
