//! What an outline encloses.

use glam::DVec2;

use crate::geometry::{Bounds, Curve};
use crate::numerics::{cross, side};
use crate::system::MediumId;

/// The inside of a closed outline that is filled with a medium.
#[derive(Clone, Debug)]
pub(crate) struct Region {
    /// Place of the outline among all outlines; the later one fills an overlap.
    pub(crate) outline: usize,
    pub(crate) medium: MediumId,
    /// Whether the inside lies to the left of the outline's direction of travel.
    pub(crate) inside_left: bool,
    bounds: Bounds,
    /// Relative to the system's origin; arcs of at most half a circle.
    curves: Vec<Curve>,
}

impl Region {
    pub(crate) fn new(outline: usize, medium: MediumId, curves: Vec<Curve>) -> Self {
        let bounds = curves.iter().map(Bounds::from).fold(Bounds::EMPTY, Bounds::union);
        Self { outline, medium, inside_left: turns_left(&curves, bounds.center()), bounds, curves }
    }

    /// Whether a point lies inside; either answer on the outline itself.
    ///
    /// Counts the chords that a ray towards +x crosses, in exact arithmetic, and the arcs' segments that hold the point.
    pub(crate) fn contains(&self, p: DVec2) -> bool {
        self.bounds.contains(p) && self.curves.iter().filter(|curve| crosses(curve, p)).count() % 2 == 1
    }
}

/// Whether a ray from `p` towards +x crosses the curve an odd number of times.
pub(crate) fn crosses(curve: &Curve, p: DVec2) -> bool {
    let Curve { a, b, curvature, .. } = *curve;
    let turn = side(a, b, p);
    let passes = (a.y > p.y) != (b.y > p.y) && (turn > 0.0) == (b.y > a.y);
    // A point on the chord is taken where the crossing rule takes it: to its right, or above a level one.
    let left = turn > 0.0 || (turn == 0.0 && b.y - a.y == 0.0 && b.x > a.x);
    let in_segment = !curve.is_straight() && left == (curvature < 0.0) && curve.offset(p) * curvature > 0.0;
    passes != in_segment
}

/// Whether a closed outline runs counter-clockwise, by its signed area.
fn turns_left(curves: &[Curve], about: DVec2) -> bool {
    curves.iter().map(|curve| signed_area(curve, about)).sum::<f64>() > 0.0
}

/// Area that a curve sweeps about a point, positive counter-clockwise.
pub(crate) fn signed_area(curve: &Curve, about: DVec2) -> f64 {
    0.5 * cross(curve.a - about, curve.b - about) + curve.segment_area()
}

#[cfg(test)]
mod tests {
    use glam::Vec2Swizzles;

    use super::*;

    fn region(curves: Vec<Curve>) -> Region {
        Region::new(0, MediumId(0), curves)
    }

    #[test]
    fn a_crescent_holds_what_lies_between_its_arcs() {
        let (bottom, top) = (DVec2::new(0.0, -3.0), DVec2::new(0.0, 3.0));
        let crescent = region(vec![
            Curve::arc(bottom, DVec2::new(2.0, 0.0), top).unwrap(),
            Curve::arc(top, DVec2::new(1.0, 0.0), bottom).unwrap(),
        ]);
        assert!(crescent.inside_left);
        for (x, inside) in [(0.5, false), (1.5, true), (2.5, false), (-0.5, false)] {
            assert_eq!(crescent.contains(DVec2::new(x, 0.0)), inside, "x = {x}");
        }
        assert!(crescent.contains(DVec2::new(0.1, 2.9)));
    }

    #[test]
    fn a_clockwise_triangle_has_its_inside_on_the_right() {
        let [a, b, c] = [DVec2::ZERO, DVec2::Y, DVec2::X];
        let triangle = region(vec![Curve::line(a, b), Curve::line(b, c), Curve::line(c, a)]);
        assert!(!triangle.inside_left);
        assert!(triangle.contains(DVec2::splat(0.25)) && !triangle.contains(DVec2::splat(0.75)));
    }

    #[test]
    fn a_disk_holds_its_diameter() {
        let (right, left) = (DVec2::new(3.0, 2.0), DVec2::new(-1.0, 2.0));
        for (a, b) in [(right, left), (left, right), (right.yx(), left.yx()), (left.yx(), right.yx())] {
            let disk = region(vec![Curve::arc_from_bulge(a, b, 1.0), Curve::arc_from_bulge(b, a, 1.0)]);
            assert!(
                disk.contains(a.lerp(b, 0.25)) && !disk.contains(a.lerp(b, -0.25)) && !disk.contains(b.lerp(a, -0.25))
            );
        }
    }
}
