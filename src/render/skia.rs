//! The display list's shapes in tiny-skia's terms.

use glam::DVec2;
use kurbo::{Arc, Point, SvgArc, Vec2};
use tiny_skia::{LineCap, LineJoin, PathBuilder, StrokeDash};

use crate::drawing::{Cap, Glyph, GlyphStep, Path, PathStep, Stroke};

/// Largest distance of a cubic curve from the arc that it stands for, pixels before scaling.
const ARC_TOLERANCE: f64 = 0.01;

pub(super) fn draw_glyph(pen: &mut PathBuilder, outline: &[GlyphStep], glyph: &Glyph) {
    let place = |p: DVec2| single(glyph.at + p * glyph.size);
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
pub(super) fn skia_path(path: &Path) -> Option<tiny_skia::Path> {
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
            PathStep::ArcTo { radius, large, sweep, to } => {
                draw_arc(&mut pen, last, radius, [large, sweep], to);
                last = to;
            }
            PathStep::Close => pen.close(),
        }
    }
    pen.finish()
}

fn draw_arc(pen: &mut PathBuilder, from: DVec2, radius: f64, [large_arc, sweep]: [bool; 2], to: DVec2) {
    let point = |p: DVec2| Point::new(p.x, p.y);
    let radii = Vec2::new(radius, radius);
    let arc = SvgArc { from: point(from), to: point(to), radii, x_rotation: 0.0, large_arc, sweep };
    let Some(arc) = Arc::from_svg_arc(&arc) else {
        let (x, y) = single(to);
        return pen.line_to(x, y);
    };
    let single = |p: Point| single(DVec2::new(p.x, p.y));
    arc.to_cubic_beziers(ARC_TOLERANCE, |c, d, p| {
        let (c, d, p) = (single(c), single(d), single(p));
        pen.cubic_to(c.0, c.1, d.0, d.1, p.0, p.1);
    });
}

pub(super) fn skia_stroke(stroke: &Stroke) -> tiny_skia::Stroke {
    let dash: Vec<f32> = stroke.dash.iter().map(|length| single(DVec2::splat(*length)).0).collect();
    tiny_skia::Stroke {
        width: single(DVec2::splat(stroke.width)).0,
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
#[allow(clippy::cast_possible_truncation, reason = "pixel coordinates; a float holds a hundredth of a pixel")]
pub(super) fn single(p: DVec2) -> (f32, f32) {
    (p.x as f32, p.y as f32)
}
