//! The display list as a page's operators (ISO 32000-1, 8 and 11).

use std::collections::BTreeSet;

use glam::DVec2;
use pdf_writer::types::{BlendMode, LineCapStyle, LineJoinStyle};
use pdf_writer::{Content, Name, Str};

use super::{POINTS, fonts::Fonts, single};
use crate::drawing::{Anchor, extent, pixel};
use crate::drawing::{Cap, Color, Drawing, Fill, Group, Item, Lines, Path, PathStep, Rect, Shape, Stroke, Text, Whole};
use crate::render::arcs::cubics;

/// What the page and its groups have in common.
#[derive(Default)]
pub(super) struct Shared {
    pub(super) fonts: Fonts,
    pub(super) states: BTreeSet<State>,
    /// Operators of the groups that are put together apart.
    pub(super) groups: Vec<Vec<u8>>,
}

impl Shared {
    pub(super) fn group_name(number: usize) -> String {
        format!("X{number}")
    }
}

/// How things are laid on what is behind them.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct State {
    /// Opacity, a byte's steps.
    alpha: u8,
    adds_up: bool,
}

impl State {
    fn new(opacity: f64, adds_up: bool) -> Self {
        Self { alpha: crate::render::png::alpha(opacity), adds_up }
    }

    pub(super) fn name(self) -> String {
        format!("{}{}", if self.adds_up { "L" } else { "G" }, self.alpha)
    }

    pub(super) fn opacity(self) -> f32 {
        f32::from(self.alpha) / 255.0
    }

    pub(super) fn blend_mode(self) -> BlendMode {
        if self.adds_up { BlendMode::Screen } else { BlendMode::Normal }
    }
}

/// A page or a group of it that is being drawn, in pixels with y down.
pub(super) struct Page<'a> {
    content: Content,
    shared: &'a mut Shared,
    /// Whether things add up as lights do.
    adds_up: bool,
}

impl<'a> Page<'a> {
    /// The operators of a whole figure.
    pub(super) fn whole(drawing: &Drawing, shared: &'a mut Shared) -> Vec<u8> {
        let mut page = Self::new(shared, false);
        let [width, height] = drawing.size.map(single);
        page.content.transform([POINTS, 0.0, 0.0, -POINTS, 0.0, POINTS * height]);
        page.content.set_line_join(LineJoinStyle::RoundJoin);
        if let Some(color) = drawing.background {
            page.fill_color(Fill::solid(color));
            page.content.rect(0.0, 0.0, width, height).fill_nonzero();
        }
        page.items(&drawing.items);
        page.content.finish().into_vec()
    }

    fn new(shared: &'a mut Shared, adds_up: bool) -> Self {
        Self { content: Content::new(), shared, adds_up }
    }

    fn items(&mut self, items: &[Item]) {
        for item in items {
            match item {
                Item::Shape(shape) => self.shape(shape),
                Item::Lines(lines) => self.lines(lines),
                Item::Text(text) => self.text(text),
                Item::Group(group) => self.group(group),
            }
        }
    }

    fn group(&mut self, group: &Group) {
        self.content.save_state();
        if let Some(Rect { min, max }) = group.clip {
            let [(x, y), (width, height)] = [min, max - min].map(point);
            self.content.rect(x, y, width, height).clip_nonzero().end_path();
        }
        match group.whole {
            Some(Whole { opacity, adds_up }) => {
                let mut apart = Page::new(&mut *self.shared, adds_up);
                apart.items(&group.items);
                let content = apart.content.finish().into_vec();
                let name = Shared::group_name(self.shared.groups.len());
                self.shared.groups.push(content);
                self.state(State::new(opacity, false));
                self.content.x_object(Name(name.as_bytes()));
            }
            None => self.items(&group.items),
        }
        self.content.restore_state();
    }

    fn shape(&mut self, shape: &Shape) {
        if shape.path.is_empty() {
            return;
        }
        if let Some(fill) = shape.fill {
            self.fill_color(fill);
            self.path(&shape.path);
            self.content.fill_nonzero();
        }
        if let Some(stroke) = &shape.stroke {
            self.stroke_style(stroke);
            self.path(&shape.path);
            self.content.stroke();
        }
    }

    fn lines(&mut self, lines: &Lines) {
        if lines.ends.is_empty() {
            return;
        }
        self.stroke_style(&lines.stroke);
        for ends in &lines.ends {
            let [ax, ay, bx, by] = ends.map(|hundredths| f64::from(hundredths) / 100.0);
            let [(ax, ay), (bx, by)] = [DVec2::new(ax, ay), DVec2::new(bx, by)].map(point);
            self.content.move_to(ax, ay).line_to(bx, by);
        }
        self.content.stroke();
    }

    /// A line of text, a piece a span.
    fn text(&mut self, text: &Text) {
        self.fill_color(Fill::solid(text.color));
        let mut left = match text.anchor {
            Anchor::Start => text.at.x,
            Anchor::Middle => text.at.x - 0.5 * text.width(),
            Anchor::End => text.at.x - text.width(),
        };
        self.content.begin_text();
        for span in text.spans.iter().filter(|span| !span.text.is_empty()) {
            let size = text.span_size(span);
            let (x, y) = point(DVec2::new(left, text.at.y + text.drop(span)));
            let shown = span.in_place();
            let bytes = self.shared.fonts.encode(text.font, &shown);
            self.content.set_font(Name(Fonts::name(text.font).as_bytes()), number(size));
            // Letters stand upright though y points down.
            self.content.set_text_matrix([1.0, 0.0, 0.0, -1.0, x, y]).show(Str(&bytes));
            left += text.font.width(&shown) * size;
        }
        self.content.end_text();
    }

    fn path(&mut self, path: &Path) {
        let mut last = DVec2::ZERO;
        for step in path.steps() {
            match *step {
                PathStep::MoveTo(p) => {
                    self.content.move_to(point(p).0, point(p).1);
                    last = p;
                }
                PathStep::LineTo(p) => {
                    self.content.line_to(point(p).0, point(p).1);
                    last = p;
                }
                PathStep::ArcTo { to, .. } => {
                    match cubics(last, step) {
                        Some(curves) => curves.into_iter().for_each(|curve| self.cubic_to(curve)),
                        None => {
                            self.content.line_to(point(to).0, point(to).1);
                        }
                    }
                    last = to;
                }
                PathStep::Close => {
                    self.content.close_path();
                }
            }
        }
    }

    fn cubic_to(&mut self, curve: [DVec2; 3]) {
        let [c, d, p] = curve.map(point);
        self.content.cubic_to(c.0, c.1, d.0, d.1, p.0, p.1);
    }

    fn fill_color(&mut self, Fill { color, opacity }: Fill) {
        let [r, g, b] = channels(color);
        self.content.set_fill_rgb(r, g, b);
        self.state(State::new(opacity, self.adds_up));
    }

    fn stroke_style(&mut self, stroke: &Stroke) {
        let [r, g, b] = channels(stroke.color);
        let cap = match stroke.cap {
            Cap::Butt => LineCapStyle::ButtCap,
            Cap::Round => LineCapStyle::RoundCap,
        };
        self.content.set_stroke_rgb(r, g, b).set_line_width(number(extent(stroke.width))).set_line_cap(cap);
        self.content.set_dash_pattern(stroke.dash.iter().map(|length| number(extent(*length))), 0.0);
        self.state(State::new(stroke.opacity, self.adds_up));
    }

    fn state(&mut self, state: State) {
        self.shared.states.insert(state);
        self.content.set_parameters(Name(state.name().as_bytes()));
    }
}

fn channels(Color(channels): Color) -> [f32; 3] {
    channels.map(|channel| f32::from(channel) / 255.0)
}

/// A point with what PDF needs of its digits.
fn point(p: DVec2) -> (f32, f32) {
    (number(p.x), number(p.y))
}

#[allow(clippy::cast_possible_truncation, reason = "a float holds a hundredth of a pixel")]
fn number(length: f64) -> f32 {
    pixel(length) as f32
}
