//! Characters that do not stand for themselves but act on what stands around them. Words come from strangers: such a character
//! must not move a terminal's cursor, break a line, or turn other words round.

use std::borrow::Cow;

/// Whether a character steers: a control character (also those above ASCII, which some terminals obey), a break of lines, or a
/// mark or override of the direction of writing (Unicode Standard Annex 9, table 4).
pub(crate) fn steers(c: char) -> bool {
    c.is_control() || is_bidi_control(c) || matches!(c, '\u{2028}' | '\u{2029}')
}

fn is_bidi_control(c: char) -> bool {
    matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// Whether a character leaves no trace of its own where fonts follow Unicode (its property Default_Ignorable_Code_Point, but for
/// the fillers of Hangul): joiners, selectors of variants, soft hyphens, tags.
pub(crate) fn is_invisible(c: char) -> bool {
    is_bidi_control(c)
        || matches!(c, '\u{ad}' | '\u{34f}' | '\u{180b}'..='\u{180f}' | '\u{200b}'..='\u{200d}' | '\u{2060}'..='\u{206f}')
        || matches!(c, '\u{fe00}'..='\u{fe0f}' | '\u{feff}' | '\u{1d173}'..='\u{1d17a}' | '\u{e0000}'..='\u{e0fff}')
}

/// Whether a character is not seen where it stands: one that steers, an invisible one, or a mark of annotations between lines.
pub(crate) fn is_unseen(c: char) -> bool {
    steers(c) || is_invisible(c) || matches!(c, '\u{fff9}'..='\u{fffb}')
}

/// Words on one line, with spaces in place of characters that steer.
pub(crate) fn one_line(words: &str) -> String {
    words.split(steers).collect::<Vec<_>>().join(" ")
}

/// Text for a terminal: what is not seen appears as `\u{1b}`.
pub(crate) fn harmless(text: &str) -> Cow<'_, str> {
    if !text.contains(is_unseen) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        if is_unseen(c) { shown.extend(c.escape_unicode()) } else { shown.push(c) }
    }
    Cow::Owned(shown)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_steers_is_a_space() {
        let words = "a\u{1b}[2J\u{9b}b\nc\u{202e}d\u{2028}é";
        assert_eq!(one_line(words), "a [2J b c d é");
    }

    #[test]
    fn joiners_are_invisible_and_do_not_steer() {
        for c in "\u{200c}\u{200d}\u{fe0f}\u{feff}".chars() {
            assert!(is_invisible(c) && !steers(c), "{c:?}");
        }
        assert!(!is_invisible(' ') && !is_invisible('\u{301}') && !is_invisible('א'));
    }

    #[test]
    fn what_is_not_seen_is_shown_as_its_number() {
        assert_eq!(harmless("a\u{1b}[31mb\n\u{9b}c"), "a\\u{1b}[31mb\\u{a}\\u{9b}c");
        assert_eq!(harmless("x\u{202e}y\u{2066}"), "x\\u{202e}y\\u{2066}");
        assert!(matches!(harmless("Größe 4 µm, 光"), Cow::Borrowed(_)));
    }
}
