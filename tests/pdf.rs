//! Figures as PDF: the page, its text, and the same bytes every time.

#![cfg(feature = "pdf")]
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

mod support;

use std::collections::BTreeMap;

use snellius::diagram::draw;
use snellius::drawing::Drawing;
use snellius::render;
use support::{run, run_text, scene_names};

const PRISM: &str = r#"(
    title: "Dispersion – schön",
    caption: "Into a prism.",
    bodies: [(name: "prism", shape: Prism(apex_angle: 60, side: 40), medium: Catalog("F2"))],
    sources: [(light: Ray(from: (-50, -18), direction: Towards((-12, 0))), spectrum: Lines([450, 650]))],
    diagram: (size: (800, 400), theme: Dark),
    notes: [(at: (-40, 20), text: "鏡")],
)"#;

fn figure(text: &str) -> Drawing {
    let run = run_text(text);
    draw(&run.scene, &run.system, &run.trace.tree)
}

/// A file's text outside of its streams, and its streams inflated.
fn parts(file: &[u8]) -> (String, Vec<String>) {
    let find =
        |from: usize, what: &[u8]| file[from..].windows(what.len()).position(|at| at == what).map(|at| from + at);
    let (mut outside, mut streams, mut at) = (String::new(), Vec::new(), 0);
    while let Some(begin) = find(at, b"\nstream\n") {
        outside += &String::from_utf8_lossy(&file[at..begin]);
        let end = find(begin, b"\nendstream").unwrap();
        let data = miniz_oxide::inflate::decompress_to_vec_zlib(&file[begin + 8..end]).unwrap();
        streams.push(String::from_utf8_lossy(&data).into_owned());
        at = end;
    }
    (outside + &String::from_utf8_lossy(&file[at..]), streams)
}

/// The character of each glyph of a face.
type Characters = BTreeMap<u16, char>;

/// The faces of a page by their names there.
fn faces(outside: &str, streams: &[String]) -> BTreeMap<String, Characters> {
    let fonts = outside.split("/Font <<").nth(1).unwrap().split(">>").next().unwrap();
    let names = fonts.split('/').skip(1).map(|entry| entry.split(' ').next().unwrap().to_owned());
    let number = |hex: &str| u16::from_str_radix(hex, 16).unwrap();
    let maps = streams.iter().filter(|stream| stream.contains("begincmap")).map(|map| {
        let pairs = map.lines().filter_map(|line| line.strip_prefix('<')?.strip_suffix('>')?.split_once("> <"));
        let pairs = pairs.filter(|(glyph, _)| glyph.len() == 4 && *glyph != "0000");
        pairs.map(|(glyph, character)| (number(glyph), char::from_u32(number(character).into()).unwrap())).collect()
    });
    names.zip(maps).collect()
}

/// The bytes of a string between parentheses, or in hexadecimal digits.
fn bytes(string: &str) -> Vec<u8> {
    if let Some(hex) = string.strip_prefix('<') {
        let digits: Vec<u32> = hex.chars().filter_map(|digit| digit.to_digit(16)).collect();
        return digits.chunks(2).map(|pair| u8::try_from(16 * pair[0] + pair[1]).unwrap()).collect();
    }
    let mut rest = string[1..string.len() - 1].chars();
    let mut bytes = Vec::new();
    while let Some(character) = rest.next() {
        let escaped = if character == '\\' { rest.next().unwrap() } else { ' ' };
        bytes.push(match (character, escaped) {
            ('\\', 'n') => b'\n',
            ('\\', 'r') => b'\r',
            ('\\', 't') => b'\t',
            ('\\', 'b') => 8,
            ('\\', 'f') => 12,
            ('\\', digit) if digit.is_digit(8) => {
                let digits: String = std::iter::once(digit).chain(rest.by_ref().take(2)).collect();
                u8::from_str_radix(&digits, 8).unwrap()
            }
            ('\\', other) | (other, _) => u8::try_from(other).unwrap(),
        });
    }
    bytes
}

/// The words of a page, a piece each, as a reader finds them.
fn words(outside: &str, streams: &[String]) -> Vec<String> {
    let faces = faces(outside, streams);
    let page = streams.iter().find(|stream| stream.contains("BT\n")).unwrap();
    let mut face = &Characters::new();
    let mut words = Vec::new();
    for line in page.lines() {
        if let Some(font) = line.strip_suffix(" Tf") {
            face = &faces[font[1..].split(' ').next().unwrap()];
        } else if let Some(shown) = line.strip_suffix(" Tj") {
            let bytes = bytes(shown);
            let glyphs = bytes.chunks(2).map(|pair| u16::from_be_bytes([pair[0], pair[1]]));
            words.push(glyphs.map(|glyph| face.get(&glyph).copied().unwrap_or('?')).collect());
        }
    }
    words
}

#[test]
fn the_page_has_the_figures_size_words_and_title() {
    let file = render::pdf(&figure(PRISM)).unwrap();
    let (outside, streams) = parts(&file);
    assert!(file.starts_with(b"%PDF-1.7") && file.trim_ascii_end().ends_with(b"%%EOF"));
    assert!(outside.contains("/MediaBox [0 0 600 300]"), "800 × 400 pixels of 3/4 point");
    assert!(!outside.contains("Date"));
    assert!(outside.contains("/Title <FEFF0044006900730070"), "in UTF-16: {outside}");
    assert!(outside.contains("/Subject (Into a prism.)"));
    assert!(outside.contains("+DejaVuSans-Bold") && outside.contains("/FontFile2"));
    let words = words(&outside, &streams);
    for expected in ["Dispersion – schön", "Into a prism.", "θ", "450 nm", "?"] {
        assert!(words.iter().any(|found| found == expected), "{expected}: {words:?}");
    }
    assert!(file.len() < 40_000, "only the glyphs that are used: {}", file.len());
}

#[test]
fn lights_add_up_in_a_group_apart() {
    let (outside, streams) = parts(&render::pdf(&figure(PRISM)).unwrap());
    assert!(outside.contains("/BM /Screen") && outside.contains("/I true"));
    let page = streams.iter().find(|stream| stream.contains("BT\n")).unwrap();
    let groups = streams.iter().filter(|stream| stream.contains("/L255 gs")).count();
    assert!(groups >= 2 && page.matches(" Do").count() == groups && !page.contains("/L"), "{groups}");
    assert!(page.contains(" re\nW\nn"), "layers end at the frame");
    assert!(page.contains("[5 4] 0 d"), "normals are dashed");
    let faint = page.lines().filter(|line| line.starts_with("/G") && *line != "/G255 gs").count();
    assert!(faint > 4, "weak rays are faint: {faint}");
}

#[test]
fn the_same_figure_gives_the_same_bytes() {
    let one = || render::pdf(&figure(PRISM)).unwrap();
    assert_eq!(one(), one());
    assert_ne!(one(), render::pdf(&figure(&PRISM.replace("650", "651"))).unwrap());
}

#[test]
fn every_scene_becomes_a_page() {
    for name in scene_names() {
        let run = run(&name);
        let drawing = draw(&run.scene, &run.system, &run.trace.tree);
        let (outside, streams) = parts(&render::pdf(&drawing).unwrap());
        let words = words(&outside, &streams).concat();
        let first = run.scene.title.split(' ').next().unwrap();
        assert!(words.contains(first), "{name}: {words}");
        for stream in streams.iter().filter(|stream| stream.contains("BT\n")) {
            assert!(!stream.contains("NaN") && !stream.contains("inf"), "{name}");
            let count = |operator: &str| stream.lines().filter(|line| *line == operator).count();
            assert_eq!(count("q"), count("Q"), "{name}");
        }
    }
}
