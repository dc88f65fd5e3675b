//! Competitors timed in turns.

use crate::clock::medians;
use crate::study::Study;

const MOST_ROUNDS: u32 = 301;

/// What is timed: its name, how many segments or queries a run of it takes, and the run.
pub(crate) struct Task<'a> {
    name: &'static str,
    count: u64,
    run: Box<dyn FnMut() + 'a>,
}

/// Median times of a race, by name.
pub(crate) struct Times(Vec<(&'static str, f64)>);

impl<'a> Task<'a> {
    /// What `run` gives is kept from being optimized away.
    pub(crate) fn new<T>(name: &'static str, count: u64, mut run: impl FnMut() -> T + 'a) -> Self {
        Self { name, count, run: Box::new(move || drop(std::hint::black_box(run()))) }
    }
}

/// Nanoseconds per segment of every task: the median of several rounds, of more the shorter they are, since what else the machine
/// does interrupts some runs and must not be the median.
pub(crate) fn race(study: &Study, tasks: Vec<Task<'_>>) -> Times {
    let (names, mut runs): (Vec<_>, Vec<_>) = tasks.into_iter().map(|task| ((task.name, task.count), task.run)).unzip();
    let round: f64 = medians(1, &mut runs).iter().sum();
    let (least, patience) = study.size((3, 0.3), (9, 3.0));
    let rounds = (least..MOST_ROUNDS).find(|rounds| f64::from(*rounds) * round > patience).unwrap_or(MOST_ROUNDS);
    let seconds = medians(rounds as usize, &mut runs);
    Times(names.iter().zip(seconds).map(|((name, count), seconds)| (*name, 1e9 * seconds / *count as f64)).collect())
}

impl Times {
    /// Time of a task that took part.
    pub(crate) fn of(&self, name: &str) -> f64 {
        self.get(name).unwrap()
    }

    pub(crate) fn get(&self, name: &str) -> Option<f64> {
        self.0.iter().find(|(known, _)| *known == name).map(|(_, time)| *time)
    }

    /// The shortest time of some tasks.
    pub(crate) fn least(&self, names: &[&str]) -> f64 {
        names.iter().map(|name| self.of(name)).fold(f64::INFINITY, f64::min)
    }
}
