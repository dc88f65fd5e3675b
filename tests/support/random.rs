//! Random numbers, the same in every run.

use glam::DVec2;

/// Steele, Lea and Flood's `SplitMix64`.
#[derive(Clone)]
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Evenly in 0 to 1.
    pub fn unit(&mut self) -> f64 {
        f64::from(u32::try_from(self.next() >> 32).unwrap()) / f64::from(u32::MAX)
    }

    pub fn below(&mut self, n: usize) -> usize {
        usize::try_from(self.next() % u64::try_from(n).unwrap()).unwrap()
    }

    /// The same number, its neighbor above or its neighbor below.
    pub fn beside(&mut self, x: f64) -> f64 {
        [x, x.next_up(), x.next_down()][self.below(3)]
    }

    pub fn beside_point(&mut self, p: DVec2) -> DVec2 {
        DVec2::new(self.beside(p.x), self.beside(p.y))
    }
}
