//! Bundles of rays about an axis: where they cross, and the closed forms of lenses that say where they must.

use glam::DVec2;
use snellius::analysis::{ObjectImage, object_images};
use snellius::scene::Light;
use snellius::trace::{Segment, TracedRay};

use crate::measure::{asin, changed, sin, tan};
use crate::support::Run;

/// All rays of the source with this name, in order.
pub(crate) fn rays<'a>(run: &'a Run, source: &str) -> Vec<&'a TracedRay> {
    let named = |other: &snellius::scene::Source| other.name.as_deref() == Some(source);
    let number = run.scene.sources.iter().position(named).unwrap_or_else(|| panic!("no source {source}"));
    run.trace.tree.rays.iter().filter(|ray| ray.source == number).collect()
}

/// The last segment of a ray that never splits.
pub(crate) fn out(ray: &TracedRay) -> &Segment {
    let splits = ray.segments.windows(2).any(|pair| pair[1].parent != Some(pair[0].id));
    assert!(!splits, "ray {} splits", ray.name());
    ray.segments.last().unwrap()
}

/// Height above `axis` at which a ray sets out.
pub(crate) fn height(ray: &TracedRay, axis: f64) -> f64 {
    ray.segments[0].from.y - axis
}

/// Rise per run of a segment.
pub(crate) fn slope(segment: &Segment) -> f64 {
    segment.direction.y / segment.direction.x
}

/// x at which a segment, extended both ways, has the height `y`.
pub(crate) fn x_at(segment: &Segment, y: f64) -> f64 {
    segment.from.x + (y - segment.from.y) / slope(segment)
}

/// y at which a segment, extended both ways, passes the place `x`.
pub(crate) fn y_at(segment: &Segment, x: f64) -> f64 {
    segment.from.y + (x - segment.from.x) * slope(segment)
}

/// Where two segments, extended both ways, meet.
pub(crate) fn meet(a: &Segment, b: &Segment) -> DVec2 {
    a.from + a.direction * ((b.from - a.from).perp_dot(b.direction) / a.direction.perp_dot(b.direction))
}

/// Distance of a point from a segment extended both ways.
pub(crate) fn distance(segment: &Segment, p: DVec2) -> f64 {
    segment.direction.perp_dot(p - segment.from).abs()
}

/// Whether a point lies ahead of a segment's start.
pub(crate) fn is_ahead(segment: &Segment, p: DVec2) -> bool {
    segment.direction.dot(p - segment.from) > 0.0
}

#[track_caller]
pub(crate) fn assert_near(actual: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((actual - expected).abs() <= tolerance, "{what}: {actual}, not {expected} within {tolerance:e}");
}

/// Largest minus smallest.
pub(crate) fn spread(values: impl IntoIterator<Item = f64>) -> f64 {
    let (least, most) = values.into_iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, m), v| (l.min(v), m.max(v)));
    most - least
}

/// The same scene with every beam narrowed to two rays at this height on both sides of its middle.
pub(crate) fn narrowed(run: &Run, half_width: f64) -> Run {
    changed(run, |scene| {
        for source in &mut scene.sources {
            if let Light::Beam { width, rays, .. } = &mut source.light {
                (*width, *rays) = (2.0 * half_width, 2);
            }
        }
    })
}

/// Focal length, and distance of the rear focus from the rear vertex, of a thick lens of relative index n: the lensmaker's
/// equation.
pub(crate) fn lensmaker(n: f64, [r1, r2]: [f64; 2], thickness: f64) -> (f64, f64) {
    let power = (n - 1.0) * (1.0 / r1 - 1.0 / r2 + (n - 1.0) * thickness / (n * r1 * r2));
    (1.0 / power, (1.0 - (n - 1.0) * thickness / (n * r1)) / power)
}

/// A spherical or plane face on the axis and what follows it.
pub(crate) struct Face {
    pub(crate) vertex: f64,
    pub(crate) radius: f64,
    pub(crate) index: f64,
}

/// Where on the axis a ray crosses that came parallel to it at height `h` out of the index 1: the trigonometric formulas
/// of A. E. Conrady, "Applied Optics and Optical Design" (1929), chapter 1, by angles U to the axis and intersections.
pub(crate) fn axis_crossing(faces: &[Face], h: f64) -> f64 {
    // Angle U toward the axis and place of the crossing; none while the ray is parallel to the axis.
    let mut ray: Option<(f64, f64)> = None;
    let mut n = 1.0;
    for Face { vertex, radius, index } in faces {
        let sin_i = match ray {
            None => h / radius,
            Some((u, crossing)) if radius.is_finite() => (crossing - vertex - radius) / radius * sin(u),
            Some((u, _)) => -sin(u),
        };
        let (i, refracted) = (asin(sin_i), asin(n / index * sin_i));
        let u = ray.map_or(0.0, |(u, _)| u) + i - refracted;
        ray = match ray {
            None if radius.is_infinite() => None,
            Some((before, crossing)) if radius.is_infinite() => {
                Some((u, vertex + (crossing - vertex) * tan(before) / tan(u)))
            }
            _ => Some((u, vertex + radius + radius * sin(refracted) / sin(u))),
        };
        n = *index;
    }
    ray.unwrap().1
}

/// Every ray of a source leaves through the crossing of the closed form.
pub(crate) fn assert_cross_as_computed(run: &Run, source: &str, axis: f64, faces: &[Face]) {
    for ray in rays(run, source).into_iter().filter(|ray| height(ray, axis) != 0.0) {
        let h = height(ray, axis);
        assert_near(x_at(out(ray), axis), axis_crossing(faces, h.abs()), 1e-9, &format!("crossing of the ray at {h}"));
    }
}

/// Where on the axis the rays of a source cross in the limit of a narrow beam.
pub(crate) fn focus(run: &Run, source: &str, axis: f64) -> f64 {
    let narrow = narrowed(run, 1e-3);
    x_at(out(rays(&narrow, source)[1]), axis)
}

/// The images of the only object.
pub(crate) fn images(run: &Run) -> Vec<ObjectImage> {
    object_images(&run.system, &run.trace.tree)
}

/// The same scene with every object shrunk toward its foot to this share of its height.
pub(crate) fn shrunk(run: &Run, share: f64) -> Run {
    changed(run, |scene| {
        for source in &mut scene.sources {
            if let Light::Object { from, to } = &mut source.light {
                *to = *from + share * (*to - *from);
            }
        }
    })
}
