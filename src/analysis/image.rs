//! Images of object arrows, found where the traced rays meet.

use glam::DVec2;

use crate::numerics::cross;
use crate::system::{OpticalSystem, PlacedObject, PlacedSource};
use crate::trace::{RayTree, Segment, SegmentId, TracedRay, Via, trace};

/// Rays that pass their common point farther off than this share of the image's height make no image.
const SHARP: f64 = 0.1;
/// Rays whose directions differ by less than this, radians, are parallel.
const PARALLEL: f64 = 1e-6;
/// An object that leans by less than this, radians, stands across the axis.
const UPRIGHT: f64 = 1e-9;
/// A tip nearer to the axis than this share of the object's height is on it.
const ON_AXIS: f64 = 1e-6;

/// The image of an object arrow, in scene coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// The source whose image it is, by its place in the scene.
    pub source: usize,
    /// Image of the object's foot.
    pub foot: DVec2,
    /// Image of its tip: the point that is nearest to all rays in the sense of least squares.
    pub tip: DVec2,
    /// Whether light gets there; else the rays only seem to come from there.
    pub is_real: bool,
    /// Whether light goes on from it to a further element.
    pub is_intermediate: bool,
    /// The segments whose lines meet in the tip, each by the place of its ray in the tree.
    pub segments: Vec<(usize, SegmentId)>,
}

/// The images of all objects, in the order of the sources and along the light.
///
/// The rays of an object are followed on the way that they share, at every hit the branch that has most of their light; of
/// several lines it is the middle one. Where their lines meet between two hits, there is a real image. Behind the last hit it
/// may be virtual too. Rays that pass each other by more than a tenth of the image's height make none, and neither do parallel ones.
///
/// The foot stands by the first-order law that a plane across the axis is imaged into one across the axis, at the
/// magnification of the tip. The foot of an object that is not across the axis of the element that it faces, and of one
/// whose tip is on it, is where two neighboring rays of its own meet.
///
/// # Source
/// Hecht, "Optics", 4th ed., sections 5.2.3 and 5.4.3.
#[must_use]
pub fn images(system: &OpticalSystem, tree: &RayTree) -> Vec<Image> {
    let objects = || system.sources.iter().enumerate().filter_map(|(k, source)| Some((k, source, source.object?)));
    if objects().next().is_none() {
        return Vec::new();
    }
    let probes = trace(&probing(system, objects().map(|(_, source, object)| (source, object)))).tree;
    let rays = |tree: &RayTree, source: usize| -> Vec<usize> {
        let first = tree.rays.partition_point(|ray| ray.source < source);
        let own = tree.rays[first..].iter().take_while(|ray| ray.source == source).count();
        let lines = system.sources.get(source).map_or(1, |placed| placed.lines.len()).max(1);
        (first..first + own)
            .collect::<Vec<_>>()
            .chunks(lines)
            .filter_map(|ray| ray.get(ray.len() / 2).copied())
            .collect()
    };
    let mut images = Vec::new();
    for (number, (source, _, object)) in objects().enumerate() {
        let own = rays(tree, source);
        let probes: Vec<_> = probes.rays.iter().filter(|ray| ray.source == number).collect();
        let traced: Vec<_> = own.iter().map(|place| &tree.rays[*place]).collect();
        images.extend(Search { source, object, own, traced, probes }.images());
    }
    images
}

/// The same system with the probes of objects for its sources, each of its middle line.
fn probing<'a>(
    system: &'a OpticalSystem,
    objects: impl Iterator<Item = (&'a PlacedSource, PlacedObject)>,
) -> OpticalSystem {
    let probe = |(source, object): (&PlacedSource, PlacedObject)| {
        let line = source.lines.get(source.lines.len() / 2).copied();
        PlacedSource {
            starts: object.probes.to_vec(),
            lines: line.into_iter().collect(),
            object: None,
            ..source.clone()
        }
    };
    OpticalSystem { sources: objects.map(probe).collect(), ..system.clone() }
}

/// What the images of one object are sought in.
struct Search<'a> {
    source: usize,
    object: PlacedObject,
    /// Places of its rays in the tree, and the rays.
    own: Vec<usize>,
    traced: Vec<&'a TracedRay>,
    probes: Vec<&'a TracedRay>,
}

/// A step of the way that several rays share: how it came about, and one segment of each ray.
struct Step<'a> {
    via: Via,
    /// The body at which it began.
    body: Option<usize>,
    segments: Vec<&'a Segment>,
}

impl Search<'_> {
    fn images(&self) -> Vec<Image> {
        let way = common_way(&self.traced);
        let mut probes: Vec<Option<&Segment>> = self.probes.iter().map(|ray| ray.segments.first()).collect();
        let mut images = Vec::new();
        for (k, step) in way.iter().enumerate().skip(1) {
            for (probe, ray) in probes.iter_mut().zip(&self.probes) {
                *probe = probe.and_then(|last| child(ray, last, step.via, step.body));
            }
            images.extend(self.image(step, k + 1 == way.len(), &probes));
        }
        images
    }

    /// The image that the segments of a step make, if any.
    fn image(&self, step: &Step<'_>, is_last: bool, probes: &[Option<&Segment>]) -> Option<Image> {
        let tip = meeting(&step.segments)?;
        let along = |segment: &Segment| (tip - segment.from).dot(segment.direction);
        let is_real = step.segments.iter().all(|segment| along(segment) > 0.0);
        let is_virtual = step.segments.iter().all(|segment| along(segment) < 0.0);
        let gets_there = |segment: &&Segment| {
            segment.to.is_none_or(|to| along(segment) <= (1.0 + 1e-9) * (to - segment.from).length())
        };
        if !(is_real && step.segments.iter().all(gets_there) || is_virtual && is_last) {
            return None;
        }
        let foot = self.foot(tip, probes)?;
        let miss = |segment: &Segment| cross(segment.direction, tip - segment.from).abs();
        let spread = step.segments.iter().map(|segment| miss(segment)).fold(0.0, f64::max);
        let segments = self.own.iter().copied().zip(step.segments.iter().map(|segment| segment.id)).collect();
        let Self { source, .. } = *self;
        (spread <= SHARP * foot.distance(tip)).then_some(Image {
            source,
            foot,
            tip,
            is_real,
            is_intermediate: !is_last,
            segments,
        })
    }

    /// Image of the foot, beside that of the tip.
    fn foot(&self, tip: DVec2, probes: &[Option<&Segment>]) -> Option<DVec2> {
        let PlacedObject { foot, tip: object, axis, .. } = self.object;
        let &[on_axis, first, second] = probes else { return None };
        let across = axis.direction.perp();
        let (height, tip_height) = (object - foot, (object - axis.vertices[0]).dot(across));
        let is_upright = height.dot(axis.direction).abs() <= UPRIGHT * height.length();
        if let Some(on_axis) = on_axis.filter(|_| is_upright && tip_height.abs() > ON_AXIS * height.length()) {
            let beside = on_axis.from + on_axis.direction * (tip - on_axis.from).dot(on_axis.direction);
            let foot_height = (foot - axis.vertices[0]).dot(across);
            return Some(beside + (tip - beside) * (foot_height / tip_height));
        }
        crossing(first?, second?)
    }
}

/// The steps of the way that all rays share, from their sources on.
fn common_way<'a>(rays: &[&'a TracedRay]) -> Vec<Step<'a>> {
    let mut way: Vec<Step<'a>> = Vec::new();
    let first: Option<Vec<&Segment>> = rays.iter().map(|ray| ray.segments.first()).collect();
    let mut next =
        first.filter(|segments| segments.len() > 1).map(|segments| Step { via: Via::Source, body: None, segments });
    while let Some(step) = next {
        next = onward(rays, &step);
        way.push(step);
    }
    way
}

/// The branch behind a step that all rays have and that has most of their light.
fn onward<'a>(rays: &[&'a TracedRay], step: &Step<'a>) -> Option<Step<'a>> {
    let body = step.segments.first()?.hit?.body;
    let power = |step: &Step<'_>| step.segments.iter().map(|segment| segment.power.total()).sum::<f64>();
    let ways = [Via::Transmission, Via::TotalInternalReflection, Via::Reflection].into_iter().filter_map(|via| {
        let parts = rays.iter().zip(&step.segments).map(|(ray, last)| child(ray, last, via, Some(body)));
        Some(Step { via, body: Some(body), segments: parts.collect::<Option<_>>()? })
    });
    ways.max_by(|a, b| power(a).total_cmp(&power(b)))
}

/// The branch that came of a segment's hit on a body in one way.
fn child<'a>(ray: &'a TracedRay, last: &Segment, via: Via, body: Option<usize>) -> Option<&'a Segment> {
    let hit = last.hit?;
    let mut behind = ray.segments.iter().skip(last.id.index() + 1);
    behind.find(|segment| segment.parent == Some(last.id) && segment.via == via && Some(hit.body) == body)
}

/// The point nearest to the lines of several segments, in the sense of least squares; `None` where they are parallel.
fn meeting(segments: &[&Segment]) -> Option<DVec2> {
    let first = segments.first()?;
    let turned = segments.iter().map(|segment| cross(first.direction, segment.direction).abs()).fold(0.0, f64::max);
    if turned <= PARALLEL {
        return None;
    }
    // The normals n of the lines: Σ n n·(p − from) = 0.
    let (mut xx, mut xy, mut yy, mut right) = (0.0, 0.0, 0.0, DVec2::ZERO);
    for segment in segments {
        let n = segment.direction.perp();
        (xx, xy, yy) = (xx + n.x * n.x, xy + n.x * n.y, yy + n.y * n.y);
        right += n * n.dot(segment.from - first.from);
    }
    let apart = DVec2::new(yy * right.x - xy * right.y, xx * right.y - xy * right.x) / (xx * yy - xy * xy);
    Some(first.from + apart).filter(|p| p.is_finite())
}

/// Where the lines of two segments cross; `None` where they are parallel.
fn crossing(one: &Segment, other: &Segment) -> Option<DVec2> {
    let along = cross(other.from - one.from, other.direction) / cross(one.direction, other.direction);
    Some(one.from + along * one.direction).filter(|p| p.is_finite())
}
