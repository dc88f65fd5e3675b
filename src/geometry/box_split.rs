//! How boxes are parted that a search tree is made of.
//!
//! # Source
//! Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", IEEE Symposium on Interactive Ray Tracing 2007, for
//! the binned splits.

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

/// A box in the tree's units.
#[derive(Clone, Copy)]
pub(super) struct Flat {
    pub(super) min: [f32; 2],
    pub(super) max: [f32; 2],
}

impl Flat {
    const EMPTY: Self = Self { min: [f32::INFINITY; 2], max: [f32::NEG_INFINITY; 2] };

    fn union(self, other: Self) -> Self {
        Self {
            min: [0, 1].map(|axis| self.min[axis].min(other.min[axis])),
            max: [0, 1].map(|axis| self.max[axis].max(other.max[axis])),
        }
    }

    /// Half the circumference: the chance that a line meets the box.
    fn girth(self) -> f32 {
        (self.max[0] - self.min[0]).max(0.0) + (self.max[1] - self.min[1]).max(0.0)
    }

    /// Twice the center.
    fn center(self, axis: usize) -> f32 {
        self.min[axis] + self.max[axis]
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
        all.union(Flat { min: center, max: center })
    });
    let spread = [0, 1].map(|axis| centers.max[axis] - centers.min[axis]);
    let axis = usize::from(spread[1] > spread[0]);
    let middle = items.len() / 2;
    if items.len() <= 4 || depth > DEEP || spread[axis] <= 0.0 {
        items.select_nth_unstable_by(middle, |a, b| a.flat.center(axis).total_cmp(&b.flat.center(axis)));
        return items.split_at_mut(middle);
    }
    #[expect(clippy::cast_precision_loss, reason = "a small number")]
    let per_bin = BINS as f32 / spread[axis];
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at least 0 and clamped")]
    let bin = |item: &Item| (((item.flat.center(axis) - centers.min[axis]) * per_bin) as usize).min(BINS - 1);
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
    let add = |(count, flat): &mut (u32, Flat), &(more, other): &(u32, Flat)| {
        *count += more;
        *flat = flat.union(other);
        Some((*count, *flat))
    };
    let below: Vec<_> = bins.iter().scan((0, Flat::EMPTY), add).collect();
    let mut above: Vec<_> = bins.iter().rev().scan((0, Flat::EMPTY), add).collect();
    above.reverse();
    #[expect(clippy::cast_precision_loss, reason = "an estimate")]
    let cost = |(count, flat): (u32, Flat)| count as f32 * flat.girth();
    let total = |cut: &usize| cost(below[cut - 1]) + cost(above[*cut]);
    (1..BINS).min_by(|a, b| total(a).total_cmp(&total(b))).unwrap_or(1)
}
