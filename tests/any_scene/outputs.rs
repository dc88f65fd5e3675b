//! Every form that a traced scene is shown in: well formed, whole, and without a number that is none.

use serde_json::Value;
use snellius::explain::{Part, brightest, explain, latex, markdown};
use snellius::scene::Shape;
use snellius::trace::{Trace, TracedRay};
use snellius::{OpticalSystem, Scene, diagram, explain as explanation, render, report};

/// Figures of more pixels are not painted: that takes long.
const MOST_PIXELS: u32 = 4000;

/// Holds all that is shown of a trace to its form.
pub fn whole(scene: &Scene, system: &OpticalSystem, trace: &Trace) {
    let own = own_words(scene);
    let plain = |form: &str, text: &str| has_only_numbers(form, text, &own);
    plain("text", &report::text(system, trace));
    json(system, trace);
    csv(system, trace);
    let explanations: Vec<_> = brightest(&trace.tree)
        .into_iter()
        .map(|(ray, branch)| explain(scene, system, ray, branch).expect("a branch of the tree is explained"))
        .collect();
    for part in [Part::Worked, Part::Worksheet, Part::Key] {
        plain("explain", &explanation::text(&explanations, part));
        plain("markdown", &markdown(&explanations, part));
        plain("latex", &latex(&explanations, part));
    }
    let drawing = diagram::draw(scene, system, &trace.tree);
    svg(&render::svg(&drawing), scene.diagram.size, &own);
    svg(&render::svg_outlined(&drawing), scene.diagram.size, &own);
    if let Some(last) = drawing.steps().last() {
        svg(&render::svg(&drawing.up_to(*last)), scene.diagram.size, &own);
    }
    let [width, height] = scene.diagram.size;
    if width * height <= MOST_PIXELS {
        let png = render::png(&drawing, 1.0).expect("a small figure is painted");
        assert_eq!(png[16..24], [width.to_be_bytes(), height.to_be_bytes()].concat(), "the PNG's size");
    }
}

/// JSON that reads back, with the counts of the trace, and null only where nothing applies.
fn json(system: &OpticalSystem, trace: &Trace) {
    let read = |text: &str| serde_json::from_str::<Value>(text).unwrap_or_else(|error| panic!("{error}: {text}"));
    let mut whole = read(&report::json(system, trace));
    no_null("", &whole);
    let length = |value: &Value| value.as_array().expect("a list").len() as u64;
    let rays = whole.as_object_mut().expect("an object").remove("rays").expect("rays");
    let segments: u64 = rays.as_array().expect("a list").iter().map(|ray| length(&ray["segments"])).sum();
    assert_eq!(
        (whole["counts"]["rays"].as_u64(), whole["counts"]["segments"].as_u64()),
        (Some(length(&rays)), Some(segments))
    );
    assert_eq!((length(&rays), segments), (trace.summary.rays, trace.summary.segments));
    assert_eq!(whole, read(&report::summary_json(system, &trace.summary)));
}

fn no_null(name: &str, value: &Value) {
    match value {
        Value::Null => {
            assert!(["parent", "to", "hit", "n_t", "theta_t_deg", "critical_deg"].contains(&name), "{name} is null");
        }
        Value::Array(items) => items.iter().for_each(|item| no_null("an item", item)),
        Value::Object(fields) => fields.iter().for_each(|(name, value)| no_null(name, value)),
        Value::Bool(_) | Value::Number(_) | Value::String(_) => {}
    }
}

/// A row a segment; its numbers are finite, and stand where they apply.
fn csv(system: &OpticalSystem, trace: &Trace) {
    let table = report::csv(system, &trace.tree);
    let mut rows = csv::Reader::from_reader(table.as_bytes());
    let columns: Vec<String> = rows.headers().expect("names of columns").iter().map(str::to_owned).collect();
    let segments = trace.tree.rays.iter().flat_map(|ray| &ray.segments);
    let mut count = 0;
    for (row, segment) in rows.records().zip(segments) {
        let row = row.expect("a row");
        count += 1;
        for (column, cell) in columns.iter().zip(&row) {
            let hit = segment.hit.as_ref();
            let is_given = match column.as_str() {
                "via" | "ending" | "body" => continue,
                "parent" => segment.parent.is_some(),
                "to_x" | "to_y" => segment.to.is_some(),
                "n_i" | "theta_i_deg" | "reflectance" | "transmittance" => hit.is_some(),
                "n_t" => hit.is_some_and(|hit| hit.n_t.is_some()),
                "theta_t_deg" => hit.is_some_and(|hit| hit.sin_t.is_some()),
                _ => true,
            };
            let is_finite = cell.parse::<f64>().is_ok_and(f64::is_finite);
            assert!(if is_given { is_finite } else { cell.is_empty() }, "{column} is {cell:?}: {segment:?}");
        }
    }
    assert_eq!(count, trace.summary.segments, "rows");
    assert!(table.lines().count() as u64 > count);
}

/// Well-formed XML of the figure's size.
fn svg(text: &str, [width, height]: [u32; 2], own: &[String]) {
    let document = roxmltree::Document::parse(text).unwrap_or_else(|error| panic!("{error}: {text}"));
    let root = document.root_element();
    let size = ["width", "height", "viewBox"].map(|name| root.attribute(name).unwrap_or_default().to_owned());
    assert_eq!(size, [width.to_string(), height.to_string(), format!("0 0 {width} {height}")]);
    has_only_numbers("svg", text, own);
}

/// No `NaN` and no `inf` stands among words and numbers, but where the scene itself says so.
fn has_only_numbers(form: &str, text: &str, own: &[String]) {
    for word in ["NaN", "inf"].into_iter().filter(|word| !own.iter().any(|own| own.contains(word))) {
        let is_part = |at: usize| {
            let (before, after) = (text[..at].chars().next_back(), text[at + word.len()..].chars().next());
            // A letter before it may be a command of a path.
            before.is_some_and(|c| c.is_lowercase()) || after.is_some_and(char::is_alphabetic)
        };
        let found = text.match_indices(word).find(|(at, _)| !is_part(*at));
        assert!(found.is_none(), "{word} in {form}: {text}");
    }
}

/// What the scene's author wrote for people.
fn own_words(scene: &Scene) -> Vec<String> {
    let bodies = scene.bodies.iter().flat_map(|body| [body.name.clone(), body.label.clone()]);
    let names = bodies.chain(scene.sources.iter().map(|source| source.name.clone())).flatten();
    let notes = scene.notes.iter().map(|note| note.text.clone());
    names.chain(notes).chain([scene.title.clone(), scene.caption.clone()]).collect()
}

/// Hits on the longest path of a ray.
pub fn depth(ray: &TracedRay) -> usize {
    let mut depths: Vec<usize> = Vec::with_capacity(ray.segments.len());
    for segment in &ray.segments {
        depths.push(segment.parent.map_or(0, |parent| depths[parent.index()] + 1));
    }
    depths.into_iter().max().unwrap_or(0)
}

/// Edges and arcs of all bodies.
pub fn sides(scene: &Scene) -> usize {
    let sides = |shape: &Shape| match shape {
        Shape::Polygon(points) => points.len(),
        Shape::RegularPolygon { sides, .. } => *sides as usize,
        Shape::Lens { facets, .. } => 4 + 2 * facets.unwrap_or(0) as usize,
        Shape::Outline { path, .. } => path.len(),
        Shape::LensGroup { surfaces, .. } => 4 * surfaces.len(),
        _ => 4,
    };
    scene.bodies.iter().map(|body| sides(&body.shape)).sum()
}
