//! The color of a wavelength on a screen.

use super::Wavelength;
use crate::numerics::{exp, pow};

/// The wavelengths, nm, between which the fit's chromaticity is used. Beyond them the eye's hardly changes, while the
/// tails of the fit drift to orange and blue.
const HUES: (f64, f64) = (410.0, 650.0);
/// The wavelengths, nm, at which the brightness starts to fade.
const BRIGHT: (f64, f64) = (430.0, 640.0);
/// The wavelengths, nm, from which on only the faintest brightness is left.
const VISIBLE: (f64, f64) = (380.0, 780.0);
/// Linear light of the strongest channel outside the visible range, where a ray should still be seen.
const FAINTEST: f64 = 0.2;
/// The least contrast ratio with white that keeps a line readable: the guideline's value for graphics.
const READABLE: f64 = 3.0;
/// The least contrast ratio with a dark ground: the guideline's value for text, since thin bright lines lose on dark.
const READABLE_ON_DARK: f64 = 4.5;

/// Linear light in the sRGB primaries; the screen shows 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Linear([f64; 3]);

/// The sRGB color of monochromatic light, for a dark ground.
///
/// No screen shows spectral colors: each lacks at least one of the primaries by a negative amount. That channel is set to
/// 0, which keeps the color fully saturated (mixing in gray instead turns red to pink and green to mint), and the others
/// are made as bright as the screen goes. Toward the ends of the visible range, 380 nm and 780 nm, colors fade; beyond, a
/// dim violet or deep red stands for what the eye does not see.
///
/// # Source
/// Wyman, Sloan and Shirley, "Simple Analytic Approximations to the CIE XYZ Color Matching Functions", Journal of Computer
/// Graphics Techniques 2(2), 2013, 1-11: the multi-lobe fit of the CIE 1931 functions. IEC 61966-2-1:1999: sRGB primaries
/// and transfer curve.
#[must_use]
pub fn spectral_color(wavelength: Wavelength) -> [u8; 3] {
    let nm = wavelength.nanometers();
    let color = Linear::of_spectrum(nm.clamp(HUES.0, HUES.1)).clipped();
    let strongest = color.0.into_iter().fold(f64::MIN_POSITIVE, f64::max);
    color.scaled(brightness(nm) / strongest).encoded(f64::round)
}

/// The color itself if it is readable on white, else the same hue darkened until it is (contrast ratio at least 3).
///
/// # Source
/// W3C, "Web Content Accessibility Guidelines" 2.1, 2018: relative luminance, contrast ratio, and the least ratio for
/// graphics.
#[must_use]
pub fn readable_on_light(color: [u8; 3]) -> [u8; 3] {
    let linear = Linear(color.map(decoded));
    let limit = 1.05 / READABLE - 0.05;
    if linear.luminance() <= limit { color } else { linear.scaled(limit / linear.luminance()).encoded(f64::floor) }
}

/// The color itself if it is readable on a dark `ground`, else the same hue with as much white as it takes (contrast ratio
/// at least 4.5); white where even that does not do.
///
/// # Source
/// As [`readable_on_light`], with the guideline's least ratio for text.
#[must_use]
pub fn readable_on_dark(color: [u8; 3], ground: [u8; 3]) -> [u8; 3] {
    let linear = Linear(color.map(decoded));
    let limit = READABLE_ON_DARK * (Linear(ground.map(decoded)).luminance() + 0.05) - 0.05;
    let luminance = linear.luminance();
    if luminance >= limit {
        return color;
    }
    let white = ((limit - luminance) / (1.0 - luminance)).min(1.0);
    Linear(linear.0.map(|channel| channel + white * (1.0 - channel))).encoded(f64::ceil)
}

/// The gray of the same luminance.
///
/// # Source
/// IEC 61966-2-1:1999: transfer curve and primaries, whose luminances are weighted.
#[must_use]
pub fn gray(color: [u8; 3]) -> [u8; 3] {
    Linear([Linear(color.map(decoded)).luminance(); 3]).encoded(f64::round)
}

/// Brightness of the strongest channel, linear, 1 but toward the ends of the visible range.
fn brightness(nm: f64) -> f64 {
    let from_violet = (nm - VISIBLE.0) / (BRIGHT.0 - VISIBLE.0);
    let from_red = (VISIBLE.1 - nm) / (VISIBLE.1 - BRIGHT.1);
    from_violet.min(from_red).clamp(FAINTEST, 1.0)
}

/// One lobe of the fit: Gaussian with its own inverse width on each side of its center.
fn lobe(nm: f64, height: f64, center: f64, below: f64, above: f64) -> f64 {
    let t = (nm - center) * if nm < center { below } else { above };
    height * exp(-0.5 * t * t)
}

/// CIE 1931 x̄, ȳ and z̄ at a vacuum wavelength in nm.
fn color_matching(nm: f64) -> [f64; 3] {
    [
        lobe(nm, 0.362, 442.0, 0.0624, 0.0374)
            + lobe(nm, 1.056, 599.8, 0.0264, 0.0323)
            + lobe(nm, -0.065, 501.1, 0.0490, 0.0382),
        lobe(nm, 0.821, 568.8, 0.0213, 0.0247) + lobe(nm, 0.286, 530.9, 0.0613, 0.0322),
        lobe(nm, 1.217, 437.0, 0.0845, 0.0278) + lobe(nm, 0.681, 459.0, 0.0385, 0.0725),
    ]
}

impl Linear {
    /// Monochromatic light; a channel outside the screen's gamut is negative.
    fn of_spectrum(nm: f64) -> Self {
        let [x, y, z] = color_matching(nm);
        Self([
            3.2406 * x - 1.5372 * y - 0.4986 * z,
            -0.9689 * x + 1.8758 * y + 0.0415 * z,
            0.0557 * x - 0.2040 * y + 1.0570 * z,
        ])
    }

    /// Relative luminance Y.
    fn luminance(self) -> f64 {
        let [r, g, b] = self.0;
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }

    /// The nearest color, channel by channel, that a screen can show.
    fn clipped(self) -> Self {
        Self(self.0.map(|channel| channel.max(0.0)))
    }

    fn scaled(self, factor: f64) -> Self {
        Self(self.0.map(|channel| channel * factor))
    }

    /// The 8-bit sRGB values.
    fn encoded(self, to_whole: fn(f64) -> f64) -> [u8; 3] {
        self.0.map(|channel| {
            let curve = if channel <= 0.003_130_8 { 12.92 * channel } else { 1.055 * pow(channel, 1.0 / 2.4) - 0.055 };
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a float cast saturates at 0 and 255"
            )]
            let value = to_whole(255.0 * curve) as u8;
            value
        })
    }
}

/// Linear light of one 8-bit sRGB value.
fn decoded(value: u8) -> f64 {
    let curve = f64::from(value) / 255.0;
    if curve <= 0.040_45 { curve / 12.92 } else { pow((curve + 0.055) / 1.055, 2.4) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn color_of(nm: f64) -> [u8; 3] {
        spectral_color(Wavelength::from_nanometers(nm).unwrap())
    }

    fn luminance(color: [u8; 3]) -> f64 {
        Linear(color.map(decoded)).luminance()
    }

    /// Hue on the color circle in degrees: red 0, yellow 60, green 120, cyan 180, blue 240, violet above.
    fn hue([r, g, b]: [u8; 3]) -> f64 {
        let [r, g, b] = [r, g, b].map(f64::from);
        let (low, high) = (r.min(g).min(b), r.max(g).max(b));
        let sixth = if high == r {
            ((g - b) / (high - low)).rem_euclid(6.0)
        } else if high == g {
            2.0 + (b - r) / (high - low)
        } else {
            4.0 + (r - g) / (high - low)
        };
        60.0 * sixth
    }

    #[test]
    fn hues_run_from_violet_to_red() {
        let hues: Vec<f64> = (440..=650).step_by(5).map(|nm| hue(color_of(f64::from(nm)))).collect();
        assert!(hues.is_sorted_by(|a, b| a >= b), "{hues:?}");
        let names = [
            (420.0, 265.0),
            (470.0, 230.0),
            (495.0, 170.0),
            (530.0, 120.0),
            (570.0, 60.0),
            (600.0, 20.0),
            (650.0, 0.0),
        ];
        for (nm, expected) in names {
            assert!((hue(color_of(nm)) - expected).abs() < 15.0, "{nm} nm");
        }
    }

    #[test]
    fn fraunhofer_lines() {
        let colors = super::super::FRAUNHOFER.map(|line| spectral_color(line.wavelength));
        let [g, f, e, d, sodium, laser, c] = colors;
        assert_eq!([f, d, c], [[0, 194, 255], [255, 138, 0], [242, 0, 0]]);
        assert_eq!([g, e, sodium, laser], [[101, 0, 255], [0, 255, 0], [255, 129, 0], [255, 0, 0]]);
    }

    #[test]
    fn every_wavelength_is_visible_and_readable_on_white() {
        for nm in (100..=2000).step_by(3) {
            let color = color_of(f64::from(nm));
            assert!(color.into_iter().any(|channel| channel >= 120), "{nm} nm: {color:?}");
            let dark = readable_on_light(color);
            assert!(1.05 / (luminance(dark) + 0.05) >= READABLE, "{nm} nm: {dark:?}");
            assert!((hue(color) - hue(dark)).abs() < 2.5, "{nm} nm: {color:?} {dark:?}");
        }
    }

    #[test]
    fn sodium_is_darkened_for_paper_and_deep_red_is_not() {
        assert_eq!(readable_on_light(spectral_color(Wavelength::SODIUM_D)), [232, 117, 0]);
        assert_eq!(readable_on_light([199, 0, 0]), [199, 0, 0]);
        assert_eq!(readable_on_light([255; 3]), [148; 3]);
    }

    #[test]
    fn colors_are_lifted_on_dark() {
        let ground = [16, 22, 29];
        for color in [[0, 0, 0], [21, 101, 168], [200, 32, 47], [0, 0, 255], [27, 122, 67]] {
            let lifted = readable_on_dark(color, ground);
            assert!((luminance(lifted) + 0.05) / (luminance(ground) + 0.05) >= READABLE_ON_DARK, "{color:?}");
            assert!(color == [0; 3] || (hue(lifted) - hue(color)).abs() < 8.0, "{color:?} {lifted:?}");
        }
        assert_eq!(readable_on_dark([255, 214, 102], ground), [255, 214, 102], "bright enough");
        assert_eq!(readable_on_dark([0; 3], [200; 3]), [255; 3], "no dark ground");
    }

    #[test]
    fn gray_has_the_luminance_of_its_color() {
        for color in [[255, 0, 0], [228, 205, 164], [0, 0, 255], [255; 3], [0; 3]] {
            let gray = gray(color);
            assert!(gray[0] == gray[1] && gray[1] == gray[2], "{color:?}");
            assert!((luminance(gray) - luminance(color)).abs() < 5e-3, "{color:?}");
        }
    }

    #[test]
    fn the_fit_peaks_like_the_eye() {
        // CIE 1931 table: ȳ(555) = 1.0000, x̄(600) = 1.0622, z̄(450) = 1.7721.
        assert!((color_matching(555.0)[1] - 1.0).abs() < 0.01);
        assert!((color_matching(600.0)[0] - 1.0622).abs() < 0.01);
        assert!((color_matching(450.0)[2] - 1.7721).abs() < 0.02);
    }
}
