//! Characters that do not stand for themselves but act on what stands around them. Words come from strangers: such a character
//! must not move a terminal's cursor, break a line, or turn other words round.

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

/// Words on one line, with spaces in place of characters that steer.
pub(crate) fn one_line(words: &str) -> String {
    words.split(steers).collect::<Vec<_>>().join(" ")
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
}
