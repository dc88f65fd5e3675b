use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use super::console::{Fault, Mistake, legible, reason, tell};
use super::stats::Stopwatch;
use crate::analysis;
use crate::compile::{Compiled, compile_checked};
use crate::diagram;
use crate::scene::{self, Limit, Limits, Loaded, Places, Problem, Scene};
use crate::system::OpticalSystem;
use crate::trace::{RayTree, trace};

/// A scene read, checked and compiled.
pub(super) struct Ready {
    pub(super) scene: Scene,
    pub(super) system: OpticalSystem,
    /// What is suspicious without a look at its light.
    pub(super) warnings: Vec<Problem>,
    pub(super) text: String,
    places: Places,
}

/// Why there is no scene.
pub(super) enum Refusal {
    /// The file cannot be read.
    Unread(String),
    /// These are the problems of the scene, with its text.
    Problems(Vec<Problem>, String),
}

impl Ready {
    /// What is suspicious about where the light goes. Without its tree the light is followed once more, and only deviations, which
    /// name branches, need the tree for that.
    pub(super) fn light_warnings(&self, tree: Option<&RayTree>) -> Vec<Problem> {
        let traced = (tree.is_none() && !self.scene.diagram.deviations.is_empty()).then(|| trace(&self.system).tree);
        let tree = tree.or(traced.as_ref());
        let mut problems = analysis::problems(&self.scene, &self.system, tree);
        problems.extend(tree.into_iter().flat_map(|tree| diagram::problems(&self.scene, tree)));
        problems.iter_mut().for_each(|problem| self.places.locate(problem));
        problems
    }

    /// Shows what is suspicious about where the light of the scene at a path goes.
    pub(super) fn warn_of_light(&self, path: &Path, tree: Option<&RayTree>) {
        warn(&self.light_warnings(tree), &self.text, path);
    }
}

/// Shows problems that do not end the job.
pub(super) fn warn(problems: &[Problem], text: &str, path: &Path) {
    if !problems.is_empty() {
        tell(shown(problems, text, path));
    }
}

/// With an empty line behind: each problem takes several lines.
fn shown(problems: &[Problem], text: &str, path: &Path) -> String {
    format!("{}\n", scene::render_problems(problems, text, &plain_name(path)).trim_end())
}

impl Refusal {
    /// The fault of the scene at a path, every problem at once.
    pub(super) fn fault(&self, path: &Path) -> Fault {
        match self {
            Self::Unread(why) => Fault(format!("{}: {why}", name(path))),
            Self::Problems(problems, text) => Fault(shown(problems, text, path)),
        }
    }
}

/// Whether a path on the command line stands for standard input.
pub(super) fn is_stdin(path: &Path) -> bool {
    path == Path::new("-")
}

/// A path's name in messages.
pub(super) fn name(path: &Path) -> String {
    if is_stdin(path) { "<stdin>".into() } else { legible(path) }
}

/// A path's name as it is.
pub(super) fn plain_name(path: &Path) -> String {
    if is_stdin(path) { "<stdin>".into() } else { path.display().to_string() }
}

/// Refuses a list of scenes that names standard input twice: it can be read only once.
pub(super) fn refuse_two_stdins(scenes: &[PathBuf]) -> Result<(), Mistake> {
    match scenes.iter().filter(|scene| is_stdin(scene)).count() {
        0 | 1 => Ok(()),
        _ => Err(Mistake("standard input '-' can be read only once".into())),
    }
}

/// Reads a scene and makes it ready to trace. Shows its warnings; the fault holds every problem at once.
pub(super) fn prepare(path: &Path, limits: &Limits, watch: &mut Stopwatch) -> Result<Ready, Fault> {
    let ready = load(path, limits, watch).map_err(|refusal| refusal.fault(path))?;
    warn(&ready.warnings, &ready.text, path);
    Ok(ready)
}

/// Reads a scene and makes it ready to trace, and shows nothing.
pub(super) fn load(path: &Path, limits: &Limits, watch: &mut Stopwatch) -> Result<Ready, Refusal> {
    let text = read(path, limits.of(Limit::Bytes))?;
    watch.begin("loading");
    let Loaded { scene, places, mut warnings } = match scene::load_within(&text, limits) {
        Ok(loaded) => loaded,
        Err(problems) => return Err(Refusal::Problems(problems, text)),
    };
    watch.begin("compiling");
    let placed = |mut problem: Problem| {
        places.locate(&mut problem);
        problem
    };
    match compile_checked(&scene) {
        Ok(Compiled { system, warnings: more }) => {
            warnings.extend(more.into_iter().map(placed));
            Ok(Ready { scene, system, warnings, text, places })
        }
        Err(problem) => {
            warnings.push(placed(problem));
            Err(Refusal::Problems(warnings, text))
        }
    }
}

fn read(path: &Path, most: u64) -> Result<String, Refusal> {
    let mut bytes = Vec::new();
    // One byte more than a scene may have tells that there is too much, without reading all of it.
    let enough = most + 1;
    let read = if is_stdin(path) {
        io::stdin().lock().take(enough).read_to_end(&mut bytes)
    } else {
        File::open(path).and_then(|file| file.take(enough).read_to_end(&mut bytes))
    };
    match read {
        Err(error) => Err(Refusal::Unread(format!("cannot be read: {}", reason(&error)))),
        Ok(length) if length as u64 > most => Err(Refusal::Unread(format!(
            "this is too long for a scene: at most {most} bytes are read; {}",
            Limit::Bytes.cure()
        ))),
        Ok(_) => match scene::text_of(&bytes, "") {
            Ok(text) => Ok(text.to_owned()),
            Err(problems) => Err(Refusal::Problems(problems.list().to_vec(), problems.text().to_owned())),
        },
    }
}
