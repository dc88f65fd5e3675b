//! The reference of the trace names every field, column and ending.

use std::collections::BTreeSet;

use serde_json::Value;
use snellius::trace::Ending;

use crate::commands::{folder, run};
use crate::page::{Page, first_cells};

const TRACE_FORMAT: &str = "docs/trace-format.md";

/// The JSON trace and the summary of the first scene of the page.
fn traces(page: &Page) -> [Value; 2] {
    let folder = folder(page);
    ["json", "summary"].map(|format| {
        let printed = run(&format!("snellius trace prism.ron --format {format}"), folder.path()).unwrap();
        serde_json::from_str(&printed).unwrap()
    })
}

/// Every field of a value, as a path such as `rays[].segments[].id`.
fn fields(value: &Value, path: &str, found: &mut BTreeSet<String>) {
    match value {
        Value::Object(map) => {
            for (name, value) in map {
                let path = if path.is_empty() { name.clone() } else { format!("{path}.{name}") };
                fields(value, &path, found);
                found.insert(path);
            }
        }
        Value::Array(list) => list.iter().for_each(|value| fields(value, &format!("{path}[]"), found)),
        _ => {}
    }
}

fn contains(whole: &Value, part: &Value) -> bool {
    whole == part
        || match whole {
            Value::Object(map) => map.values().any(|value| contains(value, part)),
            Value::Array(list) => list.iter().any(|value| contains(value, part)),
            _ => false,
        }
}

#[cfg(unix)]
#[test]
fn the_reference_names_the_fields_of_json_and_no_others() {
    let page = Page::read(TRACE_FORMAT);
    let mut named = BTreeSet::new();
    for part in page.section("JSON").split("\n### ").skip(1) {
        let heading = part.lines().next().unwrap();
        let path = heading.split('`').nth(1).map_or(String::new(), |path| format!("{path}."));
        named.extend(first_cells(part).iter().map(|field| format!("{path}{field}")));
    }
    let mut found = BTreeSet::new();
    fields(&traces(&page)[0], "", &mut found);
    assert_eq!(named, found);
}

#[cfg(unix)]
#[test]
fn json_that_is_shown_is_real() {
    let page = Page::read(TRACE_FORMAT);
    let real = traces(&page);
    let mut shown = 0;
    for block in page.marked("json") {
        let part: Value = serde_json::from_str(&block.text).unwrap();
        assert!(real.iter().any(|whole| contains(whole, &part)), "{}", page.place(block));
        shown += 1;
    }
    assert!(shown >= 2);
}

#[cfg(unix)]
#[test]
fn the_columns_of_csv_are_those_shown() {
    let page = Page::read(TRACE_FORMAT);
    let printed = run("snellius trace prism.ron --format csv", folder(&page).path()).unwrap();
    let block = page.marked("csv").next().unwrap();
    assert_eq!(printed.lines().next(), Some(block.text.trim_end()));
}

#[test]
fn the_reference_names_every_ending() {
    let page = Page::read(TRACE_FORMAT);
    let endings = [
        Ending::Interface,
        Ending::Absorbed,
        Ending::Detected,
        Ending::Escaped,
        Ending::CutMinPower,
        Ending::CutMaxDepth,
        Ending::CutMaxSegments,
    ];
    assert_eq!(first_cells(page.section("Endings")), endings.map(Ending::word));
}
