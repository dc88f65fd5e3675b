use std::collections::BTreeMap;

use glam::DVec2;

use crate::analysis::ObjectImage;
use crate::diagram::branches::{Branch, generation};
use crate::diagram::frame::clip;
use crate::diagram::generations::Aged;
use crate::diagram::room::{Room, centered};
use crate::diagram::{Figure, extensions};
use crate::drawing::{Anchor, Color, Fill, Item, Path, Shape, Stroke, Text};
use crate::trace::SegmentId;

const SIZE: f64 = 12.0;
/// Width of an arrow's shaft, pixels.
const WIDTH: f64 = 2.4;
/// Length of its head, pixels, where the arrow is long enough.
const HEAD: f64 = 11.0;
/// A head takes at most this share of its arrow.
const LARGEST_HEAD: f64 = 0.45;
/// Half of a head's width, as a share of its length.
const SLENDER: f64 = 0.42;
/// Free space between an arrow and its words, pixels.
const GAP: f64 = 6.0;
/// Free space between words and lines, pixels.
const OFF_LINES: f64 = 4.0;
/// More arrows would be noise.
const MOST: usize = 200;

/// An object or an image in its place in the figure.
struct Arrow {
    foot: DVec2,
    tip: DVec2,
    /// What is written beside it.
    words: Option<String>,
    color: Color,
    /// Whether light comes from its tip or gets there.
    is_real: bool,
    /// How many hits lie behind the light that shows it.
    generation: u32,
    class: &'static str,
}

/// The arrows of objects and of their images, dashed where no light gets.
pub(super) fn arrows(figure: &Figure<'_>) -> Vec<Aged> {
    let drawn =
        |arrow: &Arrow| drawn(figure, arrow).into_iter().map(|item| (arrow.generation, item)).collect::<Vec<_>>();
    all(figure).iter().flat_map(drawn).collect()
}

/// The lines from the last hits back to virtual images.
pub(super) fn lines_back(figure: &Figure<'_>) -> Vec<Aged> {
    let virtual_images: Vec<_> = figure.optics.images.iter().filter(|image| !image.is_real).take(MOST).collect();
    let blends = if virtual_images.is_empty() { BTreeMap::new() } else { extensions::blends(figure) };
    let lines = virtual_images.into_iter().flat_map(|image| image.segments.iter().map(move |segment| (image, segment)));
    let lines = lines.filter_map(|(image, (ray, id))| {
        let ray = figure.tree.rays.get(*ray)?;
        let segment = ray.segments.get(id.index())?;
        let back = (image.tip - segment.from).dot(segment.direction);
        let [from, to] = [segment.from, segment.from + back * segment.direction].map(|p| figure.frame.place(p));
        let [a, b] = clip(from, to - from, 1.0, &figure.frame.area)?;
        let blend = blends.get(&extensions::way(ray, segment)).copied().flatten();
        let stroke = figure.styles.extension(&Branch { blend, ..Branch::plain(ray, segment, [a, b]) });
        Some((generation(ray, *id), Shape::stroked(Path::line(a, b), stroke, "extension").into()))
    });
    lines.collect()
}

/// What the author calls an object, and what its images are.
pub(super) fn words(figure: &Figure<'_>, room: &mut Room) -> Vec<Aged> {
    let mut items: Vec<Aged> = Vec::new();
    for arrow in all(figure).iter().filter(|_| figure.scene.diagram.labels) {
        let Some(words) = &arrow.words else { continue };
        let color = arrow.color.toward(figure.palette.ink, 0.25);
        let text = Text::new(words, DVec2::ZERO, SIZE, color).anchored(Anchor::Middle).classed("label");
        if let Some((_, middle)) = room.best(&text, &places(arrow, &text), OFF_LINES) {
            let text = centered(&text, middle);
            room.take(text.bounds());
            items.push((arrow.generation, text.into()));
        }
    }
    items
}

/// Middles of places for an arrow's words: beyond its foot or its tip, or beside it.
fn places(arrow: &Arrow, text: &Text) -> Vec<(f64, DVec2)> {
    let along = (arrow.tip - arrow.foot).normalize_or_zero();
    let half = 0.5 * text.bounds().size();
    let off = |way: DVec2, gap: f64| way * (gap + (half * way).abs().element_sum());
    let mut places = Vec::new();
    for (step, gap) in (0..).map(f64::from).zip([GAP, 12.0, 20.0, 30.0]) {
        places.push((step, arrow.foot + off(-along, gap)));
        places.push((0.4 + step, arrow.tip + off(along, gap)));
        for (rank, share) in (0..).map(f64::from).zip([0.5, 0.75, 0.25, 1.0, 0.0]) {
            let beside = arrow.foot.lerp(arrow.tip, share);
            for way in [along.perp(), -along.perp()] {
                places.push((1.5 + 0.2 * rank + step, beside + off(way, gap)));
            }
        }
        for (end, out) in [(arrow.foot, -along), (arrow.tip, along)] {
            for way in [along.perp(), -along.perp()] {
                places.push((3.0 + step, end + off(out, gap) + 0.8 * half.x * way));
            }
        }
    }
    places
}

fn all(figure: &Figure<'_>) -> Vec<Arrow> {
    let sources = figure.system.sources().iter().enumerate();
    let objects = sources.filter_map(|(k, source)| {
        let object = source.object?;
        let [foot, tip] = [object.foot, object.tip].map(|p| figure.frame.place(p));
        let words = name(figure, k).map(str::to_owned);
        Some(Arrow { foot, tip, words, color: color(figure, k), is_real: true, generation: 0, class: "object" })
    });
    let images = figure.optics.images.iter().map(|image| {
        let [foot, tip] = [image.foot, image.tip].map(|p| figure.frame.place(p));
        let words = name(figure, image.source).map(|_| kind(image).to_owned());
        let class = if image.is_real { "image real" } else { "image virtual" };
        let last = |(ray, id): &(usize, SegmentId)| figure.tree.rays.get(*ray).map(|ray| generation(ray, *id));
        let generation = image.segments.iter().filter_map(last).max().unwrap_or(0);
        Arrow { foot, tip, words, color: color(figure, image.source), is_real: image.is_real, generation, class }
    });
    objects.take(MOST).chain(images.take(MOST)).collect()
}

fn kind(image: &ObjectImage) -> &'static str {
    match (image.is_real, image.is_intermediate) {
        (false, _) => "virtual image",
        (true, true) => "intermediate image",
        (true, false) => "image",
    }
}

fn name<'a>(figure: &'a Figure<'_>, source: usize) -> Option<&'a str> {
    figure.scene.sources.get(source)?.name.as_deref()
}

/// The source's own color, or ink.
fn color(figure: &Figure<'_>, source: usize) -> Color {
    let own = figure.scene.sources.get(source).and_then(|source| source.color);
    own.map_or(figure.palette.ink, |own| figure.palette.own_light(own))
}

/// Shaft and head.
fn drawn(figure: &Figure<'_>, arrow: &Arrow) -> Vec<Item> {
    let Arrow { foot, tip, color, class, .. } = *arrow;
    let along = (tip - foot).normalize_or_zero();
    let head = HEAD.min(LARGEST_HEAD * foot.distance(tip));
    let neck = tip - 0.8 * head * along;
    let stroke = Stroke::solid(color, WIDTH).capped(crate::drawing::Cap::Butt);
    let stroke = if arrow.is_real { stroke } else { stroke.dashed(&[6.0, 4.0]) };
    let around = figure.frame.area.grown(HEAD);
    let shaft =
        clip(foot, neck - foot, 1.0, &around).map(|[a, b]| Shape::stroked(Path::line(a, b), stroke, class).into());
    let aside = SLENDER * head * along.perp();
    let back = tip - head * along;
    let shape = Path::polygon(&[tip, back + aside, back - aside]);
    let head = around.contains(tip).then(|| Shape::filled(shape, Fill::solid(color), class).into());
    [shaft, head].into_iter().flatten().collect()
}
