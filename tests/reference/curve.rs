//! Straight edges and circular arcs: where a line crosses them, their normals, and how far a point is.

use f256::f256;

use crate::bench::coincidence;
use crate::placement::Placement;
use crate::support::wide::{Wide2, narrow, wide};

/// A directed edge, arc or whole circle.
#[derive(Clone, Copy)]
pub(crate) struct Curve {
    pub(crate) a: Wide2,
    pub(crate) b: Wide2,
    pub(crate) circle: Option<Circle>,
}

/// What an arc is part of; it turns left where its center is on the left of its direction of travel.
#[derive(Clone, Copy)]
pub(crate) struct Circle {
    pub(crate) center: Wide2,
    pub(crate) radius: f256,
    left: bool,
    whole: bool,
}

/// Where a line crosses a curve.
#[derive(Clone, Copy)]
pub(crate) struct Crossing {
    pub(crate) distance: f256,
    /// On a circle, whether the line leaves it here.
    pub(crate) exit: bool,
}

/// How a line passes a circle.
pub(crate) struct Graze {
    /// Distance along the line of its point nearest to the circle's center.
    pub(crate) along: f256,
    /// By how much the line misses the circle, negative where it cuts it.
    pub(crate) gap: f256,
}

impl Curve {
    pub(crate) fn line(a: Wide2, b: Wide2) -> Self {
        Self { a, b, circle: None }
    }

    pub(crate) fn whole(center: Wide2, radius: f256) -> Self {
        let a = center + Wide2 { x: radius, y: f256::ZERO };
        Self { a, b: a, circle: Some(Circle { center, radius, left: true, whole: true }) }
    }

    /// The arc through three points; the edge if they lie on a line.
    pub(crate) fn through(a: Wide2, through: Wide2, b: Wide2) -> Self {
        let (p, q) = (through - a, b - a);
        let twice_area = p.cross(q);
        if twice_area == f256::ZERO {
            return Self::line(a, b);
        }
        let (pp, qq) = (p.dot(p), q.dot(q));
        // The point as far from 0 as from p and q.
        let to_center = (f256::ONE / (wide(2.0) * twice_area)) * (qq * p.perp() - pp * q.perp());
        let circle =
            Circle { center: a + to_center, radius: to_center.length(), left: twice_area > f256::ZERO, whole: false };
        Self { a, b, circle: Some(circle) }
    }

    /// The arc about a center.
    pub(crate) fn about(center: Wide2, a: Wide2, b: Wide2, left: bool) -> Self {
        Self { a, b, circle: Some(Circle { center, radius: (a - center).length(), left, whole: false }) }
    }

    pub(crate) fn reversed(self) -> Self {
        let circle = self.circle.map(|circle| Circle { left: !circle.left, ..circle });
        Self { a: self.b, b: self.a, circle }
    }

    pub(crate) fn placed(self, placement: &Placement) -> Self {
        let circle = self.circle.map(|circle| Circle { center: placement.point(circle.center), ..circle });
        Self { a: placement.point(self.a), b: placement.point(self.b), circle }
    }

    /// Its ends; a whole circle has none.
    pub(crate) fn ends(&self) -> Vec<Wide2> {
        if self.circle.is_some_and(|circle| circle.whole) { vec![] } else { vec![self.a, self.b] }
    }

    /// Points between which it lies: the ends, and where an arc runs along an axis.
    pub(crate) fn extremes(&self) -> Vec<Wide2> {
        let mut points = vec![self.a, self.b];
        if let Some(Circle { center, radius, .. }) = self.circle {
            let zero = f256::ZERO;
            let axes = [(radius, zero), (-radius, zero), (zero, radius), (zero, -radius)];
            let tops = axes.map(|(x, y)| center + Wide2 { x, y });
            points.extend(tops.into_iter().filter(|p| self.holds(*p)));
        }
        points
    }

    /// Largest absolute coordinate of any of its points.
    pub(crate) fn reach(&self) -> f64 {
        self.extremes().into_iter().map(|p| p.narrow().abs().max_element()).fold(0.0, f64::max)
    }

    /// Whether a point of the line or circle is on the curve.
    pub(crate) fn holds(&self, p: Wide2) -> bool {
        let chord = self.b - self.a;
        match self.circle {
            None => {
                let along = (p - self.a).dot(chord);
                f256::ZERO <= along && along <= chord.dot(chord)
            }
            // An arc that turns left bulges to the right of its chord.
            Some(circle) => circle.whole || (chord.cross(p - self.a) <= f256::ZERO) == circle.left,
        }
    }

    /// The crossings of its whole line or circle with a line, nearest first; `d` is a unit vector.
    pub(crate) fn crossings_of_whole(&self, o: Wide2, d: Wide2) -> Vec<Crossing> {
        let Some(Circle { center, radius, .. }) = self.circle else {
            let edge = self.b - self.a;
            let across = d.cross(edge);
            let crossing = || Crossing { distance: (self.a - o).cross(edge) / across, exit: false };
            return if across == f256::ZERO { vec![] } else { vec![crossing()] };
        };
        let q = o - center;
        let middle = -d.dot(q);
        let square = radius * radius - d.cross(q) * d.cross(q);
        if square < f256::ZERO {
            return vec![];
        }
        let half = square.sqrt();
        vec![Crossing { distance: middle - half, exit: false }, Crossing { distance: middle + half, exit: true }]
    }

    /// The crossings of the curve itself with a line.
    pub(crate) fn crossings(&self, o: Wide2, d: Wide2) -> Vec<Crossing> {
        let all = self.crossings_of_whole(o, d).into_iter();
        all.filter(|crossing| self.holds(o + crossing.distance * d)).collect()
    }

    /// How a line passes the circle, if it does so beside the arc itself.
    pub(crate) fn graze(&self, o: Wide2, d: Wide2) -> Option<Graze> {
        let Circle { center, radius, .. } = self.circle?;
        let q = center - o;
        let offset = d.cross(q);
        let along = d.dot(q);
        let side = if offset > f256::ZERO { -radius } else { radius };
        let touched = center + side * d.perp();
        self.holds(touched).then(|| Graze { along, gap: offset.abs() - radius })
    }

    /// A unit normal at a point of the curve.
    pub(crate) fn normal(&self, p: Wide2) -> Wide2 {
        self.circle.map_or_else(|| (self.b - self.a).perp().unit(), |circle| (p - circle.center).unit())
    }

    /// The inverse radius, towards the center from a point of the curve.
    pub(crate) fn curvature(&self, p: Wide2) -> Wide2 {
        let towards = |circle: Circle| (f256::ONE / (circle.radius * circle.radius)) * (circle.center - p);
        self.circle.map_or(Wide2::ZERO, towards)
    }

    /// Distance from a point to the curve.
    pub(crate) fn distance(&self, p: Wide2) -> f256 {
        let to_ends = (p - self.a).length().min((p - self.b).length());
        match self.circle {
            _ if !self.may_project(p) => to_ends,
            None => (p - self.a).cross((self.b - self.a).unit()).abs(),
            Some(Circle { center, radius, .. }) => ((p - center).length() - radius).abs(),
        }
    }

    fn may_project(&self, p: Wide2) -> bool {
        // A point off the circle projects onto it along the radius.
        let foot = |circle: Circle| {
            let q = p - circle.center;
            circle.center + (circle.radius / q.length()) * q
        };
        match self.circle {
            None => self.holds(p),
            Some(circle) => (p - circle.center).dot(p - circle.center) > f256::ZERO && self.holds(foot(circle)),
        }
    }

    pub(crate) fn middle(&self) -> Wide2 {
        wide(0.5) * (self.a + self.b)
    }

    /// Whether it is an edge of no length, up to rounding.
    pub(crate) fn is_rounding(&self) -> bool {
        self.circle.is_none() && narrow((self.b - self.a).length()) <= coincidence(self.reach())
    }
}
