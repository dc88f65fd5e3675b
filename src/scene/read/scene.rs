use glam::DVec2;

use super::node::Node;
use super::reader::{Read, Reader};
use crate::scene::{Body, DiagramSettings, Limit, Medium, Note, Scene, Source, TraceSettings};

const FIELDS: [&str; 8] = ["title", "caption", "surroundings", "bodies", "sources", "trace", "diagram", "notes"];

impl Read for Scene {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let f = r.fields(node, "a scene", &FIELDS, "(bodies: […], sources: […])")?;
        Some(Self {
            title: f.or(r, "title", String::new()),
            caption: f.or(r, "caption", String::new()),
            surroundings: f.or(r, "surroundings", Medium::Index(1.0)),
            bodies: f.or(r, "bodies", Vec::new()),
            sources: f.or(r, "sources", Vec::new()),
            trace: f.or(r, "trace", TraceSettings::default()),
            diagram: f.or(r, "diagram", DiagramSettings::default()),
            notes: f.or(r, "notes", Vec::new()),
        })
    }

    fn stand_in() -> Self {
        Self::default()
    }
}

impl Read for Vec<Body> {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        r.each(node, "bodies", Limit::Bodies)
    }

    fn stand_in() -> Self {
        Self::new()
    }
}

impl Read for Vec<Source> {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        r.each(node, "sources", Limit::Sources)
    }

    fn stand_in() -> Self {
        Self::new()
    }
}

impl Read for Vec<Note> {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        r.each(node, "notes", Limit::Notes)
    }

    fn stand_in() -> Self {
        Self::new()
    }
}

impl Read for Note {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let f = r.fields(node, "a note", &["at", "text"], "(at: (10, 40), text: \"eye\")")?;
        Some(Self { at: f.required(r, "at"), text: f.required(r, "text") })
    }

    fn stand_in() -> Self {
        Self { at: DVec2::NAN, text: String::new() }
    }
}
