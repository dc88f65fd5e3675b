//! Images of object arrows, found where the traced rays meet.

use glam::DVec2;

use crate::analysis::bundle::{Bundle, BundleRay, Focus, ImageKind};
use crate::system::{OpticalSystem, PlacedObject, PlacedSource};
use crate::trace::{RayTree, Segment, SegmentId, TracedRay, trace};

/// Rays that pass their focus farther off than this share of the image's height make no image.
const SHARP: f64 = 0.05;
/// An object that leans by less than this, radians, stands across the axis: coordinates are written with few digits.
const UPRIGHT: f64 = 0.02;
/// A tip nearer to the axis than this share of the object's height is on it.
const ON_AXIS: f64 = 1e-6;
/// Light gets as far as where it is stopped, up to this share of its way.
const ROUNDING: f64 = 1e-9;

/// The image of an object arrow, in scene coordinates.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ObjectImage {
    /// The source whose image it is, by its place in the scene.
    pub source: usize,
    /// Image of the object's foot.
    pub foot: DVec2,
    /// Image of its tip: the [focus](Bundle::focus) of the rays from there.
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
/// several lines it is the middle one. Where they meet between two hits, there is a real image. Behind the last hit it may be
/// virtual too. Rays that pass their focus farther off, in the mean square, than a twentieth of the image's height make none, and
/// neither do parallel ones.
///
/// The foot stands by the first-order law that a plane across the axis is imaged into one across the axis, at the
/// magnification of the tip. The foot of an object that is not across the axis of the element that it faces, and of one
/// whose tip is on it, is where two neighboring rays of its own meet.
///
/// # Source
/// Hecht, "Optics", 4th ed., sections 5.2.3 and 5.4.3.
#[must_use]
pub fn object_images(system: &OpticalSystem, tree: &RayTree) -> Vec<ObjectImage> {
    let objects = || system.sources.iter().enumerate().filter_map(|(k, source)| Some((k, source, source.object?)));
    if objects().next().is_none() {
        return Vec::new();
    }
    let probes = trace(&probing(system, objects().map(|(_, source, object)| (source, object)))).tree;
    let search = |(number, (source, placed, object)): (usize, (usize, &PlacedSource, PlacedObject))| {
        let own = middle_line(of_source(tree, source), placed);
        let traced = own.iter().filter_map(|place| tree.rays.get(*place)).map(Traced::new).collect();
        let probes = of_source(&probes, number).filter_map(|place| probes.rays.get(place)).map(Traced::new).collect();
        Search { source, object, own, traced, probes }.images()
    };
    objects().enumerate().flat_map(search).collect()
}

/// Places of a source's rays in a tree.
fn of_source(tree: &RayTree, source: usize) -> std::ops::Range<usize> {
    let before = |source: usize| tree.rays.partition_point(|ray| ray.source < source);
    before(source)..before(source + 1)
}

/// Of these places, those of the middle one of every ray's lines.
fn middle_line(places: std::ops::Range<usize>, placed: &PlacedSource) -> Vec<usize> {
    let lines = placed.lines.len().max(1);
    places.skip(placed.lines.len() / 2).step_by(lines).collect()
}

/// The same system with the probes of objects for its sources, each of its middle line.
fn probing<'a>(
    system: &'a OpticalSystem,
    objects: impl Iterator<Item = (&'a PlacedSource, PlacedObject)>,
) -> OpticalSystem {
    let probe = |(source, object): (&PlacedSource, PlacedObject)| {
        let line = source.lines.get(source.lines.len() / 2).copied();
        let lines = line.into_iter().collect();
        PlacedSource { starts: object.probes.to_vec(), lines, object: None, ..source.clone() }
    };
    OpticalSystem { sources: objects.map(probe).collect(), ..system.clone() }
}

/// What the images of one object are sought in.
struct Search<'a> {
    source: usize,
    object: PlacedObject,
    /// Places of its rays in the tree, and the rays.
    own: Vec<usize>,
    traced: Vec<Traced<'a>>,
    probes: Vec<Traced<'a>>,
}

/// A ray, and what begins where each of its segments ends.
struct Traced<'a> {
    ray: &'a TracedRay,
    children: Vec<Vec<&'a Segment>>,
}

/// A step of the way that several rays share.
struct Step<'a> {
    /// How it came about, in the letter of an address, and at which body; `None` at the source.
    from: Option<(char, usize)>,
    /// One of each ray.
    segments: Vec<&'a Segment>,
}

impl Search<'_> {
    fn images(&self) -> Vec<ObjectImage> {
        let way = common_way(&self.traced);
        let mut probes: Vec<Option<&Segment>> = self.probes.iter().map(|probe| probe.ray.segments.first()).collect();
        let mut images = Vec::new();
        for (k, step) in way.iter().enumerate() {
            let Some(from) = step.from else { continue };
            for (last, probe) in probes.iter_mut().zip(&self.probes) {
                *last = last.and_then(|last| probe.onward(last, from));
            }
            images.extend(self.image(step, k + 1 == way.len(), &probes));
        }
        images
    }

    /// The image that the segments of a step make, if any.
    fn image(&self, step: &Step<'_>, is_last: bool, probes: &[Option<&Segment>]) -> Option<ObjectImage> {
        let Focus { at: tip, spread, kind } = focus(self.traced.iter().zip(step.segments.iter().copied()))?;
        let gets_there = |segment: &&Segment| {
            let way = (tip - segment.from).length();
            segment.to.is_none_or(|to| way <= (1.0 + ROUNDING) * (to - segment.from).length())
        };
        let is_image = match kind {
            ImageKind::Real => step.segments.iter().all(gets_there),
            ImageKind::Virtual => is_last,
            ImageKind::Between => false,
        };
        let foot = self.foot(tip, probes).filter(|_| is_image)?;
        let segments = self.own.iter().copied().zip(step.segments.iter().map(|segment| segment.id)).collect();
        (spread <= SHARP * foot.distance(tip)).then_some(ObjectImage {
            source: self.source,
            foot,
            tip,
            is_real: kind == ImageKind::Real,
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
        let neighbors = self.probes.iter().skip(1).zip([first?, second?]);
        focus(neighbors).map(|focus| focus.at)
    }
}

fn focus<'a>(segments: impl Iterator<Item = (&'a Traced<'a>, &'a Segment)>) -> Option<Focus> {
    Bundle { rays: segments.map(|(traced, segment)| BundleRay::new(traced.ray, segment)).collect() }.focus()
}

/// The steps of the way that all rays share, from their sources on.
fn common_way<'a>(rays: &[Traced<'a>]) -> Vec<Step<'a>> {
    let first: Option<Vec<&Segment>> = rays.iter().map(|traced| traced.ray.segments.first()).collect();
    let first = first.map(|segments| Step { from: None, segments });
    let mut way: Vec<Step<'a>> = first.into_iter().collect();
    while let Some(next) = way.last().and_then(|last| strongest(rays, last)) {
        way.push(next);
    }
    way
}

/// The branch behind a step that all rays have and that has most of their light.
fn strongest<'a>(rays: &[Traced<'a>], step: &Step<'a>) -> Option<Step<'a>> {
    let body = step.segments.first()?.hit?.body;
    let power = |step: &Step<'_>| step.segments.iter().map(|segment| segment.power.total()).sum::<f64>();
    let ways = ['r', 'i', 't'].into_iter().filter_map(|letter| {
        let from = (letter, body);
        let segments = rays.iter().zip(&step.segments).map(|(traced, last)| traced.onward(last, from));
        Some(Step { from: Some(from), segments: segments.collect::<Option<_>>()? })
    });
    ways.max_by(|a, b| power(a).total_cmp(&power(b)))
}

impl<'a> Traced<'a> {
    fn new(ray: &'a TracedRay) -> Self {
        Self { ray, children: ray.children() }
    }

    /// The branch that came of a segment's hit on a body in one way.
    fn onward(&self, last: &Segment, (letter, body): (char, usize)) -> Option<&'a Segment> {
        let children = self.children.get(last.id.index()).filter(|_| last.hit.is_some_and(|hit| hit.body == body))?;
        children.iter().find(|next| next.via.letter() == Some(letter)).copied()
    }
}
