//! Words of a scene never become markup, a command, a formula or a sign for a terminal, whatever is written for whom.

#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

#[path = "markup/latex.rs"]
mod latex;
#[path = "markup/markdown.rs"]
mod markdown;
mod support;

use std::collections::{BTreeMap, BTreeSet};

use latex::{Latex, latex_is_tame};
use markdown::{gallery_is_tame, markdown_is_tame, outline};
use proptest::prelude::*;
use roxmltree::Document;
use snellius::explain::{self, Part};
use snellius::{Scene, diagram, render, report};
use support::{Run, hostile, run_text};

/// All that figures are made of.
const ELEMENTS: [&str; 10] = ["svg", "title", "desc", "defs", "clipPath", "rect", "g", "path", "text", "tspan"];
const ATTRIBUTES: [&str; 32] = [
    "aria-label",
    "class",
    "clip-path",
    "d",
    "data-address",
    "data-body",
    "data-generation",
    "data-power",
    "dy",
    "fill",
    "fill-opacity",
    "font-family",
    "font-size",
    "font-style",
    "font-weight",
    "height",
    "id",
    "opacity",
    "role",
    "stroke",
    "stroke-dasharray",
    "stroke-linecap",
    "stroke-linejoin",
    "stroke-opacity",
    "stroke-width",
    "style",
    "text-anchor",
    "text-rendering",
    "viewBox",
    "width",
    "x",
    "y",
];

/// A character that acts on what stands around it.
fn steers(c: char) -> bool {
    c.is_control()
        || "\u{61c}\u{200e}\u{200f}\u{2028}\u{2029}".contains(c)
        || ('\u{202a}'..='\u{202e}').contains(&c)
        || ('\u{2066}'..='\u{2069}').contains(&c)
}

/// What an element or an attribute of XML can hold of some words.
fn in_xml(words: &str) -> String {
    let words = words.replace(['\t', '\n', '\r'], " ");
    words.chars().filter(|c| !c.is_control() && !matches!(c, '\u{fffe}' | '\u{ffff}')).collect()
}

/// The letters of some words that a figure shows.
fn letters(words: &str) -> String {
    words.chars().filter(|c| !c.is_whitespace() && !steers(*c) && !matches!(c, '\u{fffe}' | '\u{ffff}')).collect()
}

fn one_line(words: &str) -> String {
    words.replace(steers, " ")
}

fn svg_is_tame(words: &str, run: &Run) {
    let drawing = diagram::draw(&run.scene, &run.system, &run.trace.tree);
    for svg in [render::svg(&drawing), render::svg_outlined(&drawing)] {
        let document = Document::parse(&svg).unwrap();
        for node in document.descendants().filter(roxmltree::Node::is_element) {
            assert!(ELEMENTS.contains(&node.tag_name().name()), "{node:?}");
            let unknown = node.attributes().find(|attribute| !ATTRIBUTES.contains(&attribute.name()));
            assert!(unknown.is_none(), "{unknown:?}");
        }
        let is_plain = |node: &roxmltree::Node| node.is_root() || node.is_element() || node.is_text();
        assert!(document.descendants().all(|node| is_plain(&node)), "comments or instructions");
        let text = |name| document.descendants().find(|node| node.has_tag_name(name)).and_then(|node| node.text());
        assert_eq!([text("title"), text("desc")].map(Option::unwrap_or_default), [in_xml(words).as_str(); 2]);
        let bodies = document.descendants().filter_map(|node| node.attribute("data-body"));
        let bodies: BTreeSet<&str> = bodies.collect();
        let name = in_xml(words);
        assert_eq!(bodies, BTreeSet::from([name.as_str(), "#1", &format!("{name}2"), "#3"]));
        shown_whole(words, &document);
    }
}

/// Titles, captions and notes break into lines and lose nothing.
fn shown_whole(words: &str, document: &Document) {
    let mut shown: BTreeMap<&str, String> = BTreeMap::new();
    for node in document.descendants() {
        let Some(class) = node.attribute("class") else { continue };
        let own = node.descendants().filter(|part| part.is_text()).filter_map(|part| part.text());
        let own: String = node.attribute("aria-label").map_or_else(|| own.collect(), str::to_owned);
        if ["title", "caption", "note"].contains(&class) {
            *shown.entry(class).or_default() += &letters(&own);
        }
    }
    for class in ["title", "caption", "note"] {
        assert_eq!(shown.get(class).map_or("", String::as_str), letters(words), "{class}");
    }
}

/// What a name is read back from: an apostrophe goes at the start and behind semicolons.
fn unguarded(cell: &str) -> String {
    let parts = cell.split(';').map(|part| part.strip_prefix('\'').unwrap_or(part));
    parts.collect::<Vec<_>>().join(";")
}

fn csv_is_tame(words: &str, run: &Run) {
    let table = report::csv(&run.system, &run.trace.tree);
    let rows = |separator| {
        csv::ReaderBuilder::new().delimiter(separator).flexible(true).from_reader(table.as_bytes()).into_records()
    };
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let names = reader.headers().unwrap().clone();
    let words_at: Vec<usize> =
        ["via", "ending", "body"].map(|name| names.iter().position(|known| known == name).unwrap()).into();
    let segments = run.trace.tree.rays.iter().flat_map(|ray| &ray.segments);
    let mut met = 0;
    for (row, segment) in rows(b',').map(Result::unwrap).zip(segments) {
        assert_eq!(row.len(), names.len());
        for (k, cell) in row.iter().enumerate().filter(|(k, _)| !words_at.contains(k)) {
            assert!(cell.is_empty() || cell.parse::<f64>().is_ok(), "{}: {cell:?}", &names[k]);
        }
        let expected = match segment.hit.as_ref().map(|hit| hit.body) {
            None => String::new(),
            Some(0) => one_line(words),
            Some(2) => one_line(words) + "2",
            Some(unnamed) => format!("#{unnamed}"),
        };
        assert_eq!(unguarded(&row[words_at[2]]), expected);
        met += usize::from(!expected.is_empty());
    }
    assert!(met > 10);
    // A comma separates, or a semicolon where it is the decimal sign.
    let formula = |cell: &str| cell.trim_start().starts_with(['=', '+', '-', '@', '＝', '＋', '－', '＠']);
    for row in rows(b',').chain(rows(b';')).map(Result::unwrap) {
        for (k, cell) in row.iter().enumerate() {
            let is_number = cell.parse::<f64>().is_ok();
            assert!(is_number || !formula(cell), "column {k}: {cell:?}");
        }
    }
    assert!(!table.contains(|c| steers(c) && c != '\n'), "{table:?}");
}

fn json_is_tame(words: &str, run: &Run) {
    for json in [report::json(&run.system, &run.trace), report::summary_json(&run.system, &run.trace.summary)] {
        assert!(!json.contains(|c| steers(c) && c != '\n'), "{json:?}");
        let read: serde_json::Value = serde_json::from_str(&json).unwrap();
        assert_eq!(read["title"], words);
        assert_eq!(read["screens"][0]["body"], format!("{words}2"));
    }
}

fn explained(run: &Run, written: fn(&[explain::Explanation], Part) -> String) -> String {
    let branches = explain::brightest(&run.trace.tree);
    let explain = |(ray, branch)| explain::explain(&run.scene, &run.system, ray, branch);
    let explanations: Vec<_> = branches.into_iter().filter_map(explain).collect();
    assert!(!explanations.is_empty());
    written(&explanations, Part::Worked)
}

fn text_is_tame(run: &Run) {
    for text in [report::text(&run.system, &run.trace), explained(run, explain::text)] {
        assert!(!text.contains(|c| steers(c) && c != '\n'), "{text:?}");
    }
}

fn all_is_tame(words: &str) {
    let run = run_text(&hostile::scene(words));
    assert_eq!(run.scene.title, words);
    svg_is_tame(words, &run);
    csv_is_tame(words, &run);
    json_is_tame(words, &run);
    text_is_tame(&run);
    latex_is_tame(&run);
    markdown_is_tame(words, &run);
    gallery_is_tame(&run);
}

/// Tries everything that is known to be tried.
fn each(is_tame: impl Fn(&str, &Run)) {
    let names = hostile::PIECES.iter().filter(|words| hostile::is_name(words)).map(|words| (*words).to_owned());
    for words in names.chain([hostile::all(), "a".into()]) {
        is_tame(&words, &run_text(&hostile::scene(&words)));
    }
}

#[test]
fn words_are_words_in_figures() {
    each(svg_is_tame);
}

#[test]
fn words_are_words_in_tables() {
    each(csv_is_tame);
}

#[test]
fn words_are_words_in_json() {
    each(json_is_tame);
}

#[test]
fn words_are_words_in_text() {
    each(|_, run| text_is_tame(run));
}

#[test]
fn words_are_words_in_latex() {
    each(|_, run| latex_is_tame(run));
}

#[test]
fn words_are_words_in_markdown() {
    each(markdown_is_tame);
}

#[test]
fn words_are_words_in_the_gallery() {
    each(|_, run| gallery_is_tame(run));
}

/// Words of these pieces and of any characters.
fn any_words() -> impl Strategy<Value = String> {
    let piece = prop_oneof![
        proptest::sample::select(&hostile::PIECES[..]).prop_map(String::from),
        proptest::sample::select(
            &["=", "+", "-", "@", ";", "'", "\"", "\\", "`", "<", "&", "$", " ", "\n", "\u{202e}"][..]
        )
        .prop_map(String::from),
        any::<String>(),
        "[ -~]{1,12}",
    ];
    proptest::collection::vec(piece, 1..6)
        .prop_map(|pieces| pieces.concat())
        .prop_filter("a name", |words| hostile::is_name(words))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]
    #[test]
    fn any_words_are_words(words in any_words()) {
        all_is_tame(&words);
    }
}

/// What the checks above are worth: each finds markup that is let through.
#[test]
fn markup_would_be_found() {
    assert!(std::panic::catch_unwind(|| Latex::read("a % b")).is_err());
    assert!(Latex::read("\\input{x}").commands.contains("input"));
    for markdown in ["[a](b)", "https://example.org", "<b>", "~~a~~", "`a`", "a@example.org", "|a|\n|-|\n"] {
        assert!(std::panic::catch_unwind(|| outline(markdown)).is_err(), "{markdown}");
    }
    let scene = Scene::from_ron(&hostile::scene("<script>")).unwrap();
    assert_eq!(scene.bodies[0].name.as_deref(), Some("<script>"));
}

/// The direction of writing of one label turns no other word of its line: the index stands behind the name.
#[test]
fn right_to_left_names_leave_other_words_in_their_places() {
    let run = run_text(&hostile::scene("\u{5e9}\u{5dc}\u{5d5}\u{5dd} 7"));
    let svg = render::svg(&diagram::draw(&run.scene, &run.system, &run.trace.tree));
    let document = Document::parse(&svg).unwrap();
    let labels: Vec<_> = document.descendants().filter(|node| node.attribute("class") == Some("label")).collect();
    let with_index: Vec<_> =
        labels.iter().filter_map(|node| node.text()).filter(|text| text.contains("n\u{a0}=")).collect();
    assert!(!with_index.is_empty());
    for text in with_index {
        let index = text.split("\u{2069}").nth(1).unwrap_or(text);
        assert!(
            text.starts_with('\u{2068}') && index.starts_with(", n\u{a0}=\u{a0}1.") || !text.contains('\u{5e9}'),
            "{text:?}"
        );
    }
    assert!(svg.contains("\u{2068}\u{5e9}\u{5dc}\u{5d5}\u{5dd} 7\u{2069}"));
}
