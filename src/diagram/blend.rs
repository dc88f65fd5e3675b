use crate::diagram::branches::Branch;
use crate::drawing::Color;
use crate::light::spectral_color;

/// What several spectral lines of one ray are to the eye that does not tell them apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Blend {
    /// All lines of the ray: white light, whatever they are.
    Whole,
    /// Some of them: the color that they add up to, as bright as the brightest of them. So the two lines of a doublet
    /// keep their hue, while red, green and blue make white.
    Part(Color),
}

impl Blend {
    /// The blend of a bundle of branches, one a line.
    pub(super) fn of(bundle: &[Branch<'_>]) -> Self {
        if bundle.first().is_some_and(|first| bundle.len() == first.lines) {
            return Self::Whole;
        }
        Self::Part(sum(bundle.iter().map(|branch| spectral_color(branch.ray.wavelength))))
    }
}

/// The sum of colors, scaled back to the strongest channel of any of them.
fn sum(colors: impl Iterator<Item = [u8; 3]>) -> Color {
    let mut total = [0_u64; 3];
    let mut brightest = 0;
    for color in colors {
        for (total, channel) in total.iter_mut().zip(color) {
            *total += u64::from(channel);
            brightest = brightest.max(channel);
        }
    }
    let strongest = total.into_iter().fold(1, u64::max);
    let scaled = |channel: u64| (channel * u64::from(brightest) + strongest / 2) / strongest;
    Color(total.map(|channel| u8::try_from(scaled(channel)).unwrap_or(u8::MAX)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sum_keeps_hues_and_makes_white() {
        let of = |colors: &[[u8; 3]]| sum(colors.iter().copied()).0;
        assert_eq!(of(&[[255, 0, 0], [0, 255, 0], [0, 0, 255]]), [255, 255, 255]);
        assert_eq!(of(&[[255, 220, 0], [255, 220, 0]]), [255, 220, 0]);
        assert_eq!(of(&[[200, 0, 0], [0, 0, 100]]), [200, 0, 100]);
        assert_eq!(of(&[]), [0, 0, 0]);
    }
}
