use std::fmt::Write as _;
use std::ops::Range;

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};

use crate::characters::{harmless, is_unseen};
use crate::scene::Problem;
use crate::scene::lines::{LineSpan, Lines};

const MOST_SHOWN: usize = 100;
/// Bytes shown to either side of the fault in a very long line.
const SURROUNDINGS: usize = 300;

/// Problems as text for people, each beginning with `FILE:LINE:COL:`, then the line at fault underlined, its path and the cure.
///
/// Lines and columns count from 1, columns in characters. Characters that would command a terminal are shown as signs or numbers.
/// `text` is the scene's text; for a scene without text, pass `""`. After 100 problems, the rest is counted only.
#[must_use]
pub fn render_problems(problems: &[Problem], text: &str, file: &str) -> String {
    let lines = Lines::new(text);
    let mut shown: Vec<String> =
        problems.iter().take(MOST_SHOWN).map(|problem| render(problem, &lines, file)).collect();
    let more: u64 = problems.iter().skip(MOST_SHOWN).map(|problem| u64::from(problem.more.max(1))).sum();
    if more > 0 {
        shown.push(format!("{file}: {more} more problems follow\n"));
    }
    shown.join("\n")
}

fn render(problem: &Problem, lines: &Lines<'_>, file: &str) -> String {
    let severity = problem.severity.word();
    let span = problem.span.as_ref().and_then(|span| Some((span, lines.span(span)?)));
    let place = span.map_or(String::new(), |(_, LineSpan { line, column, .. })| format!("{line}:{column}: "));
    let file = if file.is_empty() { String::new() } else { format!("{}:", harmless(file)) };
    let gap = if place.is_empty() && !file.is_empty() { " " } else { "" };
    let mut out = format!("{file}{gap}{place}{severity}: {}\n", harmless(&problem.message));
    out.extend(span.map(|(span, _)| snippet(lines, span, &harmless(&problem.label))));
    // Writing to a string cannot fail.
    if !problem.path.is_empty() {
        let _ = writeln!(out, "  in: {}", harmless(&problem.path));
    }
    if !problem.help.is_empty() {
        let _ = writeln!(out, "help: {}", harmless(&problem.help));
    }
    out
}

/// The line at fault with its number, underlined; of a fault over several lines the first.
fn snippet(lines: &Lines<'_>, span: &Range<usize>, label: &str) -> String {
    let (text, number) = (lines.text, lines.number(span.start));
    let line = lines.line(number);
    let start = span.start.clamp(line.start, line.end);
    let shown_start = boundary(text, start.saturating_sub(SURROUNDINGS)).max(line.start);
    let shown_end = boundary(text, start + SURROUNDINGS).min(line.end);
    let end = span.end.clamp(start, shown_end);
    let [before, marked, after] = [shown_start..start, start..end, end..shown_end].map(|part| seen(&text[part]));
    let mark = AnnotationKind::Primary.span(before.len()..before.len() + marked.len());
    let mark = mark.label((!label.is_empty()).then_some(label));
    let source = Snippet::source(before + &marked + &after).line_start(number).annotation(mark);
    let shown = Renderer::plain().render(&[Level::ERROR.no_name().secondary_title("").element(source)]);
    shown.lines().skip(1).map(|line| format!("{}\n", line.trim_end())).collect()
}

/// A part of a line with a sign for each character that is not seen; the renderer has signs for most, and for tabs blanks.
fn seen(part: &str) -> String {
    let is_known = |c: char| c.is_ascii_control() || c == '\u{200d}';
    part.chars().map(|c| if is_unseen(c) && !is_known(c) { char::REPLACEMENT_CHARACTER } else { c }).collect()
}

/// The last place between characters at or before a byte.
fn boundary(text: &str, at: usize) -> usize {
    (0..=at.min(text.len())).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str, span: Range<usize>) -> String {
        render_problems(&[Problem::error("", "wrong", "").label("here").at(span)], text, "f")
    }

    #[test]
    fn lines_and_columns_count_characters_from_one() {
        assert!(shown("a\r\n\u{e9}b\r\n", 5..6).starts_with("f:2:2: error: wrong\n2 | \u{e9}b\n"));
        assert!(shown("\u{feff}(x)", 4..5).starts_with("f:1:2: error: wrong\n1 | (x)\n  |  ^ here\n"));
        assert!(shown("", 0..0).starts_with("f:1:1: error: wrong\n"));
        assert!(shown("ab", 2..2).starts_with("f:1:3: error: wrong\n"));
    }

    #[test]
    fn a_fault_over_several_lines_is_shown_by_the_first() {
        assert_eq!(shown("(\n  abc\n)", 4..9), "f:2:3: error: wrong\n2 |   abc\n  |   ^^^ here\n");
    }

    #[test]
    fn tabs_and_wide_characters_keep_the_underline_in_its_place() {
        assert_eq!(shown("\t光(x)", 5..6), "f:1:4: error: wrong\n1 |     光(x)\n  |        ^ here\n");
    }

    #[test]
    fn nothing_commands_the_terminal() {
        let problem = Problem::error("a\u{1b}", "b\u{9b}2J", "c\u{202e}").label("d\u{7}").at(2..3);
        let text = "\u{1b}[31m\u{9b}\u{202e}\u{2028}\u{200e}";
        let shown = render_problems(&[problem], text, "e\u{1b}c");
        assert_eq!(shown.chars().find(|c| is_unseen(*c) && *c != '\n'), None, "{shown:?}");
        assert!(shown.contains("1 | \u{241b}[31m\u{fffd}\u{fffd}\u{fffd}\u{fffd}\n  |   ^ d\\u{7}\n"), "{shown}");
    }

    #[test]
    fn long_lines_are_cut() {
        let text = "µ".repeat(100_000);
        assert!(shown(&text, 100_000..100_002).len() < 1000);
    }

    #[test]
    fn places_outside_of_the_text_are_left_out() {
        assert_eq!(shown("é", 1..7), "f: error: wrong\n");
        assert_eq!(render_problems(&[Problem::error("", "wrong", "")], "", ""), "error: wrong\n");
    }
}
