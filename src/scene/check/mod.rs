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
use crate::scene::problem::{Found, shortened};
use crate::scene::{Body, Limit, Limits, Problem, Scene, Source};

impl Scene {
    /// All problems of the scene that can be told without computing where its bodies meet; empty if it has none.
    ///
    /// They carry paths, and no places: a scene does not know its text. [`load`](crate::scene::load) checks by itself.
    #[must_use]
    pub fn validate(&self) -> Vec<Problem> {
        self.validate_within(&Limits::default())
    }

    /// [`validate`](Self::validate) within limits of one's own.
    #[must_use]
    pub fn validate_within(&self, limits: &Limits) -> Vec<Problem> {
        self.faults(limits, &|_| false).into_list()
    }

    /// All problems but for those at the paths that are `ignored`.
    pub(super) fn faults(&self, limits: &Limits, ignored: &dyn Fn(&str) -> bool) -> Found {
        let mut c = Checker::new(limits, ignored);
        c.words("title", &self.title);
        c.words("caption", &self.caption);
        check_medium(&mut c, "surroundings", &self.surroundings);
        check_bodies(&mut c, &self.bodies);
        let are_few = check_sources(&mut c, &self.sources);
        check_objects(&mut c, self);
        if are_few {
            check_wavelengths(&mut c, self);
        }
        check_trace(&mut c, &self.trace);
        check_diagram(&mut c, &self.diagram);
        c.at_most("notes", "a scene", "notes", self.notes.len() as u64, Limit::Notes);
        for (k, note) in self.notes.iter().enumerate() {
            c.point(format_args!("notes[{k}].at"), "a note's place", note.at);
            c.words(format_args!("notes[{k}].text"), &note.text);
        }
        c.found
    }
}

fn check_bodies(c: &mut Checker<'_>, bodies: &[Body]) {
    c.at_most("bodies", "a scene", "bodies", bodies.len() as u64, Limit::Bodies);
    if check_points(c, bodies) {
        for (k, body) in bodies.iter().enumerate() {
            check_body(c, format_args!("bodies[{k}]"), body);
        }
    }
    check_names(c, "body", "bodies", bodies.iter().map(|body| body.name.as_deref()));
}

/// The points of all outlines together, before any memory is taken for them.
fn check_points(c: &mut Checker<'_>, bodies: &[Body]) -> bool {
    let most = c.limits.of(Limit::Points);
    let mut total: u64 = 0;
    let over = bodies.iter().position(|body| {
        total = total.saturating_add(body.shape.curves());
        total > most
    });
    c.require(over.is_none(), || {
        let message =
            format!("the outlines have {total} points so far, sides and facets counted; at most {most} are allowed");
        let help = format!("use fewer points, arcs in place of facets, or fewer bodies; {}", Limit::Points.cure());
        Problem::error(format!("bodies[{}].shape", over.unwrap_or(0)), message, help).label("too many")
    })
}

/// Tells whether rays and lines are few enough to be gone through.
fn check_sources(c: &mut Checker<'_>, sources: &[Source]) -> bool {
    c.at_most("sources", "a scene", "sources", sources.len() as u64, Limit::Sources);
    for (k, source) in sources.iter().enumerate() {
        check_source(c, format_args!("sources[{k}]"), source);
    }
    check_names(c, "source", "sources", sources.iter().map(|source| source.name.as_deref()));
    check_ray_total(c, sources)
}

fn check_names<'a>(c: &mut Checker<'_>, what: &str, list: &str, names: impl Iterator<Item = Option<&'a str>>) {
    let mut seen: HashMap<&str, usize> = HashMap::new();
    for (k, name) in names.enumerate().filter_map(|(k, name)| Some((k, name?))) {
        let path = || format!("{list}[{k}].name");
        c.words(format_args!("{list}[{k}].name"), name);
        let sound = c.require(!name.trim().is_empty() && !name.starts_with('#'), || {
            let message = format!("a {what} cannot be named \"{}\"", shortened(name));
            let help = "write at least one letter, and no `#` in front: results use `#k` for what has no name";
            Problem::error(path(), message, help).label("not a name")
        });
        let first = *seen.entry(name).or_insert(k);
        c.require(first == k || !sound, || {
            let message = format!("the name \"{}\" is taken by {list}[{first}]", shortened(name));
            Problem::error(path(), message, format!("give every {what} a name of its own, or none"))
                .label("second time")
        });
    }
}
