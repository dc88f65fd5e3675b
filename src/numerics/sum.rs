//! A sum that closes.

use crate::numerics::cross::sum_parts;

/// A running sum whose error does not grow with the number of terms.
///
/// # Source
/// Neumaier, "Rundungsfehleranalyse einiger Verfahren zur Summation endlicher Summen", ZAMM 54 (1974), 39-51.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sum {
    total: f64,
    lost: f64,
}

impl Sum {
    /// Adds one term.
    #[inline]
    pub fn add(&mut self, term: f64) {
        let (total, lost) = sum_parts(self.total, term);
        self.lost += lost;
        self.total = total;
    }

    /// Adds the terms of another sum.
    #[inline]
    pub fn add_sum(&mut self, other: Self) {
        self.add(other.total);
        self.lost += other.lost;
    }

    /// The sum of the terms so far; 0 for none.
    #[must_use]
    pub fn value(self) -> f64 {
        self.total + self.lost
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn recovers_what_a_plain_sum_loses() {
        let mut sum = Sum::default();
        for term in [1.0, 1e100, 1.0, -1e100] {
            sum.add(term);
        }
        assert_eq!(sum.value(), 2.0);
    }
}
