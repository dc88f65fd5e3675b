//! How much a path amplifies what it is disturbed by: the same path is followed several times beside itself, with the
//! start and every hit displaced across the ray by 2^-60 of the scene's size, the direction turned by 2^-60 there, powers
//! and optical paths changed by 2^-60 of themselves, among walls and indices of disturbed numbers, each time with other
//! signs.

use f256::f256;

use crate::bench::Wall;
use crate::curve::Curve;
use crate::numbers::{Numbers, PATTERNS};
use crate::support::wide::{Wide2, narrow, power_of_two, wide};

/// Light on its way.
#[derive(Clone, Copy)]
pub(crate) struct State {
    pub(crate) p: Wide2,
    pub(crate) d: Wide2,
    pub(crate) power: [f256; 2],
    pub(crate) path: f256,
}

/// What disturbs a state.
#[derive(Clone, Copy)]
pub(crate) struct Nudge {
    sideways: f256,
    turn: f256,
    numbers: Numbers,
}

/// The true state, and beside it the disturbed ones.
#[derive(Clone)]
pub(crate) struct Bundle {
    pub(crate) states: Vec<State>,
    size: f64,
    hits: u32,
    /// Whether left and right have changed sides, by an odd number of reflections.
    mirrored: bool,
}

impl Nudge {
    pub(crate) const NONE: Self =
        Self { sideways: f256::ZERO, turn: f256::ZERO, numbers: Numbers { state: 0, size: 0.0 } };

    /// The last signs add up along a path, as a turn to the left is one to the right after a reflection; the others are equal
    /// or change with the hits.
    fn new(state: usize, hits: u32, mirrored: bool, size: f64) -> Self {
        let Some(pattern) = state.checked_sub(1) else { return Self::NONE };
        let smallest = power_of_two(-60);
        let flips = [false, hits % 2 == 1, hits % 4 >= 2, mirrored][pattern / 2];
        let sideways = if flips { -smallest } else { smallest };
        let turn = if pattern % 2 == 1 { -sideways } else { sideways };
        Self { sideways, turn, numbers: Numbers { state, size } }
    }

    /// A point displaced across a direction.
    pub(crate) fn point(&self, p: Wide2, d: Wide2) -> Wide2 {
        p + (self.sideways * wide(self.numbers.size)) * d.perp()
    }

    pub(crate) fn direction(&self, d: Wide2) -> Wide2 {
        (d + self.turn * d.perp()).unit()
    }

    /// A power or a length.
    pub(crate) fn number(&self, x: f256) -> f256 {
        x + self.sideways * x
    }

    /// An index.
    pub(crate) fn index(&self, n: f256) -> f256 {
        self.numbers.number(n)
    }

    /// Where a wall runs.
    pub(crate) fn curve<'a>(&self, wall: &'a Wall) -> &'a Curve {
        &wall.curves[self.numbers.state]
    }
}

impl Bundle {
    pub(crate) fn new(start: State, size: f64) -> Self {
        let nudged = |state| {
            let nudge = Nudge::new(state, 0, false, size);
            State { p: nudge.point(start.p, start.d), d: nudge.direction(start.d), ..start }
        };
        Self { states: (0..=PATTERNS).map(nudged).collect(), size, hits: 0, mirrored: false }
    }

    pub(crate) fn truth(&self) -> &State {
        &self.states[0]
    }

    /// Every state where it arrives; `None` where a disturbed one does not share the way.
    pub(crate) fn at_hit(&self, next: impl Fn(&State, &Nudge) -> Option<State>) -> Option<Self> {
        let nudged = self.states.iter().enumerate();
        let states = nudged.map(|(k, state)| next(state, &self.nudge(k))).collect::<Option<_>>()?;
        Some(Self { states, ..*self })
    }

    /// Every state after a hit, reflected or transmitted; `None` as at it.
    pub(crate) fn after_hit(&self, reflected: bool, next: impl Fn(&State, &Nudge) -> Option<State>) -> Option<Self> {
        let turned = Self { mirrored: self.mirrored != reflected, ..self.clone() };
        Some(Self { hits: self.hits + 1, ..turned.at_hit(next)? })
    }

    /// What disturbs a state at the next hit.
    fn nudge(&self, state: usize) -> Nudge {
        Nudge::new(state, self.hits + 1, self.mirrored, self.size)
    }

    /// Largest deviation of a number from its true one.
    pub(crate) fn deviation(&self, number: impl Fn(&State) -> f256) -> f256 {
        self.nudged_deviation(|state, _| number(state))
    }

    /// The same, of a number that what disturbs the next hit has a part in.
    pub(crate) fn nudged_deviation(&self, number: impl Fn(&State, &Nudge) -> f256) -> f256 {
        let truth = number(self.truth(), &Nudge::NONE);
        let states = self.states.iter().enumerate();
        states.map(|(k, state)| (number(state, &self.nudge(k)) - truth).abs()).fold(f256::ZERO, f256::max)
    }

    fn spread(&self, vector: impl Fn(&State) -> Wide2) -> f256 {
        let truth = vector(self.truth());
        self.states.iter().map(|state| (vector(state) - truth).length()).fold(f256::ZERO, f256::max)
    }

    /// Deviation against a disturbance, at least 1.
    fn condition(deviation: f256, of: f256) -> f64 {
        narrow(deviation / (power_of_two(-60) * of)).max(1.0)
    }

    pub(crate) fn of_position(&self) -> f64 {
        Self::condition(self.spread(|state| state.p), wide(self.size))
    }

    pub(crate) fn of_direction(&self) -> f64 {
        Self::condition(self.spread(|state| state.d), f256::ONE)
    }

    pub(crate) fn of_path(&self) -> f64 {
        Self::condition(self.deviation(|state| state.path), wide(self.size))
    }

    /// Of the powers as shares of `whole`.
    pub(crate) fn of_power(&self, whole: f256) -> f64 {
        let of = |k: usize| self.deviation(|state| state.power[k]);
        Self::condition(of(0).max(of(1)), whole)
    }
}
