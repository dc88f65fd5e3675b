//! How much may be compared to lay out a scene: outlines that come near each other everywhere take time, and memory, that
//! grows with the square of their size.

use std::cell::Cell;

/// Most comparisons of edges and outlines with each other while a scene is compiled. A scene takes some for each of its edges, and
/// more only where edges come near each other; so many take seconds and up to 2 GB of memory.
pub const MAX_COMPARISONS: u64 = 20_000_000;

/// Comparisons that are left.
pub(crate) struct Effort(Cell<u64>);

/// The comparisons are used up.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Exhausted {
    /// The place of what was to be compared with the others.
    pub(crate) at: usize,
}

impl Effort {
    pub(crate) fn new(most: u64) -> Self {
        Self(Cell::new(most))
    }

    /// Takes note of comparisons.
    pub(crate) fn spend(&self, count: usize) {
        self.0.set(self.0.get().saturating_sub(u64::try_from(count).unwrap_or(u64::MAX)));
    }

    pub(crate) fn is_spent(&self) -> bool {
        self.0.get() == 0
    }

    /// Asked before each of many things is compared with others, with its place among them.
    pub(crate) fn check(&self, at: usize) -> Result<(), Exhausted> {
        if self.is_spent() { Err(Exhausted { at }) } else { Ok(()) }
    }
}
