use glam::DVec2;

use crate::drawing::pixel;

/// One step of a [`Path`], in pixels with y down.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum PathStep {
    /// Start a new piece.
    MoveTo(DVec2),
    /// Straight to a point.
    LineTo(DVec2),
    /// Along a circular arc to a point, as SVG's `A`.
    ArcTo {
        /// Radius.
        radius: f64,
        /// Whether the arc is longer than half a circle.
        large: bool,
        /// Whether it turns clockwise on the screen.
        sweep: bool,
        /// Where it ends.
        to: DVec2,
    },
    /// Straight back to the start of the piece.
    Close,
}

/// Pieces of straight lines and circular arcs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Path {
    steps: Vec<PathStep>,
}

/// An upright rectangle, y down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    /// Left upper corner.
    pub min: DVec2,
    /// Right lower corner.
    pub max: DVec2,
}

impl Path {
    /// Nothing yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// A straight line.
    #[must_use]
    pub fn line(from: DVec2, to: DVec2) -> Self {
        let mut path = Self::new();
        path.move_to(from);
        path.line_to(to);
        path
    }

    /// A closed polygon; fewer than two points give an empty path.
    #[must_use]
    pub fn polygon(points: &[DVec2]) -> Self {
        let mut path = Self::new();
        if let [first, rest @ ..] = points {
            if rest.is_empty() {
                return path;
            }
            path.move_to(*first);
            rest.iter().for_each(|p| path.line_to(*p));
            path.close();
        }
        path
    }

    /// A rectangle.
    #[must_use]
    pub fn rect(rect: Rect) -> Self {
        let Rect { min, max } = rect;
        Self::polygon(&[min, DVec2::new(max.x, min.y), max, DVec2::new(min.x, max.y)])
    }

    /// A full circle.
    #[must_use]
    pub fn circle(center: DVec2, radius: f64) -> Self {
        let across = DVec2::new(radius, 0.0);
        let mut path = Self::new();
        path.move_to(center - across);
        path.arc_to(radius, false, true, center + across);
        path.arc_to(radius, false, true, center - across);
        path.close();
        path
    }

    /// Starts a new piece.
    pub fn move_to(&mut self, p: DVec2) {
        self.steps.push(PathStep::MoveTo(point(p)));
    }

    /// Goes straight to a point.
    pub fn line_to(&mut self, p: DVec2) {
        self.steps.push(PathStep::LineTo(point(p)));
    }

    /// Goes along a circular arc to a point.
    pub fn arc_to(&mut self, radius: f64, large: bool, sweep: bool, to: DVec2) {
        self.steps.push(PathStep::ArcTo { radius: pixel(radius), large, sweep, to: point(to) });
    }

    /// Goes straight back to the start of the piece.
    pub fn close(&mut self) {
        self.steps.push(PathStep::Close);
    }

    /// Adds the pieces of another path.
    pub fn append(&mut self, other: Self) {
        self.steps.extend(other.steps);
    }

    /// The same elsewhere.
    #[must_use]
    pub fn moved(&self, by: DVec2) -> Self {
        let moved = |step: &PathStep| match *step {
            PathStep::MoveTo(p) => PathStep::MoveTo(point(p + by)),
            PathStep::LineTo(p) => PathStep::LineTo(point(p + by)),
            PathStep::ArcTo { radius, large, sweep, to } => {
                PathStep::ArcTo { radius, large, sweep, to: point(to + by) }
            }
            PathStep::Close => PathStep::Close,
        };
        Self { steps: self.steps.iter().map(moved).collect() }
    }

    /// The steps in order.
    #[must_use]
    pub fn steps(&self) -> &[PathStep] {
        &self.steps
    }

    /// Whether there is nothing to draw.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.steps.is_empty()
    }
}

impl Rect {
    /// Width and height.
    #[must_use]
    pub fn size(&self) -> DVec2 {
        self.max - self.min
    }

    /// The middle.
    #[must_use]
    pub fn center(&self) -> DVec2 {
        0.5 * (self.min + self.max)
    }

    /// The rectangle with every side moved outward, inward where `by` is negative.
    #[must_use]
    pub fn grown(&self, by: f64) -> Self {
        Self { min: self.min - by, max: self.max + by }
    }

    /// The same elsewhere.
    #[must_use]
    pub fn moved(&self, by: DVec2) -> Self {
        Self { min: self.min + by, max: self.max + by }
    }

    /// Whether a point lies in it, borders included.
    #[must_use]
    pub fn contains(&self, p: DVec2) -> bool {
        p.cmpge(self.min).all() && p.cmple(self.max).all()
    }

    /// Whether two rectangles share a point.
    #[must_use]
    pub fn overlaps(&self, other: &Self) -> bool {
        self.min.cmple(other.max).all() && other.min.cmple(self.max).all()
    }
}

fn point(p: DVec2) -> DVec2 {
    DVec2::new(pixel(p.x), pixel(p.y))
}
