use crate::scene::names::nearest;

/// What to write for a color.
const COLOR_HELP: &str = "write `\"#rrggbb\"`, `\"#rgb\"` or one of the names `\"black\"`, `\"gray\"`, `\"white\"`, \
     `\"red\"`, `\"orange\"`, `\"yellow\"`, `\"green\"`, `\"cyan\"`, `\"blue\"`, `\"violet\"`, `\"magenta\"`, `\"brown\"`";

const NAMED: [(&str, [u8; 3]); 13] = [
    ("black", [0, 0, 0]),
    ("gray", [128, 128, 128]),
    ("grey", [128, 128, 128]),
    ("white", [255, 255, 255]),
    ("red", [255, 0, 0]),
    ("orange", [255, 165, 0]),
    ("yellow", [255, 255, 0]),
    ("green", [0, 128, 0]),
    ("cyan", [0, 255, 255]),
    ("blue", [0, 0, 255]),
    ("violet", [238, 130, 238]),
    ("magenta", [255, 0, 255]),
    ("brown", [165, 42, 42]),
];

/// What to write instead of a color that there is not.
pub(super) fn color_help(wrong: &str) -> String {
    match nearest(wrong, &NAMED.map(|(name, _)| name)) {
        Some(near) => format!("did you mean `\"{near}\"`? Else {COLOR_HELP}"),
        None => COLOR_HELP.to_owned(),
    }
}

/// Red, green and blue of `#rrggbb`, `#rgb` or a name of CSS.
pub(super) fn parse_color(text: &str) -> Option<[u8; 3]> {
    let Some(digits) = text.strip_prefix('#') else {
        return NAMED.iter().find(|(name, _)| *name == text).map(|(_, color)| *color);
    };
    let digits: Vec<u8> = digits.chars().map(hex_digit).collect::<Option<_>>()?;
    match digits[..] {
        [r, g, b] => Some([17 * r, 17 * g, 17 * b]),
        [r1, r0, g1, g0, b1, b0] => Some([16 * r1 + r0, 16 * g1 + g0, 16 * b1 + b0]),
        _ => None,
    }
}

fn hex_digit(c: char) -> Option<u8> {
    c.to_digit(16).and_then(|digit| u8::try_from(digit).ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_long_short_and_named_colors() {
        assert_eq!(parse_color("#1f77b4"), Some([0x1f, 0x77, 0xb4]));
        assert_eq!(parse_color("#Fa0"), Some([0xff, 0xaa, 0x00]));
        assert_eq!(parse_color("orange"), Some([255, 165, 0]));
    }

    #[test]
    fn refuses_everything_else() {
        for text in ["", "#", "#12345", "#+1+1+1", "#ééé", "rouge", "1f77b4"] {
            assert_eq!(parse_color(text), None, "{text}");
        }
    }
}
