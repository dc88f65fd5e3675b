//! The README tells the truth: its scenes load, its files exist.

#![allow(clippy::unwrap_used, reason = "a test may fail")]

mod support;

use std::fs;

use snellius::{Scene, compile};

#[test]
fn its_scenes_load_and_compile_without_a_warning() {
    let readme = readme();
    let scenes: Vec<_> = readme.split("```ron\n").skip(1).map(|rest| rest.split("```").next().unwrap()).collect();
    assert_eq!(scenes.len(), 2);
    for text in scenes {
        let scene = Scene::from_ron(text).unwrap_or_else(|problems| panic!("{problems}"));
        assert!(compile(&scene).unwrap().warnings.is_empty());
    }
}

#[test]
fn every_file_that_it_names_exists() {
    let readme = readme();
    let links = readme.split("](").skip(1).map(|rest| rest.split(')').next().unwrap());
    let scenes = readme.split_whitespace().filter(|word| word.starts_with("scenes/"));
    let files: Vec<_> = links.filter(|link| !link.contains("://")).chain(scenes).collect();
    assert!(files.len() >= 4);
    for file in files.iter().filter_map(|file| file.split('#').next()) {
        assert!(support::root().join(file).exists(), "{file}");
    }
}

fn readme() -> String {
    fs::read_to_string(support::root().join("README.md")).unwrap()
}
