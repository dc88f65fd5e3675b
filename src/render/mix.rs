use tiny_skia::{BlendMode, PremultipliedColorU8};

/// A color laid on another, both premultiplied.
pub(super) fn laid_on(below: PremultipliedColorU8, [r, g, b, a]: [u32; 4], mode: BlendMode) -> PremultipliedColorU8 {
    let mix = |below: u8, above: u32| {
        let covers = if mode == BlendMode::Screen { above } else { a };
        u8::try_from(above + share(u32::from(below), 255 - covers)).unwrap_or(u8::MAX)
    };
    let channels = [mix(below.red(), r), mix(below.green(), g), mix(below.blue(), b), mix(below.alpha(), a)];
    let [r, g, b, a] = channels;
    PremultipliedColorU8::from_rgba(r.min(a), g.min(a), b.min(a), a).unwrap_or(below)
}

/// A number times a share in 255ths, rounded.
pub(super) fn share(number: u32, share: u32) -> u32 {
    (number * share + 127) / 255
}
