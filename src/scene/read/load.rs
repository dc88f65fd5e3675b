use super::node::{Node, check_syntax, enables_extensions};
use super::reader::Reader;
use super::syntax::syntax_problem;
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
    let body = text.strip_prefix('\u{feff}').unwrap_or(text);
    let offset = text.len() - body.len();
    if body.len() as u64 > limits.of(Limit::Bytes) {
        return Err(vec![too_long(body.len(), limits.of(Limit::Bytes))]);
    }
    check_syntax(body).map_err(|error| vec![syntax_problem(body, offset, &error)])?;
    if enables_extensions(body) {
        return Err(vec![extension(offset)]);
    }
    let mut reader = Reader::new(*limits);
    let root = Node::root(body, offset);
    reader.place("", root.span());
    let scene: Scene = reader.read(&root);
    let mut found = std::mem::take(&mut reader.problems);
    if !found.is_full() {
        // What a stand-in gets wrong says nothing about the file.
        found.append(scene.faults(limits, &|path| reader.is_stand_in(path)));
    }
    let mut problems = found.into_list();
    problems.iter_mut().for_each(|problem| locate(problem, &reader.places, text));
    problems.sort_by_key(|problem| (problem.more > 0, problem.span.as_ref().map(|span| span.start)));
    if problems.iter().any(|problem| problem.severity == Severity::Error) {
        return Err(problems);
    }
    Ok(Loaded { scene, places: reader.places, warnings: problems })
}

/// The text of a scene file's bytes, for [`load`].
///
/// # Errors
/// The bytes are not UTF-8; the problem shows the place of the first fault under the file's name.
pub fn text_of<'a>(bytes: &'a [u8], file: &str) -> Result<&'a str, Problems> {
    std::str::from_utf8(bytes).map_err(|error| {
        let help = "save the file as UTF-8, which every editor offers";
        let problem = Problem::error("", "the file is not text in UTF-8", help).label("not a character");
        let start = error.valid_up_to();
        let shown = bytes.get(..bytes.len().min(start + 300)).unwrap_or(bytes);
        let text = String::from_utf8_lossy(shown).into_owned();
        Problems::new(vec![problem.at(start..start + char::REPLACEMENT_CHARACTER.len_utf8())], text, file)
    })
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

fn extension(offset: usize) -> Problem {
    let message = "the first line turns on an extension that scenes do not use";
    Problem::error("", message, "leave the line out; only `implicit_some` is on, and it always is")
        .at(offset..offset + 1)
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
