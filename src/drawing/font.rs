//! DejaVu Sans, embedded: widths for layout, outlines for renderers without fonts of their own.

use std::sync::OnceLock;

use glam::DVec2;
use ttf_parser::{Face, OutlineBuilder};

/// A face of the one family that figures use.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Font {
    /// Upright.
    #[default]
    Regular,
    /// Bold.
    Bold,
    /// Slanted.
    Oblique,
}

/// One step of a glyph's outline, in ems with y down and the baseline at 0.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum GlyphStep {
    /// Start a new contour.
    MoveTo(DVec2),
    /// Straight to a point.
    LineTo(DVec2),
    /// A quadratic curve by its control point and its end.
    QuadTo(DVec2, DVec2),
    /// A cubic curve by its control points and its end.
    CubicTo(DVec2, DVec2, DVec2),
    /// Back to the start of the contour.
    Close,
}

/// Advance of the box that stands for a missing glyph, ems.
const BOX_ADVANCE: f64 = 0.6;

impl Font {
    /// Whether the font has a glyph for a character.
    #[must_use]
    pub fn has(self, character: char) -> bool {
        self.face().is_some_and(|face| face.glyph_index(character).is_some())
    }

    /// How far the next character stands from this one, ems.
    #[must_use]
    pub fn advance(self, character: char) -> f64 {
        self.face()
            .and_then(|face| {
                let units = face.glyph_hor_advance(face.glyph_index(character)?)?;
                Some(f64::from(units) / f64::from(face.units_per_em()))
            })
            .unwrap_or(BOX_ADVANCE)
    }

    /// Width of a line of text in ems, without kerning.
    #[must_use]
    pub fn width(self, text: &str) -> f64 {
        text.chars().map(|character| self.advance(character)).sum()
    }

    /// The outline of a character; a box if the font has no glyph for it.
    #[must_use]
    pub fn outline(self, character: char) -> Vec<GlyphStep> {
        let glyph = self.face().and_then(|face| Some((face, face.glyph_index(character)?)));
        let Some((face, glyph)) = glyph else { return missing_glyph() };
        let mut pen = Pen { per_em: 1.0 / f64::from(face.units_per_em()), steps: Vec::new() };
        // A glyph without an outline, such as a space, leaves the pen empty.
        let _bounds = face.outline_glyph(glyph, &mut pen);
        pen.steps
    }

    /// The whole face as a TrueType file.
    #[must_use]
    pub fn data(self) -> &'static [u8] {
        match self {
            Self::Regular => dejavu::sans::regular(),
            Self::Bold => dejavu::sans::bold(),
            Self::Oblique => dejavu::sans::oblique(),
        }
    }

    fn face(self) -> Option<&'static Face<'static>> {
        static FACES: [OnceLock<Option<Face<'static>>>; 3] = [const { OnceLock::new() }; 3];
        let cell = match self {
            Self::Regular => &FACES[0],
            Self::Bold => &FACES[1],
            Self::Oblique => &FACES[2],
        };
        cell.get_or_init(|| Face::parse(self.data(), 0).ok()).as_ref()
    }
}

/// An upright frame, so that a lost character is seen.
fn missing_glyph() -> Vec<GlyphStep> {
    let mut steps = contour([(0.06, 0.0), (0.06, -0.73), (0.54, -0.73), (0.54, 0.0)]);
    steps.extend(contour([(0.12, -0.06), (0.48, -0.06), (0.48, -0.67), (0.12, -0.67)]));
    steps
}

fn contour(corners: [(f64, f64); 4]) -> Vec<GlyphStep> {
    let mut steps: Vec<_> = corners.iter().map(|(x, y)| GlyphStep::LineTo(DVec2::new(*x, *y))).collect();
    steps[0] = GlyphStep::MoveTo(DVec2::new(corners[0].0, corners[0].1));
    steps.push(GlyphStep::Close);
    steps
}

struct Pen {
    per_em: f64,
    steps: Vec<GlyphStep>,
}

impl Pen {
    fn at(&self, x: f32, y: f32) -> DVec2 {
        DVec2::new(f64::from(x), -f64::from(y)) * self.per_em
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.steps.push(GlyphStep::MoveTo(self.at(x, y)));
    }
    fn line_to(&mut self, x: f32, y: f32) {
        self.steps.push(GlyphStep::LineTo(self.at(x, y)));
    }
    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.steps.push(GlyphStep::QuadTo(self.at(x1, y1), self.at(x, y)));
    }
    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.steps.push(GlyphStep::CubicTo(self.at(x1, y1), self.at(x2, y2), self.at(x, y)));
    }
    fn close(&mut self) {
        self.steps.push(GlyphStep::Close);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn knows_the_letters_of_optics() {
        for character in "θληδ°₁²±µ→".chars() {
            assert!(Font::Regular.has(character), "{character}");
            assert!(!Font::Regular.outline(character).is_empty());
        }
        assert!((Font::Regular.width("Mi") - (1767.0 + 569.0) / 2048.0).abs() < 1e-12);
    }

    #[test]
    fn a_lost_character_is_a_box() {
        assert!(!Font::Bold.has('漢'));
        assert_eq!(Font::Bold.outline('漢'), missing_glyph());
        assert!(Font::Bold.outline(' ').is_empty());
    }
}
