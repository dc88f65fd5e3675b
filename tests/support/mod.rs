//! What several tests need: scene files found, loaded and traced.
#![allow(dead_code, unreachable_pub, clippy::unwrap_used, reason = "each test uses a part, and a test may fail")]

pub mod figures;
pub mod gallery;
pub mod hostile;
pub mod random;
pub mod recorded;
pub mod tables;
pub mod wide;

use std::fs;
use std::path::{Path, PathBuf};

use snellius::compile::compile;
use snellius::trace::{Trace, TracedRay, trace};
use snellius::{OpticalSystem, Scene};

/// A scene with all that comes of it.
pub struct Run {
    pub scene: Scene,
    pub system: OpticalSystem,
    pub trace: Trace,
}

/// Every scene file, as `chapter/name`, sorted.
pub fn scene_names() -> Vec<String> {
    let root = root().join("scenes");
    let mut names: Vec<_> = files(&root, "ron").iter().map(|path| name_under(&root, path)).collect();
    names.sort();
    names
}

/// Loads, compiles and traces `scenes/NAME.ron`.
pub fn run(name: &str) -> Run {
    let path = root().join("scenes").join(format!("{name}.ron"));
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    run_text(&text)
}

/// Loads, compiles and traces a scene from its text.
pub fn run_text(text: &str) -> Run {
    run_scene(Scene::from_ron(text).unwrap_or_else(|problems| panic!("{problems}")))
}

/// Compiles and traces a scene.
pub fn run_scene(scene: Scene) -> Run {
    let system = compile(&scene).unwrap_or_else(|problems| panic!("{problems}")).system;
    let trace = trace(&system);
    Run { scene, system, trace }
}

/// The project's folder.
pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// Every file below a folder with this extension.
pub fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    all_files(folder).into_iter().filter(|path| path.extension().is_some_and(|found| found == extension)).collect()
}

/// Every file below a folder.
pub fn all_files(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let paths = entries.map(|entry| entry.unwrap().path());
    paths.flat_map(|path| if path.is_dir() { all_files(&path) } else { vec![path] }).collect()
}

/// A file's name below a folder, without extension, with `/` between the parts.
pub fn name_under(folder: &Path, path: &Path) -> String {
    path_under(folder, &path.with_extension(""))
}

/// A file's path below a folder, with `/` between the parts.
pub fn path_under(folder: &Path, path: &Path) -> String {
    let below = path.strip_prefix(folder).unwrap();
    below.iter().map(|part| part.to_str().unwrap()).collect::<Vec<_>>().join("/")
}

/// The segment with this path (letters t, r, i) of a ray.
pub fn segment<'a>(ray: &'a TracedRay, path: &str) -> &'a snellius::trace::Segment {
    let has_path = |segment: &&snellius::trace::Segment| ray.address(segment.id).rsplit(':').next() == Some(path);
    ray.segments.iter().find(has_path).unwrap_or_else(|| panic!("no branch {path:?} in ray {}", ray.name()))
}
