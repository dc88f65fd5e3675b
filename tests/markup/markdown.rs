//! Explanations and the gallery in Markdown: no word is markup.

use std::sync::LazyLock;

use comrak::nodes::NodeValue;
use comrak::{Arena, Options, parse_document};
use snellius::explain;

use crate::support::{Run, gallery, hostile, run_text};
use crate::{explained, one_line};

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
pub(crate) fn outline(markdown: &str) -> (Vec<&'static str>, Vec<String>) {
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

pub(crate) fn markdown_is_tame(words: &str, run: &Run) {
    static PLAIN: LazyLock<Vec<&str>> =
        LazyLock::new(|| outline(&explained(&run_text(&hostile::scene("a")), explain::markdown)).0);
    let (kinds, headings) = outline(&explained(run, explain::markdown));
    assert_eq!(kinds, *PLAIN);
    assert_eq!(headings[0].trim(), one_line(words).replace('\0', "\u{fffd}").trim());
}

/// A scene's place in docs/gallery.md: a table of HTML with Markdown in it.
pub(crate) fn gallery_is_tame(run: &Run) {
    let cell = gallery::cell("chapter/name", &run.scene);
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
