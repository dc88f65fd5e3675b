//! What is one, in groups.

/// Union-find over numbers from 0: the smallest of those that are one leads.
#[derive(Clone, Debug)]
pub(crate) struct Leaders(Vec<usize>);

impl Leaders {
    /// So many numbers, each by itself.
    pub(crate) fn new(count: usize) -> Self {
        Self((0..count).collect())
    }

    /// One more number, by itself.
    pub(crate) fn push(&mut self) {
        self.0.push(self.0.len());
    }

    /// The leader of a number.
    pub(crate) fn of(&self, number: usize) -> usize {
        let mut leader = number;
        while self.0[leader] != leader {
            leader = self.0[leader];
        }
        leader
    }

    /// Makes two numbers one, with all that are one with either.
    pub(crate) fn unite(&mut self, first: usize, second: usize) {
        let leaders = [first, second].map(|number| self.of(number));
        let least = leaders[0].min(leaders[1]);
        // Straight to the leader, so that no way there grows long.
        for number in [first, second, leaders[0], leaders[1]] {
            self.0[number] = least;
        }
    }
}
