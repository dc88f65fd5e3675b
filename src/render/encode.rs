use tiny_skia::Pixmap;

/// A picture as a PNG file, without transparency where it has none.
pub(super) fn encode(pixels: &Pixmap) -> Result<Vec<u8>, png::EncodingError> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, pixels.width(), pixels.height());
    encoder.set_depth(png::BitDepth::Eight);
    // Figures are mostly flat: no filter gains anything, and a light search for repeats finds nearly all of them.
    encoder.set_filter(png::Filter::NoFilter);
    encoder.set_deflate_compression(png::DeflateCompression::Level(1));
    let opaque = pixels.pixels().iter().all(|pixel| pixel.is_opaque());
    encoder.set_color(if opaque { png::ColorType::Rgb } else { png::ColorType::Rgba });
    let mut writer = encoder.write_header()?;
    if opaque {
        let mut rgb = vec![0; 3 * pixels.pixels().len()];
        for (three, pixel) in rgb.chunks_exact_mut(3).zip(pixels.pixels()) {
            three.copy_from_slice(&[pixel.red(), pixel.green(), pixel.blue()]);
        }
        writer.write_image_data(&rgb)?;
    } else {
        writer.write_image_data(&pixels.clone().take_demultiplied())?;
    }
    writer.finish()?;
    Ok(file)
}
