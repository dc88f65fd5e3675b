//! What an outline encloses.

use std::cmp::Reverse;

use glam::DVec2;

use crate::compile::arrangement::Boundary;
use crate::compile::effort::Effort;
use crate::compile::runs::{NODES, Runs};
use crate::geometry::{Bounds, BoxTree, Curve};
use crate::numerics::{cross, side};
use crate::system::MediumId;

/// The inside of a closed outline that is filled with a medium.
#[derive(Clone, Debug)]
pub(crate) struct Region<'a> {
    /// Place of the outline among all outlines; the later one fills an overlap.
    pub(crate) outline: usize,
    pub(crate) medium: MediumId,
    /// Whether the inside lies to the left of the outline's direction of travel.
    pub(crate) inside_left: bool,
    bounds: Bounds,
    /// Arcs of at most half a circle.
    boundaries: &'a [Boundary],
    /// Over runs of `RUN` boundaries, where there are many.
    tree: Option<BoxTree>,
}

/// Boundaries that are looked at together.
const RUN: usize = 8;
/// Most boundaries to be looked at one by one.
const FEW: usize = 64;

impl<'a> Region<'a> {
    pub(crate) fn new(medium: MediumId, boundaries: &'a [Boundary]) -> Self {
        let around = |some: &[Boundary]| some.iter().fold(Bounds::EMPTY, |all, b| all.union(Bounds::from(&b.curve)));
        let bounds = around(boundaries);
        let has_many = boundaries.len() > FEW;
        Self {
            outline: boundaries.first().map_or(0, |first| first.outline),
            medium,
            inside_left: turns_left(boundaries, bounds.center()),
            bounds,
            boundaries,
            tree: has_many.then(|| BoxTree::new(&boundaries.chunks(RUN).map(around).collect::<Vec<_>>())),
        }
    }

    /// Whether a point lies inside; either answer on the outline itself.
    ///
    /// Counts the chords that a ray towards +x crosses, in exact arithmetic, and the arcs' segments that hold the point.
    pub(crate) fn contains(&self, p: DVec2, effort: &Effort) -> bool {
        if !self.bounds.contains(p) {
            return false;
        }
        let count = |some: &[Boundary]| some.iter().filter(|boundary| crosses(&boundary.curve, p)).count();
        let Some(tree) = &self.tree else { return count(self.boundaries) % 2 == 1 };
        let (mut crossed, mut looked_at) = (0, 0);
        let nodes = tree.meeting(Bounds { min: p, max: DVec2::new(self.bounds.max.x, p.y) }, |run| {
            let first = RUN * run;
            crossed += count(&self.boundaries[first..self.boundaries.len().min(first + RUN)]);
            looked_at += 1;
        });
        effort.spend((looked_at + nodes) / NODES);
        crossed % 2 == 1
    }
}

/// All regions, in painter's order, found by where they are.
pub(crate) struct Regions<'a> {
    list: Vec<Region<'a>>,
    boundaries: &'a [Boundary],
    runs: &'a Runs,
    /// The region of each outline that has one.
    of_outline: Vec<Option<usize>>,
    /// The regions that lie about more than one run of boundaries: none of these need come near what is inside.
    large: Vec<usize>,
    tree: BoxTree,
}

impl<'a> Regions<'a> {
    /// The regions of the outlines that `media` gives one; `runs` are those of the boundaries.
    pub(crate) fn new(boundaries: &'a [Boundary], runs: &'a Runs, media: &[Option<MediumId>]) -> Self {
        let mut regions = Self {
            list: Vec::new(),
            boundaries,
            runs,
            of_outline: vec![None; media.len()],
            large: Vec::new(),
            tree: BoxTree::new(&[]),
        };
        let (mut first, mut run) = (0, 0);
        for of_outline in boundaries.chunk_by(|a, b| a.outline == b.outline) {
            while runs.range(run).end <= first {
                run += 1;
            }
            first += of_outline.len();
            let Some(medium) = media[of_outline[0].outline] else { continue };
            regions.of_outline[of_outline[0].outline] = Some(regions.list.len());
            if first > runs.range(run).end {
                regions.large.push(regions.list.len());
            }
            regions.list.push(Region::new(medium, of_outline));
        }
        regions.tree = BoxTree::new(&regions.large.iter().map(|k| regions.list[*k].bounds).collect::<Vec<_>>());
        regions
    }

    /// Puts the regions into `found` that have boundaries in some runs or whose boxes share a point with `bounds`, the last
    /// one first.
    pub(crate) fn near<'b>(&'b self, runs: &[usize], bounds: Bounds, found: &mut Vec<&'b Region<'a>>, effort: &Effort) {
        let mut places = Vec::new();
        for of_run in runs.iter().map(|run| &self.boundaries[self.runs.range(*run)]) {
            let outlines = of_run.chunk_by(|a, b| a.outline == b.outline).map(|of_outline| of_outline[0].outline);
            places.extend(outlines.filter_map(|outline| self.of_outline[outline]));
        }
        let nodes = self.tree.meeting(bounds, |k| places.push(self.large[k]));
        effort.spend((places.len() + nodes) / NODES);
        places.sort_unstable_by_key(|place| Reverse(*place));
        places.dedup();
        found.clear();
        found.extend(places.into_iter().map(|place| &self.list[place]));
    }

    /// The last region that holds a point.
    pub(crate) fn at(&self, p: DVec2, effort: &Effort) -> Option<&Region<'a>> {
        let (mut runs, mut found, here) = (Vec::new(), Vec::new(), Bounds { min: p, max: p });
        let nodes = self.runs.meeting(here, |run| runs.push(run));
        effort.spend(nodes / NODES);
        self.near(&runs, here, &mut found, effort);
        effort.spend(found.len() / NODES);
        found.into_iter().find(|region| region.contains(p, effort))
    }
}

/// Whether a ray from `p` towards +x crosses the curve an odd number of times.
pub(crate) fn crosses(curve: &Curve, p: DVec2) -> bool {
    let Curve { a, b, curvature, .. } = *curve;
    let turn = side(a, b, p);
    let passes = (a.y > p.y) != (b.y > p.y) && (turn > 0.0) == (b.y > a.y);
    // A point on the chord is taken where the crossing rule takes it: to its right, or above a level one.
    let left = turn > 0.0 || (turn == 0.0 && b.y - a.y == 0.0 && b.x > a.x);
    let in_segment = !curve.is_straight() && left == (curvature < 0.0) && curve.offset(p) * curvature > 0.0;
    passes != in_segment
}

/// Whether a closed outline runs counter-clockwise, by its signed area.
fn turns_left(boundaries: &[Boundary], about: DVec2) -> bool {
    boundaries.iter().map(|boundary| signed_area(&boundary.curve, about)).sum::<f64>() > 0.0
}

/// Area that a curve sweeps about a point, positive counter-clockwise.
pub(crate) fn signed_area(curve: &Curve, about: DVec2) -> f64 {
    0.5 * cross(curve.a - about, curve.b - about) + curve.segment_area()
}

#[cfg(test)]
mod tests {
    use glam::Vec2Swizzles;

    use super::*;

    const MOST: u64 = 1_000_000;

    fn boundaries(curves: &[Curve]) -> Vec<Boundary> {
        curves.iter().map(|curve| Boundary { curve: *curve, reach: 1.0, outline: 0, along: 0.0 }).collect()
    }

    #[test]
    fn a_crescent_holds_what_lies_between_its_arcs() {
        let (bottom, top) = (DVec2::new(0.0, -3.0), DVec2::new(0.0, 3.0));
        let outline = boundaries(&[
            Curve::arc(bottom, DVec2::new(2.0, 0.0), top).unwrap(),
            Curve::arc(top, DVec2::new(1.0, 0.0), bottom).unwrap(),
        ]);
        let crescent = Region::new(MediumId(0), &outline);
        assert!(crescent.inside_left);
        for (x, inside) in [(0.5, false), (1.5, true), (2.5, false), (-0.5, false)] {
            assert_eq!(crescent.contains(DVec2::new(x, 0.0), &Effort::new(MOST)), inside, "x = {x}");
        }
        assert!(crescent.contains(DVec2::new(0.1, 2.9), &Effort::new(MOST)));
    }

    #[test]
    fn a_clockwise_triangle_has_its_inside_on_the_right() {
        let [a, b, c] = [DVec2::ZERO, DVec2::Y, DVec2::X];
        let outline = boundaries(&[Curve::line(a, b), Curve::line(b, c), Curve::line(c, a)]);
        let triangle = Region::new(MediumId(0), &outline);
        assert!(!triangle.inside_left);
        assert!(
            triangle.contains(DVec2::splat(0.25), &Effort::new(MOST))
                && !triangle.contains(DVec2::splat(0.75), &Effort::new(MOST))
        );
    }

    #[test]
    fn a_disk_holds_its_diameter() {
        let (right, left) = (DVec2::new(3.0, 2.0), DVec2::new(-1.0, 2.0));
        for (a, b) in [(right, left), (left, right), (right.yx(), left.yx()), (left.yx(), right.yx())] {
            let outline = boundaries(&[Curve::arc_from_bulge(a, b, 1.0), Curve::arc_from_bulge(b, a, 1.0)]);
            let disk = Region::new(MediumId(0), &outline);
            assert!(
                disk.contains(a.lerp(b, 0.25), &Effort::new(MOST))
                    && !disk.contains(a.lerp(b, -0.25), &Effort::new(MOST))
                    && !disk.contains(b.lerp(a, -0.25), &Effort::new(MOST))
            );
        }
    }

    #[test]
    fn an_outline_of_many_arcs_holds_what_lies_inside() {
        let corner = |k: u32| f64::from(2 + k % 2) * crate::numerics::Turn::degrees(0.5 * f64::from(k)).direction();
        let arc = |k: u32| {
            Curve::arc_from_bulge(corner(k), corner((k + 1) % 720), if k.is_multiple_of(3) { 0.2 } else { -0.1 })
        };
        let outline = boundaries(&(0..720).map(arc).collect::<Vec<_>>());
        let star = Region::new(MediumId(0), &outline);
        let plain = Region { tree: None, ..star.clone() };
        for k in 0..900 {
            let p = DVec2::new(f64::from(k % 30), f64::from(k / 30)) * 0.2 - 3.0;
            assert_eq!(star.contains(p, &Effort::new(MOST)), plain.contains(p, &Effort::new(MOST)), "{p}");
        }
        assert!(star.contains(DVec2::ZERO, &Effort::new(MOST)));
    }
}
