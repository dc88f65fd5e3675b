//! The tables of `tests/truth`, and comparison with them.

use std::collections::BTreeMap;
use std::fs;

use glam::DVec2;
use serde_json::{Map, Value};
use snellius::trace::{Segment, Trace, TracedRay};

use crate::support::{root, run_text};

/// What a value may be off: an angle in degrees, a share of the power, or a length in units of the scene's size.
pub(crate) const TOLERANCE: f64 = 1e-12;

/// A row of a table.
pub(crate) struct Row {
    /// The file and the row itself, for messages.
    pub(crate) what: String,
    cells: BTreeMap<String, String>,
}

impl Row {
    pub(crate) fn text(&self, column: &str) -> &str {
        self.cells.get(column).unwrap_or_else(|| panic!("no column {column:?} in {}", self.what))
    }

    pub(crate) fn number(&self, column: &str) -> f64 {
        number(self.text(column))
    }
}

/// The rows of a table, which must be so many.
pub(crate) fn table(name: &str, count: usize) -> Vec<Row> {
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

/// The entries of a JSON file by name, which must be so many.
pub(crate) fn entries(name: &str, count: usize) -> Map<String, Value> {
    let text = fs::read_to_string(root().join("tests/truth").join(name)).unwrap();
    let Value::Object(entries) = serde_json::from_str(&text).unwrap() else { panic!("{name} holds no object") };
    assert_eq!(entries.len(), count, "{name}");
    entries
}

/// A list in a JSON object.
pub(crate) fn list<'a>(object: &'a Value, key: &str) -> &'a [Value] {
    object[key].as_array().unwrap_or_else(|| panic!("no list {key:?} in {object}"))
}

/// A text in a JSON object; `None` for null and where there is none.
pub(crate) fn text<'a>(object: &'a Value, key: &str) -> Option<&'a str> {
    object[key].as_str()
}

/// A number that a JSON object holds as text.
pub(crate) fn value(object: &Value, key: &str) -> f64 {
    number(text(object, key).unwrap_or_else(|| panic!("no number {key:?} in {object}")))
}

/// A point or vector that a JSON object holds as two numbers.
pub(crate) fn point(object: &Value, x: &str, y: &str) -> DVec2 {
    DVec2::new(value(object, x), value(object, y))
}

/// A number or a fraction such as `4/3`.
pub(crate) fn number(text: &str) -> f64 {
    match text.split_once('/') {
        Some((a, b)) => number(a) / number(b),
        None => text.parse().unwrap_or_else(|_| panic!("{text:?} is no number")),
    }
}

#[track_caller]
pub(crate) fn close(actual: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((actual - expected).abs() <= tolerance, "{what}: {actual} is not {expected}");
}

#[track_caller]
pub(crate) fn close_points(actual: DVec2, expected: DVec2, tolerance: f64, what: &str) {
    assert!(actual.distance(expected) <= tolerance, "{what}: {actual} is not {expected}");
}

/// Traces a scene's text.
pub(crate) fn traced(scene: &str) -> Trace {
    run_text(scene).trace
}

/// The branch with this path, if it was spawned.
pub(crate) fn branch<'a>(ray: &'a TracedRay, path: &str) -> Option<&'a Segment> {
    ray.segments.iter().find(|segment| path_of(ray, segment) == path)
}

/// The letters of a branch's address.
pub(crate) fn path_of(ray: &TracedRay, segment: &Segment) -> String {
    ray.address(segment.id).rsplit(':').next().unwrap().to_owned()
}
