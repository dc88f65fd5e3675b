use crate::drawing::{Font, words};

/// Signs that belong to what stands on both sides of them.
const JOINTS: [&str; 14] = ["=", "≈", "≠", "<", ">", "≤", "≥", "+", "−", "±", "·", "×", "/", "∝"];
/// Functions, which belong to what follows.
const FUNCTIONS: [&str; 6] = ["sin", "cos", "tan", "asin", "acos", "atan"];
/// What may stand after a number as its unit.
const UNITS: [&str; 16] =
    ["mm", "cm", "m", "km", "µm", "μm", "nm", "°", "′", "%", "‰", "px", "s", "ms", "dpt", "times"];

/// Breaks text into lines of at most `width` ems, between words where it can and never within a quantity that fits.
pub(super) fn wrap(text: &str, font: Font, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let mut line = String::new();
    for word in quantities(text, font, width) {
        let longer = if line.is_empty() { word.clone() } else { format!("{line} {word}") };
        if font.width(&longer) <= width {
            line = longer;
            continue;
        }
        lines.extend(Some(std::mem::take(&mut line)).filter(|line| !line.is_empty()));
        line = break_word(&word, font, width, &mut lines);
    }
    lines.extend(Some(line).filter(|line| !line.is_empty()));
    lines
}

/// The words of a text, those of one quantity (`66.7 mm`, `n = 1.5`) as one word where it fits on a line.
fn quantities(text: &str, font: Font, width: f64) -> Vec<String> {
    let mut joined: Vec<String> = Vec::new();
    let mut before = "";
    for word in words(text) {
        match joined.last_mut() {
            Some(last) if belong(before, word) && font.width(last) + font.width(word) + font.advance(' ') <= width => {
                last.push(' ');
                last.push_str(word);
            }
            _ => joined.push(word.to_owned()),
        }
        before = word;
    }
    joined
}

/// Whether two words are parts of one quantity.
fn belong(before: &str, word: &str) -> bool {
    let unit = word.trim_end_matches(['.', ',', ';', ':', ')', '!', '?']);
    let number = before.ends_with(|c: char| c.is_ascii_digit()) || before.ends_with('°');
    let functions = || FUNCTIONS.contains(&before.trim_start_matches('('));
    JOINTS.contains(&before) || JOINTS.contains(&word) || functions() || number && UNITS.contains(&unit)
}

/// Puts full lines of a word that is too long into `lines` and returns the rest.
fn break_word(word: &str, font: Font, width: f64, lines: &mut Vec<String>) -> String {
    let mut line = String::new();
    let mut length = 0.0;
    for character in word.chars() {
        let advance = font.advance(character);
        if length + advance > width && !line.is_empty() {
            lines.push(std::mem::take(&mut line));
            length = 0.0;
        }
        line.push(character);
        length += advance;
    }
    line
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantities_stay_whole() {
        for (text, whole) in [
            ("it stands 66.7 mm in front", "66.7 mm"),
            ("the angle is 41.2 °, no more", "41.2 °,"),
            ("of glass with n = 1.5 it is", "n = 1.5"),
            ("of glass, n\u{a0}=\u{a0}1.5\u{a0}or\u{a0}so, it", "n\u{a0}=\u{a0}1.5\u{a0}or\u{a0}so,"),
            ("so sin 45° = 1.5 sin 28° holds", "sin 45° = 1.5 sin 28°"),
        ] {
            for width in 12..30 {
                let lines = wrap(text, Font::Regular, f64::from(width));
                assert!(lines.iter().any(|line| line.contains(whole)), "{width}: {lines:?}");
            }
        }
        assert_eq!(wrap("n = 1.5", Font::Regular, 2.5), ["n =", "1.5"], "where it does not fit");
    }

    #[test]
    fn no_line_is_longer_than_the_width() {
        let text = "Light meets the hypotenuse at 45°. Donaudampfschifffahrtsgesellschaft is long.";
        let lines = wrap(text, Font::Regular, 12.0);
        assert!(lines.len() > 3);
        assert!(lines.iter().all(|line| Font::Regular.width(line) <= 12.0));
        assert_eq!(lines.concat().replace(' ', ""), text.replace(' ', ""));
        assert!(wrap(" \n", Font::Bold, 12.0).is_empty());
        assert_eq!(wrap("ab", Font::Bold, 0.0), ["a", "b"], "never stuck");
    }
}
