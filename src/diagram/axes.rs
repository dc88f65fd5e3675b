use glam::DVec2;

use crate::diagram::Figure;
use crate::diagram::frame::clip;
use crate::diagram::optics::axes as all_axes;
use crate::drawing::{Item, Path, Shape, Stroke};
use crate::numerics::cross;

/// Of more different axes none is drawn.
const MOST: usize = 3;
/// Axes whose lines are closer than this throughout the figure are one, pixels.
const COINCIDENT: f64 = 0.5;

/// The optical axes of lenses and curved mirrors, each line once, through the whole frame.
pub(super) fn axes(figure: &Figure<'_>) -> Vec<Item> {
    let frame = &figure.frame;
    let mut lines: Vec<[DVec2; 2]> = Vec::new();
    for (_, axis) in all_axes(figure.scene) {
        let (at, along) = (frame.place(axis.vertices[0]), frame.turn(axis.direction));
        // From far outside to far outside: the frame cuts it.
        let reach = 2.0 * (frame.area.size().length() + (at - frame.area.center()).length());
        let Some(ends) = clip(at - reach * along, along, 2.0 * reach, &frame.area) else { continue };
        let along = (ends[1] - ends[0]).normalize_or_zero();
        let coincides = |[a, b]: &[DVec2; 2]| [a, b].iter().all(|p| cross(along, **p - ends[0]).abs() <= COINCIDENT);
        if !lines.iter().any(coincides) {
            lines.push(ends);
        }
        if lines.len() > MOST {
            return Vec::new();
        }
    }
    let stroke = Stroke::solid(figure.palette.quiet, 0.8).faded(0.7).dashed(&[12.0, 3.0, 2.0, 3.0]);
    lines.iter().map(|[a, b]| Shape::stroked(Path::line(*a, *b), stroke.clone(), "axis").into()).collect()
}
