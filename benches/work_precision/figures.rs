//! Key figures, printed as the tests print theirs; one past its bound is noted, and the run goes on to its end.

use std::process::ExitCode;

use crate::table::{Table, digits};

#[derive(Default)]
pub(crate) struct Figures {
    rows: Vec<[String; 3]>,
    missed: Vec<String>,
}

impl Figures {
    pub(crate) fn at_most(&mut self, name: &str, value: f64, bound: f64) {
        println!("FIGURE|{name}|{value:.3e}|at most|{bound:.3e}");
        self.note(name, value, format!("≤ {}", digits(bound)), value <= bound);
    }

    pub(crate) fn at_least(&mut self, name: &str, value: f64, bound: f64) {
        println!("FIGURE|{name}|{value:.3e}|at least|{bound:.3e}");
        self.note(name, value, format!("≥ {}", digits(bound)), value >= bound);
    }

    /// A figure without a bound.
    pub(crate) fn counted(&mut self, name: &str, value: f64) {
        println!("FIGURE|{name}|{value:.3e}||");
        self.note(name, value, String::new(), true);
    }

    fn note(&mut self, name: &str, value: f64, bound: String, is_met: bool) {
        if !is_met {
            println!("MISSED,{name}");
            self.missed.push(format!("{name}: {value:.3e} is not {bound}"));
        }
        self.rows.push([name.to_owned(), digits(value), bound]);
    }

    pub(crate) fn table(&self) -> Table {
        let mut table = Table::new("work_precision", &["figure", "measured", "bound"]);
        self.rows.iter().for_each(|row| table.row(row.clone()));
        table
    }

    pub(crate) fn verdict(&self) -> ExitCode {
        for missed in &self.missed {
            println!("MISSED: {missed}");
        }
        if self.missed.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
    }
}
