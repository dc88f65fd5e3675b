use crate::diagram::blend::Blend;
use crate::drawing::Color;
use crate::light::{Wavelength, gray, readable_on_dark, readable_on_light, spectral_color};
use crate::scene::Theme;
use crate::trace::Via;

/// The colors of a theme.
#[derive(Clone, Copy, Debug)]
pub(super) struct Palette {
    theme: Theme,
    /// Ground of the figure.
    pub(super) ground: Color,
    /// Title and strong lines.
    pub(super) ink: Color,
    /// Caption, notes, normals.
    pub(super) quiet: Color,
    /// Light, where its color tells nothing else.
    pub(super) ray: Color,
    /// Outlines of bodies and the words in them.
    pub(super) outline: Color,
    /// Mirrors.
    pub(super) mirror: Color,
    /// Screens.
    pub(super) screen: Color,
    /// What the figure is about.
    pub(super) accent: Color,
    /// Fill of a body whose index is 2.5.
    dense: Color,
}

const LIGHT: Palette = Palette {
    theme: Theme::Light,
    ground: Color::hex(0xff_ff_ff),
    ink: Color::hex(0x1f_29_33),
    quiet: Color::hex(0x6b_77_85),
    ray: Color::hex(0xc8_20_2f),
    outline: Color::hex(0x4f_78_a0),
    mirror: Color::hex(0x52_5f_6e),
    screen: Color::hex(0x8a_97_a6),
    accent: Color::hex(0x8a_1c_7c),
    dense: Color::hex(0x9a_c5_e8),
};

const DARK: Palette = Palette {
    theme: Theme::Dark,
    ground: Color::hex(0x10_16_1d),
    ink: Color::hex(0xee_f2_f6),
    quiet: Color::hex(0x9a_a8_b7),
    ray: Color::hex(0xff_5a_54),
    outline: Color::hex(0x86_b0_d8),
    mirror: Color::hex(0xb4_c0_cd),
    screen: Color::hex(0x8a_97_a6),
    accent: Color::hex(0xd9_7b_ea),
    dense: Color::hex(0x3d_6b_97),
};

const PRINT: Palette = Palette {
    theme: Theme::Print,
    ground: Color::hex(0xff_ff_ff),
    ink: Color::hex(0x00_00_00),
    quiet: Color::hex(0x55_55_55),
    ray: Color::hex(0x00_00_00),
    outline: Color::hex(0x50_50_50),
    mirror: Color::hex(0x30_30_30),
    screen: Color::hex(0x80_80_80),
    accent: Color::hex(0x00_00_00),
    dense: Color::hex(0xb4_b4_b4),
};

impl Palette {
    pub(super) fn of(theme: Theme) -> Self {
        match theme {
            Theme::Light => LIGHT,
            Theme::Dark => DARK,
            Theme::Print => PRINT,
        }
    }

    /// Fill for a medium: the ground at index 1, deeper the higher the index.
    pub(super) fn medium(&self, index: f64) -> Color {
        self.ground.toward(self.dense, (index - 1.0) / 1.5)
    }

    /// Color of a spectral line on this ground.
    pub(super) fn wavelength(&self, wavelength: Wavelength) -> Color {
        self.readable(spectral_color(wavelength))
    }

    /// Color of lines of one ray that run together: all of them are white light, which is ink on a light ground; some of
    /// them have the color that they add up to.
    pub(super) fn blend(&self, blend: Blend) -> Color {
        match (blend, self.theme) {
            (Blend::Whole, Theme::Dark) => Color::hex(0xff_ff_ff),
            (Blend::Whole, Theme::Light | Theme::Print) => self.ink,
            (Blend::Part(Color(pure)), _) => self.readable(pure),
        }
    }

    /// The author's color for light: on a dark ground as bright as it must be, in print ink, where dashes tell rays apart.
    pub(super) fn own_light(&self, own: [u8; 3]) -> Color {
        match self.theme {
            Theme::Light => Color(own),
            Theme::Dark => Color(readable_on_dark(own, self.ground.0)),
            Theme::Print => self.ink,
        }
    }

    /// The author's color for a body: on a dark ground deep enough that rays and words stand out, in print gray.
    pub(super) fn own_body(&self, own: [u8; 3]) -> Color {
        match self.theme {
            Theme::Light => Color(own),
            Theme::Dark => Color(own).toward(self.ground, 0.75),
            Theme::Print => Color(gray(own)),
        }
    }

    /// A color of light as it is seen on this ground.
    fn readable(&self, pure: [u8; 3]) -> Color {
        Color(if self.theme == Theme::Dark { pure } else { readable_on_light(pure) })
    }

    /// Color of light by its share of the source ray, 0 to 1.
    pub(super) fn power(&self, share: f64) -> Color {
        let (weak, strong) = match self.theme {
            Theme::Light => (Color::hex(0xf0_a8_30), Color::hex(0xa0_0c_2c)),
            Theme::Dark => (Color::hex(0x8c_4a_c8), Color::hex(0xff_d8_66)),
            Theme::Print => (Color::hex(0xa0_a0_a0), Color::hex(0x00_00_00)),
        };
        weak.toward(strong, share.sqrt().sqrt())
    }

    /// Color of light by how it came about.
    pub(super) fn via(&self, via: Via) -> Color {
        let [transmitted, reflected] = match self.theme {
            Theme::Light => [Color::hex(0x15_65_a8), Color::hex(0xa8_4b_00)],
            Theme::Dark => [Color::hex(0x6c_b8_ff), Color::hex(0xff_b4_54)],
            Theme::Print => [Color::hex(0x40_40_40), Color::hex(0x80_80_80)],
        };
        match via {
            Via::Source => self.ray,
            Via::Transmission => transmitted,
            Via::Reflection => reflected,
            Via::TotalInternalReflection => self.accent,
        }
    }
}
