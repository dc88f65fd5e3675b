//! Every scene is traced and drawn, and compared with `snapshots/`: its ray tree with the power balance as text, its
//! figure as SVG, and for some the PNG; docs/gallery.md shows them all. `INSTA_UPDATE=always cargo test --test scenes` writes
//! everything anew.

mod support;

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use snellius::{diagram, render, report};
use support::Run;
use support::recorded::is_recorded;
use tiny_skia::Pixmap;

/// Scenes whose PNG is kept: text, dispersion and the dark theme among them.
const PICTURES: [&str; 8] = [
    "lenses/achromat",
    "lenses/cooke-triplet",
    "mirrors/caustic",
    "nature/rainbow-primary",
    "prisms/minimum-deviation",
    "prisms/white-light",
    "refraction/slab-reflections",
    "total-reflection/half-disk-above",
];

#[test]
fn trees_and_figures_are_as_recorded() {
    for name in support::scene_names() {
        let run = support::run(&name);
        let (folder, file) = name.rsplit_once('/').unwrap_or(("", &name));
        let mut settings = insta::Settings::new();
        settings.set_snapshot_path(snapshots().join(folder));
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        settings.bind(|| {
            insta::assert_snapshot!(format!("{file}.tree"), report::text(&run.system, &run.trace));
        });
        is_recorded(&snapshots().join(format!("{name}.svg")), &svg(&run));
    }
}

#[test]
fn pictures_are_within_one_level_of_those_recorded() {
    for name in PICTURES {
        let run = support::run(name);
        let png = render::png(&diagram::draw(&run.scene, &run.system, &run.trace.tree), 1.0).unwrap();
        let path = snapshots().join(format!("{name}.png"));
        if std::env::var("INSTA_UPDATE").is_ok_and(|update| update == "always") {
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(&path, &png).unwrap();
        }
        let recorded = Pixmap::load_png(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let drawn = Pixmap::decode_png(&png).unwrap();
        assert_eq!((drawn.width(), drawn.height()), (recorded.width(), recorded.height()), "{name}");
        let farthest = drawn.data().iter().zip(recorded.data()).map(|(a, b)| a.abs_diff(*b)).max();
        assert!(farthest <= Some(1), "{name}: a channel differs by {farthest:?}");
    }
}

#[test]
fn every_file_among_the_snapshots_has_its_scene() {
    let scenes = support::scene_names();
    let trees = scenes.iter().flat_map(|name| [format!("{name}.tree.snap"), format!("{name}.svg")]);
    let expected: BTreeSet<String> = trees.chain(PICTURES.iter().map(|name| format!("{name}.png"))).collect();
    let files = support::all_files(&snapshots());
    let mut found: BTreeSet<String> = files.iter().map(|path| support::path_under(&snapshots(), path)).collect();
    // Messages of invalid scenes are another test's.
    found.retain(|name| !name.starts_with("invalid/"));
    let wrong: Vec<_> = found.symmetric_difference(&expected).collect();
    assert!(wrong.is_empty(), "missing, or without a scene: {wrong:?}");
}

#[test]
fn every_scene_has_a_title_and_a_caption() {
    for name in support::scene_names() {
        let scene = support::run(&name).scene;
        assert!(!scene.title.is_empty() && !scene.caption.is_empty(), "{name}");
    }
}

#[test]
fn there_are_at_least_thirty_scenes() {
    assert!(support::scene_names().len() >= 30);
}

#[test]
fn the_gallery_shows_every_scene() {
    is_recorded(&support::root().join("docs/gallery.md"), &support::gallery::page());
}

fn svg(run: &Run) -> String {
    render::svg(&diagram::draw(&run.scene, &run.system, &run.trace.tree))
}

fn snapshots() -> PathBuf {
    support::root().join("snapshots")
}
