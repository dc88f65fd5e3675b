//! Files that are no scene at all: other languages, other encodings, no text.

use super::node::skip_blank;
use crate::scene::{Problem, Problems};

/// How files begin that are no text, and what they are.
const KINDS: [(&[u8], &str); 8] = [
    (b"\x89PNG", "a PNG picture"),
    (b"\xff\xd8\xff", "a JPEG picture"),
    (b"GIF8", "a GIF picture"),
    (b"%PDF", "a PDF document"),
    (b"PK\x03\x04", "a ZIP archive or an office document"),
    (b"\x1f\x8b", "a compressed file"),
    (b"\xff\xfe", "text in UTF-16"),
    (b"\xfe\xff", "text in UTF-16"),
];

/// The text of a scene file's bytes, for [`load`](crate::scene::load).
///
/// # Errors
/// The bytes are not UTF-8; the problem shows the place of the first fault under the file's name.
pub fn text_of<'a>(bytes: &'a [u8], file: &str) -> Result<&'a str, Problems> {
    if let Some((_, kind)) = KINDS.iter().find(|(begin, _)| bytes.starts_with(begin)) {
        let help = if kind.starts_with("text") {
            "save the file as UTF-8, which every editor offers"
        } else {
            "give a scene file, which is text that begins with `(`; `snellius new prism` prints one"
        };
        let problem = Problem::error("", format!("this is {kind}, not a scene"), help).at(0..0);
        return Err(Problems::new(vec![problem], "", file));
    }
    std::str::from_utf8(bytes).map_err(|error| {
        let help = "save the file as UTF-8, which every editor offers";
        let problem = Problem::error("", "the file is not text in UTF-8", help).label("not a character");
        let start = error.valid_up_to();
        let shown = bytes.get(..bytes.len().min(start + 300)).unwrap_or(bytes);
        let text = String::from_utf8_lossy(shown).into_owned();
        Problems::new(vec![problem.at(start..start + char::REPLACEMENT_CHARACTER.len_utf8())], text, file)
    })
}

/// What is wrong with text that begins as no scene does; `offset` is where it begins in the file.
pub(super) fn other_language(text: &str, offset: usize) -> Option<Problem> {
    let start = text.len() - skip_blank(text).len();
    let rest = &text[start..];
    let (begin, what, help) = if rest.starts_with('{') {
        ("{", "as in JSON or Python", "write `(title: \"…\", bodies: […])`, names of fields without quotes")
    } else if rest.starts_with('<') {
        (
            "<",
            "as in XML or SVG",
            "write `(title: \"…\", bodies: […])`; `snellius new prism` prints a scene to start from",
        )
    } else if rest.starts_with("---") {
        ("---", "as in YAML", "write `(title: \"…\", bodies: […])`; `snellius new prism` prints a scene to start from")
    } else {
        return None;
    };
    let message = format!("a scene begins with `(`, not with `{begin}` {what}");
    let at = offset + start;
    Some(Problem::error("", message, help).label("not a scene").at(at..at + begin.len()))
}
