//! Curves of the scene as paths of the figure: arcs stay arcs unless they are too large for a renderer's numbers.

use glam::DVec2;

use crate::diagram::frame::{Frame, clip};
use crate::drawing::{Path, Rect};
use crate::geometry::Curve;

/// Arcs above this radius are drawn as chords, pixels.
const LARGEST_RADIUS: f64 = 1e6;
/// Shapes that reach farther out than this are cut to the frame first, pixels.
const FAR: f64 = 2e4;
/// Chords may leave their arc by this much, pixels.
const FLATNESS: f64 = 0.04;
/// Every halving of an arc quarters its height over the chord; forty are enough for the largest numbers.
const HALVINGS: u32 = 40;

/// Halvings that bring any arc, up to a full circle, below half a circle.
const HALVINGS_OF_A_CIRCLE: u32 = 4;

/// Points along a curve, close enough to tell its extent.
pub(super) fn samples(curve: &Curve) -> Vec<DVec2> {
    let mut pieces = vec![*curve];
    if !curve.is_straight() {
        for _ in 0..4 {
            pieces = pieces.iter().flat_map(Curve::halves).collect();
        }
    }
    pieces.iter().map(|piece| piece.a).chain([curve.b]).collect()
}

/// A connected line as a path.
pub(super) fn path(frame: &Frame, curves: &[Curve], closed: bool) -> Path {
    let Some(first) = curves.first() else { return Path::new() };
    if !curves.iter().all(|curve| is_tame(frame, curve)) {
        let points = flatten(frame, curves);
        let around = frame.area.grown(60.0);
        return if closed { Path::polygon(&cut(&points, &around)) } else { pieces(&points, &around) };
    }
    let mut path = Path::new();
    path.move_to(frame.place(first.a));
    // A straight edge back to the start is what closing draws.
    let drawn = match curves {
        [rest @ .., last] if closed && last.is_straight() => rest,
        all => all,
    };
    drawn.iter().for_each(|curve| follow(frame, curve, HALVINGS_OF_A_CIRCLE, &mut path));
    if closed {
        path.close();
    }
    path
}

/// The line as chords, pixels; far outside the frame only roughly.
pub(super) fn flatten(frame: &Frame, curves: &[Curve]) -> Vec<DVec2> {
    let mut points: Vec<DVec2> = curves.first().map(|curve| frame.place(curve.a)).into_iter().collect();
    for curve in curves {
        chords(frame, curve, HALVINGS, &mut points);
    }
    points.retain(|p| p.is_finite());
    points
}

fn is_tame(frame: &Frame, curve: &Curve) -> bool {
    let near = |p: DVec2| frame.place(p).abs().max_element() < FAR;
    near(curve.a) && near(curve.b) && (curve.is_straight() || radius(frame, curve) <= LARGEST_RADIUS)
}

fn radius(frame: &Frame, curve: &Curve) -> f64 {
    frame.scale() / curve.curvature.abs()
}

/// Draws a curve on, an arc in pieces of less than half a circle. One that `halvings` cannot bring there is smaller than
/// the rounding of its place, and a line does.
fn follow(frame: &Frame, curve: &Curve, halvings: u32, path: &mut Path) {
    let to = frame.place(curve.b);
    if curve.is_straight() || halvings == 0 {
        return path.line_to(to);
    }
    // Near half a circle a rounded radius moves the apex far more than its own error; shorter arcs do not.
    let radius = radius(frame, curve);
    if (to - frame.place(curve.a)).length() > 1.6 * radius || curve.spans_more_than_half() {
        let [first, second] = curve.halves();
        follow(frame, &first, halvings - 1, path);
        return follow(frame, &second, halvings - 1, path);
    }
    // A left turn in the scene, y up, runs against the clock on the screen.
    path.arc_to(radius, false, curve.curvature < 0.0, to);
}

fn chords(frame: &Frame, curve: &Curve, halvings: u32, points: &mut Vec<DVec2>) {
    let [a, b] = [frame.place(curve.a), frame.place(curve.b)];
    let chord = (b - a).length();
    // Only a whole arc can go farther; a half that seems to is smaller than the rounding of its place.
    let larger = halvings == HALVINGS && curve.spans_more_than_half();
    let height = chord * chord / (8.0 * radius(frame, curve));
    let seen = Rect { min: a.min(b) - chord, max: a.max(b) + chord }.overlaps(&frame.area.grown(60.0));
    if curve.is_straight() || halvings == 0 || !chord.is_finite() || (!larger && (height <= FLATNESS || !seen)) {
        points.push(b);
        return;
    }
    let halves = curve.halves();
    if !larger && halves.iter().any(|half| half.a.distance(half.b) >= curve.a.distance(curve.b)) {
        points.push(b);
        return;
    }
    for half in halves {
        chords(frame, &half, halvings - 1, points);
    }
}

/// The part of an open line near the frame, one piece a chord.
fn pieces(points: &[DVec2], around: &Rect) -> Path {
    let mut path = Path::new();
    let mut last = None;
    for pair in points.windows(2) {
        let Some([a, b]) = clip(pair[0], pair[1] - pair[0], 1.0, around) else { continue };
        if last != Some(a) {
            path.move_to(a);
        }
        path.line_to(b);
        last = Some(b);
    }
    path
}

/// The part of a polygon inside a rectangle; where it was cut its border runs along the rectangle's.
///
/// Sutherland and Hodgman, "Reentrant polygon clipping", Communications of the ACM 17 (1974), 32-42.
fn cut(points: &[DVec2], rect: &Rect) -> Vec<DVec2> {
    let sides = [(DVec2::X, rect.min.x), (-DVec2::X, -rect.max.x), (DVec2::Y, rect.min.y), (-DVec2::Y, -rect.max.y)];
    sides.into_iter().fold(points.to_vec(), |points, (inward, limit)| {
        let inside = |p: DVec2| p.dot(inward) - limit;
        let mut kept = Vec::with_capacity(points.len());
        for (i, &b) in points.iter().enumerate() {
            let a = points[if i == 0 { points.len() - 1 } else { i - 1 }];
            let (u, v) = (inside(a), inside(b));
            if (u < 0.0) != (v < 0.0) {
                kept.push(a + (b - a) * (u / (u - v)));
            }
            if v >= 0.0 {
                kept.push(b);
            }
        }
        kept.retain(|p| p.is_finite());
        kept
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagram::frame::Extent;
    use crate::drawing::PathStep;

    fn frame() -> Frame {
        let area = Rect { min: DVec2::ZERO, max: DVec2::new(100.0, 100.0) };
        Frame::new(area, &Extent { min: DVec2::splat(-1.0), max: DVec2::splat(1.0) })
    }

    #[test]
    fn half_a_circle_is_two_quarters() {
        let arc = Curve::arc(DVec2::X, DVec2::Y, -DVec2::X).unwrap();
        let path = path(&frame(), &[arc], true);
        let to = DVec2::new(50.0, 0.0);
        assert_eq!(path.steps()[1], PathStep::ArcTo { radius: 50.0, large: false, sweep: false, to });
        assert_eq!(path.steps().len(), 4);
        assert_eq!(samples(&arc).len(), 17);
    }

    #[test]
    fn the_horizon_of_a_huge_disk_crosses_the_frame() {
        let r = 1e9;
        let top = Curve::arc(DVec2::new(r, -r), DVec2::ZERO, DVec2::new(-r, -r)).unwrap();
        let bottom = Curve::arc(DVec2::new(-r, -r), DVec2::new(0.0, -2.0 * r), DVec2::new(r, -r)).unwrap();
        let path = path(&frame(), &[top, bottom], true);
        let on_horizon =
            path.steps().iter().any(|step| matches!(step, PathStep::LineTo(p) if (p.y - 50.0).abs() < 0.1));
        assert!(on_horizon, "{path:?}");
        assert!(path.steps().len() < 50);
    }

    #[test]
    fn a_far_corner_is_cut_away() {
        let corners = [DVec2::ZERO, DVec2::new(1e12, 0.0), DVec2::new(0.0, 1e12)];
        let edges: Vec<Curve> = (0..3).map(|i| Curve::line(corners[i], corners[(i + 1) % 3])).collect();
        let path = path(&frame(), &edges, true);
        for step in path.steps() {
            if let PathStep::MoveTo(p) | PathStep::LineTo(p) = step {
                assert!(p.abs().max_element() < 200.0, "{path:?}");
            }
        }
    }
}
