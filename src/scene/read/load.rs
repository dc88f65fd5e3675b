use std::borrow::Cow;

use super::foreign::other_language;
use super::node::{Node, check_syntax, enables_extensions};
use super::reader::Reader;
use super::syntax::syntax_problem;
use crate::scene::places::parent;
use crate::scene::{Limit, Limits, Places, Problem, Problems, Scene, Severity};

/// A scene that was read from text, free of errors.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Loaded {
    /// The scene.
    pub scene: Scene,
    /// Where its values stand in the text.
    pub places: Places,
    /// What is suspicious but allowed, each with its place.
    pub warnings: Vec<Problem>,
}

/// Reads a scene from the text of its file, within the usual [`Limits`].
///
/// A byte order mark at the beginning is passed over; spans count it.
///
/// # Errors
/// All problems of the scene, in the order of the text, at least one of them an error. Where the text cannot be parsed, the one
/// place where parsing stopped. Of more than 1000 problems, the rest is only counted, and what depends on others is not checked.
pub fn load(text: &str) -> Result<Loaded, Vec<Problem>> {
    load_within(text, &Limits::default())
}

/// [`load`] within limits of one's own.
///
/// # Errors
/// As those of [`load`].
pub fn load_within(text: &str, limits: &Limits) -> Result<Loaded, Vec<Problem>> {
    let text = &*with_known_line_ends(text);
    let body = text.strip_prefix('\u{feff}').unwrap_or(text);
    let offset = text.len() - body.len();
    if body.len() as u64 > limits.of(Limit::Bytes) {
        return Err(vec![too_long(body.len(), limits.of(Limit::Bytes))]);
    }
    if let Some(problem) = other_language(body, offset) {
        return Err(vec![problem]);
    }
    check_syntax(body).map_err(|error| vec![syntax_problem(body, offset, &error)])?;
    if enables_extensions(body) {
        return Err(vec![extension(body, offset)]);
    }
    let mut reader = Reader::new(*limits);
    let root = Node::root(body, offset);
    reader.place("", root.span());
    let scene: Scene = reader.read(&root);
    let mut found = std::mem::take(&mut reader.problems);
    if !found.is_full() {
        found.append(scene.faults(limits, &|path| says_nothing(&reader, path)));
    }
    let mut problems = found.into_list();
    problems.iter_mut().for_each(|problem| locate(problem, &reader.places, text));
    problems.sort_by_key(|problem| (problem.more > 0, problem.span.as_ref().map(|span| span.start)));
    if problems.iter().any(|problem| problem.severity == Severity::Error) {
        return Err(problems);
    }
    Ok(Loaded { scene, places: reader.places, warnings: problems })
}

/// The text with `\n` for every `\r` that ends a line alone, which ends no comment in RON. All bytes keep their places.
fn with_known_line_ends(text: &str) -> Cow<'_, str> {
    let is_alone = |at: usize| text.as_bytes().get(at + 1) != Some(&b'\n');
    let alone: Vec<usize> = text.match_indices('\r').map(|(at, _)| at).filter(|at| is_alone(*at)).collect();
    if alone.is_empty() {
        return Cow::Borrowed(text);
    }
    let mut bytes = text.as_bytes().to_vec();
    alone.into_iter().for_each(|at| bytes[at] = b'\n');
    String::from_utf8(bytes).map_or(Cow::Borrowed(text), Cow::Owned)
}

/// Whether what is wrong at a path is that of a stand-in, which says nothing about the file.
fn says_nothing(reader: &Reader, path: &str) -> bool {
    // A formula is at fault as a whole, its coefficients one by one.
    let is_formula = path.ends_with(".b") || path.ends_with(".coefficients");
    let around = if is_formula { parent(path) } else { None };
    reader.is_stand_in(path) || around.is_some_and(|medium| reader.has_stand_in(medium))
}

impl Scene {
    /// Reads a scene from text in the format of scene files.
    ///
    /// # Errors
    /// All problems of the scene; they display as the `snellius` command shows them.
    pub fn from_ron(text: &str) -> Result<Self, Problems> {
        load(text).map(|loaded| loaded.scene).map_err(|list| Problems::new(list, text, "scene"))
    }
}

fn extension(body: &str, offset: usize) -> Problem {
    let message = "the first line turns on an extension that scenes do not use";
    let start = body.find('#').unwrap_or(0);
    let end = body[start..].find(']').map_or(start + 1, |at| start + at + 1);
    Problem::error("", message, "leave the line out; only `implicit_some` is on, and it always is")
        .label("not needed")
        .at(offset + start..offset + end)
}

fn too_long(bytes: usize, most: u64) -> Problem {
    let message = format!("the text is {bytes} bytes long; at most {most} are read");
    let help = "split the scene, or give curved outlines as arcs instead of many points";
    Problem::error("", message, format!("{help}; {}", Limit::Bytes.cure())).at(0..0)
}

/// Points of long lists are not recorded one by one; here the one at fault is looked up.
fn locate(problem: &mut Problem, places: &Places, text: &str) {
    if problem.span.is_none() {
        problem.span = node_at(&problem.path, places, text).map(|node| node.span());
    }
    places.locate(problem);
}

fn node_at<'a>(path: &str, places: &Places, text: &'a str) -> Option<Node<'a>> {
    if let Some(span) = places.exact(path) {
        return Node::at(text, span, path);
    }
    let (list, index) = path.strip_suffix(']')?.rsplit_once('[')?;
    let list = node_at(list, places, text)?;
    let index = index.parse().ok()?;
    match list.list() {
        Some(mut elements) => elements.nth(index),
        None => list.group()?.nth(index),
    }
}
