use std::fmt::Write as _;
use std::ops::Range;

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};

use crate::scene::{Problem, Severity};

const MOST_SHOWN: usize = 100;
const BYTE_ORDER_MARK: char = '\u{feff}';
/// Bytes shown to either side of the fault in a very long line.
const SURROUNDINGS: usize = 300;

/// Problems as text for people, each beginning with `FILE:LINE:COL:`, then the line at fault underlined, its path and the cure.
///
/// Lines and columns count from 1, columns in characters. `text` is the scene's text; for a scene without text, pass `""`.
/// After 100 problems, the rest is counted only.
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
    let severity = match problem.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
    };
    let span = problem.span.clone().filter(|span| lines.text.get(span.clone()).is_some());
    let place = span.as_ref().map_or(String::new(), |span| {
        let (line, column) = lines.place(span.start);
        format!("{line}:{column}: ")
    });
    let file = if file.is_empty() { String::new() } else { format!("{file}:") };
    let gap = if place.is_empty() && !file.is_empty() { " " } else { "" };
    let mut out = format!("{file}{gap}{place}{severity}: {}\n", problem.message);
    out.extend(span.map(|span| lines.snippet(span, &problem.label)));
    // Writing to a string cannot fail.
    if !problem.path.is_empty() {
        let _ = writeln!(out, "  in: {}", problem.path);
    }
    if !problem.help.is_empty() {
        let _ = writeln!(out, "help: {}", problem.help);
    }
    out
}

/// A text and where its lines begin, after a byte order mark.
struct Lines<'a> {
    text: &'a str,
    starts: Vec<usize>,
}

impl<'a> Lines<'a> {
    fn new(text: &'a str) -> Self {
        let first = if text.starts_with(BYTE_ORDER_MARK) { BYTE_ORDER_MARK.len_utf8() } else { 0 };
        let others = text.match_indices('\n').map(|(at, _)| at + 1);
        Self { text, starts: std::iter::once(first).chain(others).collect() }
    }

    /// Number of the line that holds a byte, from 1.
    fn number(&self, at: usize) -> usize {
        self.starts.partition_point(|start| *start <= at).max(1)
    }

    /// The line with a number, without its end, as bytes of the text.
    fn line(&self, number: usize) -> Range<usize> {
        let start = self.starts[number - 1];
        let end = self.starts.get(number).map_or(self.text.len(), |next| next - 1);
        let line = self.text.get(start..end).unwrap_or_default();
        start..start + line.trim_end_matches('\r').len()
    }

    /// Line and column of a byte, both from 1.
    fn place(&self, at: usize) -> (usize, usize) {
        let number = self.number(at);
        let before = self.text.get(self.line(number).start..at).unwrap_or_default();
        (number, 1 + before.chars().count())
    }

    /// The line at fault with its number, underlined; of a fault over several lines the first.
    fn snippet(&self, span: Range<usize>, label: &str) -> String {
        let number = self.number(span.start);
        let line = self.line(number);
        let start = span.start.clamp(line.start, line.end);
        let end = span.end.clamp(start, line.end);
        let shown_start = boundary(self.text, start.saturating_sub(SURROUNDINGS)).max(line.start);
        let shown_end = boundary(self.text, start + SURROUNDINGS).min(line.end);
        let marked = start - shown_start..end.min(shown_end) - shown_start;
        let mark = AnnotationKind::Primary.span(marked).label((!label.is_empty()).then_some(label));
        let source = Snippet::source(&self.text[shown_start..shown_end]).line_start(number).annotation(mark);
        let shown = Renderer::plain().render(&[Level::ERROR.no_name().secondary_title("").element(source)]);
        shown.lines().skip(1).map(|line| format!("{}\n", line.trim_end())).collect()
    }
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
