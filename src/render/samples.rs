//! Very many straight lines of one style at once: first all samples that any of them covers, then the paint.
//!
//! A pixel has 4 × 4 samples, as many as tiny-skia takes. One is covered if it lies within half the width of a line, so that
//! every line has round ends and crossings are not painted twice. A stroker's outlines would have to be sorted along every
//! row of samples; here a line sets its bits and is done.

use std::ops::Range;

use glam::DVec2;

/// Samples along a pixel's side.
const SIDE: f64 = 4.0;
/// Pixels whose samples of one row are one word.
const PIXELS: usize = 16;

/// The samples of a picture, a bit each.
pub(super) struct Samples {
    width: usize,
    height: usize,
    /// Blocks in a row of pixels.
    words: usize,
    /// The four rows of samples of sixteen pixels each, from the left upper corner.
    blocks: Vec<[u64; 4]>,
}

impl Samples {
    /// None covered yet, for a picture of so many pixels.
    pub(super) fn new(width: u32, height: u32) -> Self {
        let [width, height] = [width as usize, height as usize];
        let words = width.div_ceil(PIXELS);
        Self { width, height, words, blocks: vec![[0; 4]; words * height] }
    }

    /// Covers the samples of a line with round ends, pixels.
    pub(super) fn cover(&mut self, from: DVec2, to: DVec2, half_width: f64) {
        let line = Line::new(from * SIDE, to * SIDE, half_width * SIDE);
        let [top, bottom] = line.rows(line.r).map(|y| first(y, self.height));
        // Between the arcs of its ends both borders are straight and equally far apart.
        let [from, to] = line.rows(-line.lift.abs()).map(|y| first(y, self.height).clamp(top, bottom));
        let mut arcs = |rows: Range<usize>| {
            for row in rows {
                let [left, right] = [-1.0, 1.0].map(|side| line.border(middle(row), side));
                self.set(row, left, right);
            }
        };
        arcs(top..from.min(to));
        arcs(from.max(to)..bottom);
        if from >= to {
            return arcs(to..from);
        }
        let [mut left, mut right] = [-1.0, 1.0].map(|side| line.border(middle(from), side));
        for row in from..to {
            self.set(row, left, right);
            left += line.slope;
            right += line.slope;
        }
    }

    /// Covers the samples of a row between two borders.
    #[inline]
    fn set(&mut self, row: usize, left: f64, right: f64) {
        let [left, right] = [left, right].map(|border| first(border, self.width));
        if left >= right {
            return;
        }
        let start = row / 4 * self.words;
        let (from, to) = (left / 64, (right - 1) / 64);
        let row_of = |block: &mut [u64; 4], bits| block[row % 4] |= bits;
        let (head, tail) = (u64::MAX << (left % 64), u64::MAX >> (63 - (right - 1) % 64));
        if from == to {
            return row_of(&mut self.blocks[start + from], head & tail);
        }
        row_of(&mut self.blocks[start + from], head);
        self.blocks[start + from + 1..start + to].iter_mut().for_each(|block| row_of(block, u64::MAX));
        row_of(&mut self.blocks[start + to], tail);
    }

    /// Hands on every pixel that has covered samples, by its place in the picture's rows, with how many of 16, and forgets
    /// them.
    pub(super) fn take(&mut self, mut pixel: impl FnMut(usize, u8)) {
        for (i, block) in self.blocks.iter_mut().enumerate().filter(|(_, block)| **block != [0; 4]) {
            let place = i / self.words * self.width + i % self.words * PIXELS;
            for (k, count) in counts(std::mem::take(block)).into_iter().enumerate().filter(|(_, count)| *count > 0) {
                pixel(place + k, count);
            }
        }
    }
}

/// Numbers of covered samples of sixteen pixels.
fn counts(block: [u64; 4]) -> [u8; PIXELS] {
    const NIBBLES: u64 = 0x0f0f_0f0f_0f0f_0f0f;
    let (mut even, mut odd) = (0, 0);
    for row in block {
        let pairs = row - ((row >> 1) & 0x5555_5555_5555_5555);
        let fours = (pairs & 0x3333_3333_3333_3333) + ((pairs >> 2) & 0x3333_3333_3333_3333);
        even += fours & NIBBLES;
        odd += (fours >> 4) & NIBBLES;
    }
    let (even, odd) = (even.to_le_bytes(), odd.to_le_bytes());
    std::array::from_fn(|k| if k % 2 == 0 { even[k / 2] } else { odd[k / 2] })
}

/// All points within a distance of a stretch, in samples.
struct Line {
    /// The upper end; of two at one height the left one.
    a: DVec2,
    b: DVec2,
    r: f64,
    /// Unit direction from `a` to `b`, down or right.
    along: DVec2,
    /// Step to the right for a step down.
    slope: f64,
    /// How much higher than its ends the straight border on the right starts and stops, and lower the one on the left.
    lift: f64,
}

impl Line {
    fn new(a: DVec2, b: DVec2, r: f64) -> Self {
        let (a, b) = if (a.y, a.x) <= (b.y, b.x) { (a, b) } else { (b, a) };
        let along = (b - a).try_normalize().unwrap_or(DVec2::X);
        Self { a, b, r, along, slope: along.x / along.y, lift: r * along.x }
    }

    /// Heights so far above its upper end and below its lower one.
    fn rows(&self, beyond: f64) -> [f64; 2] {
        [self.a.y - beyond, self.b.y + beyond]
    }

    /// Where it ends at a height to the left (`side` −1) or to the right (1): a straight border between two arcs.
    fn border(&self, y: f64, side: f64) -> f64 {
        let lift = side * self.lift;
        let arc = |end: DVec2| end.x + side * (self.r * self.r - (y - end.y) * (y - end.y)).max(0.0).sqrt();
        if y <= self.a.y - lift {
            arc(self.a)
        } else if y >= self.b.y - lift {
            arc(self.b)
        } else {
            self.a.x + side * self.r * self.along.y + (y - self.a.y + lift) * self.slope
        }
    }
}

/// The first sample along so many pixels whose middle is not before a border; one beyond the last if there is none.
fn first(border: f64, pixels: usize) -> usize {
    /// A sum with it has the nearest whole number in its last bits, a multiple as fast as a conversion.
    const WHOLE: f64 = 1.5 * (1_u64 << 52) as f64;
    let sample = (border + WHOLE).to_bits().wrapping_sub(WHOLE.to_bits()).cast_signed();
    usize::try_from(sample).unwrap_or(0).min(4 * pixels)
}

/// The middle of a sample along its row or column.
fn middle(sample: usize) -> f64 {
    u32::try_from(sample).map_or(f64::INFINITY, f64::from) + 0.5
}

#[cfg(test)]
mod tests {
    use tiny_skia::{FillRule, LineCap, Paint, PathBuilder, Pixmap, Stroke as Plain, Transform};

    use super::*;
    use crate::drawing::{Color, Drawing, Lines, Rect, Stroke};
    use crate::render::png;
    use crate::render::png::alpha;
    use crate::render::skia::single;

    const SIZE: u32 = 96;

    /// Lines between points without order, some of them a single point, upright, level or half outside.
    fn lines(count: i32, width: f64, opacity: f64) -> Lines {
        let mut lines = Lines::new(Stroke::solid(Color::hex(0x20_40_c0), width).faded(opacity), "");
        let place = |k: i32| k * 7919 % 11_003 - 600;
        lines.ends = (0..count).map(|k| [4 * k, 4 * k + 1, 4 * k + 2, 4 * k + 3].map(place)).collect();
        lines.ends.extend([[2000, 2000, 2000, 2000], [3000, 500, 3000, 9000], [500, 4000, 9000, 4000]]);
        lines
    }

    fn picture(lines: &Lines) -> Pixmap {
        let (items, background) = (vec![lines.clone().into()], Some(Color::hex(0xff_ff_ff)));
        let (title, description) = (String::new(), String::new());
        let drawing = Drawing { size: [SIZE; 2], background, title, description, items };
        Pixmap::decode_png(&png(&drawing, 1.0).unwrap()).unwrap()
    }

    fn ends([ax, ay, bx, by]: [i32; 4]) -> [DVec2; 2] {
        [DVec2::new(ax.into(), ay.into()), DVec2::new(bx.into(), by.into())].map(|p| p / 100.0)
    }

    /// Differences of two pictures, the largest channel of every pixel.
    fn differences(a: &Pixmap, b: &Pixmap) -> Vec<u8> {
        let channels = a.data().chunks(4).zip(b.data().chunks(4));
        channels.map(|(a, b)| a.iter().zip(b).map(|(a, b)| a.abs_diff(*b)).max().unwrap_or(0)).collect()
    }

    /// The picture of what the lines are: every sample's distance from every line, then one coat of paint.
    fn by_distance(lines: &Lines) -> Pixmap {
        let mut picture = Pixmap::new(SIZE, SIZE).unwrap();
        let covered = |p: DVec2| {
            lines.ends.iter().any(|line| {
                let [a, b] = ends(*line);
                let along = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
                let foot = if along.is_nan() { a } else { a.lerp(b, along) };
                (p - foot).length() <= 0.5 * lines.stroke.width
            })
        };
        for (i, pixel) in (0..).zip(picture.pixels_mut()) {
            let corner = DVec2::new(f64::from(i % SIZE), f64::from(i / SIZE));
            let middles = (0..16).map(|k| DVec2::new(f64::from(k % 4), f64::from(k / 4)) * 0.25 + 0.125);
            let count = u8::try_from(middles.filter(|p| covered(corner + *p)).count()).unwrap();
            let share = f64::from(count) / 16.0 * lines.stroke.opacity;
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a channel")]
            let mix = |c: u8| (255.0 + (f64::from(c) - 255.0) * share).round() as u8;
            let [r, g, b] = lines.stroke.color.0.map(mix);
            *pixel = tiny_skia::PremultipliedColorU8::from_rgba(r, g, b, 255).unwrap();
        }
        picture
    }

    #[test]
    fn a_line_covers_what_is_within_half_its_width() {
        for (count, width, opacity) in [(1, 5.0, 1.0), (12, 2.4, 1.0), (40, 0.6, 0.4), (40, 1.3, 0.22)] {
            let lines = lines(count, width, opacity);
            let worst = differences(&picture(&lines), &by_distance(&lines)).into_iter().max();
            assert!(worst.unwrap() <= 1, "{count} lines of {width} px: {worst:?}");
        }
    }

    #[test]
    fn many_lines_look_as_a_stroker_draws_them() {
        for (count, width, opacity) in [(20, 2.4, 1.0), (60, 1.3, 0.5), (60, 0.6, 0.3)] {
            let lines = lines(count, width, opacity);
            let mut pen = PathBuilder::new();
            for [a, b] in lines.ends.iter().map(|line| ends(*line).map(single)) {
                pen.move_to(a.0, a.1);
                pen.line_to(b.0, b.1);
            }
            #[allow(clippy::cast_possible_truncation, reason = "a width of a few pixels")]
            let stroke = Plain { width: width as f32, line_cap: LineCap::Round, ..Plain::default() };
            let outline = pen.finish().unwrap().stroke(&stroke, 1.0).unwrap();
            let mut plain = Pixmap::new(SIZE, SIZE).unwrap();
            plain.fill(tiny_skia::Color::WHITE);
            let mut paint = Paint::default();
            paint.set_color_rgba8(0x20, 0x40, 0xc0, alpha(opacity));
            plain.fill_path(&outline, &paint, FillRule::Winding, Transform::identity(), None);
            let differences = differences(&picture(&lines), &plain);
            let apart = |by: u8| differences.iter().filter(|difference| **difference > by).count();
            // tiny-skia rounds corners to 1/256 px: here and there a border is on the other side of one sample.
            assert!(apart(1) * 50 < differences.len(), "{width}: {}", apart(1));
            assert_eq!(apart(16), 0, "{width}");
        }
    }

    #[test]
    fn a_clip_and_a_scale_hold_for_many_lines_too() {
        let group = |clip| crate::drawing::Group::layer("", vec![lines(30, 1.5, 1.0).into()]).clipped(clip);
        let clip = Rect { min: DVec2::splat(20.0), max: DVec2::splat(50.0) };
        let drawing = Drawing {
            size: [SIZE; 2],
            background: Some(Color::hex(0xff_ff_ff)),
            title: String::new(),
            description: String::new(),
            items: vec![group(clip).into()],
        };
        let picture = Pixmap::decode_png(&png(&drawing, 2.0).unwrap()).unwrap();
        let dark = (0..).zip(picture.pixels()).filter(|(_, pixel)| pixel.red() < 128).map(|(i, _)| [i % 192, i / 192]);
        let dark: Vec<[u32; 2]> = dark.collect();
        assert!(dark.iter().flatten().all(|place| (40..100).contains(place)));
        assert!(dark.len() > 300, "{}", dark.len());
    }
}
