use std::collections::BTreeMap;

use glam::DVec2;

use crate::diagram::branches::{letters, share};
use crate::diagram::frame::Extent;
use crate::diagram::optics::Optics;
use crate::diagram::{extensions, outline};
use crate::drawing::Rect;
use crate::numerics::cross;
use crate::scene::{Scene, View};
use crate::system::OpticalSystem;
use crate::trace::{Ending, RayTree, Segment, TracedRay};

/// Rays below this share of their source ray do not pull the view toward where they cross.
const STRONG: f64 = 0.2;
/// A crossing farther away than this many sizes of the scene is not worth a smaller figure.
const REACH: f64 = 4.0;
/// Free space around hits, so that the frame does not cut their angle arcs, pixels.
const ARC: f64 = 34.0;
/// Free space around everything, as a share of the larger side.
const MARGIN: f64 = 0.04;

/// The part of the scene to show.
pub(super) fn extent(scene: &Scene, system: &OpticalSystem, tree: &RayTree, optics: &Optics, area: &Rect) -> Extent {
    if let View::Box(a, b) = scene.diagram.view {
        return Extent::point(a).with(b);
    }
    let aspect = area.size().x.max(1.0) / area.size().y.max(1.0);
    let Lit { all, hits, escaped } = lit(tree, scene.diagram.faintest);
    let unlit = extensions::points(scene, tree);
    let Some(things) = Extent::of(things(scene, system).into_iter().chain(all.into_iter().flat_map(Extent::ends)))
    else {
        return Extent { min: DVec2::splat(-1.0), max: DVec2::splat(1.0) };
    };
    let focused = crossings(&escaped, &things, aspect)
        .into_iter()
        .chain(unlit)
        .chain(optics.points(&things))
        .fold(things, Extent::with);
    let all = tails(&escaped, focused.height_at(aspect)).fold(focused, Extent::with).padded(MARGIN);
    hits.filter(|_| scene.diagram.angles).map_or(all, |hits| with_room_for_arcs(all, hits, area))
}

/// The extent with room around the hits for their angle arcs.
fn with_room_for_arcs(all: Extent, hits: Extent, area: &Rect) -> Extent {
    let by = DVec2::splat(ARC / (area.size() / all.size()).min_element());
    all.with(hits.min - by).with(hits.max + by)
}

/// Segments with their rays and shares of the source ray.
type Escaped<'a> = Vec<(&'a TracedRay, &'a Segment, f64)>;

/// What of the light is drawn.
#[derive(Default)]
struct Lit<'a> {
    /// The box of its segments.
    all: Option<Extent>,
    /// The box of where it turns.
    hits: Option<Extent>,
    escaped: Escaped<'a>,
}

fn lit(tree: &RayTree, faintest: f64) -> Lit<'_> {
    let mut lit = Lit::default();
    let grown = |extent: Option<Extent>, p| extent.map(|extent| extent.with(p)).or_else(|| Extent::of([p]));
    for (ray, segment) in tree.rays.iter().flat_map(|ray| ray.segments.iter().map(move |segment| (ray, segment))) {
        let share = share(ray, segment);
        if share < faintest {
            continue;
        }
        lit.all = grown(lit.all, segment.from);
        if let Some(to) = segment.to {
            lit.all = grown(lit.all, to);
            if segment.ending == Ending::Interface {
                lit.hits = grown(lit.hits, to);
            }
        }
        if segment.ending == Ending::Escaped {
            lit.escaped.push((ray, segment, share));
        }
    }
    lit
}

/// Other points that must be seen: bodies, the sources' starts, notes.
fn things(scene: &Scene, system: &OpticalSystem) -> Vec<DVec2> {
    let outlines = system.bodies().iter().flat_map(|body| &body.outlines);
    let mut points: Vec<DVec2> = outlines.flat_map(|o| &o.curves).flat_map(outline::samples).collect();
    let starts = system.sources().iter().flat_map(|source| &source.starts);
    points.extend(starts.map(|start| start.from + system.origin()));
    points.extend(system.sources().iter().filter_map(|source| source.object).map(|object| object.foot));
    points.extend(scene.notes.iter().map(|note| note.at));
    points
}

/// Ends of escaped rays when they get a fair length; weak ones get less, spectral lines more, since they fan out slowly.
fn tails(escaped: &Escaped<'_>, height: f64) -> impl Iterator<Item = DVec2> {
    escaped.iter().map(move |(ray, segment, share)| {
        let length = if *share >= 0.1 { 0.35 } else { 0.2 };
        let fanning = if ray.one_of_several_lines { 2.0 } else { 1.0 };
        segment.from + segment.direction * (length * fanning * height)
    })
}

/// Where neighboring rays cross after they left the bodies.
fn crossings(escaped: &Escaped<'_>, things: &Extent, aspect: f64) -> Vec<DVec2> {
    let reach = REACH * things.size().max_element();
    let beyond = 0.2 * things.height_at(aspect);
    let mut bundles: BTreeMap<(u64, String), Vec<(&TracedRay, &Segment)>> = BTreeMap::new();
    for (ray, segment, _) in escaped.iter().filter(|(_, _, share)| *share >= STRONG) {
        let key = (ray.wavelength.nanometers().to_bits(), letters(ray, segment.id));
        bundles.entry(key).or_default().push((ray, segment));
    }
    let pairs = bundles.values().flat_map(|bundle| bundle.windows(2));
    let pairs = pairs.filter(|pair| neighbors(pair[0].0, pair[1].0));
    pairs.filter_map(|pair| meet(pair[0].1, pair[1].1, reach, beyond)).collect()
}

/// Whether two rays stand side by side in one source, or come from one point in two sources.
fn neighbors(a: &TracedRay, b: &TracedRay) -> bool {
    let start = |ray: &TracedRay| ray.segments.first().map(|segment| segment.from);
    if a.source == b.source { a.ray.checked_add(1) == Some(b.ray) } else { start(a) == start(b) }
}

/// A point a little beyond the crossing of two escaped segments.
fn meet(a: &Segment, b: &Segment, reach: f64, beyond: f64) -> Option<DVec2> {
    let turn = cross(a.direction, b.direction);
    let apart = b.from - a.from;
    let [s, t] = [cross(apart, b.direction) / turn, cross(apart, a.direction) / turn];
    let ahead = |t: f64| t > 0.0 && t <= reach;
    (ahead(s) && ahead(t)).then(|| a.from + a.direction * (s + beyond))
}
