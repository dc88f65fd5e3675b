use std::cell::Cell;
use std::ops::Range;

const BYTE_ORDER_MARK: char = '\u{feff}';

/// A text and where its lines begin, after a byte order mark. A line ends with `\n`, `\r\n` or `\r`.
pub(crate) struct Lines<'a> {
    pub(super) text: &'a str,
    starts: Vec<usize>,
    /// A byte and the column of it that was asked for last: most problems come in the order of the text.
    last: Cell<(usize, usize)>,
}

/// Where a span begins and ends: lines and columns from 1, columns in characters (Unicode scalar values). The end is the place
/// behind its last character.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct LineSpan {
    pub(crate) line: usize,
    pub(crate) column: usize,
    pub(crate) end_line: usize,
    pub(crate) end_column: usize,
}

impl<'a> Lines<'a> {
    pub(crate) fn new(text: &'a str) -> Self {
        let first = if text.starts_with(BYTE_ORDER_MARK) { BYTE_ORDER_MARK.len_utf8() } else { 0 };
        let bytes = text.as_bytes();
        let is_end = |at: usize| match bytes[at] {
            b'\n' => true,
            b'\r' => bytes.get(at + 1) != Some(&b'\n'),
            _ => false,
        };
        let others = (0..bytes.len()).filter(|at| is_end(*at)).map(|at| at + 1);
        Self { text, starts: std::iter::once(first).chain(others).collect(), last: Cell::default() }
    }

    /// Where a span is; `None` if the text has no such bytes.
    pub(crate) fn span(&self, span: &Range<usize>) -> Option<LineSpan> {
        let inside = self.text.get(span.clone())?;
        let (line, end_line) = (self.number(span.start), self.number(span.end));
        let column = self.column(span.start);
        let end_column = if line == end_line {
            column + inside.chars().count()
        } else {
            1 + self.characters(self.line(end_line).start, span.end)
        };
        Some(LineSpan { line, column, end_line, end_column })
    }

    fn column(&self, at: usize) -> usize {
        let start = self.line(self.number(at)).start;
        let (known, column) = self.last.get();
        let (from, before) = if (start..=at).contains(&known) && column > 0 { (known, column) } else { (start, 1) };
        let column = before + self.characters(from, at);
        self.last.set((at, column));
        column
    }

    fn characters(&self, from: usize, to: usize) -> usize {
        self.text.get(from..to).map_or(0, |between| between.chars().count())
    }

    /// Number of the line that holds a byte, from 1.
    pub(super) fn number(&self, at: usize) -> usize {
        self.starts.partition_point(|start| *start <= at).max(1)
    }

    /// The line with a number, without its end, as bytes of the text.
    pub(super) fn line(&self, number: usize) -> Range<usize> {
        let start = self.starts[number - 1];
        let end = self.starts.get(number).copied().unwrap_or(self.text.len());
        let line = self.text.get(start..end).unwrap_or_default();
        start..start + line.trim_end_matches(['\r', '\n']).len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn span(text: &str, span: Range<usize>) -> [usize; 4] {
        let LineSpan { line, column, end_line, end_column } = Lines::new(text).span(&span).unwrap();
        [line, column, end_line, end_column]
    }

    #[test]
    fn spans_count_characters_and_end_behind_the_last_one() {
        assert_eq!(span("ab\ncd", 1..2), [1, 2, 1, 3]);
        assert_eq!(span("é–\nµcd", 2..9), [1, 2, 2, 3], "bytes of one letter each: 2, 3, 1, 2, 1");
        assert_eq!(span("\u{feff}(x)", 4..5), [1, 2, 1, 3]);
        assert_eq!(span("", 0..0), [1, 1, 1, 1]);
        assert_eq!(Lines::new("é").span(&(1..2)), None);
    }

    #[test]
    fn every_kind_of_line_end_ends_a_line() {
        let text = "a\r\nb\rc\nd\r";
        assert_eq!([0, 3, 5, 7].map(|at| span(text, at..at + 1)[..2].to_vec()), [[1, 1], [2, 1], [3, 1], [4, 1]]);
        assert_eq!(Lines::new(text).line(1), 0..1);
    }

    #[test]
    fn columns_come_right_in_any_order() {
        let text = "0123456789\n0123456789";
        let lines = Lines::new(text);
        let column = |at: usize| lines.span(&(at..at)).map(|place| (place.line, place.column));
        let places = [3, 7, 5, 13, 20, 2].map(column);
        assert_eq!(places, [(1, 4), (1, 8), (1, 6), (2, 3), (2, 10), (1, 3)].map(Some));
    }
}
