//! The display list: what a figure is made of, in pixels with y down, and nothing about optics.
//!
//! Every coordinate that enters a [`Path`] or a [`Text`] is made finite and rounded to 1/100 px there, so that a renderer
//! sees neither NaN nor −0 and the same figure gives the same bytes on every machine. The renderers hold other numbers to
//! their range: a width, a size or an opacity that is NaN or below 0 counts as 0.

mod arabic;
mod color;
mod font;
mod item;
mod items;
mod lines;
mod number;
mod order;
mod panels;
mod path;
mod steps;
mod style;
mod text;

pub use color::Color;
pub use font::{Font, GlyphStep};
pub use item::{Drawing, Group, Item, Shape, Whole};
pub use items::Items;
pub use lines::Lines;
pub(crate) use number::extent;
pub use number::{hundredths, pixel, shortest};
pub use path::{Path, PathStep, Rect};
pub use style::{Cap, Fill, Stroke};
pub use text::{Anchor, Glyph, Script, Span, Text, words};
