//! Words of a scene do not run, wherever a figure or a page with them is opened.

use comrak::{Options, markdown_to_html};
use roxmltree::Document;
use snellius::explain::{self, Part};
use snellius::{diagram, render};

use crate::chromium::Chromium;
use crate::support::{gallery, hostile, run_text};

/// A script that marks the page it is in, from within an object too.
const SCRIPT: &str = "<script>top.document.documentElement.id='RUN'</script>";
const WAYS: [&str; 4] = ["direct", "img", "object", "inline"];

fn svgs(words: &str) -> [String; 2] {
    let run = run_text(&hostile::scene(words));
    let drawing = diagram::draw(&run.scene, &run.system, &run.trace.tree);
    [render::svg(&drawing), render::svg_outlined(&drawing)]
}

fn page(body: &str) -> String {
    format!(
        "<!doctype html><html><head><meta charset=\"utf-8\"><title>still</title></head><body>\n{body}\n</body></html>"
    )
}

/// Opens a figure in one of the ways that pages have.
fn opened(browser: &Chromium, svg: &str, way: &str) -> String {
    browser.put("figure.svg", svg);
    let body = match way {
        "img" => "<img src=\"figure.svg\">",
        "object" => "<object data=\"figure.svg\" type=\"image/svg+xml\"></object>",
        "inline" => svg,
        _ => return browser.dom("figure.svg"),
    };
    browser.put("page.html", &page(body));
    browser.dom("page.html")
}

const FIGURE: [&str; 10] = ["svg", "title", "desc", "defs", "clipPath", "rect", "g", "path", "text", "tspan"];
const PAGE: [&str; 18] = [
    "html", "head", "meta", "title", "body", "table", "tbody", "tr", "td", "p", "img", "strong", "br", "a", "h1", "h2",
    "h3", "ul",
];

/// The elements of a page as a browser writes it down, which has every `<` of words as `&lt;` but those within quotes.
fn tags(dom: &str) -> impl Iterator<Item = &str> {
    let mut rest = dom;
    std::iter::from_fn(move || {
        let tag = &rest[rest.find('<')? + 1..];
        let mut in_quotes = false;
        let end = tag.find(|c| {
            in_quotes ^= c == '"';
            c == '>' && !in_quotes
        });
        rest = &tag[end?..];
        tag.split([' ', '>']).next()
    })
    .filter(|tag| !tag.starts_with(['/', '!']))
}

fn only_has(dom: &str, known: &[&str]) {
    let unknown: Vec<_> = tags(dom).filter(|tag| !known.contains(tag) && *tag != "li").collect();
    assert!(unknown.is_empty(), "{unknown:?}");
}

fn has_run(dom: &str) -> bool {
    // Words may say so too; a script gives the whole document the name.
    let root = dom.find("<html").or_else(|| dom.find("<svg")).and_then(|at| dom[at..].split('>').next());
    root.unwrap().contains("id=\"RUN\"")
}

#[test]
fn no_word_of_a_figure_runs() {
    let Some(browser) = Chromium::find("no_word_of_a_figure_runs") else { return };
    let words = hostile::all();
    for svg in svgs(&words) {
        for way in WAYS {
            let dom = opened(&browser, &svg, way);
            assert!(!has_run(&dom), "{way}: {}", &dom[..300]);
            if way == "direct" {
                let shown = Document::parse(&dom).unwrap();
                let original = Document::parse(&svg).unwrap();
                let parts = |document: &Document| -> Vec<String> {
                    document.descendants().map(|node| format!("{:?} {:?}", node.tag_name(), node.text())).collect()
                };
                assert_eq!(parts(&shown), parts(&original), "the same elements with the same words");
            } else {
                let figure = if way == "inline" { &FIGURE[..] } else { &[] };
                only_has(&dom, &[&["html", "head", "meta", "title", "body", way], figure].concat());
            }
        }
    }
}

/// The test above would notice: the same figure with its words let through runs in every way but `<img>`, which runs nothing.
#[test]
fn a_word_that_is_let_through_is_noticed() {
    let Some(browser) = Chromium::find("a_word_that_is_let_through_is_noticed") else { return };
    let [svg, _] = svgs(SCRIPT);
    let escaped = SCRIPT.replace('<', "&lt;").replace('>', "&gt;").replace('\'', "&#39;");
    assert!(svg.contains(&escaped));
    let title = format!("<title>{escaped}</title>");
    let let_through = svg.replace(&title, SCRIPT);
    assert_ne!(svg, let_through);
    for way in WAYS {
        assert_eq!(has_run(&opened(&browser, &let_through, way)), way != "img", "{way}");
        assert!(!has_run(&opened(&browser, &svg, way)), "{way}");
    }
}

/// Pages of Markdown become HTML, raw HTML in them let through as it is meant to be: the gallery has tables.
#[test]
fn no_word_of_a_page_runs() {
    let Some(browser) = Chromium::find("no_word_of_a_page_runs") else { return };
    let mut options = Options::default();
    options.render.r#unsafe = true;
    (options.extension.autolink, options.extension.table) = (true, true);
    let html = |markdown: &str| page(&markdown_to_html(markdown, &options));
    let run = run_text(&hostile::scene(&hostile::all()));
    let branches = explain::brightest(&run.trace.tree);
    let explanations: Vec<_> = branches
        .into_iter()
        .filter_map(|(ray, branch)| explain::explain(&run.scene, &run.system, ray, branch))
        .collect();
    let table = format!("<table>\n<tr>\n{}</tr>\n</table>\n", gallery::cell("chapter/name", &run.scene));
    for markdown in [table.as_str(), &explain::markdown(&explanations, Part::Worked)] {
        browser.put("page.html", &html(markdown));
        let dom = browser.dom("page.html");
        assert!(!has_run(&dom), "{dom}");
        only_has(&dom, &PAGE);
        assert_eq!(
            tags(&dom).filter(|tag| *tag == "a").count(),
            usize::from(markdown == table),
            "no link but the gallery's own"
        );
    }
    browser.put("page.html", &html(&format!("a {SCRIPT}\n")));
    assert!(has_run(&browser.dom("page.html")), "what is let through would be noticed");
}
