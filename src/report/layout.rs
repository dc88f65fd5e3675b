//! How the lines of the JSON trace are broken.

use std::io;

use serde_json::ser::Formatter;

use crate::characters::steers;

/// Breaks lines after the outermost fields, and between the elements of the lists of screens, rays, hits and segments.
#[derive(Debug, Default)]
pub(super) struct OneLineEach {
    depth: usize,
    /// Whether something stands already in the list or object that is being closed.
    filled: bool,
}

impl OneLineEach {
    /// Whether the elements of the list or object at this depth stand on lines of their own.
    fn breaks(&self, list: bool) -> bool {
        if list { self.depth <= 4 } else { self.depth == 1 }
    }

    /// Indentation of the elements at this depth; an object within a list begins where its list's elements stand.
    fn indent(&self, list: bool) -> usize {
        if list { self.depth + 2 } else { 2 }
    }

    fn new_line<W: ?Sized + io::Write>(out: &mut W, indent: usize) -> io::Result<()> {
        write!(out, "\n{:indent$}", "")
    }

    fn open<W: ?Sized + io::Write>(&mut self, out: &mut W, bracket: &[u8]) -> io::Result<()> {
        self.depth += 1;
        self.filled = false;
        out.write_all(bracket)
    }

    fn before_element<W: ?Sized + io::Write>(&self, out: &mut W, list: bool, first: bool) -> io::Result<()> {
        match (self.breaks(list), first) {
            (true, true) => Self::new_line(out, self.indent(list)),
            (true, false) => out.write_all(b",").and_then(|()| Self::new_line(out, self.indent(list))),
            (false, true) => Ok(()),
            (false, false) => out.write_all(b", "),
        }
    }

    fn close<W: ?Sized + io::Write>(&mut self, out: &mut W, list: bool, bracket: &[u8]) -> io::Result<()> {
        if self.breaks(list) && self.filled {
            Self::new_line(out, self.indent(list) - 2)?;
        }
        self.depth -= 1;
        self.filled = true;
        out.write_all(bracket)
    }
}

impl Formatter for OneLineEach {
    /// Letters as they are; characters that a terminal would obey by their codes, which read back the same.
    fn write_string_fragment<W: ?Sized + io::Write>(&mut self, out: &mut W, fragment: &str) -> io::Result<()> {
        let mut rest = fragment;
        while let Some((at, c)) = rest.char_indices().find(|(_, c)| steers(*c)) {
            // None lies above U+FFFF.
            write!(out, "{}\\u{:04x}", &rest[..at], u32::from(c))?;
            rest = &rest[at + c.len_utf8()..];
        }
        out.write_all(rest.as_bytes())
    }

    fn begin_array<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.open(out, b"[")
    }

    fn begin_array_value<W: ?Sized + io::Write>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        self.before_element(out, true, first)
    }

    fn end_array_value<W: ?Sized + io::Write>(&mut self, _: &mut W) -> io::Result<()> {
        self.filled = true;
        Ok(())
    }

    fn end_array<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.close(out, true, b"]")
    }

    fn begin_object<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.open(out, b"{")
    }

    fn begin_object_key<W: ?Sized + io::Write>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        self.before_element(out, false, first)
    }

    fn begin_object_value<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        out.write_all(b": ")
    }

    fn end_object_value<W: ?Sized + io::Write>(&mut self, _: &mut W) -> io::Result<()> {
        self.filled = true;
        Ok(())
    }

    fn end_object<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.close(out, false, b"}")
    }
}
