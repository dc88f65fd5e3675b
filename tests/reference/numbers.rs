//! The scene's numbers as they are given, and disturbed as rounding disturbs them.

use f256::f256;

use crate::support::wide::{power_of_two, wide};

/// Sign patterns of disturbances, so that what cancels in one does not in another.
pub(crate) const PATTERNS: usize = 8;

/// What the numbers of a scene are read with: state 0 takes them as they are, the others change each by 2^-60 of itself,
/// lengths by no more than 2^-60 of the scene's size; equal numbers by the same.
#[derive(Clone, Copy)]
pub(crate) struct Numbers {
    pub(crate) state: usize,
    pub(crate) size: f64,
}

impl Numbers {
    /// A coordinate, length or radius.
    pub(crate) fn length(&self, x: f64) -> f256 {
        self.changed(wide(x), wide(x.abs().min(self.size)))
    }

    /// An angle or an index.
    pub(crate) fn number(&self, x: f256) -> f256 {
        self.changed(x, x)
    }

    fn changed(&self, x: f256, by: f256) -> f256 {
        let Some(pattern) = self.state.checked_sub(1) else { return x };
        let change = power_of_two(-60) * by;
        if hash(x, pattern) { x + change } else { x - change }
    }
}

/// A sign that is as good as random.
fn hash(x: f256, pattern: usize) -> bool {
    let (high, low) = x.abs().to_bits();
    let folded = high ^ (high >> 64) ^ low ^ (low >> 64);
    let bits = u64::try_from(folded & u128::from(u64::MAX)).unwrap().wrapping_mul(0x9e37_79b9_7f4a_7c15);
    (bits >> (40 + pattern)) & 1 == 0
}
