/// An opaque sRGB color.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Color(pub [u8; 3]);

impl Color {
    /// A color from `0xRRGGBB`.
    #[must_use]
    pub const fn hex(code: u32) -> Self {
        let [_, r, g, b] = code.to_be_bytes();
        Self([r, g, b])
    }

    /// The color `share` of the way from this one to `other`, by sRGB channels; `share` is held to 0..1.
    #[must_use]
    pub fn toward(self, other: Self, share: f64) -> Self {
        let share = if share.is_nan() { 0.0 } else { share.clamp(0.0, 1.0) };
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "lies between two bytes")]
        let mix = |a: u8, b: u8| (f64::from(a) + (f64::from(b) - f64::from(a)) * share).round() as u8;
        let ([r, g, b], [s, h, c]) = (self.0, other.0);
        Self([mix(r, s), mix(g, h), mix(b, c)])
    }

    /// The CSS form, `#rrggbb`.
    #[must_use]
    pub fn css(self) -> String {
        let [r, g, b] = self.0;
        format!("#{r:02x}{g:02x}{b:02x}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mixes_and_prints() {
        let (black, white) = (Color::hex(0), Color::hex(0xff_ff_ff));
        assert_eq!(black.toward(white, 0.5).css(), "#808080");
        assert_eq!(black.toward(white, f64::NAN), black);
        assert_eq!(black.toward(white, 7.0), white);
    }
}
