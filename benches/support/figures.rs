//! Key figures, printed as the tests print theirs; one past its bound is noted, and the run goes on to its end.

use std::process::ExitCode;

use crate::table::{Table, digits};

pub(crate) struct Figures {
    rows: Vec<[String; 4]>,
    missed: Vec<String>,
    /// Factor by which ratios may be past their bounds: above 1 where a short run says little.
    pub(crate) looseness: f64,
}

/// What a ratio is held to, and what it is meant to reach.
#[derive(Clone, Copy)]
pub(crate) enum Bound {
    AtLeast { bound: f64, goal: f64 },
    AtMost { bound: f64, goal: f64 },
}

impl Default for Figures {
    fn default() -> Self {
        Self { rows: Vec::new(), missed: Vec::new(), looseness: 1.0 }
    }
}

impl Figures {
    pub(crate) fn at_most(&mut self, name: &str, value: f64, bound: f64) {
        println!("FIGURE|{name}|{value:.3e}|at most|{bound:.3e}");
        self.note(name, value, [format!("≤ {}", digits(bound)), String::new()], value <= bound);
    }

    pub(crate) fn at_least(&mut self, name: &str, value: f64, bound: f64) {
        println!("FIGURE|{name}|{value:.3e}|at least|{bound:.3e}");
        self.note(name, value, [format!("≥ {}", digits(bound)), String::new()], value >= bound);
    }

    /// A figure without a bound.
    pub(crate) fn counted(&mut self, name: &str, value: f64) {
        println!("FIGURE|{name}|{value:.3e}||");
        self.note(name, value, [String::new(), String::new()], true);
    }

    /// One time over another.
    pub(crate) fn ratio(&mut self, name: &str, value: f64, bound: Bound) {
        println!("RATIO {name} {}", digits(value));
        let is_met = match bound {
            Bound::AtLeast { bound, .. } => value * self.looseness >= bound,
            Bound::AtMost { bound, .. } => value <= bound * self.looseness,
        };
        self.note(name, value, bound.words(), is_met);
    }

    /// A ratio that was not measured, and why.
    pub(crate) fn unmeasured(&mut self, name: &str, why: &str, bound: Bound) {
        println!("MISSED,{name}");
        self.missed.push(format!("{name} was not measured: {why}"));
        let [bound, goal] = bound.words();
        self.rows.push([name.to_owned(), String::new(), bound, goal]);
    }

    fn note(&mut self, name: &str, value: f64, [bound, goal]: [String; 2], is_met: bool) {
        if !is_met {
            println!("MISSED,{name}");
            self.missed.push(format!("{name}: {value:.3e} is not {bound}"));
        }
        self.rows.push([name.to_owned(), digits(value), bound, goal]);
    }

    /// All figures; what they are meant to reach is a column of its own where any has such a goal.
    pub(crate) fn table(&self, name: &str) -> Table {
        if self.rows.iter().all(|row| row[3].is_empty()) {
            let mut table = Table::new(name, &["figure", "measured", "bound"]);
            self.rows.iter().cloned().for_each(|[figure, measured, bound, _]| table.row([figure, measured, bound]));
            return table;
        }
        let mut table = Table::new(name, &["figure", "measured", "bound", "goal"]);
        self.rows.iter().cloned().for_each(|row| table.row(row));
        table
    }

    pub(crate) fn verdict(&self) -> ExitCode {
        for missed in &self.missed {
            println!("MISSED: {missed}");
        }
        if self.missed.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
    }
}

impl Bound {
    fn words(self) -> [String; 2] {
        match self {
            Self::AtLeast { bound, goal } => [format!("≥ {}", digits(bound)), digits(goal)],
            Self::AtMost { bound, goal } => [format!("≤ {}", digits(bound)), digits(goal)],
        }
    }
}
