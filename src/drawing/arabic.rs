//! The joined forms of Arabic letters, for renderers that draw outlines letter by letter.
//!
//! # Source
//! The Unicode Standard, 9.2, cursive joining, and the blocks Arabic Presentation Forms-A and -B, which hold the forms of a letter in
//! the order isolated, final, initial, medial; letters that join only the one before have the first two.

use unicode_bidi::{BidiClass, bidi_class};

const TATWEEL: char = '\u{640}';
const JOINER: char = '\u{200d}';
const LAM: char = '\u{644}';

/// Forms-B: from this letter on, the number of forms of each, and where the first of them stands.
const BASIC: [(u32, &str, u32); 2] = [(0x621, "12222424244444222244444444", 0xfe80), (0x641, "4444444224", 0xfed1)];
/// Letters of Persian and Urdu in Forms-A: the letter, its first form, the number of forms.
const MORE: [(char, u32, u32); 13] = [
    ('\u{679}', 0xfb66, 4),
    ('\u{67e}', 0xfb56, 4),
    ('\u{686}', 0xfb7a, 4),
    ('\u{688}', 0xfb88, 2),
    ('\u{691}', 0xfb8c, 2),
    ('\u{698}', 0xfb8a, 2),
    ('\u{6a9}', 0xfb8e, 4),
    ('\u{6af}', 0xfb92, 4),
    ('\u{6ba}', 0xfb9e, 2),
    ('\u{6be}', 0xfbaa, 4),
    ('\u{6c1}', 0xfba6, 4),
    ('\u{6cc}', 0xfbfc, 4),
    ('\u{6d2}', 0xfbae, 2),
];
/// Lam and an alef are one sign: the alef, and the first of its two forms.
const LAM_ALEF: [(char, u32); 4] = [('\u{622}', 0xfef5), ('\u{623}', 0xfef7), ('\u{625}', 0xfef9), ('\u{627}', 0xfefb)];

/// The same words with every letter in the form that its neighbors ask for. Other characters stay.
pub(super) fn joined(text: &str) -> String {
    let letters: Vec<char> = text.chars().collect();
    let is_mark = |c: &&char| bidi_class(**c) == BidiClass::NSM;
    let mut out = String::with_capacity(text.len());
    let mut before = false;
    let mut skip = false;
    for (k, &letter) in letters.iter().enumerate() {
        if std::mem::take(&mut skip) {
            continue;
        }
        if is_mark(&&letter) {
            out.push(letter);
            continue;
        }
        let alef = letters.get(k + 1).and_then(|next| LAM_ALEF.iter().find(|(alef, _)| letter == LAM && alef == next));
        let Some((first, count)) = alef.map(|(_, first)| (*first, 2)).or_else(|| forms(letter)) else {
            out.push(letter);
            before = matches!(letter, TATWEEL | JOINER);
            continue;
        };
        skip = alef.is_some();
        let next = letters[k + 1..].iter().find(|c| !is_mark(c));
        let after =
            count == 4 && next.is_some_and(|c| matches!(*c, TATWEEL | JOINER) || forms(*c).is_some_and(|(_, n)| n > 1));
        let form = first + u32::from(before && count > 1) + 2 * u32::from(after);
        out.push(char::from_u32(form).unwrap_or(letter));
        before = count == 4 && after;
    }
    out
}

/// The first form of a letter, and the number of its forms.
fn forms(letter: char) -> Option<(u32, u32)> {
    let in_basic = |(start, counts, first): &(u32, &str, u32)| {
        let place = usize::try_from(u32::from(letter).checked_sub(*start)?).ok()?;
        let count = counts.chars().nth(place)?.to_digit(10)?;
        Some((first + counts.chars().take(place).filter_map(|c| c.to_digit(10)).sum::<u32>(), count))
    };
    let more = || MORE.iter().find(|(known, ..)| *known == letter).map(|(_, first, count)| (*first, *count));
    BASIC.iter().find_map(in_basic).or_else(more)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_forms_are_those_of_the_standard() {
        // The last letter of each stretch ends where the next begins in Unicode's chart.
        assert_eq!(forms('\u{63a}'), Some((0xfecd, 4)), "ghain");
        assert_eq!(forms('\u{64a}'), Some((0xfef1, 4)), "yeh, before the ligatures of lam");
        assert_eq!(forms('\u{62f}'), Some((0xfea9, 2)), "dal");
        assert_eq!(forms('a'), None);
    }

    #[test]
    fn letters_join_their_neighbors() {
        assert_eq!(joined("ضوء"), "\u{febf}\u{feee}\u{fe80}", "light");
        assert_eq!(joined("عدسة"), "\u{fecb}\u{feaa}\u{feb3}\u{fe94}", "lens");
        assert_eq!(joined("سلام n"), "\u{feb3}\u{fefc}\u{fee1} n", "lam and alef are one");
        assert_eq!(joined("بَب"), "\u{fe91}\u{64e}\u{fe90}", "marks part nothing");
        assert_eq!(joined("ب\u{200c}ب"), "\u{fe8f}\u{200c}\u{fe8f}", "a non-joiner does");
        assert_eq!(joined("گپ"), "\u{fb94}\u{fb57}");
        assert_eq!(joined("abc אב"), "abc אב");
    }
}
