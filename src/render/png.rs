//! PNG through tiny-skia. Text is drawn from glyph outlines with the advances that the layout used.

use std::fmt;
use std::rc::Rc;

use glam::DVec2;
use tiny_skia::{BlendMode, FillRule, Mask, Paint, PathBuilder, Pixmap, PixmapPaint, Transform};

use crate::drawing::{Cap, Color, Drawing, Group, Item, Lines, Path, Rect, Shape, Text, Whole, extent};
use crate::render::encode::encode;
use crate::render::mix;
use crate::render::samples::Samples;
use crate::render::skia::{FAR, draw_glyph, single, skia_path, skia_stroke};
use crate::scene::Limit;

/// Why a figure could not become a picture.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum RenderError {
    /// The scale is not a number above 0.
    Scale(f32),
    /// The picture has no pixels or too many.
    Size {
        /// Width in pixels.
        width: f64,
        /// Height in pixels.
        height: f64,
        /// Most pixels that a picture may have.
        most: u64,
    },
    /// The encoder failed.
    Encode(String),
}

impl fmt::Display for RenderError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scale(scale) => write!(f, "the scale must be a number above 0, not {scale}"),
            Self::Size { width, height, most } => {
                write!(f, "a picture of {width} × {height} pixels cannot be made; the limit is {most} pixels")
            }
            Self::Encode(reason) => write!(f, "the encoder failed: {reason}"),
        }
    }
}

impl std::error::Error for RenderError {}

/// The figure as a PNG file, `scale` device pixels to a pixel of the figure; at most 1.5·10⁸ pixels.
///
/// # Errors
///
/// If `scale` is not above 0, the picture would be empty or too large, or the encoder fails.
pub fn png(drawing: &Drawing, scale: f32) -> Result<Vec<u8>, RenderError> {
    png_within(drawing, scale, Limit::Pixels.usual())
}

/// [`png()`] of as many pixels as `most`; each takes about ten bytes of memory.
///
/// # Errors
///
/// As those of [`png()`].
pub fn png_within(drawing: &Drawing, scale: f32, most: u64) -> Result<Vec<u8>, RenderError> {
    let mut canvas = Canvas::new(drawing, scale, most)?;
    if let Some(color) = drawing.background {
        let Color([r, g, b]) = color;
        canvas.pixels.fill(tiny_skia::Color::from_rgba8(r, g, b, 255));
    }
    canvas.items(&drawing.items, None);
    encode(canvas.pixels).map_err(|error| RenderError::Encode(error.to_string()))
}

struct Canvas {
    pixels: Pixmap,
    transform: Transform,
    /// How a shape is laid on what is there.
    mode: BlendMode,
    /// Kept from one set of lines to the next.
    samples: Option<Samples>,
    /// The last mask that was made, which most layers share.
    clipped: Option<(Rect, Rc<Mask>)>,
}

impl Canvas {
    fn new(drawing: &Drawing, scale: f32, most: u64) -> Result<Self, RenderError> {
        if !(scale.is_finite() && scale > 0.0) {
            return Err(RenderError::Scale(scale));
        }
        let [width, height] = drawing.size.map(|side| (f64::from(side) * f64::from(scale)).round());
        let refused = RenderError::Size { width, height, most };
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "held to the type's range")]
        let [w, h] = [width as u32, height as u32];
        if u64::from(w) * u64::from(h) > most {
            return Err(refused);
        }
        let pixels = Pixmap::new(w, h).ok_or(refused)?;
        Ok(Self {
            pixels,
            transform: Transform::from_scale(scale, scale),
            mode: BlendMode::SourceOver,
            samples: None,
            clipped: None,
        })
    }

    fn items(&mut self, items: &[Item], mask: Option<&Mask>) {
        for item in items {
            match item {
                Item::Shape(shape) => self.shape(shape, mask),
                Item::Lines(lines) => self.lines(lines, mask),
                Item::Text(text) => self.text(text, mask),
                Item::Group(group) => {
                    let clip = group.clip.and_then(|rect| self.clip(&rect, mask));
                    let mask = clip.as_deref().or(mask);
                    match group.whole {
                        Some(whole) => self.whole(group, whole, mask),
                        None => self.items(&group.items, mask),
                    }
                }
            }
        }
    }

    /// Puts things together on an empty layer, which is laid on the picture.
    fn whole(&mut self, group: &Group, Whole { opacity, adds_up }: Whole, mask: Option<&Mask>) {
        let Some(([x, y], mut layer)) = self.layer(&group.items) else { return };
        layer.mode = if adds_up { BlendMode::Screen } else { BlendMode::SourceOver };
        layer.items(&group.items, None);
        let paint = PixmapPaint { opacity: single(DVec2::splat(extent(opacity).min(1.0))).0, ..PixmapPaint::default() };
        self.pixels.draw_pixmap(x, y, layer.pixels.as_ref(), &paint, Transform::identity(), mask);
    }

    /// An empty canvas that just holds some items, and its place on this one; `None` where nothing is seen of them.
    fn layer(&self, items: &[Item]) -> Option<([i32; 2], Self)> {
        let scale = f64::from(self.transform.sx);
        let whole = DVec2::new(f64::from(self.pixels.width()), f64::from(self.pixels.height()));
        let bounds = items.iter().filter_map(bounds).reduce(union)?;
        let min = (bounds.min * scale - 2.0).floor().clamp(DVec2::ZERO, whole);
        let size = (bounds.max * scale + 2.0).ceil().clamp(DVec2::ZERO, whole) - min;
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "whole numbers within the picture")]
        let (at, pixels) = ([min.x as i32, min.y as i32], Pixmap::new(size.x as u32, size.y as u32)?);
        let (x, y) = single(-min);
        Some((
            at,
            Self {
                pixels,
                transform: self.transform.post_translate(x, y),
                mode: BlendMode::SourceOver,
                samples: None,
                clipped: None,
            },
        ))
    }

    fn shape(&mut self, shape: &Shape, mask: Option<&Mask>) {
        let Some(path) = skia_path(&shape.path, self.far()) else { return };
        if let Some(fill) = shape.fill {
            let paint = self.paint(fill.color, fill.opacity);
            self.pixels.fill_path(&path, &paint, FillRule::Winding, self.transform, mask);
        }
        if let Some(stroke) = &shape.stroke {
            let paint = self.paint(stroke.color, stroke.opacity);
            self.pixels.stroke_path(&path, &paint, &skia_stroke(stroke, self.far()), self.transform, mask);
        }
    }

    fn lines(&mut self, lines: &Lines, mask: Option<&Mask>) {
        if lines.stroke.dash.is_empty() && lines.stroke.cap == Cap::Round {
            self.sampled(lines, mask);
        } else {
            self.stroked(lines, mask);
        }
    }

    /// Lines by their samples, which are a multiple faster than the outlines of strokes.
    fn sampled(&mut self, lines: &Lines, mask: Option<&Mask>) {
        let (width, height) = (self.pixels.width(), self.pixels.height());
        let mut samples = self.samples.take().unwrap_or_else(|| Samples::new(width, height));
        let Transform { sx, tx, ty, .. } = self.transform;
        let (scale, move_by) = (f64::from(sx), DVec2::new(f64::from(tx), f64::from(ty)));
        for [ax, ay, bx, by] in &lines.ends {
            let [a, b] = [place(*ax, *ay), place(*bx, *by)].map(|p| p * scale + move_by);
            samples.cover(a, b, 0.5 * extent(lines.stroke.width) * scale);
        }
        let paint = mix::Paint::new(lines.stroke.color.0, alpha(lines.stroke.opacity), self.mode);
        let masked = mask.map(Mask::data);
        let (pixels, _) = self.pixels.data_mut().as_chunks_mut();
        samples.take(|at, count| paint.lay_on(&mut pixels[at], count, masked.map_or(255, |mask| mask[at])));
        self.samples = Some(samples);
    }

    fn stroked(&mut self, lines: &Lines, mask: Option<&Mask>) {
        let mut path = Path::new();
        for [ax, ay, bx, by] in &lines.ends {
            path.move_to(place(*ax, *ay));
            path.line_to(place(*bx, *by));
        }
        self.shape(&Shape::stroked(path, lines.stroke.clone(), ""), mask);
    }

    fn text(&mut self, text: &Text, mask: Option<&Mask>) {
        let mut pen = PathBuilder::new();
        for glyph in text.glyphs() {
            draw_glyph(&mut pen, &text.font.outline(glyph.character), &glyph, self.far());
        }
        let Some(path) = pen.finish() else { return };
        let paint = self.paint(text.color, 1.0);
        self.pixels.fill_path(&path, &paint, FillRule::Winding, self.transform, mask);
    }

    /// [`FAR`] in pixels of the drawing.
    fn far(&self) -> f64 {
        FAR / f64::from(self.transform.sx)
    }

    fn paint(&self, color: Color, opacity: f64) -> Paint<'static> {
        let Color([r, g, b]) = color;
        let mut paint = Paint { anti_alias: true, blend_mode: self.mode, ..Paint::default() };
        paint.set_color_rgba8(r, g, b, alpha(opacity));
        paint
    }

    /// A mask for a rectangle within what is already masked.
    fn clip(&mut self, rect: &Rect, outer: Option<&Mask>) -> Option<Rc<Mask>> {
        if let (None, Some((known, mask))) = (outer, &self.clipped)
            && known == rect
        {
            return Some(Rc::clone(mask));
        }
        let path = skia_path(&Path::rect(*rect), self.far())?;
        if let Some(outer) = outer {
            let mut mask = outer.clone();
            mask.intersect_path(&path, FillRule::Winding, true, self.transform);
            return Some(Rc::new(mask));
        }
        let mut mask = Mask::new(self.pixels.width(), self.pixels.height())?;
        mask.fill_path(&path, FillRule::Winding, true, self.transform);
        let mask = Rc::new(mask);
        self.clipped = Some((*rect, Rc::clone(&mask)));
        Some(mask)
    }
}

/// The part of the figure that an item may touch, pixels; `None` for nothing.
fn bounds(item: &Item) -> Option<Rect> {
    match item {
        Item::Shape(shape) => {
            let bounds = skia_path(&shape.path, FAR)?.bounds();
            let point = |x: f32, y: f32| DVec2::new(f64::from(x), f64::from(y));
            let rect = Rect { min: point(bounds.left(), bounds.top()), max: point(bounds.right(), bounds.bottom()) };
            Some(rect.grown(shape.stroke.as_ref().map_or(0.0, |stroke| extent(stroke.width))))
        }
        Item::Lines(lines) => {
            let points = lines.ends.iter().flat_map(|[ax, ay, bx, by]| [place(*ax, *ay), place(*bx, *by)]);
            let point = |p: DVec2| Rect { min: p, max: p };
            points.map(point).reduce(union).map(|rect| rect.grown(extent(lines.stroke.width)))
        }
        Item::Text(text) => Some(text.bounds().grown(extent(text.size))),
        Item::Group(group) => group.items.iter().filter_map(bounds).reduce(union),
    }
}

/// An opacity of 0 to 1 as a byte.
pub(super) fn alpha(opacity: f64) -> u8 {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "held to a byte's range")]
    let alpha = (opacity.clamp(0.0, 1.0) * 255.0).round() as u8;
    alpha
}

/// A point given in hundredths of a pixel.
fn place(x: i32, y: i32) -> DVec2 {
    DVec2::new(f64::from(x), f64::from(y)) / 100.0
}

fn union(a: Rect, b: Rect) -> Rect {
    Rect { min: a.min.min(b.min), max: a.max.max(b.max) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Stroke;

    fn drawing(items: Vec<Item>) -> Drawing {
        let background = Some(Color::hex(0xff_ff_ff));
        Drawing { size: [60, 40], background, title: String::new(), description: String::new(), items }
    }

    fn darkest(drawing: &Drawing, scale: f32) -> u8 {
        let picture = Pixmap::decode_png(&png(drawing, scale).unwrap()).unwrap();
        picture.pixels().iter().map(|pixel| pixel.green()).min().unwrap()
    }

    #[test]
    fn text_leaves_pixels_even_without_a_glyph() {
        for words in ["H", "漢"] {
            let text = Text::new(words, DVec2::new(10.0, 30.0), 20.0, Color::hex(0));
            assert!(darkest(&drawing(vec![text.into()]), 2.0) < 10, "{words}");
        }
    }

    #[test]
    fn lights_add_up_and_leave_what_is_behind() {
        let line = |y: f64, color: u32| {
            let path = Path::line(DVec2::new(10.0, y), DVec2::new(50.0, y));
            Item::from(Shape::stroked(path, Stroke::solid(Color::hex(color), 6.0), ""))
        };
        let lights = vec![line(18.0, 0xff_00_00), line(18.0, 0x00_ff_00), line(22.0, 0x00_00_ff)];
        let pixel = |opacity: f64, y: u32| {
            let group = Group::layer("", lights.clone()).as_whole(Whole { opacity, adds_up: true });
            let mut drawing = drawing(vec![group.into()]);
            drawing.background = Some(Color::hex(0x00_00_40));
            let picture = Pixmap::decode_png(&png(&drawing, 1.0).unwrap()).unwrap();
            let pixel = picture.pixel(30, y).unwrap();
            [pixel.red(), pixel.green(), pixel.blue()]
        };
        assert_eq!(pixel(1.0, 16), [255, 255, 0], "not the ground's blue");
        assert_eq!(pixel(1.0, 20), [255, 255, 255]);
        assert_eq!(pixel(1.0, 5), [0, 0, 0x40]);
        let half = pixel(0.5, 16);
        assert!(half[0].abs_diff(128) < 2 && half[2].abs_diff(32) < 2, "{half:?}");
    }

    #[test]
    fn a_clip_hides_what_is_outside() {
        let line = Path::line(DVec2::new(0.0, 20.0), DVec2::new(60.0, 20.0));
        let shape = Shape::stroked(line, Stroke::solid(Color::hex(0), 3.0), "");
        let clip = Rect { min: DVec2::new(0.0, 30.0), max: DVec2::new(60.0, 40.0) };
        let group = crate::drawing::Group::layer("", vec![shape.into()]).clipped(clip);
        assert_eq!(darkest(&drawing(vec![group.into()]), 1.0), 255);
    }

    #[test]
    fn impossible_sizes_are_refused() {
        let small = drawing(Vec::new());
        assert_eq!(png(&small, 0.0), Err(RenderError::Scale(0.0)));
        assert!(matches!(png(&small, f32::NAN), Err(RenderError::Scale(_))));
        assert!(matches!(png(&small, 1e-9), Err(RenderError::Size { .. })));
        assert!(matches!(png(&small, 1e9), Err(RenderError::Size { .. })));
        let huge = Drawing { size: [u32::MAX; 2], ..small };
        assert!(matches!(png(&huge, 1.0), Err(RenderError::Size { .. })));
    }
}
