//! Pictures that pages show.

use std::fs;

use snellius::{Scene, compile, diagram, render, trace};

#[cfg(unix)]
use crate::commands::run_page;
#[cfg(unix)]
use crate::page::pages;
use crate::page::root;
use crate::support::files;
use crate::support::recorded::is_recorded;

/// Pages whose pictures are plots, which their own programs make.
#[cfg(unix)]
const PLOTS: [&str; 2] = ["docs/accuracy.md", "docs/performance.md"];

#[test]
fn a_picture_beside_its_scene_is_what_snellius_draws() {
    let scenes = files(&root().join("docs"), "ron");
    assert!(!scenes.is_empty());
    for path in scenes {
        let scene = Scene::from_ron(&fs::read_to_string(&path).unwrap()).unwrap();
        let compiled = compile(&scene).unwrap();
        assert!(compiled.warnings.is_empty(), "{}", path.display());
        let drawn = render::svg(&diagram::draw(&scene, &compiled.system, &trace(&compiled.system).tree));
        assert!(!drawn.contains("\n\n"), "{}: at an empty line a picture in a doc comment ends", path.display());
        is_recorded(&path.with_extension("svg"), &drawn);
    }
}

#[cfg(unix)]
#[test]
fn a_picture_of_a_page_is_what_its_commands_draw() {
    for page in pages().iter().filter(|page| !PLOTS.contains(&page.name.as_str())) {
        let here = root().join(&page.name).with_file_name("");
        let folder = tempfile::tempdir().unwrap();
        // Those of snapshots/ are held by the test of all scenes, and those beside a scene by the test above.
        let shown = page.targets().filter(|target| target.ends_with(".svg") && !target.contains("snapshots/"));
        let own: Vec<_> =
            shown.map(|target| here.join(target)).filter(|path| !path.with_extension("ron").exists()).collect();
        if own.is_empty() {
            continue;
        }
        run_page(page, folder.path()).unwrap_or_else(|error| panic!("{error}"));
        for path in own {
            let made = fs::read_to_string(folder.path().join(path.file_name().unwrap()));
            let made = made.unwrap_or_else(|_| panic!("{}: no command writes {}", page.name, path.display()));
            is_recorded(&path, &made);
        }
    }
}
