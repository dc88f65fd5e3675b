//! What a scene must fulfil beyond its form, the same for files and for scenes built in Rust.

mod body;
mod checker;
mod crossing;
mod lens;
mod light;
mod medium;
mod outline;
mod settings;

use std::collections::HashMap;

use self::body::check_body;
use self::checker::Checker;
use self::light::{check_ray_total, check_source};
use self::medium::{check_medium, check_wavelengths};
use self::settings::{check_diagram, check_trace};
use crate::scene::{MAX_BODIES, MAX_NOTES, Problem, Scene};

/// The numbers that entries have in their file, where some before them could not be read; empty if all could.
#[derive(Clone, Debug, Default)]
pub(super) struct Numbering {
    pub(super) bodies: Vec<usize>,
    pub(super) sources: Vec<usize>,
    pub(super) notes: Vec<usize>,
}

impl Numbering {
    pub(super) fn body(&self, k: usize) -> String {
        format!("bodies[{}]", self.bodies.get(k).unwrap_or(&k))
    }

    pub(super) fn source(&self, k: usize) -> String {
        format!("sources[{}]", self.sources.get(k).unwrap_or(&k))
    }

    fn note(&self, k: usize) -> String {
        format!("notes[{}]", self.notes.get(k).unwrap_or(&k))
    }
}

impl Scene {
    /// All problems of the scene that can be told without computing where its bodies meet; empty if it has none.
    ///
    /// They carry paths, and no places: a scene does not know its text. [`load`](crate::scene::load) checks by itself.
    #[must_use]
    pub fn validate(&self) -> Vec<Problem> {
        check_scene(self, &Numbering::default())
    }
}

/// All problems of a scene, by path.
pub(super) fn check_scene(scene: &Scene, numbering: &Numbering) -> Vec<Problem> {
    let mut c = Checker::default();
    check_medium(&mut c, "surroundings", &scene.surroundings);
    check_size(&mut c, "bodies", scene.bodies.len(), MAX_BODIES);
    for (k, body) in scene.bodies.iter().enumerate() {
        check_body(&mut c, &numbering.body(k), body);
    }
    for (k, source) in scene.sources.iter().enumerate() {
        check_source(&mut c, &numbering.source(k), source);
    }
    check_size(&mut c, "notes", scene.notes.len(), MAX_NOTES);
    for (k, note) in scene.notes.iter().enumerate() {
        c.point(&format!("{}.at", numbering.note(k)), "a note's place", note.at);
    }
    let bodies = scene.bodies.iter().enumerate().map(|(k, body)| (numbering.body(k), body.name.as_deref()));
    check_names(&mut c, "body", bodies);
    let sources = scene.sources.iter().enumerate().map(|(k, source)| (numbering.source(k), source.name.as_deref()));
    check_names(&mut c, "source", sources);
    check_ray_total(&mut c, scene, numbering);
    check_wavelengths(&mut c, scene, numbering);
    check_trace(&mut c, &scene.trace);
    check_diagram(&mut c, &scene.diagram);
    c.problems
}

fn check_size(c: &mut Checker, path: &str, size: usize, most: usize) {
    c.require(size <= most, || {
        let message = format!("the scene has {size} {path}; at most {most} are allowed");
        Problem::error(path, message, "split the scene into several files").label("too many")
    });
}

fn check_names<'a>(c: &mut Checker, what: &str, names: impl Iterator<Item = (String, Option<&'a str>)>) {
    let mut seen: HashMap<&str, String> = HashMap::new();
    for (owner, name) in names {
        let Some(name) = name else { continue };
        let path = format!("{owner}.name");
        let plain = c.require(!name.trim().is_empty() && !name.starts_with('#'), || {
            let message = format!("a {what} cannot be named \"{name}\"");
            let help = "write at least one letter, and no `#` in front: results use `#k` for what has no name";
            Problem::error(&path, message, help).label("not a name")
        });
        let first = seen.get(name);
        let unique = c.require(first.is_none() || !plain, || {
            let first = first.cloned().unwrap_or_default();
            let message = format!("the name \"{name}\" is taken by {first}");
            Problem::error(&path, message, format!("give every {what} a name of its own, or none")).label("second time")
        });
        if unique {
            seen.insert(name, owner);
        }
    }
}
