//! Drawings made by hand, from any numbers and words.

use glam::DVec2;
use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;
use proptest::sample::select;
use snellius::drawing::{
    Anchor, Cap, Color, Drawing, Fill, Font, Group, Item, Lines, Path, Rect, Script, Shape, Span, Stroke, Text, Whole,
    words,
};
use snellius::render::{png, svg, svg_outlined};

use crate::config;
use crate::hostile::{self, number, point};

fn path() -> impl Strategy<Value = Path> {
    let step = (0..5_u8, point(), number(), any::<bool>(), any::<bool>());
    vec(step, 0..6).prop_map(|steps| {
        let mut path = Path::new();
        for (kind, p, x, large, sweep) in steps {
            match kind {
                0 => path.move_to(p),
                1 => path.line_to(p),
                2 => path.arc_to(x, large, sweep, p),
                3 => path.append(Path::circle(p, x).moved(p)),
                _ => path.close(),
            }
        }
        path
    })
}

fn stroke() -> impl Strategy<Value = Stroke> {
    let numbers = (number(), number(), vec(number(), 0..4), any::<bool>());
    numbers.prop_map(|(width, opacity, dash, butt)| {
        let stroke = Stroke::solid(Color::hex(0xab_cd_ef), width).faded(opacity).dashed(&dash);
        stroke.capped(if butt { Cap::Butt } else { Cap::Round })
    })
}

fn shape() -> impl Strategy<Value = Item> {
    (path(), stroke(), number(), hostile::words()).prop_map(|(path, stroke, opacity, words)| {
        let mut shape = Shape::stroked(path, stroke, &words).with("data-address", words.clone());
        let mut fill = Fill::solid(Color::hex(0x12_34_56));
        fill.opacity = opacity;
        shape.fill = Some(fill);
        shape.with("no <name>", words).into()
    })
}

fn lines() -> impl Strategy<Value = Item> {
    let ends = vec((point(), point()), 0..4);
    (ends, stroke(), any::<[i32; 4]>(), any::<bool>()).prop_map(|(ends, mut stroke, any, round)| {
        if round {
            stroke.dash.clear();
            stroke.cap = Cap::Round;
        }
        let mut lines = Lines::new(stroke, "ray");
        ends.into_iter().for_each(|(from, to)| lines.push(from, to));
        lines.ends.extend([any, [i32::MIN; 4], [i32::MAX, i32::MIN, 0, 0]]);
        lines.into()
    })
}

fn text() -> impl Strategy<Value = Item> {
    let style = (select(&[Font::Regular, Font::Bold, Font::Oblique][..]), 0..3_u8);
    (hostile::words(), point(), number(), style, point()).prop_map(|(words, at, size, (font, anchor), moved)| {
        let mut text = Text::new(&words, at, size, Color::hex(0)).in_font(font).subscript(&words).then("x");
        text = text.anchored([Anchor::Start, Anchor::Middle, Anchor::End][usize::from(anchor)]);
        text.at = moved;
        text.spans.push(Span { text: words, script: Script::Subscript });
        let _any = (text.width(), text.bounds());
        text.into()
    })
}

fn item() -> impl Strategy<Value = Item> {
    let leaf = prop_oneof![3 => shape(), 1 => lines(), 2 => text()];
    leaf.prop_recursive(4, 24, 4, |inner| {
        let clip = option::of((point(), point()).prop_map(|(min, max)| Rect { min, max }));
        let whole = option::of((number(), any::<bool>()).prop_map(|(opacity, adds_up)| Whole { opacity, adds_up }));
        let rest = (clip, whole, option::of(hostile::count()), hostile::words());
        (vec(inner, 0..4), rest).prop_map(|(items, (clip, whole, step, words))| {
            let mut group = Group::layer(&words, items).named(&words).with("data-body", words.clone());
            (group.clip, group.whole, group.step) = (clip, whole, step);
            group.into()
        })
    })
}

/// Small ones, so that they can be painted, and others.
fn drawing() -> impl Strategy<Value = Drawing> {
    let size = prop_oneof![4 => [1..80_u32, 1..80_u32], 1 => [hostile::count(), hostile::count()]];
    (size, vec(item(), 0..5), hostile::words()).prop_map(|(size, items, words)| {
        let mut drawing = Drawing::default();
        (drawing.size, drawing.items) = (size, items);
        (drawing.title, drawing.description) = (words.clone(), words);
        drawing
    })
}

/// Well-formed, and without a number that is none.
pub(crate) fn check_svg(text: &str) {
    let document = roxmltree::Document::parse(text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    for attribute in document.descendants().flat_map(|node| node.attributes()) {
        let value = attribute.value();
        let numbers = value.split([' ', ',', 'M', 'L', 'A', 'Q', 'C', 'Z']);
        let is_none = |word: &str| matches!(word, "NaN" | "inf" | "-inf");
        let is_words =
            matches!(attribute.name(), "class" | "id" | "aria-label") || attribute.name().starts_with("data-");
        assert!(is_words || !numbers.into_iter().any(is_none), "{}={value:?}", attribute.name());
    }
}

proptest! {
    #![proptest_config(config(250))]

    #[test]
    fn drawings_by_hand_are_written(drawing in drawing(), scale in prop_oneof![0.1..2.0, number()]) {
        check_svg(&svg(&drawing));
        check_svg(&svg_outlined(&drawing));
        let [width, height] = drawing.size.map(|side| f64::from(side) * scale);
        // Large ones take long, too large ones none.
        if !(1e5..=1.6e8).contains(&(width * height)) {
            #[expect(clippy::cast_possible_truncation, reason = "any number will do")]
            let _refused_or_done = png(&drawing, scale as f32);
        }
        #[cfg(feature = "pdf")]
        snellius::render::pdf(&drawing).unwrap();
        let _any = (drawing.missing_glyphs(), drawing.steps(), drawing.up_to(3));
        check_svg(&svg(&Drawing::side_by_side(&[drawing.clone(), drawing], u32::MAX)));
    }

    #[test]
    fn words_and_glyphs_take_any_text(text in vec(any::<char>(), 0..40).prop_map(String::from_iter), font in select(&[Font::Regular, Font::Bold][..])) {
        let _any: Vec<&str> = words(&text).collect();
        prop_assert!(font.width(&text) >= 0.0);
        text.chars().for_each(|c| drop((font.outline(c), font.has(c))));
        check_svg(&svg_outlined(&Drawing::side_by_side(&[written(&text)], 0)));
    }
}

fn written(text: &str) -> Drawing {
    let mut drawing = Drawing::default();
    drawing.size = [40, 40];
    drawing.items.push(Text::new(text, DVec2::ZERO, 12.0, Color::hex(0)).into());
    drawing.description = text.to_owned();
    drawing
}

#[test]
fn a_picture_too_large_or_of_no_size_is_an_error() {
    for size in [[0, 0], [0, 10], [u32::MAX; 2], [20_000, 20_000]] {
        let mut drawing = Drawing::default();
        drawing.size = size;
        assert!(png(&drawing, 1.0).is_err(), "{size:?}");
        check_svg(&svg(&drawing));
    }
    for scale in [0.0, -1.0, f32::NAN, f32::INFINITY, f32::MIN_POSITIVE, f32::MAX] {
        assert!(png(&written("x"), scale).is_err(), "{scale}");
    }
}

/// Found by the drawings above.
#[test]
fn letters_wider_than_numbers_of_pixels_are_painted() {
    let words = "many words with no end and a wordwithoutanyspaceinit".repeat(40);
    let text = Text::new(&words, DVec2::new(f64::MAX, 0.0), 2.8e61, Color::hex(0)).in_font(Font::Bold);
    let text = text.subscript(&words).then("x").subscript(&words).anchored(Anchor::End);
    let mut drawing = Drawing::default();
    (drawing.size, drawing.items) = ([4, 1], vec![text.into()]);
    png(&drawing, 32.739_09).unwrap();
}

#[test]
fn groups_in_groups_without_end_are_cut_off() {
    let mut item: Item = Text::new("inmost", DVec2::new(5.0, 20.0), 12.0, Color::hex(0)).into();
    for depth in 0..200_000 {
        item = Group::layer("deep", vec![item]).into();
        if depth == 40 {
            let mut drawing = written("top");
            drawing.items.push(item.clone());
            assert!(svg(&drawing).contains("inmost"), "so deep is well");
        }
    }
    let mut drawing = written("top");
    drawing.items.push(item);
    check_svg(&svg(&drawing));
    assert!(png(&drawing, 1.0).is_ok() && drawing.missing_glyphs().is_empty());
    assert_eq!(drawing.clone(), drawing);
}
