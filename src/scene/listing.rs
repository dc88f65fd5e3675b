use std::fmt::Write as _;
use std::ops::Range;

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};

use crate::scene::{Problem, Severity};

/// Problems as text for people, each beginning with `FILE:LINE:COL:`, then the line at fault underlined, then the cure.
///
/// Lines and columns count from 1, columns in characters. `text` is the scene's text; for a scene without text, pass `""`.
#[must_use]
pub fn render_problems(problems: &[Problem], text: &str, file: &str) -> String {
    let mut out = String::new();
    for problem in problems {
        if !out.is_empty() {
            out.push('\n');
        }
        render(&mut out, problem, text, file);
    }
    out
}

fn render(out: &mut String, problem: &Problem, text: &str, file: &str) {
    let severity = match problem.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
    };
    let span = problem.span.clone().filter(|span| text.get(span.clone()).is_some());
    let place = span.as_ref().map_or(String::new(), |span| {
        let (line, column) = line_and_column(text, span.start);
        format!("{line}:{column}:")
    });
    // Writing to a string cannot fail.
    let _ = writeln!(out, "{file}:{place} {severity}: {}", problem.message);
    if let Some(span) = span {
        out.push_str(&snippet(problem, text, span));
    }
    if !problem.path.is_empty() {
        let _ = writeln!(out, "  in: {}", problem.path);
    }
    if !problem.help.is_empty() {
        let _ = writeln!(out, "help: {}", problem.help);
    }
}

/// The line at fault with its number, underlined.
fn snippet(problem: &Problem, text: &str, span: Range<usize>) -> String {
    let start = text[..span.start].rfind('\n').map_or(0, |at| at + 1);
    let rest = &text[span.start..];
    let end = span.start + rest.find('\n').unwrap_or(rest.len());
    let line = text[start..end].trim_end_matches('\r');
    let (number, _) = line_and_column(text, span.start);
    let marked = span.start - start..(span.end.max(span.start + 1) - start).min(line.len().max(span.start - start));
    let mark = AnnotationKind::Primary.span(marked).label((!problem.label.is_empty()).then_some(&*problem.label));
    let source = Snippet::source(line).line_start(number).annotation(mark);
    let report = [Level::ERROR.no_name().secondary_title("").element(source)];
    let shown = Renderer::plain().render(&report);
    shown.lines().skip(1).map(|line| format!("{}\n", line.trim_end())).collect()
}

/// Line and column of a byte, both from 1; the column counts characters, and a byte order mark is none.
fn line_and_column(text: &str, at: usize) -> (usize, usize) {
    let before = text.get(..at).unwrap_or(text).trim_start_matches('\u{feff}');
    let line_start = before.rfind('\n').map_or(0, |at| at + 1);
    (1 + before.matches('\n').count(), 1 + before[line_start..].chars().count())
}
