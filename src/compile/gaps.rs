//! Gaps between bodies too thin to be meant.

use std::collections::HashMap;

use glam::DVec2;

use crate::compile::effort::{Effort, Exhausted};
use crate::compile::lists::Lists;
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

/// How far apart the boxes of boundaries may be where they make a gap.
pub(crate) const MARGIN: f64 = 2.0 * THINNEST;

/// The thinnest gap of each pair of bodies, where it is thinner than light and yet no contact. What a later body covers
/// is no boundary any more and makes no gap. Distances below `near` are rounding.
///
/// `of_run` tells which interfaces lie on the boundaries of a run, and `neighbors` which runs come within [`MARGIN`].
pub(crate) fn gaps(
    interfaces: &[Interface],
    of_run: &[usize],
    neighbors: &Lists,
    near: f64,
    effort: &Effort,
) -> Result<Gaps, Exhausted> {
    let mut found = Gaps::default();
    for run in 0..of_run.len() - 1 {
        for i in of_run[run]..of_run[run + 1] {
            effort.check(i)?;
            let others = neighbors.of(run).iter().filter(|other| **other >= run);
            let others = others.flat_map(|other| of_run[*other]..of_run[other + 1]);
            let mut looked_at = 0;
            for j in others.filter(|j| *j > i && interfaces[*j].body != interfaces[i].body) {
                looked_at += 1;
                if let Some(width) = width(&interfaces[i], &interfaces[j]).filter(|width| near < *width) {
                    found.add(interfaces[i].body, interfaces[j].body, width);
                }
            }
            effort.spend(looked_at / 4);
        }
    }
    Ok(found)
}

/// The gap between two interfaces, if it is thin enough.
fn width(first: &Interface, second: &Interface) -> Option<f64> {
    let [one, other] = [first, second].map(|interface| Bounds::from(&interface.curve).grown(THINNEST));
    let apart = one.meets(other).then(|| distance(&first.curve, &second.curve)).flatten();
    apart.filter(|width| *width < THINNEST)
}

/// Gaps in the order in which they were found, one for a pair of bodies.
#[derive(Default)]
pub(crate) struct Gaps {
    pub(crate) list: Vec<Gap>,
    /// Whether there are more than the list may hold.
    pub(crate) has_more: bool,
    places: HashMap<[usize; 2], usize>,
}

impl Gaps {
    /// Most gaps to be told.
    pub(crate) const MOST: usize = 1000;

    fn add(&mut self, one: usize, other: usize, width: f64) {
        let (earlier, later) = (one.min(other), one.max(other));
        if let Some(place) = self.places.get(&[earlier, later]) {
            let gap = &mut self.list[*place];
            gap.width = gap.width.min(width);
        } else if self.list.len() < Self::MOST {
            self.places.insert([earlier, later], self.list.len());
            self.list.push(Gap { earlier, later, width });
        } else {
            self.has_more = true;
        }
    }
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
