//! The display list's shapes in tiny-skia's terms.

use glam::DVec2;
use tiny_skia::{LineCap, LineJoin, PathBuilder, StrokeDash};

use crate::drawing::{Cap, Glyph, GlyphStep, Path, PathStep, Stroke, extent};
use crate::render::arcs::cubics;

/// Pixels of the picture within which tiny-skia is given points and widths: at some 5e8, measured, it begins to panic.
pub(super) const FAR: f64 = 1e8;

/// Points stay within `far`, as those of paths and widths below.
pub(super) fn draw_glyph(pen: &mut PathBuilder, outline: &[GlyphStep], glyph: &Glyph, far: f64) {
    let place = |p: DVec2| within(glyph.at + p * glyph.size, far);
    for step in outline {
        match *step {
            GlyphStep::MoveTo(p) => pen.move_to(place(p).0, place(p).1),
            GlyphStep::LineTo(p) => pen.line_to(place(p).0, place(p).1),
            GlyphStep::QuadTo(c, p) => {
                let (c, p) = (place(c), place(p));
                pen.quad_to(c.0, c.1, p.0, p.1);
            }
            GlyphStep::CubicTo(c, d, p) => {
                let (c, d, p) = (place(c), place(d), place(p));
                pen.cubic_to(c.0, c.1, d.0, d.1, p.0, p.1);
            }
            GlyphStep::Close => pen.close(),
        }
    }
}

/// `None` where the path is empty.
pub(super) fn skia_path(path: &Path, far: f64) -> Option<tiny_skia::Path> {
    let single = |p: DVec2| within(p, far);
    let mut pen = PathBuilder::new();
    let mut last = DVec2::ZERO;
    for step in path.steps() {
        match *step {
            PathStep::MoveTo(p) => {
                let (x, y) = single(p);
                pen.move_to(x, y);
                last = p;
            }
            PathStep::LineTo(p) => {
                let (x, y) = single(p);
                pen.line_to(x, y);
                last = p;
            }
            PathStep::ArcTo { to, .. } => {
                match cubics(last, step) {
                    Some(curves) => curves.into_iter().for_each(|curve| cubic_to(&mut pen, curve.map(single))),
                    None => pen.line_to(single(to).0, single(to).1),
                }
                last = to;
            }
            PathStep::Close => pen.close(),
        }
    }
    pen.finish()
}

fn cubic_to(pen: &mut PathBuilder, [c, d, p]: [(f32, f32); 3]) {
    pen.cubic_to(c.0, c.1, d.0, d.1, p.0, p.1);
}

pub(super) fn skia_stroke(stroke: &Stroke, far: f64) -> tiny_skia::Stroke {
    let dash: Vec<f32> = stroke.dash.iter().map(|length| single(DVec2::splat(extent(*length))).0).collect();
    tiny_skia::Stroke {
        width: single(DVec2::splat(extent(stroke.width).min(far))).0,
        line_cap: match stroke.cap {
            Cap::Butt => LineCap::Butt,
            Cap::Round => LineCap::Round,
        },
        line_join: LineJoin::Round,
        dash: StrokeDash::new(dash, 0.0),
        ..tiny_skia::Stroke::default()
    }
}

/// A point in tiny-skia's precision.
fn within(p: DVec2, far: f64) -> (f32, f32) {
    single(p.clamp(DVec2::splat(-far), DVec2::splat(far)))
}

#[allow(clippy::cast_possible_truncation, reason = "pixel coordinates; a float holds a hundredth of a pixel")]
pub(super) fn single(p: DVec2) -> (f32, f32) {
    (p.x as f32, p.y as f32)
}
