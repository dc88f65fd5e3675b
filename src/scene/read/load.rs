use super::node::{Node, check_syntax};
use super::reader::Reader;
use super::scene::scene;
use super::syntax::syntax_problem;
use crate::scene::check::check_scene;
use crate::scene::{MAX_TEXT_BYTES, Places, Problem, Problems, Scene, Severity};

/// A scene that was read from text, free of errors.
#[derive(Clone, Debug, PartialEq)]
pub struct Loaded {
    /// The scene.
    pub scene: Scene,
    /// Where its values stand in the text.
    pub places: Places,
    /// What is suspicious but allowed, each with its place.
    pub warnings: Vec<Problem>,
}

/// Reads a scene from the text of its file.
///
/// A byte order mark at the beginning is passed over; spans count it.
///
/// # Errors
/// All problems of the scene, in the order of the text, at least one of them an error. Where the text cannot be parsed, the one
/// place where parsing stopped.
pub fn load(text: &str) -> Result<Loaded, Vec<Problem>> {
    let body = text.strip_prefix('\u{feff}').unwrap_or(text);
    let offset = text.len() - body.len();
    if body.len() > MAX_TEXT_BYTES {
        return Err(vec![too_long(body.len())]);
    }
    check_syntax(body).map_err(|error| vec![syntax_problem(body, offset, &error)])?;
    let mut reader = Reader::default();
    let read = scene(&mut reader, &Node::root(body, offset));
    let Reader { mut problems, places } = reader;
    if let Some((scene, numbering)) = &read {
        problems.extend(check_scene(scene, numbering));
    }
    problems.iter_mut().for_each(|problem| locate(problem, &places, text));
    problems.sort_by_key(|problem| problem.span.as_ref().map(|span| span.start));
    match read {
        Some((scene, _)) if problems.iter().all(|problem| problem.severity == Severity::Warning) => {
            Ok(Loaded { scene, places, warnings: problems })
        }
        _ => Err(problems),
    }
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

fn too_long(bytes: usize) -> Problem {
    let message = format!("the text is {bytes} bytes long; at most {MAX_TEXT_BYTES} are read");
    Problem::error("", message, "split the scene, or give curved outlines as arcs instead of many points").at(0..0)
}

/// Points of long lists are not recorded one by one; here the one at fault is looked up.
fn locate(problem: &mut Problem, places: &Places, text: &str) {
    if problem.span.is_none() && places.exact(&problem.path).is_none() {
        problem.span = element(&problem.path, places, text);
    }
    places.locate(problem);
}

fn element(path: &str, places: &Places, text: &str) -> Option<std::ops::Range<usize>> {
    let (list, index) = path.strip_suffix(']')?.rsplit_once('[')?;
    let index: usize = index.parse().ok()?;
    let list = Node::at(text, places.exact(list)?, list)?;
    list.list()?.get(index).map(Node::span)
}
