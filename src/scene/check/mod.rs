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
use self::light::{check_objects, check_ray_total, check_source};
use self::medium::{check_medium, check_wavelengths};
use self::settings::{check_diagram, check_trace};
use crate::scene::{Body, MAX_BODIES, MAX_NOTES, Problem, Scene, Source};

impl Scene {
    /// All problems of the scene that can be told without computing where its bodies meet; empty if it has none.
    ///
    /// They carry paths, and no places: a scene does not know its text. [`load`](crate::scene::load) checks by itself.
    #[must_use]
    pub fn validate(&self) -> Vec<Problem> {
        let mut c = Checker::default();
        check_medium(&mut c, "surroundings", &self.surroundings);
        check_bodies(&mut c, &self.bodies);
        check_sources(&mut c, &self.sources);
        check_objects(&mut c, self);
        check_wavelengths(&mut c, self);
        check_trace(&mut c, &self.trace);
        check_diagram(&mut c, &self.diagram);
        c.size("notes", "a scene", "notes", self.notes.len(), [0, MAX_NOTES]);
        for (k, note) in self.notes.iter().enumerate() {
            c.point(format_args!("notes[{k}].at"), "a note's place", note.at);
        }
        c.problems
    }
}

fn check_bodies(c: &mut Checker, bodies: &[Body]) {
    c.size("bodies", "a scene", "bodies", bodies.len(), [0, MAX_BODIES]);
    for (k, body) in bodies.iter().enumerate() {
        check_body(c, format_args!("bodies[{k}]"), body);
    }
    check_names(c, "body", "bodies", bodies.iter().map(|body| body.name.as_deref()));
}

fn check_sources(c: &mut Checker, sources: &[Source]) {
    for (k, source) in sources.iter().enumerate() {
        check_source(c, format_args!("sources[{k}]"), source);
    }
    check_names(c, "source", "sources", sources.iter().map(|source| source.name.as_deref()));
    check_ray_total(c, sources);
}

fn check_names<'a>(c: &mut Checker, what: &str, list: &str, names: impl Iterator<Item = Option<&'a str>>) {
    let mut seen: HashMap<&str, usize> = HashMap::new();
    for (k, name) in names.enumerate().filter_map(|(k, name)| Some((k, name?))) {
        let path = || format!("{list}[{k}].name");
        let sound = c.require(!name.trim().is_empty() && !name.starts_with('#'), || {
            let message = format!("a {what} cannot be named \"{name}\"");
            let help = "write at least one letter, and no `#` in front: results use `#k` for what has no name";
            Problem::error(path(), message, help).label("not a name")
        });
        let first = *seen.entry(name).or_insert(k);
        c.require(first == k || !sound, || {
            let message = format!("the name \"{name}\" is taken by {list}[{first}]");
            Problem::error(path(), message, format!("give every {what} a name of its own, or none"))
                .label("second time")
        });
    }
}
