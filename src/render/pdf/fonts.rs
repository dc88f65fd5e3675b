//! The font's faces, each with just the glyphs that are used, and the way back from glyphs to characters.

use std::collections::BTreeMap;

use pdf_writer::types::{CidFontType, FontFlags, SystemInfo, UnicodeCmap};
use pdf_writer::{Filter, Finish, Name, Rect, Ref, Str};
use subsetter::GlyphRemapper;
use ttf_parser::{Face, GlyphId};

use super::{File, LEVEL};
use crate::drawing::Font;
use crate::render::fingerprint::fingerprint;
use crate::render::png::RenderError;

/// What is used of the faces.
#[derive(Default)]
pub(super) struct Fonts(BTreeMap<Font, Used>);

/// What is used of a face.
#[derive(Default)]
struct Used {
    glyphs: GlyphRemapper,
    /// The character of each glyph, by its number in the reduced face.
    characters: BTreeMap<u16, char>,
}

impl Fonts {
    /// The bytes that show some text, two a glyph. A character that the face lacks becomes its glyph 0, a box.
    pub(super) fn encode(&mut self, font: Font, text: &str) -> Vec<u8> {
        let used = self.0.entry(font).or_default();
        let face = Face::parse(font.data(), 0).ok();
        let glyph = |c| face.as_ref().and_then(|face| face.glyph_index(c)).map_or(0, |glyph| glyph.0);
        let mut bytes = Vec::new();
        for character in text.chars() {
            let glyph = used.glyphs.remap(glyph(character));
            if glyph != 0 {
                // A reader who searches types plain spaces.
                let character = if character == '\u{a0}' { ' ' } else { character };
                used.characters.entry(glyph).or_insert(character);
            }
            bytes.extend(glyph.to_be_bytes());
        }
        bytes
    }

    /// The name of a face on the page.
    pub(super) fn name(font: Font) -> String {
        format!("F{}", font as u8)
    }
}

impl File {
    /// Writes the faces and returns their names with their numbers.
    pub(super) fn fonts(&mut self, fonts: &Fonts) -> Result<Vec<(String, Ref)>, RenderError> {
        fonts.0.iter().map(|(font, used)| Ok((Fonts::name(*font), self.font(*font, used)?))).collect()
    }

    /// A face as a composite font whose characters are its glyphs (ISO 32000-1, 9.7).
    fn font(&mut self, font: Font, used: &Used) -> Result<Ref, RenderError> {
        let failed = |reason: String| RenderError::Encode(reason);
        let face = Face::parse(font.data(), 0).map_err(|error| failed(error.to_string()))?;
        let data = subsetter::subset(font.data(), 0, &used.glyphs).map_err(|error| failed(error.to_string()))?;
        let name = format!("{}+{}", tag(&data), post_script_name(font));
        let [id, cid, descriptor] = [(); 3].map(|()| self.next());
        let characters = self.characters(used);
        let mut composite = self.pdf.type0_font(id);
        composite.base_font(Name(name.as_bytes())).encoding_predefined(Name(b"Identity-H"));
        composite.descendant_font(cid).to_unicode(characters);
        composite.finish();

        let mut described = self.pdf.cid_font(cid);
        described.subtype(CidFontType::Type2).base_font(Name(name.as_bytes()));
        described.system_info(system("Identity")).font_descriptor(descriptor).default_width(0.0);
        described.cid_to_gid_map_predefined(Name(b"Identity"));
        let per_em = per_thousand(&face);
        let width = |glyph| per_em(face.glyph_hor_advance(GlyphId(glyph)).unwrap_or(0).into());
        described.widths().consecutive(0, used.glyphs.remapped_gids().map(width));
        described.finish();
        self.descriptor(descriptor, &name, &face, &data);
        Ok(id)
    }

    fn descriptor(&mut self, id: Ref, name: &str, face: &Face<'_>, data: &[u8]) {
        let file = self.next();
        let compressed = miniz_oxide::deflate::compress_to_vec_zlib(data, LEVEL);
        let mut stream = self.pdf.stream(file, &compressed);
        stream.filter(Filter::FlateDecode);
        stream.pair(Name(b"Length1"), i32::try_from(data.len()).unwrap_or(i32::MAX));
        stream.finish();
        let per_em = per_thousand(face);
        let height = |units: i16| per_em(units.into());
        let corners = face.global_bounding_box();
        let mut written = self.pdf.font_descriptor(id);
        written.name(Name(name.as_bytes())).flags(FontFlags::SYMBOLIC).font_file2(file);
        written.bbox(Rect::new(
            height(corners.x_min),
            height(corners.y_min),
            height(corners.x_max),
            height(corners.y_max),
        ));
        written.italic_angle(face.italic_angle()).ascent(height(face.ascender())).descent(height(face.descender()));
        written.cap_height(height(face.capital_height().unwrap_or(0)));
        // The face does not tell the width of its stems; this is that of a usual one.
        written.stem_v(80.0);
    }

    /// The characters that the glyphs stand for, so that text can be searched and copied.
    fn characters(&mut self, used: &Used) -> Ref {
        let mut map = UnicodeCmap::new(Name(b"Characters"), system("UCS"));
        used.characters.iter().for_each(|(glyph, character)| map.pair(*glyph, *character));
        let data = map.finish();
        self.stream(&data)
    }
}

fn system(ordering: &'static str) -> SystemInfo<'static> {
    SystemInfo { registry: Str(b"Adobe"), ordering: Str(ordering.as_bytes()), supplement: 0 }
}

/// Units of a face as thousandths of an em.
fn per_thousand(face: &Face<'_>) -> impl Fn(i32) -> f32 + use<> {
    let units = f32::from(face.units_per_em());
    #[allow(clippy::cast_precision_loss, reason = "a few thousand units")]
    let per_em = move |length: i32| length as f32 * 1000.0 / units;
    per_em
}

fn post_script_name(font: Font) -> &'static str {
    match font {
        Font::Regular => "DejaVuSans",
        Font::Bold => "DejaVuSans-Bold",
        Font::Oblique => "DejaVuSans-Oblique",
    }
}

/// Six letters that tell reduced faces apart (ISO 32000-1, 9.6.4).
fn tag(data: &[u8]) -> String {
    let mut rest = fingerprint(data);
    let mut letter = || {
        let place = rest % 26;
        rest /= 26;
        char::from_u32(u32::from('A') + place).unwrap_or('A')
    };
    (0..6).map(|_| letter()).collect()
}
