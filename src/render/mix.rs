use tiny_skia::BlendMode;

/// Coverages of a pixel that are told apart, from none to all 16 samples.
pub(super) const COVERAGES: usize = 17;

/// A premultiplied color to lay on others, by how much of a pixel it covers.
pub(super) struct Paint {
    color: [u32; 4],
    mode: BlendMode,
    /// The same for every number of covered samples.
    coats: [Coat; COVERAGES],
}

/// A color ready to be laid on others, in 255ths.
#[derive(Clone, Copy)]
struct Coat {
    color: [u16; 4],
    /// What each channel leaves of what is below.
    left: [u16; 4],
}

impl Paint {
    /// A straight color of some opacity.
    pub(super) fn new([r, g, b]: [u8; 3], opacity: u8, mode: BlendMode) -> Self {
        let color = [r, g, b, 255].map(|channel| share(u32::from(channel), u32::from(opacity)));
        let coats =
            std::array::from_fn(|count| coat(color, u32::try_from(16 * count).map_or(255, |c| c.min(255)), mode));
        Self { color, mode, coats }
    }

    /// Lays it on a pixel of which some samples are covered, where a mask of 0 to 255 lets it.
    pub(super) fn lay_on(&self, pixel: &mut [u8; 4], count: u8, mask: u8) {
        let coat = match mask {
            255 => self.coats[usize::from(count)],
            mask => coat(self.color, share((16 * u32::from(count)).min(255), u32::from(mask)), self.mode),
        };
        for ((below, color), left) in pixel.iter_mut().zip(coat.color).zip(coat.left) {
            // Rounded division by 255.
            let kept = u16::from(*below) * left + 128;
            #[allow(
                clippy::cast_possible_truncation,
                reason = "a premultiplied color and the rest of another are one at most"
            )]
            let mixed = (color + ((kept + (kept >> 8)) >> 8)) as u8;
            *below = mixed;
        }
    }
}

fn coat(color: [u32; 4], coverage: u32, mode: BlendMode) -> Coat {
    #[allow(clippy::cast_possible_truncation, reason = "at most 255")]
    let color = color.map(|channel| share(channel, coverage) as u16);
    // Screening lets each channel hold back its own, covering lets the opacity hold back all.
    let left = if mode == BlendMode::Screen { color } else { [color[3]; 4] };
    Coat { color, left: left.map(|held| 255 - held) }
}

/// A number times a share in 255ths, rounded.
fn share(number: u32, share: u32) -> u32 {
    (number * share + 127) / 255
}
