use tiny_skia::Pixmap;

/// A picture as a PNG file, without transparency where it has none.
pub(super) fn encode(pixels: Pixmap) -> Result<Vec<u8>, png::EncodingError> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, pixels.width(), pixels.height());
    encoder.set_depth(png::BitDepth::Eight);
    // Figures are mostly flat: less the row above they are mostly zeros, which this compressor is made for.
    encoder.set_filter(png::Filter::Up);
    encoder.set_deflate_compression(png::DeflateCompression::FdeflateUltraFast);
    let opaque = pixels.pixels().iter().all(|pixel| pixel.is_opaque());
    encoder.set_color(if opaque { png::ColorType::Rgb } else { png::ColorType::Rgba });
    let mut writer = encoder.write_header()?;
    let mut data = if opaque { pixels.take() } else { pixels.take_demultiplied() };
    if opaque {
        // In place: as much memory again would take longer to get than to fill.
        for pixel in 0..data.len() / 4 {
            data.copy_within(4 * pixel..4 * pixel + 3, 3 * pixel);
        }
        data.truncate(data.len() / 4 * 3);
    }
    writer.write_image_data(&data)?;
    writer.finish()?;
    Ok(file)
}
