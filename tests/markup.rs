//! Words of a scene never become markup, a command, a formula or a sign for a terminal, whatever is written for whom.

#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

mod support;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

use comrak::nodes::NodeValue;
use comrak::{Arena, Options, parse_document};
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

/// What LaTeX does with the characters of a document: its commands, and where groups and formulas begin and end.
#[derive(Debug, Default, PartialEq)]
struct Latex {
    commands: BTreeSet<String>,
    formulas: usize,
    lines: usize,
}

impl Latex {
    fn read(document: &str) -> Self {
        let mut read = Self { lines: document.lines().count(), ..Self::default() };
        let mut characters = document.chars().peekable();
        let (mut depth, mut in_formula) = (0_i32, false);
        while let Some(c) = characters.next() {
            match c {
                '\\' => {
                    let mut name = String::new();
                    while let Some(letter) = characters.next_if(char::is_ascii_alphabetic) {
                        name.push(letter);
                    }
                    if name.is_empty() {
                        name.extend(characters.next());
                    }
                    read.commands.insert(name);
                }
                '{' => depth += 1,
                '}' => depth -= 1,
                '$' => {
                    in_formula = !in_formula;
                    read.formulas += usize::from(in_formula);
                }
                '_' | '^' => assert!(in_formula, "a formula outside of one"),
                '%' | '#' | '&' | '~' => panic!("{c} acts"),
                _ => {}
            }
            assert!(depth >= 0, "a group ends that has not begun");
        }
        assert!(depth == 0 && !in_formula);
        read
    }
}

/// Commands for characters of words.
const LETTERS: [&str; 15] = [
    "textbackslash",
    "textasciitilde",
    "textasciicircum",
    "textless",
    "textgreater",
    "textquotedbl",
    "textasciigrave",
    "textdegree",
    "{",
    "}",
    "#",
    "$",
    "%",
    "&",
    "_",
];

fn latex_is_tame(run: &Run) {
    static PLAIN: LazyLock<Latex> =
        LazyLock::new(|| Latex::read(&explained(&run_text(&hostile::scene("a")), explain::latex)));
    let document = explained(run, explain::latex);
    let read = Latex::read(&document);
    assert_eq!(read.lines, PLAIN.lines);
    let unknown: Vec<_> =
        read.commands.difference(&PLAIN.commands).filter(|name| !LETTERS.contains(&name.as_str())).collect();
    let is_letter = |name: &&&String| !GREEK.contains(&name.as_str());
    assert_eq!(unknown.iter().filter(is_letter).count(), 0, "{unknown:?}");
    assert!(
        document.chars().all(|c| c == '\n' || (!steers(c) && (c < '\u{180}' || "–—‘’“”…".contains(c)))),
        "{document:?}"
    );
}

/// Signs that words and formulas alike are written with.
const GREEK: [&str; 34] = [
    "alpha",
    "beta",
    "gamma",
    "delta",
    "varepsilon",
    "eta",
    "theta",
    "lambda",
    "mu",
    "nu",
    "pi",
    "rho",
    "sigma",
    "tau",
    "varphi",
    "chi",
    "psi",
    "omega",
    "Delta",
    "Sigma",
    "Omega",
    "infty",
    "to",
    "leftarrow",
    "le",
    "ge",
    "approx",
    "ne",
    "surd",
    "angle",
    "cdot",
    "perp",
    "parallel",
    "circ",
];

/// Markdown as its most generous readers take it.
fn generous() -> Options<'static> {
    let mut options = Options::default();
    let on = &mut options.extension;
    (on.strikethrough, on.table, on.autolink, on.tasklist, on.superscript) = (true, true, true, true, true);
    (on.footnotes, on.math_dollars, on.underline, on.alerts, on.description_lists) = (true, true, true, true, true);
    options.parse.relaxed_autolinks = true;
    options
}

/// The kinds of what Markdown finds, in order, and the words of its headings.
fn outline(markdown: &str) -> (Vec<&'static str>, Vec<String>) {
    let arena = Arena::new();
    let document = parse_document(&arena, markdown, &generous());
    let (mut kinds, mut headings) = (Vec::new(), Vec::new());
    for node in document.descendants() {
        let kind = match &node.data().value {
            NodeValue::Document => "document",
            NodeValue::Paragraph => "paragraph",
            NodeValue::List(_) => "list",
            NodeValue::Item(_) => "item",
            NodeValue::Strong => "strong",
            NodeValue::Math(_) => "math",
            NodeValue::Heading(_) => {
                let text = node.descendants().filter_map(|part| match &part.data().value {
                    NodeValue::Text(text) => Some(text.to_string()),
                    _ => None,
                });
                headings.push(text.collect());
                "heading"
            }
            NodeValue::Text(_) => continue,
            other => panic!("{other:?} in {markdown}"),
        };
        kinds.push(kind);
    }
    (kinds, headings)
}

fn markdown_is_tame(words: &str, run: &Run) {
    static PLAIN: LazyLock<Vec<&str>> =
        LazyLock::new(|| outline(&explained(&run_text(&hostile::scene("a")), explain::markdown)).0);
    let (kinds, headings) = outline(&explained(run, explain::markdown));
    assert_eq!(kinds, *PLAIN);
    assert_eq!(headings[0].trim(), one_line(words).replace('\0', "\u{fffd}").trim_matches([' ', '\t']));
}

/// A scene's place in docs/gallery.md: a table of HTML with Markdown in it.
fn gallery_is_tame(run: &Run) {
    let cell = support::gallery::cell("chapter/name", &run.scene);
    let inside = cell.strip_prefix("<td width=\"50%\">\n\n").and_then(|rest| rest.strip_suffix("\n\n</td>\n")).unwrap();
    let arena = Arena::new();
    let (mut links, mut images, mut breaks) = (0, 0, 0);
    for node in parse_document(&arena, inside, &generous()).descendants() {
        match &node.data().value {
            NodeValue::Image(image) => {
                assert_eq!(image.url, "../snapshots/chapter/name.svg");
                images += 1;
            }
            NodeValue::Link(link) => {
                assert_eq!(link.url, "../scenes/chapter/name.ron");
                links += 1;
            }
            NodeValue::HtmlInline(html) if html == "<br>" => breaks += 1,
            NodeValue::Document | NodeValue::Paragraph | NodeValue::Strong | NodeValue::Text(_) => {}
            other => panic!("{other:?} in {cell}"),
        }
    }
    assert_eq!((images, links, breaks), (1, 1, 2));
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

#[test]
fn words_are_words() {
    all_is_tame("a");
    all_is_tame(&hostile::all());
    hostile::PIECES.iter().filter(|words| hostile::is_name(words)).for_each(|words| all_is_tame(words));
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
