//! One form for edges and arcs. With apex m, unit normal n at m and curvature κ, a point p lies on the curve where
//! κ |p − m|² − 2 n·(p − m) = 0. A straight edge is κ = 0; nothing cancels when the radius grows without bound.

use glam::DVec2;

use crate::numerics::{atan, cross, sin};

/// A directed straight edge or circular arc from `a` to `b`.
///
/// `n` points to the left of the direction of travel at `m`. An arc with positive `curvature` turns left: its center
/// `m + n / curvature` lies on its left and it bulges to the right of its chord. Lengths are scene units (millimeters).
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Curve {
    /// First end.
    pub a: DVec2,
    /// Second end.
    pub b: DVec2,
    /// Signed curvature, 1/radius; 0 is straight, positive turns left.
    pub curvature: f64,
    /// A point of the curve's line or circle where `n` is the normal: the middle of an edge, the apex of a whole arc.
    pub m: DVec2,
    /// Unit normal at `m`, to the left of the direction of travel.
    pub n: DVec2,
}

impl Curve {
    /// The straight edge from `a` to `b`. Equal points give a zero normal; callers refuse them before.
    #[must_use]
    pub fn line(a: DVec2, b: DVec2) -> Self {
        Self { a, b, m: 0.5 * (a + b), n: (b - a).normalize_or_zero().perp(), curvature: 0.0 }
    }

    /// The arc from `a` to `b` that passes through a point between them; `None` where the three do not make an arc
    /// (on one line, or equal).
    #[must_use]
    pub fn arc(a: DVec2, through: DVec2, b: DVec2) -> Option<Self> {
        let (first, second) = (through - a, b - through);
        let turn = cross(first, second);
        // Half the angle between the two chords, in the form that does not cancel.
        let (lengths, dot) = (first.length() * second.length(), first.dot(second));
        let bulge = if dot >= 0.0 { turn / (lengths + dot) } else { (lengths - dot) / turn };
        if turn == 0.0 || !bulge.is_finite() || a == b {
            return None;
        }
        Some(Self::arc_from_bulge(a, b, bulge))
    }

    /// The arc from `a` to `b` whose central angle φ gives `bulge` = tan(φ/4), positive when it turns left.
    #[must_use]
    pub fn arc_from_bulge(a: DVec2, b: DVec2, bulge: f64) -> Self {
        let chord = b - a;
        let left = chord.perp();
        let length = chord.length();
        let curvature = 4.0 * bulge / ((1.0 + bulge * bulge) * length);
        Self { a, b, m: 0.5 * (a + b) - 0.5 * bulge * left, n: left / length, curvature }
    }

    /// Whether the curve is a straight edge.
    #[inline]
    #[must_use]
    pub fn is_straight(&self) -> bool {
        self.curvature == 0.0
    }

    /// The center of an arc, infinite for an edge.
    #[must_use]
    pub fn center(&self) -> DVec2 {
        self.m + self.n / self.curvature
    }

    /// The point of the curve halfway along.
    #[must_use]
    pub fn midpoint(&self) -> DVec2 {
        let (chord, middle) = (self.b - self.a, 0.5 * (self.a + self.b));
        if self.is_straight() {
            return middle;
        }
        let bent = 0.5 * chord.length() * self.curvature;
        let rest = 1.0 + (1.0 - bent * bent).max(0.0).sqrt();
        let sagitta_per_half_chord = if self.spans_more_than_half() { rest / bent } else { bent / rest };
        self.project(middle - 0.5 * sagitta_per_half_chord * chord.perp())
    }

    /// At least the sagitta of an arc of at most half a circle, c²κ/8 to c²κ/4 over a chord of length c; 0 for an edge.
    #[inline]
    pub(crate) fn sagitta_at_most(&self) -> f64 {
        // A little more, for halves of circles that rounding has made longer.
        0.250_000_1 * self.curvature.abs() * self.a.distance_squared(self.b)
    }

    /// Whether an arc goes more than half way round its circle: its center lies on the side to which it bulges.
    #[must_use]
    pub fn spans_more_than_half(&self) -> bool {
        let chord = self.b - self.a;
        // Rounding must not make half a circle more than half.
        !self.is_straight() && cross(chord, self.normal_at(self.a)) < -1e-12 * chord.length()
    }

    /// Unit normal to the left of the direction of travel at a point on the curve.
    #[inline]
    #[must_use]
    pub fn normal_at(&self, p: DVec2) -> DVec2 {
        if self.is_straight() {
            return self.n;
        }
        self.gradient(p).normalize_or(self.n)
    }

    /// Unit direction of travel at a point on the curve.
    #[must_use]
    pub fn tangent_at(&self, p: DVec2) -> DVec2 {
        -self.normal_at(p).perp()
    }

    /// Distance of a point from the curve's whole line or circle, positive on the left of the direction of travel.
    #[inline]
    #[must_use]
    pub fn offset(&self, p: DVec2) -> f64 {
        if self.is_straight() {
            return self.n.dot(p - self.m);
        }
        self.power(p) / (1.0 + self.gradient(p).length())
    }

    /// The left side of the curve's equation with the sign of [`offset`](Self::offset), 2 n·(p − m) − κ |p − m|²: about twice
    /// the offset near the curve, and more far from it.
    #[inline]
    #[must_use]
    pub fn power(&self, p: DVec2) -> f64 {
        let q = p - self.m;
        2.0 * self.n.dot(q) - self.curvature * q.length_squared()
    }

    /// Half the gradient of [`power`](Self::power): along the normal to the left, of length 1 on the curve.
    #[inline]
    fn gradient(&self, p: DVec2) -> DVec2 {
        self.n + self.curvature * (self.m - p)
    }

    /// The nearest point of the curve's whole line or circle.
    #[inline]
    #[must_use]
    pub fn project(&self, p: DVec2) -> DVec2 {
        if self.is_straight() {
            return p - self.offset(p) * self.n;
        }
        let gradient = self.gradient(p);
        let length = gradient.length();
        let normal = if length > 0.0 { gradient / length } else { self.n };
        p - self.power(p) / (1.0 + length) * normal
    }

    /// A point of the curve's line or circle if it lies between the ends, else the nearer end. For an arc of at most half
    /// a circle.
    #[inline]
    #[must_use]
    pub fn clamp(&self, p: DVec2) -> DVec2 {
        let before = self.gradient(self.a).perp_dot(p - self.a) > 0.0;
        let after = self.gradient(self.b).perp_dot(p - self.b) < 0.0;
        if !before && !after {
            p
        } else if p.distance_squared(self.a) < p.distance_squared(self.b) {
            self.a
        } else {
            self.b
        }
    }

    /// How far along the chord a point lies: grows from 0 at `a` to the squared chord at `b`, monotone along an edge
    /// and along an arc of at most half a circle.
    #[must_use]
    pub fn along(&self, p: DVec2) -> f64 {
        (p - self.a).dot(self.b - self.a)
    }

    /// Whether a point lies strictly on the side of the chord to which the arc bulges; of the circle's own points these
    /// are the arc's. Always false for an edge.
    #[must_use]
    pub fn bulge_holds(&self, p: DVec2) -> bool {
        // An arc that turns left bulges to the right of its chord.
        cross(self.b - self.a, p - self.a) * self.curvature < 0.0
    }

    /// Whether a point lies strictly between the arc and its chord; false for an edge.
    #[must_use]
    pub fn segment_holds(&self, p: DVec2) -> bool {
        self.bulge_holds(p) && self.offset(p) * self.curvature > 0.0
    }

    /// Whether two curves are parts of one line or circle, bit for bit.
    #[must_use]
    pub fn same_circle(&self, other: &Self) -> bool {
        !self.is_straight()
            && self.m == other.m
            && self.n == other.n
            && self.curvature.to_bits() == other.curvature.to_bits()
    }

    /// Length of the curve from `a` to `b`.
    #[must_use]
    pub fn length(&self) -> f64 {
        if self.is_straight() { self.a.distance(self.b) } else { self.central_angle() / self.curvature.abs() }
    }

    /// Length along the curve from `a` to a point on it.
    #[must_use]
    pub fn length_to(&self, p: DVec2) -> f64 {
        // Of ends so near that the square of their distance is 0, an arc has no angle.
        if p.distance_squared(self.a) == 0.0 { 0.0 } else { Self { b: p, ..*self }.length() }
    }

    /// Area between an arc and its chord, positive when the arc turns left; 0 for an edge.
    #[must_use]
    pub fn segment_area(&self) -> f64 {
        if self.is_straight() {
            return 0.0;
        }
        let angle = self.central_angle();
        let square = angle * angle;
        // φ − sin φ cancels for a flat arc; its series does not.
        let difference = if angle < 0.25 {
            angle * square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0 * (1.0 - square / 72.0)))
        } else {
            angle - sin(angle)
        };
        0.5 * difference / (self.curvature * self.curvature.abs())
    }

    /// Central angle of an arc in radians: φ = 4 atan(sagitta / half chord).
    fn central_angle(&self) -> f64 {
        let sagitta = self.midpoint().distance(0.5 * (self.a + self.b));
        4.0 * atan(2.0 * sagitta / self.a.distance(self.b))
    }

    /// The two halves, each with the same line or circle.
    #[must_use]
    pub fn halves(&self) -> [Self; 2] {
        let middle = self.midpoint();
        [Self { b: middle, ..*self }, Self { a: middle, ..*self }]
    }

    /// The same points, traveled the other way.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self { a: self.b, b: self.a, m: self.m, n: -self.n, curvature: -self.curvature }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() <= 1e-14 * (1.0 + a.abs())
    }

    #[test]
    fn an_arc_through_three_points_of_the_unit_circle() {
        let arc = Curve::arc(DVec2::X, DVec2::Y, -DVec2::X).unwrap();
        assert!(close(arc.curvature, 1.0));
        assert!((arc.center()).length() < 1e-15);
        assert!((arc.midpoint() - DVec2::Y).length() < 1e-15);
        assert!(close(arc.length(), std::f64::consts::PI));
        assert!(close(arc.offset(DVec2::new(0.0, 0.25)), 0.75), "left of a left turn is inside");
    }

    #[test]
    fn three_quarters_of_a_circle() {
        let arc = Curve::arc(DVec2::X, -DVec2::X, -DVec2::Y).unwrap();
        assert!(arc.spans_more_than_half());
        assert!(close(arc.length(), 1.5 * std::f64::consts::PI));
        let [first, second] = arc.halves();
        assert!(close(first.length(), 0.75 * std::f64::consts::PI));
        assert!(close(second.length(), 0.75 * std::f64::consts::PI));
    }

    #[test]
    fn a_radius_of_1e12_stays_an_arc() {
        let sagitta = 0.5e-8;
        let arc = Curve::arc(DVec2::new(-100.0, 0.0), DVec2::new(0.0, -sagitta), DVec2::new(100.0, 0.0)).unwrap();
        assert!((arc.curvature * 1e12 - 1.0).abs() < 1e-9);
        assert!(close(arc.length(), 200.0));
    }

    #[test]
    fn a_short_piece_of_a_large_arc_is_halved_on_the_piece() {
        let whole = Curve::arc(DVec2::X, -4000.0 * DVec2::Y, -DVec2::X).unwrap();
        assert!(whole.spans_more_than_half());
        assert!((whole.midpoint() - -4000.0 * DVec2::Y).length() < 1e-9, "{}", whole.midpoint());
        let [_, second] = whole.halves();
        let piece = Curve { a: whole.project(DVec2::new(-2.0, 0.0)), ..second };
        assert!(!piece.spans_more_than_half());
        assert!((piece.midpoint() - DVec2::new(-1.5, 0.0)).length() < 1e-2);
    }

    #[test]
    fn points_on_a_line_make_no_arc() {
        assert!(Curve::arc(DVec2::ZERO, DVec2::X, 2.0 * DVec2::X).is_none());
    }
}
