//! The tables of `tests/truth`, and comparison with them.

use std::collections::BTreeMap;

use super::root;

/// A row of a table.
pub struct Row {
    /// The file and the row itself, for messages.
    pub what: String,
    cells: BTreeMap<String, String>,
}

impl Row {
    pub fn text(&self, column: &str) -> &str {
        self.cells.get(column).unwrap_or_else(|| panic!("no column {column:?} in {}", self.what))
    }

    pub fn number(&self, column: &str) -> f64 {
        number(self.text(column))
    }
}

/// The rows of a table, which must be so many.
pub fn table(name: &str, count: usize) -> Vec<Row> {
    let mut reader = csv::Reader::from_path(root().join("tests/truth").join(name)).unwrap();
    let columns: Vec<_> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    let row = |record: csv::StringRecord| Row {
        what: format!("{name}: {}", record.iter().collect::<Vec<_>>().join(",")),
        cells: columns.iter().cloned().zip(record.iter().map(str::to_owned)).collect(),
    };
    let rows: Vec<_> = reader.records().map(|record| row(record.unwrap())).collect();
    assert_eq!(rows.len(), count, "{name}");
    rows
}

/// A number or a fraction such as `4/3`.
pub fn number(text: &str) -> f64 {
    match text.split_once('/') {
        Some((a, b)) => number(a) / number(b),
        None => text.parse().unwrap_or_else(|_| panic!("{text:?} is no number")),
    }
}

#[track_caller]
pub fn close(actual: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((actual - expected).abs() <= tolerance, "{what}: {actual} is not {expected}");
}
