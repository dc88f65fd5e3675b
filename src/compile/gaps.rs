//! Gaps between bodies too thin to be meant.

use glam::DVec2;

use crate::compile::arrangement::meeting;
use crate::geometry::{Bounds, Curve};
use crate::system::Interface;

/// The thinnest gap that a scene may mean: the shortest visible wavelength, 420 nm, with 1 unit = 1 mm.
const THINNEST: f64 = 420e-6;

/// Bodies that almost touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Gap {
    pub(crate) earlier: usize,
    pub(crate) later: usize,
    /// Smallest distance found, scene units.
    pub(crate) width: f64,
}

/// The thinnest gap of each pair of bodies, where it is thinner than light and yet no contact. What a later body covers
/// is no boundary any more and makes no gap. Distances below `near` are rounding.
pub(crate) fn gaps(interfaces: &[Interface], near: f64) -> Vec<Gap> {
    let mut found: Vec<Gap> = Vec::new();
    let boxes: Vec<_> = interfaces.iter().map(|interface| Bounds::from(&interface.curve).grown(THINNEST)).collect();
    for (i, j) in meeting(&boxes) {
        let (first, second) = (&interfaces[i], &interfaces[j]);
        let (earlier, later) = (first.body.min(second.body), first.body.max(second.body));
        let apart = (earlier != later).then(|| distance(&first.curve, &second.curve)).flatten();
        let Some(width) = apart.filter(|width| near < *width && *width < THINNEST) else { continue };
        match found.iter_mut().find(|gap| (gap.earlier, gap.later) == (earlier, later)) {
            Some(gap) => gap.width = gap.width.min(width),
            None => found.push(Gap { earlier, later, width }),
        }
    }
    found
}

/// Smallest distance from ends, middles and facing points of two curves to the other one; `None` where no such point
/// lies beside the other.
fn distance(first: &Curve, second: &Curve) -> Option<f64> {
    let to_second = probes(first, second).into_iter().filter_map(|p| beside(second, p));
    let to_first = probes(second, first).into_iter().filter_map(|p| beside(first, p));
    to_second.chain(to_first).min_by(f64::total_cmp)
}

/// Points of a curve that may come nearest to another: its ends, its middle, and where it faces the other's center.
fn probes(curve: &Curve, other: &Curve) -> Vec<DVec2> {
    let mut probes = vec![curve.a, curve.b, curve.midpoint()];
    if !curve.is_straight() {
        let radius = curve.curvature.abs().recip();
        let facing = if other.is_straight() { other.n } else { (other.center() - curve.center()).normalize_or_zero() };
        let points = [curve.center() + radius * facing, curve.center() - radius * facing];
        probes.extend(points.into_iter().filter(|p| curve.bulge_holds(*p)));
    }
    probes
}

/// Distance of a point from a curve that it lies beside.
fn beside(curve: &Curve, p: DVec2) -> Option<f64> {
    let foot = curve.project(p);
    let along = curve.along(foot);
    let between = 0.0 <= along && along <= curve.a.distance_squared(curve.b);
    let on_arc = curve.is_straight() || curve.midpoint().distance(foot) <= curve.midpoint().distance(curve.a);
    (between && on_arc).then(|| curve.offset(p).abs())
}
