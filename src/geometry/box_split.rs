//! How boxes are parted that a search tree is made of.
//!
//! # Source
//! Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", IEEE Symposium on Interactive Ray Tracing 2007, for
//! the binned splits.

use glam::Vec4;

/// Bins of a split.
const BINS: usize = 16;
/// Splits deeper than this are in halves, so that no list makes a tree much deeper.
const DEEP: u32 = 32;

/// A box to be put in the tree.
#[derive(Clone, Copy)]
pub(super) struct Item {
    pub(super) place: u32,
    pub(super) flat: Flat,
}

/// A box in the tree's units: its lower ends, and its upper ends negated, so that the box around two is one minimum.
#[derive(Clone, Copy)]
pub(super) struct Flat(Vec4);

impl Flat {
    const EMPTY: Self = Self(Vec4::INFINITY);

    pub(super) fn new(min: [f32; 2], max: [f32; 2]) -> Self {
        Self(Vec4::new(min[0], min[1], -max[0], -max[1]))
    }

    /// Lower and upper end.
    pub(super) fn ends(self, axis: usize) -> [f32; 2] {
        [self.0[axis], -self.0[axis + 2]]
    }

    fn union(self, other: Self) -> Self {
        Self(self.0.min(other.0))
    }

    /// Half the circumference: the chance that a line meets the box.
    fn girth(self) -> f32 {
        let size = |axis| -(self.0[axis] + self.0[axis + 2]).min(0.0);
        size(0) + size(1)
    }

    /// Twice the center.
    fn center(self, axis: usize) -> f32 {
        self.0[axis] - self.0[axis + 2]
    }
}

pub(super) fn around(items: &[Item]) -> Flat {
    items.iter().fold(Flat::EMPTY, |all, item| all.union(item.flat))
}

/// Parts items where lines meet the fewest boxes, along the axis on which their centers spread most; in halves where that
/// would leave all on one side.
pub(super) fn split(items: &mut [Item], depth: u32) -> (&mut [Item], &mut [Item]) {
    if items.len() < 2 {
        return items.split_at_mut(items.len());
    }
    let centers = items.iter().fold(Flat::EMPTY, |all, item| {
        let center = [0, 1].map(|axis| item.flat.center(axis));
        all.union(Flat::new(center, center))
    });
    let spread = [0, 1].map(|axis| centers.ends(axis)[1] - centers.ends(axis)[0]);
    let axis = usize::from(spread[1] > spread[0]);
    let middle = items.len() / 2;
    if items.len() <= 4 || depth > DEEP || spread[axis] <= 0.0 {
        items.select_nth_unstable_by(middle, |a, b| a.flat.center(axis).total_cmp(&b.flat.center(axis)));
        return items.split_at_mut(middle);
    }
    let lowest = centers.ends(axis)[0];
    #[expect(clippy::cast_precision_loss, reason = "a small number")]
    let per_bin = BINS as f32 / spread[axis];
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at least 0 and clamped")]
    let bin = |item: &Item| (((item.flat.center(axis) - lowest) * per_bin) as usize).min(BINS - 1);
    let cut = best_cut(items, bin);
    let mut low = 0;
    for k in 0..items.len() {
        if bin(&items[k]) < cut {
            items.swap(low, k);
            low += 1;
        }
    }
    items.split_at_mut(if low == 0 || low == items.len() { middle } else { low })
}

/// The bin before which to cut.
fn best_cut(items: &[Item], bin: impl Fn(&Item) -> usize) -> usize {
    let mut bins = [(0_u32, Flat::EMPTY); BINS];
    for item in items {
        let (count, flat) = &mut bins[bin(item)];
        *count += 1;
        *flat = flat.union(item.flat);
    }
    let add = |(count, flat): (u32, Flat), (more, other): (u32, Flat)| (count + more, flat.union(other));
    #[expect(clippy::cast_precision_loss, reason = "an estimate")]
    let cost = |(count, flat): (u32, Flat)| count as f32 * flat.girth();
    // Of what lies in each bin and above it.
    let (mut above, mut costs) = ((0, Flat::EMPTY), [0.0; BINS]);
    for cut in (1..BINS).rev() {
        above = add(above, bins[cut]);
        costs[cut] = cost(above);
    }
    let (mut below, mut best, mut least) = ((0, Flat::EMPTY), 1, f32::INFINITY);
    for cut in 1..BINS {
        below = add(below, bins[cut - 1]);
        let total = cost(below) + costs[cut];
        if total < least {
            (best, least) = (cut, total);
        }
    }
    best
}
