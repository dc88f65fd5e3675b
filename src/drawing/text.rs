use std::borrow::Cow;

use glam::DVec2;

use super::order::{in_place, isolated};
use crate::characters::steers;
use crate::drawing::{Color, Font, Rect, extent, pixel};

/// Size of a subscript as a share of the text's.
const SUBSCRIPT_SIZE: f64 = 0.72;
/// How far a subscript stands below the baseline, as a share of the text's size.
const SUBSCRIPT_DROP: f64 = 0.2;

/// One line of text.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Text {
    /// The anchor's place on the baseline, pixels.
    pub at: DVec2,
    /// Which end of the line stands there.
    pub anchor: Anchor,
    /// Font size in pixels.
    pub size: f64,
    /// Face.
    pub font: Font,
    /// Color.
    pub color: Color,
    /// What is written.
    pub spans: Vec<Span>,
    /// Class names, by spaces; may be empty.
    pub class: String,
}

/// A stretch of text in one script.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Span {
    /// Words without control characters and overrides of the direction of writing; runs of white space are one space, no-break
    /// spaces stay.
    pub text: String,
    /// Where it stands.
    pub script: Script,
}

/// Where a span stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Script {
    /// On the baseline.
    Normal,
    /// Smaller and lower, as the 1 of θ₁.
    Subscript,
}

/// Which end of a line stands at its anchor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Anchor {
    /// The left end.
    Start,
    /// The middle.
    Middle,
    /// The right end.
    End,
}

/// A character in its place.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Glyph {
    /// The character.
    pub character: char,
    /// Left end of its baseline, pixels.
    pub at: DVec2,
    /// Font size, pixels.
    pub size: f64,
}

impl Span {
    /// The words for a viewer that orders letters itself, as of SVG: right-to-left writing stands in a Unicode isolate.
    #[must_use]
    pub fn isolated(&self) -> Cow<'_, str> {
        isolated(&self.text)
    }

    /// The characters that are seen, from left to right, for what draws one after the other: right-to-left writing in its order,
    /// Arabic letters in their joined forms, invisible characters left out.
    #[must_use]
    pub fn in_place(&self) -> Cow<'_, str> {
        in_place(&self.text)
    }
}

impl Text {
    /// A line in the regular face, starting at a point of its baseline.
    #[must_use]
    pub fn new(text: &str, at: DVec2, size: f64, color: Color) -> Self {
        let at = DVec2::new(pixel(at.x), pixel(at.y));
        let spans = vec![Span { text: one_line(text), script: Script::Normal }];
        Self { at, anchor: Anchor::Start, size, font: Font::Regular, color, spans, class: String::new() }
    }

    /// The same with another anchor.
    #[must_use]
    pub fn anchored(self, anchor: Anchor) -> Self {
        Self { anchor, ..self }
    }

    /// The same in another face.
    #[must_use]
    pub fn in_font(self, font: Font) -> Self {
        Self { font, ..self }
    }

    /// The same with class names.
    #[must_use]
    pub fn classed(self, class: &str) -> Self {
        Self { class: class.to_owned(), ..self }
    }

    /// The same with a subscript added at its end.
    #[must_use]
    pub fn subscript(mut self, text: &str) -> Self {
        self.spans.push(Span { text: one_line(text), script: Script::Subscript });
        self
    }

    /// The same with words on the baseline added at its end.
    #[must_use]
    pub fn then(mut self, text: &str) -> Self {
        self.spans.push(Span { text: one_line(text), script: Script::Normal });
        self
    }

    /// Width in pixels.
    #[must_use]
    pub fn width(&self) -> f64 {
        self.spans.iter().map(|span| self.font.width(&span.in_place()) * self.span_size(span)).sum()
    }

    /// The rectangle that the line takes, from above its capitals to below its descenders.
    #[must_use]
    pub fn bounds(&self) -> Rect {
        let left = DVec2::new(self.left(), pixel(self.at.y));
        let size = extent(self.size);
        Rect { min: left - DVec2::new(0.0, 0.78 * size), max: left + DVec2::new(self.width(), 0.24 * size) }
    }

    /// Every character in its place, left to right.
    #[must_use]
    pub fn glyphs(&self) -> Vec<Glyph> {
        let mut x = self.left();
        let mut glyphs = Vec::new();
        for span in &self.spans {
            let size = self.span_size(span);
            for character in span.in_place().chars() {
                glyphs.push(Glyph { character, at: DVec2::new(x, pixel(self.at.y) + self.drop(span)), size });
                x += self.font.advance(character) * size;
            }
        }
        glyphs
    }

    /// Font size of one of its spans, pixels.
    #[must_use]
    pub fn span_size(&self, span: &Span) -> f64 {
        match span.script {
            Script::Normal => extent(self.size),
            Script::Subscript => extent(self.size) * SUBSCRIPT_SIZE,
        }
    }

    /// How far below the baseline one of its spans stands, pixels.
    #[must_use]
    pub fn drop(&self, span: &Span) -> f64 {
        match span.script {
            Script::Normal => 0.0,
            Script::Subscript => extent(self.size) * SUBSCRIPT_DROP,
        }
    }

    fn left(&self) -> f64 {
        let x = pixel(self.at.x);
        match self.anchor {
            Anchor::Start => x,
            Anchor::Middle => x - 0.5 * self.width(),
            Anchor::End => x - self.width(),
        }
    }
}

/// Words between spaces where a line may break: every white space but those that Unicode calls no-break.
pub fn words(text: &str) -> impl Iterator<Item = &str> {
    let breaks = |c: char| c.is_whitespace() && !matches!(c, '\u{a0}' | '\u{202f}' | '\u{2007}');
    text.split(breaks).filter(|word| !word.is_empty())
}

/// Text on one line: runs of white space become one space; what steers other words goes, and what no file of text may hold.
fn one_line(text: &str) -> String {
    let words: Vec<String> = words(text)
        .map(|word| word.chars().filter(|c| !steers(*c) && !matches!(c, '\u{fffe}' | '\u{ffff}')).collect::<String>())
        .filter(|word| !word.is_empty())
        .collect();
    words.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_go() {
        let text = Text::new("a\u{0}b \t\n c\u{7}", DVec2::ZERO, 10.0, Color::hex(0));
        assert_eq!(text.spans[0].text, "ab c");
        let text = Text::new("5\u{a0}mm \n long", DVec2::ZERO, 10.0, Color::hex(0));
        assert_eq!(text.spans[0].text, "5\u{a0}mm long");
        let text = Text::new("a\u{202e}b \u{2067}c\u{ffff}", DVec2::ZERO, 10.0, Color::hex(0));
        assert_eq!(text.spans[0].text, "ab c", "nothing turns other words round");
    }

    #[test]
    fn anchors_move_the_line() {
        let text = Text::new("θ", DVec2::new(100.0, 50.0), 10.0, Color::hex(0)).subscript("1");
        let middle = text.clone().anchored(Anchor::Middle);
        assert!((text.glyphs()[0].at.x - middle.glyphs()[0].at.x - 0.5 * text.width()).abs() < 1e-9);
        assert!(text.glyphs()[1].at.y > 50.0, "a subscript stands lower");
        assert!(text.bounds().contains(DVec2::new(101.0, 49.0)));
    }
}
