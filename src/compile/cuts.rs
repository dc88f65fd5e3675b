//! Where boundaries are cut.

use std::collections::BTreeSet;

use glam::DVec2;

use crate::geometry::Curve;

/// Most cuts to be looked at one by one.
pub(crate) const FEW: usize = 16;

/// The points at which one boundary is cut, in the order in which they were found.
#[derive(Default)]
pub(crate) struct Cuts {
    points: Vec<usize>,
    /// How far along the boundary each is, as a key that sorts alike, and its place in `points`.
    sorted: BTreeSet<(u64, usize)>,
}

impl Cuts {
    /// Adds a point, which lies at `p`.
    pub(crate) fn push(&mut self, point: usize, p: DVec2, curve: &Curve) {
        self.sorted.insert((key(curve.along(p)), self.points.len()));
        self.points.push(point);
    }

    /// All points.
    pub(crate) fn all(&self) -> &[usize] {
        &self.points
    }

    /// The points that lay within `distance` of `p` when they were added, in order, and maybe others.
    pub(crate) fn near(&self, p: DVec2, distance: f64, curve: &Curve) -> Vec<usize> {
        if self.points.len() <= FEW {
            return self.points.clone();
        }
        let (along, reach) = (curve.along(p), distance * curve.a.distance(curve.b));
        let range = (key(along - reach), 0)..=(key(along + reach), usize::MAX);
        let mut places: Vec<usize> = self.sorted.range(range).map(|(_, place)| *place).collect();
        places.sort_unstable();
        places.into_iter().map(|place| self.points[place]).collect()
    }
}

/// A number that sorts as `x` does.
fn key(x: f64) -> u64 {
    let bits = (x + 0.0).to_bits();
    if x < 0.0 { !bits } else { bits | 1 << 63 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_near_a_place_are_found_in_the_order_in_which_they_came() {
        let line = Curve::line(DVec2::new(-1.0, 2.0), DVec2::new(99.0, 2.0));
        let mut cuts = Cuts::default();
        for k in (0..100).rev() {
            cuts.push(k, DVec2::new(f64::from(u32::try_from(k).unwrap()), 2.0), &line);
        }
        assert_eq!(cuts.near(DVec2::new(50.0, 2.0), 2.1, &line), [52, 51, 50, 49, 48]);
        assert_eq!(cuts.near(DVec2::new(-0.5, 2.0), 1.0, &line), [0]);
    }
}
