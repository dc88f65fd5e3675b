use glam::DVec2;
use kurbo::{Arc, Point, SvgArc, Vec2};

use crate::drawing::PathStep;

/// Largest distance of a cubic curve from the arc that it stands for, pixels before scaling.
const ARC_TOLERANCE: f64 = 0.01;

/// The cubic curves of an arc that goes on from a point, each by two control points and its end; `None` where the arc has no
/// size, or the step is none.
pub(super) fn cubics(from: DVec2, step: &PathStep) -> Option<Vec<[DVec2; 3]>> {
    let PathStep::ArcTo { radius, large, sweep, to } = *step else { return None };
    let point = |p: DVec2| Point::new(p.x, p.y);
    let radii = Vec2::new(radius, radius);
    let arc = SvgArc { from: point(from), to: point(to), radii, x_rotation: 0.0, large_arc: large, sweep };
    let mut curves = Vec::new();
    let back = |p: Point| DVec2::new(p.x, p.y);
    Arc::from_svg_arc(&arc)?.to_cubic_beziers(ARC_TOLERANCE, |c, d, p| curves.push([c, d, p].map(back)));
    Some(curves)
}
