//! Where the letters of right-to-left writing stand. A span is a paragraph of its own: its direction is that of its first letter, and
//! it turns no other words of the figure round. Viewers of SVG are told just that; other renderers get the letters in their places.
//!
//! # Source
//! Unicode Standard Annex 9, the bidirectional algorithm.

use std::borrow::Cow;

use unicode_bidi::{BidiClass, BidiInfo, bidi_class};

use super::arabic::joined;
use crate::characters::is_invisible;

/// Below this character there is neither right-to-left writing nor a mark that joins.
const FIRST: char = '\u{300}';
const SOFT_HYPHEN: char = '\u{ad}';
/// First strong isolate and its end.
const ISOLATE: [char; 2] = ['\u{2068}', '\u{2069}'];
/// Brackets that open to the other side in right-to-left writing.
const MIRRORED: [[char; 2]; 6] = [['(', ')'], ['[', ']'], ['{', '}'], ['<', '>'], ['«', '»'], ['‹', '›']];

/// The words for a viewer that orders letters itself.
pub(super) fn isolated(text: &str) -> Cow<'_, str> {
    let [start, end] = ISOLATE;
    if has_right_to_left(text) { format!("{start}{text}{end}").into() } else { text.into() }
}

/// The characters that are seen, from left to right.
pub(super) fn in_place(text: &str) -> Cow<'_, str> {
    if text.chars().all(|c| c < FIRST && c != SOFT_HYPHEN) {
        return text.into();
    }
    let ordered = if has_right_to_left(text) { ordered(&joined(text)) } else { text.into() };
    ordered.chars().filter(|c| !is_invisible(*c)).collect()
}

fn has_right_to_left(text: &str) -> bool {
    text.chars().any(|c| matches!(bidi_class(c), BidiClass::R | BidiClass::AL | BidiClass::AN))
}

fn ordered(text: &str) -> String {
    let info = BidiInfo::new(text, None);
    let mut out = String::with_capacity(text.len());
    for paragraph in &info.paragraphs {
        let (levels, runs) = info.visual_runs(paragraph, paragraph.range.clone());
        for run in runs {
            let part = &text[run.clone()];
            if levels[run.start].is_ltr() {
                out.push_str(part);
            } else {
                out.extend(clusters(part).into_iter().rev().flat_map(str::chars).map(mirrored));
            }
        }
    }
    out
}

/// Characters, each with the marks that stand on it.
fn clusters(text: &str) -> Vec<&str> {
    let starts = text.char_indices().filter(|(at, c)| *at == 0 || bidi_class(*c) != BidiClass::NSM).map(|(at, _)| at);
    let starts: Vec<usize> = starts.chain([text.len()]).collect();
    starts.windows(2).map(|ends| &text[ends[0]..ends[1]]).collect()
}

fn mirrored(c: char) -> char {
    let other = |[a, b]: &[char; 2]| if c == *a { Some(*b) } else { (c == *b).then_some(*a) };
    MIRRORED.iter().find_map(other).unwrap_or(c)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_stand_where_readers_expect_them() {
        assert_eq!(in_place("n = 1.5, θ"), "n = 1.5, θ");
        assert_eq!(in_place("אבג"), "גבא");
        assert_eq!(in_place("a אב 12 c"), "a 12 בא c", "numbers run left to right");
        assert_eq!(in_place("אב (ג)."), ".(ג) בא", "its own direction is that of its first letter");
        assert_eq!(in_place("אָב"), "באָ", "marks stay on their letters");
        assert_eq!(in_place("ضوء"), "\u{fe80}\u{feee}\u{febf}");
    }

    #[test]
    fn what_is_invisible_leaves_no_box() {
        assert_eq!(in_place("a\u{ad}b\u{200d}c\u{fe0f}d\u{feff}"), "abcd");
    }

    #[test]
    fn only_what_needs_it_is_isolated() {
        assert_eq!(isolated("n = 1.5, θ → 光"), "n = 1.5, θ → 光");
        assert_eq!(isolated("אב"), "\u{2068}אב\u{2069}");
    }
}
