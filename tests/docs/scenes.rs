//! Scenes that are shown.

use snellius::{Scene, compile};

use crate::page::pages;

fn compiles(text: &str) -> Result<Scene, String> {
    let scene = Scene::from_ron(text).map_err(|problems| problems.to_string())?;
    let compiled = compile(&scene).map_err(|problems| problems.to_string())?;
    match compiled.warnings.first() {
        None => Ok(scene),
        Some(warning) => Err(warning.message.clone()),
    }
}

#[test]
fn every_scene_compiles() {
    for page in pages() {
        for block in page.marked("ron") {
            compiles(&block.text).unwrap_or_else(|problems| panic!("{}:\n{problems}", page.place(block)));
        }
    }
}

#[test]
fn every_fragment_is_part_of_a_scene() {
    for page in pages() {
        for block in page.marked("ron,fragment") {
            let text = &block.text;
            let scenes = [format!("(\n{text})"), format!("(bodies: [\n{text}])"), format!("(sources: [\n{text}])")];
            let tried: Vec<_> = scenes.iter().map(|scene| compiles(scene)).collect();
            assert!(tried.iter().any(Result::is_ok), "{}:\n{tried:#?}", page.place(block));
        }
    }
}

#[test]
fn every_block_has_a_known_mark() {
    for page in pages() {
        for block in &page.blocks {
            let known = ["ron", "ron,fragment", "sh", "sh fails", "text", "json", "csv", "rust", "toml", "math"];
            assert!(known.contains(&block.mark.as_str()), "{}: {}", page.place(block), block.mark);
        }
    }
}
