//! SVG 1.1 with presentation attributes only, so that every viewer and editor shows the same figure; but for what only CSS can
//! say: lights that add up (a viewer that does not know `mix-blend-mode` paints them over each other) and text without kerning.
//!
//! Text stays text. Subscripts move by `dy`, because `baseline-shift` is not known everywhere.

use std::fmt::Write;

use glam::DVec2;

use crate::drawing::{Anchor, Cap, Drawing, Fill, Font, Group, Item, Lines, Path, PathStep, Rect, Shape, Stroke, Text};
use crate::drawing::{GlyphStep, Whole, extent, hundredths, pixel, shortest};
use crate::render::decimal::{push_line, push_point};
use crate::render::fingerprint::fingerprint;

/// Bytes of a line among very many, such as `M123.45 67.89L234.5 78`.
const USUAL_LINE: usize = 28;

/// The figure as an SVG document whose words are text; the same figure gives the same bytes.
#[must_use]
pub fn svg(drawing: &Drawing) -> String {
    document(drawing, write_text)
}

/// The same with the outlines of the letters in place of text, for where the fonts of `DejaVu Sans` are missing.
#[must_use]
pub fn svg_outlined(drawing: &Drawing) -> String {
    document(drawing, write_outlines)
}

/// Letters stand where the layout has them, whatever page the figure is set into: CSS alone can say so.
const TEXT_STYLE: &str = "direction:ltr;font-kerning:none;font-variant-ligatures:none";

/// Stands for the figure itself in names until all of it is written; no text holds it.
const FIGURE: &str = "\u{1}";

/// Writes words.
type Pen = fn(&mut String, &Text);

fn document(drawing: &Drawing, pen: Pen) -> String {
    let [width, height] = drawing.size;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
         font-family=\"DejaVu Sans, sans-serif\" text-rendering=\"geometricPrecision\" style=\"{TEXT_STYLE}\">\n"
    );
    element(&mut out, "title", &drawing.title);
    element(&mut out, "desc", &drawing.description);
    let mut clips = Vec::new();
    collect_clips(&drawing.items, &mut clips);
    define_clips(&mut out, &clips);
    if let Some(color) = drawing.background {
        line(&mut out, format_args!("<rect width=\"{width}\" height=\"{height}\" fill=\"{}\"/>", color.css()));
    }
    drawing.items.iter().for_each(|item| write_item(&mut out, item, false, pen));
    out.push_str("</svg>\n");
    named(out)
}

/// The document with a name for the figure that is made of all that it shows, so that ids differ where several figures are set
/// into one page.
fn named(document: String) -> String {
    if !document.contains(FIGURE) {
        return document;
    }
    let name = format!("{:08x}", fingerprint(document.as_bytes()));
    document.replace(FIGURE, &name)
}

/// `screened` items add up as lights do.
fn write_item(out: &mut String, item: &Item, screened: bool, pen: Pen) {
    match item {
        Item::Shape(shape) => write_shape(out, shape, screened),
        Item::Lines(lines) => write_lines(out, lines, screened),
        Item::Text(text) => pen(out, text),
        Item::Group(group) => write_group(out, group, pen),
    }
}

fn write_group(out: &mut String, group: &Group, pen: Pen) {
    out.push_str("<g");
    if !group.name.is_empty() {
        push(out, format_args!(" id=\"{}-{FIGURE}\"", escape(&group.name)));
    }
    attributes(out, &group.class, &group.data);
    let adds_up = group.whole.is_some_and(|whole| whole.adds_up);
    if let Some(Whole { opacity, .. }) = group.whole {
        write_opacity(out, "opacity", opacity);
    }
    if adds_up {
        out.push_str(" style=\"isolation:isolate\"");
    }
    if let Some(clip) = &group.clip {
        push(out, format_args!(" clip-path=\"url(#{})\"", clip_id(clip)));
    }
    out.push_str(">\n");
    group.items.iter().for_each(|item| write_item(out, item, adds_up, pen));
    out.push_str("</g>\n");
}

fn write_shape(out: &mut String, shape: &Shape, screened: bool) {
    if shape.path.is_empty() {
        return;
    }
    out.push_str("<path");
    attributes(out, &shape.class, &shape.data);
    out.push_str(" d=\"");
    write_path(out, &shape.path);
    out.push('"');
    write_fill(out, shape.fill);
    if let Some(stroke) = &shape.stroke {
        write_stroke(out, stroke);
    }
    end_path(out, screened);
}

fn write_lines(out: &mut String, lines: &Lines, screened: bool) {
    out.push_str("<path");
    attributes(out, &lines.class, &[]);
    out.push_str(" d=\"");
    out.reserve(lines.ends.len() * USUAL_LINE);
    lines.ends.iter().for_each(|line| push_line(out, *line));
    out.push('"');
    write_fill(out, None);
    write_stroke(out, &lines.stroke);
    end_path(out, screened);
}

fn end_path(out: &mut String, screened: bool) {
    if screened {
        out.push_str(" style=\"mix-blend-mode:screen\"");
    }
    out.push_str("/>\n");
}

fn write_fill(out: &mut String, fill: Option<Fill>) {
    let Some(Fill { color, opacity }) = fill else {
        out.push_str(" fill=\"none\"");
        return;
    };
    push(out, format_args!(" fill=\"{}\"", color.css()));
    write_opacity(out, "fill-opacity", opacity);
}

/// Nothing where it is solid.
fn write_opacity(out: &mut String, name: &str, opacity: f64) {
    if opacity < 1.0 || opacity.is_nan() {
        push(out, format_args!(" {name}=\"{}\"", pixel(opacity.max(0.0))));
    }
}

fn write_stroke(out: &mut String, stroke: &Stroke) {
    push(out, format_args!(" stroke=\"{}\" stroke-width=\"{}\"", stroke.color.css(), pixel(extent(stroke.width))));
    write_opacity(out, "stroke-opacity", stroke.opacity);
    if !stroke.dash.is_empty() {
        let dash: Vec<String> = stroke.dash.iter().map(|length| shortest(pixel(extent(*length)))).collect();
        push(out, format_args!(" stroke-dasharray=\"{}\"", dash.join(" ")));
    }
    if stroke.cap == Cap::Round {
        out.push_str(" stroke-linecap=\"round\"");
    }
    out.push_str(" stroke-linejoin=\"round\"");
}

fn write_path(out: &mut String, path: &Path) {
    let whole = |p: DVec2| [p.x, p.y].map(hundredths);
    for step in path.steps() {
        match *step {
            PathStep::MoveTo(p) => push_point(out, b'M', whole(p)),
            PathStep::LineTo(p) => push_point(out, b'L', whole(p)),
            PathStep::ArcTo { radius: r, large, sweep, to } => {
                let (large, sweep) = (u8::from(large), u8::from(sweep));
                push(out, format_args!("A{r} {r} 0 {large} {sweep} {} {}", to.x, to.y));
            }
            PathStep::Close => out.push('Z'),
        }
    }
}

fn write_text(out: &mut String, text: &Text) {
    push(out, format_args!("<text x=\"{}\" y=\"{}\"", pixel(text.at.x), pixel(text.at.y)));
    attributes(out, &text.class, &[]);
    push(out, format_args!(" font-size=\"{}\" fill=\"{}\"", pixel(extent(text.size)), text.color.css()));
    match text.anchor {
        Anchor::Start => {}
        Anchor::Middle => out.push_str(" text-anchor=\"middle\""),
        Anchor::End => out.push_str(" text-anchor=\"end\""),
    }
    match text.font {
        Font::Regular => {}
        Font::Bold => out.push_str(" font-weight=\"bold\""),
        Font::Oblique => out.push_str(" font-style=\"italic\""),
    }
    out.push('>');
    write_spans(out, text);
    out.push_str("</text>\n");
}

/// The letters of a text as one path, which tells the words to readers.
fn write_outlines(out: &mut String, text: &Text) {
    out.push_str("<path");
    attributes(out, &text.class, &[]);
    let words: String = text.spans.iter().map(|span| span.text.as_str()).collect();
    push(out, format_args!(" role=\"img\" aria-label=\"{}\" fill=\"{}\" d=\"", escape(&words), text.color.css()));
    for glyph in text.glyphs() {
        let place = |p: DVec2| (glyph.at + p * glyph.size).to_array().map(pixel);
        for step in text.font.outline(glyph.character) {
            let (letter, points) = match step {
                GlyphStep::MoveTo(p) => ("M", vec![p]),
                GlyphStep::LineTo(p) => ("L", vec![p]),
                GlyphStep::QuadTo(c, p) => ("Q", vec![c, p]),
                GlyphStep::CubicTo(c, d, p) => ("C", vec![c, d, p]),
                GlyphStep::Close => ("Z", Vec::new()),
            };
            out.push_str(letter);
            let numbers: Vec<_> = points.into_iter().flat_map(place).map(|number| number.to_string()).collect();
            out.push_str(&numbers.join(" "));
        }
    }
    out.push_str("\"/>\n");
}

/// Spans on the baseline are plain text; another script is a `tspan` that moves down, and the next one back up.
fn write_spans(out: &mut String, text: &Text) {
    let mut down = 0.0;
    for span in &text.spans {
        let step = pixel(text.drop(span) - down);
        if step == 0.0 && down == 0.0 {
            out.push_str(&escape(&span.isolated()));
            continue;
        }
        let size = pixel(text.span_size(span));
        push(out, format_args!("<tspan dy=\"{step}\" font-size=\"{size}\">{}</tspan>", escape(&span.isolated())));
        down += step;
    }
}

fn element(out: &mut String, name: &str, content: &str) {
    if !content.is_empty() {
        line(out, format_args!("<{name}>{}</{name}>", escape(content)));
    }
}

fn attributes(out: &mut String, class: &str, data: &[(&'static str, String)]) {
    if !class.is_empty() {
        push(out, format_args!(" class=\"{}\"", escape(class)));
    }
    let is_name = |name: &str| {
        name.strip_prefix("data-").is_some_and(|rest| {
            rest.starts_with(|c: char| c.is_ascii_lowercase())
                && rest.chars().all(|c| c.is_ascii_lowercase() || c == '-')
        })
    };
    let is_first = |place: usize, name: &str| data[..place].iter().all(|(other, _)| *other != name);
    for (place, (name, value)) in data.iter().enumerate().filter(|(_, (name, _))| is_name(name)) {
        if !is_first(place, name) {
            continue;
        }
        push(out, format_args!(" {name}=\"{}\"", escape(value)));
    }
}

fn collect_clips(items: &[Item], clips: &mut Vec<Rect>) {
    for item in items {
        if let Item::Group(group) = item {
            clips.extend(group.clip.filter(|clip| !clips.contains(clip)));
            collect_clips(&group.items, clips);
        }
    }
}

fn define_clips(out: &mut String, clips: &[Rect]) {
    if clips.is_empty() {
        return;
    }
    out.push_str("<defs>\n");
    for clip in clips {
        let (min, size) = (clip.min, clip.size());
        let [x, y, width, height] = [min.x, min.y, size.x, size.y].map(pixel);
        let id = clip_id(clip);
        let rect = format_args!("<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"/>");
        line(out, format_args!("<clipPath id=\"{id}\">{rect}</clipPath>"));
    }
    out.push_str("</defs>\n");
}

/// A name made of the numbers, so that figures set into one page share an id only where the rectangles are equal.
fn clip_id(clip: &Rect) -> String {
    let [a, b, c, d] = [clip.min.x, clip.min.y, clip.max.x, clip.max.y].map(pixel);
    format!("clip_{a}_{b}_{c}_{d}")
}

/// Text with XML's special characters replaced and those that XML forbids removed.
fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            '\t' | '\n' | '\r' => out.push(' '),
            '\u{fffe}' | '\u{ffff}' => {}
            control if control.is_control() => {}
            other => out.push(other),
        }
    }
    out
}

fn line(out: &mut String, content: std::fmt::Arguments<'_>) {
    push(out, content);
    out.push('\n');
}

fn push(out: &mut String, content: std::fmt::Arguments<'_>) {
    // Writing to a string cannot fail.
    let _always_ok = out.write_fmt(content);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Color;
    use glam::DVec2;

    fn drawing(items: Vec<Item>) -> Drawing {
        Drawing {
            size: [100, 50],
            background: None,
            title: "a < b & \"c\"\u{1}".into(),
            description: String::new(),
            items,
        }
    }

    #[test]
    fn everything_is_escaped() {
        let text = Text::new("<&>'\"\u{b}", DVec2::ZERO, 10.0, Color::hex(0));
        let shape = Shape::stroked(Path::line(DVec2::ZERO, DVec2::X), Stroke::solid(Color::hex(0), 1.0), "x")
            .with("data-body", "a\"b<\u{ffff}\n".into());
        let out = svg(&drawing(vec![text.into(), shape.into()]));
        let document = roxmltree::Document::parse(&out).unwrap();
        let find = |name| document.descendants().find(|node| node.has_tag_name(name)).unwrap();
        assert_eq!(find("title").text(), Some("a < b & \"c\""));
        assert_eq!(find("text").text(), Some("<&>'\""));
        assert_eq!(find("path").attribute("data-body"), Some("a\"b< "));
    }

    #[test]
    fn arcs_stay_arcs() {
        let path = Path::circle(DVec2::new(10.0, 10.0), 4.0);
        let mut data = String::new();
        write_path(&mut data, &path);
        assert_eq!(data, "M6 10A4 4 0 0 1 14 10A4 4 0 0 1 6 10Z");
    }

    #[test]
    fn a_subscript_returns_to_the_baseline() {
        let mut text = Text::new("θ", DVec2::ZERO, 10.0, Color::hex(0)).subscript("1");
        text.spans.push(crate::drawing::Span { text: " = 30°".into(), script: crate::drawing::Script::Normal });
        let out = svg(&drawing(vec![text.into()]));
        assert!(out.contains("θ<tspan dy=\"2\" font-size=\"7.2\">1</tspan><tspan dy=\"-2\" font-size=\"10\"> = 30°"));
    }

    #[test]
    fn names_differ_from_figure_to_figure() {
        let group = |name: &str| Item::from(Group { name: name.into(), ..Group::default() });
        let ids = |items| {
            let out = svg(&drawing(items));
            let document = roxmltree::Document::parse(&out).unwrap();
            document.descendants().filter_map(|node| node.attribute("id").map(String::from)).collect::<Vec<_>>()
        };
        let (one, other) = (ids(vec![group("rays-0"), group("rays-1")]), ids(vec![group("rays-0")]));
        assert!(one[0].starts_with("rays-0-") && one[0][7..] == one[1][7..], "{one:?}");
        assert_ne!(one[0], other[0]);
        assert_eq!(ids(vec![group("")]), Vec::<String>::new());
    }

    #[test]
    fn equal_clips_are_defined_once() {
        let clip = Rect { min: DVec2::ZERO, max: DVec2::new(10.0, 5.0) };
        let group = || Item::from(Group::layer("g", Vec::new()).clipped(clip));
        let out = svg(&drawing(vec![group(), group()]));
        assert_eq!(out.matches("<clipPath").count(), 1);
        assert_eq!(out.matches("url(#clip_0_0_10_5)").count(), 2);
    }
}
