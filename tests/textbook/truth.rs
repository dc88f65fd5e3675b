//! Traces and the files of `tests/truth`, and comparison between them.

use std::fs;

use glam::DVec2;
use serde_json::{Map, Value};
use snellius::trace::{Segment, Trace, TracedRay};

pub(crate) use crate::support::tables::{Row, close, number, table};
use crate::support::{root, run_text};

/// What a value may be off: an angle in degrees, a share of the power, or a length in units of the scene's size.
pub(crate) const TOLERANCE: f64 = 1e-12;

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
