//! Many short lists, one behind the other in one allocation.

/// Lists of indices; list k holds what belongs to the k-th of something.
#[derive(Clone, Debug)]
pub(crate) struct Lists {
    /// Where each list begins among the items, and the end of the last.
    starts: Vec<usize>,
    items: Vec<usize>,
}

impl Lists {
    /// No lists yet.
    pub(crate) fn new() -> Self {
        Self { starts: vec![0], items: Vec::new() }
    }

    /// Items by the list in which each belongs, in the order in which they come.
    pub(crate) fn sorted<I: Iterator<Item = (usize, usize)>>(count: usize, items: impl Fn() -> I) -> Self {
        let mut starts = vec![0; count + 1];
        for (list, _) in items() {
            starts[list + 1] += 1;
        }
        for k in 0..count {
            starts[k + 1] += starts[k];
        }
        let mut free = starts.clone();
        let mut sorted = vec![0; starts[count]];
        for (list, item) in items() {
            sorted[free[list]] = item;
            free[list] += 1;
        }
        Self { starts, items: sorted }
    }

    /// Puts one more item in the last list, which is not yet ended.
    pub(crate) fn push(&mut self, item: usize) {
        self.items.push(item);
    }

    /// Sorts the last list and ends it.
    pub(crate) fn end(&mut self) {
        let start = self.starts.last().copied().unwrap_or(0);
        self.items[start..].sort_unstable();
        self.starts.push(self.items.len());
    }

    /// All lists that hold something.
    pub(crate) fn filled(&self) -> impl Iterator<Item = &[usize]> {
        (0..self.starts.len() - 1).map(|list| self.of(list)).filter(|list| !list.is_empty())
    }

    /// The items of a list.
    pub(crate) fn of(&self, list: usize) -> &[usize] {
        &self.items[self.starts[list]..self.starts[list + 1]]
    }
}
