use glam::DVec2;

use crate::drawing::Rect;

/// A box in scene units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Extent {
    pub(super) min: DVec2,
    pub(super) max: DVec2,
}

/// Where scene points stand in the figure: one scale on both axes, y up in the scene and down in the figure.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    /// The part of the figure that shows the scene, pixels.
    pub(super) area: Rect,
    center: DVec2,
    /// Pixels per scene unit, finite and above 0.
    scale: f64,
}

impl Extent {
    /// The box of one point.
    pub(super) fn point(p: DVec2) -> Self {
        Self { min: p, max: p }
    }

    /// The box of all finite points; `None` if there are none.
    pub(super) fn of(points: impl IntoIterator<Item = DVec2>) -> Option<Self> {
        let mut finite = points.into_iter().filter(|p| p.is_finite());
        let first = Self::point(finite.next()?);
        Some(finite.fold(first, |extent, p| extent.with(p)))
    }

    /// The box that contains a point too, if the point is finite.
    pub(super) fn with(self, p: DVec2) -> Self {
        if p.is_finite() { Self { min: self.min.min(p), max: self.max.max(p) } } else { self }
    }

    /// Two opposite corners.
    pub(super) fn ends(self) -> [DVec2; 2] {
        [self.min, self.max]
    }

    pub(super) fn center(&self) -> DVec2 {
        // Halves first: the sum of two numbers near the largest would overflow.
        0.5 * self.min + 0.5 * self.max
    }

    pub(super) fn size(&self) -> DVec2 {
        self.max - self.min
    }

    /// The same box with each side moved outward by a share of the larger extent.
    pub(super) fn padded(&self, share: f64) -> Self {
        let by = share * self.size().max_element();
        if by.is_finite() { Self { min: self.min - by, max: self.max + by } } else { *self }
    }

    /// Height of the box of the given aspect (width to height) that just holds this one.
    pub(super) fn height_at(&self, aspect: f64) -> f64 {
        (self.size().x / aspect).max(self.size().y)
    }
}

impl Frame {
    /// The frame that shows all of an extent in an area.
    pub(super) fn new(area: Rect, extent: &Extent) -> Self {
        let center = extent.center();
        let fit = area.size().max(DVec2::ONE) / extent.size();
        let mut scale = fit.min_element();
        if !(scale.is_finite() && scale > 0.0) {
            // A point, or a box beyond the numbers: show something of the size of its distance.
            let reach = center.abs().max_element();
            scale = area.size().min_element().max(1.0) / if reach > 0.0 { 0.1 * reach } else { 10.0 };
        }
        let scale = if scale.is_finite() && scale > 0.0 { scale } else { 1.0 };
        Self { area, center, scale }
    }

    /// Pixels per scene unit.
    pub(super) fn scale(&self) -> f64 {
        self.scale
    }

    /// Where a scene point stands in the figure.
    pub(super) fn place(&self, p: DVec2) -> DVec2 {
        self.area.center() + self.turn(p - self.center) * self.scale
    }

    /// A scene direction in the figure.
    pub(super) fn turn(&self, d: DVec2) -> DVec2 {
        DVec2::new(d.x, -d.y)
    }

    /// The scene box that the area shows.
    pub(super) fn shown(&self) -> Extent {
        let half = 0.5 * self.area.size() / self.scale;
        Extent { min: self.center - half, max: self.center + half }
    }
}

/// The part of `p + t d`, 0 ≤ t ≤ `end`, inside a rectangle, as its two ends; `None` if none is.
///
/// Liang and Barsky, "A new concept and method for line clipping", ACM Transactions on Graphics 3 (1984), 1-22.
pub(super) fn clip(p: DVec2, d: DVec2, end: f64, rect: &Rect) -> Option<[DVec2; 2]> {
    let (mut near, mut far) = (0.0_f64, end);
    for (p, d, min, max) in [(p.x, d.x, rect.min.x, rect.max.x), (p.y, d.y, rect.min.y, rect.max.y)] {
        if d == 0.0 {
            if !(min..=max).contains(&p) {
                return None;
            }
            continue;
        }
        let (a, b) = ((min - p) / d, (max - p) / d);
        near = near.max(a.min(b));
        far = far.min(a.max(b));
    }
    let ends = [p + near * d, p + far * d];
    (near <= far && ends.iter().all(|p| p.is_finite())).then(|| ends.map(|p| p.clamp(rect.min, rect.max)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const AREA: Rect = Rect { min: DVec2::new(10.0, 20.0), max: DVec2::new(110.0, 70.0) };

    #[test]
    fn one_scale_and_y_up() {
        let frame = Frame::new(AREA, &Extent { min: DVec2::ZERO, max: DVec2::new(10.0, 10.0) });
        assert_eq!(frame.scale(), 5.0);
        assert_eq!(frame.place(DVec2::new(5.0, 5.0)), DVec2::new(60.0, 45.0));
        assert_eq!(frame.place(DVec2::new(5.0, 10.0)), DVec2::new(60.0, 20.0));
        assert_eq!(frame.shown(), Extent { min: DVec2::new(-5.0, 0.0), max: DVec2::new(15.0, 10.0) });
    }

    #[test]
    fn a_point_and_the_largest_numbers_have_a_scale() {
        for p in [0.0, 1e-300, -3.0, 1e12, 1e300, f64::MAX] {
            let frame = Frame::new(AREA, &Extent::point(DVec2::splat(p)));
            assert!(frame.scale() > 0.0 && frame.scale().is_finite(), "{p}");
            assert_eq!(frame.place(DVec2::splat(p)), AREA.center());
        }
        let all = Extent { min: DVec2::splat(-f64::MAX), max: DVec2::splat(f64::MAX) };
        assert!(Frame::new(AREA, &all).scale() > 0.0);
    }

    #[test]
    fn clipping() {
        let ends = clip(DVec2::new(0.0, 45.0), DVec2::X, f64::INFINITY, &AREA).unwrap();
        assert_eq!(ends, [DVec2::new(10.0, 45.0), DVec2::new(110.0, 45.0)]);
        assert!(clip(DVec2::new(0.0, 45.0), DVec2::X, 5.0, &AREA).is_none());
        assert!(clip(DVec2::new(0.0, 5.0), DVec2::X, f64::INFINITY, &AREA).is_none());
        assert!(clip(DVec2::new(0.0, 45.0), DVec2::ZERO, f64::INFINITY, &AREA).is_none());
    }
}
