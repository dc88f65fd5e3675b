//! Sound text cut at its commas, without reading what stands between them.

use super::node::skip_blank;

/// What stands between the commas of `(…)` or `[…]`, blanks and comments included; a comma before the closing bracket
/// begins nothing. `text` is sound and begins with the bracket.
pub(super) fn parts(text: &str) -> impl Iterator<Item = &str> {
    let mut start = 1;
    std::iter::from_fn(move || {
        let end = end_of_part(text, start);
        let part = text.get(start..end).filter(|part| text[end..].starts_with(',') || !skip_blank(part).is_empty())?;
        start = end + 1;
        Some(part)
    })
}

/// The place of the comma or of the closing bracket behind what begins at a place.
fn end_of_part(text: &str, start: usize) -> usize {
    let (mut depth, mut at) = (0, start);
    while let Some(byte) = text.as_bytes().get(at) {
        match byte {
            b'(' | b'[' | b'{' => depth += 1,
            b')' | b']' | b'}' | b',' if depth == 0 => return at,
            b')' | b']' | b'}' => depth -= 1,
            _ => {}
        }
        at += token(text, at);
    }
    at.min(text.len())
}

/// Bytes of the comment or of the text in quotes that begins at a place; else of one that is no letter or digit, or of a
/// whole word.
pub(super) fn token(text: &str, at: usize) -> usize {
    let rest = &text.as_bytes()[at..];
    match rest[0] {
        b'"' => quoted(rest, b'"'),
        b'\'' => quoted(rest, b'\''),
        b'/' => match rest.len() - skip_blank(&text[at..]).len() {
            // A comment that never ends holds all the rest, other comments that begin in it too.
            0 if rest.starts_with(b"/*") => rest.len(),
            length => length.max(1),
        },
        byte if is_word(byte) => {
            let word = rest.iter().position(|byte| !is_word(*byte)).unwrap_or(rest.len());
            match &rest[..word] {
                b"r" | b"br" => word + raw_quoted(&rest[word..]),
                _ => word,
            }
        }
        _ => 1,
    }
}

/// Also bytes of other than ASCII characters.
fn is_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_' || byte >= 0x80
}

/// Bytes up to the quote that ends what begins with one.
fn quoted(rest: &[u8], quote: u8) -> usize {
    let mut escaped = false;
    let ends = |byte: &u8| {
        let end = *byte == quote && !escaped;
        escaped = *byte == b'\\' && !escaped;
        end
    };
    rest.iter().skip(1).position(ends).map_or(rest.len(), |at| at + 2)
}

/// Bytes of `#"…"#` with any number of `#`; none where this does not begin so.
fn raw_quoted(rest: &[u8]) -> usize {
    let hashes = rest.iter().take_while(|byte| **byte == b'#').count();
    if rest.get(hashes) != Some(&b'"') {
        return 0;
    }
    let inside = &rest[hashes + 1..];
    let follow = |at: usize| inside[at + 1..].iter().take(hashes).take_while(|byte| **byte == b'#').count();
    let ends = |at: &usize| inside[*at] == b'"' && follow(*at) == hashes;
    (0..inside.len()).find(ends).map_or(rest.len(), |at| at + 2 * hashes + 2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commas_in_brackets_quotes_and_comments_do_not_count() {
        let text = r##"(a: (1, 2), b: "x, \", (", /* , ( */ r#"y", ("#, 'z', ',', // , (
            [3, 4], é,)"##;
        let values = ["a: (1, 2)", "b: \"x, \\\", (\"", "r#\"y\", (\"#", "'z'", "','", "[3, 4]", "é"];
        assert_eq!(parts(text).map(|part| skip_blank(part).trim_end()).collect::<Vec<_>>(), values);
        assert_eq!(parts("[]").count(), 0);
        assert_eq!(parts("( /* none */ )").count(), 0);
        assert_eq!(parts("(,)").collect::<Vec<_>>(), [""]);
    }
}
