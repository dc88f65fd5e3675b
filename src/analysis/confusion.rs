//! Where a bundle is narrowest.

use glam::DVec2;

use crate::analysis::bundle::{Bundle, ImageKind, PARALLEL};
use crate::numerics::{cross, dot};

/// The circle of least confusion, in the plane a stretch across the bundle's direction through which all rays pass.
///
/// # Source
/// Hecht, "Optics", 4th ed., section 6.3.1; Born & Wolf, "Principles of Optics", 7th ed., section 5.3.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Confusion {
    /// Its middle.
    pub at: DVec2,
    /// Its length, scene units.
    pub diameter: f64,
    /// Unit direction of the bundle, across which it stands.
    pub direction: DVec2,
    /// On which side of the rays' starts it lies.
    pub kind: ImageKind,
}

/// A ray's height y = `height` + `slope` x above the bundle's middle line; or the height of one ray above another.
#[derive(Clone, Copy, PartialEq)]
struct Line {
    height: f64,
    slope: f64,
}

impl Line {
    fn at(self, x: f64) -> f64 {
        self.height + self.slope * x
    }
}

/// The narrowest place of a bundle across a direction, exact but for rounding.
///
/// The width, highest ray less lowest, is convex and consists of straight pieces, and lies nowhere below one of them continued. So
/// no width is less than where a falling piece and a rising one meet. The piece that holds at that place takes the place of
/// one of them, until it is one of them.
pub(super) fn least_confusion(bundle: &Bundle, direction: DVec2) -> Option<Confusion> {
    let middle = bundle.middle();
    let lines = bundle.rays().iter().map(|ray| line(ray.from - middle, ray.direction, direction));
    let lines = lines.collect::<Option<Vec<Line>>>()?;
    let by_slope = |a: &&Line, b: &&Line| a.slope.total_cmp(&b.slope);
    let (flattest, steepest) = (*lines.iter().min_by(by_slope)?, *lines.iter().max_by(by_slope)?);
    let (mut falling, mut rising) = (difference(flattest, steepest), difference(steepest, flattest));
    if rising.slope <= PARALLEL {
        return None;
    }
    let mut x = 0.0;
    // There are not more pieces than these.
    for _ in 0..2 * lines.len() {
        x = (falling.height - rising.height) / (rising.slope - falling.slope);
        let [lowest, highest] = ends(&lines, x)?;
        let piece = difference(highest, lowest);
        if piece == falling || piece == rising {
            break;
        }
        *(if piece.slope < 0.0 { &mut falling } else { &mut rising }) = piece;
    }
    let [lowest, highest] = ends(&lines, x)?.map(|line| line.at(x));
    let at = middle + x * direction + 0.5 * (lowest + highest) * direction.perp();
    at.is_finite().then(|| Confusion { at, diameter: highest - lowest, direction, kind: bundle.kind(at) })
}

/// A ray in the bundle's frame; `None` for one that does not go forward.
fn line(from: DVec2, ray: DVec2, direction: DVec2) -> Option<Line> {
    let cos = dot(direction, ray);
    (cos > 0.0).then(|| Line { height: cross(ray, from) / cos, slope: cross(direction, ray) / cos })
}

fn difference(high: Line, low: Line) -> Line {
    Line { height: high.height - low.height, slope: high.slope - low.slope }
}

/// The lowest and the highest ray at x.
fn ends(lines: &[Line], x: f64) -> Option<[Line; 2]> {
    let by_height = |a: &&Line, b: &&Line| a.at(x).total_cmp(&b.at(x));
    Some([*lines.iter().min_by(by_height)?, *lines.iter().max_by(by_height)?])
}
