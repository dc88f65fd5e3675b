use std::collections::BTreeMap;

use glam::DVec2;

use crate::diagram::branches::{paths, share};
use crate::diagram::frame::Extent;
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
/// Free space around everything, as a share of the larger side.
const MARGIN: f64 = 0.04;

/// The part of the scene to show.
pub(super) fn extent(scene: &Scene, system: &OpticalSystem, tree: &RayTree, area: &Rect) -> Extent {
    if let View::Box(a, b) = scene.diagram.view {
        return Extent::point(a).with(b);
    }
    let aspect = area.size().x.max(1.0) / area.size().y.max(1.0);
    let drawn = drawn(tree, scene.diagram.faintest);
    let unlit = extensions::points(scene, tree);
    let Some(things) = Extent::of(things(scene, system, &drawn)) else {
        return Extent { min: DVec2::splat(-1.0), max: DVec2::splat(1.0) };
    };
    let focused = crossings(&drawn, &things, aspect).into_iter().chain(unlit).fold(things, Extent::with);
    tails(&drawn, focused.height_at(aspect)).fold(focused, Extent::with).padded(MARGIN)
}

type Drawn<'a> = Vec<(&'a TracedRay, &'a Segment, f64)>;

fn drawn(tree: &RayTree, faintest: f64) -> Drawn<'_> {
    let all = tree.rays.iter().flat_map(|ray| ray.segments.iter().map(move |segment| (ray, segment)));
    let shares = all.map(|(ray, segment)| (ray, segment, share(ray, segment)));
    shares.filter(|(_, _, share)| *share >= faintest).collect()
}

/// Points that must be seen: bodies, the sources' starts, hits, notes.
fn things(scene: &Scene, system: &OpticalSystem, drawn: &Drawn<'_>) -> Vec<DVec2> {
    let outlines = system.bodies().iter().flat_map(|body| &body.outlines);
    let mut points: Vec<DVec2> = outlines.flat_map(|o| &o.curves).flat_map(outline::samples).collect();
    let starts = system.sources().iter().flat_map(|source| &source.starts);
    points.extend(starts.map(|start| start.from + system.origin()));
    for (_, segment, _) in drawn {
        points.push(segment.from);
        points.extend(segment.to);
    }
    points.extend(scene.notes.iter().map(|note| note.at));
    points
}

/// Ends of escaped rays when they get a fair length; weak ones get less, spectral lines more, since they fan out slowly.
fn tails(drawn: &Drawn<'_>, height: f64) -> impl Iterator<Item = DVec2> {
    escaped(drawn).map(move |(ray, segment, share)| {
        let length = if *share >= 0.1 { 0.35 } else { 0.2 };
        let fanning = if ray.one_of_several_lines { 2.0 } else { 1.0 };
        segment.from + segment.direction * (length * fanning * height)
    })
}

/// Where neighboring rays cross after they left the bodies.
fn crossings(drawn: &Drawn<'_>, things: &Extent, aspect: f64) -> Vec<DVec2> {
    let reach = REACH * things.size().max_element();
    let beyond = 0.2 * things.height_at(aspect);
    let mut bundles: BTreeMap<(u64, String), Vec<(&TracedRay, &Segment)>> = BTreeMap::new();
    let strong = drawn.iter().filter(|(_, segment, share)| *share >= STRONG && segment.ending == Ending::Escaped);
    let mut path_of = PathOf::default();
    for (ray, segment, _) in strong {
        let key = (ray.wavelength.nanometers().to_bits(), path_of.path(ray, segment));
        bundles.entry(key).or_default().push((ray, segment));
    }
    let pairs = bundles.values().flat_map(|bundle| bundle.windows(2));
    let pairs = pairs.filter(|pair| neighbors(pair[0].0, pair[1].0));
    pairs.filter_map(|pair| meet(pair[0].1, pair[1].1, reach, beyond)).collect()
}

/// Whether two rays stand side by side in one source, or come from one point in two sources.
fn neighbors(a: &TracedRay, b: &TracedRay) -> bool {
    let start = |ray: &TracedRay| ray.segments.first().map(|segment| segment.from);
    if a.source == b.source { b.ray == a.ray + 1 } else { start(a) == start(b) }
}

/// A point a little beyond the crossing of two escaped segments.
fn meet(a: &Segment, b: &Segment, reach: f64, beyond: f64) -> Option<DVec2> {
    let turn = cross(a.direction, b.direction);
    let apart = b.from - a.from;
    let [s, t] = [cross(apart, b.direction) / turn, cross(apart, a.direction) / turn];
    let ahead = |t: f64| t > 0.0 && t <= reach;
    (ahead(s) && ahead(t)).then(|| a.from + a.direction * (s + beyond))
}

fn escaped<'a, 'b>(drawn: &'b Drawn<'a>) -> impl Iterator<Item = &'b (&'a TracedRay, &'a Segment, f64)> {
    drawn.iter().filter(|(_, segment, _)| segment.ending == Ending::Escaped)
}

/// The path letters of segments, worked out once a ray.
#[derive(Default)]
struct PathOf<'a> {
    ray: Option<&'a TracedRay>,
    paths: Vec<String>,
}

impl<'a> PathOf<'a> {
    fn path(&mut self, ray: &'a TracedRay, segment: &Segment) -> String {
        if !self.ray.is_some_and(|known| std::ptr::eq(known, ray)) {
            self.paths = paths(ray);
            self.ray = Some(ray);
        }
        self.paths.get(segment.id.index()).cloned().unwrap_or_default()
    }
}
