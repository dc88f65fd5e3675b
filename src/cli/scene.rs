use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use super::console::{Fault, Mistake, legible, reason, tell};
use super::stats::Stopwatch;
use crate::compile::{Compiled, compile_checked};
use crate::scene::{self, Loaded, MAX_TEXT_BYTES, Places, Problem, Scene};
use crate::system::OpticalSystem;

/// A scene read, checked and compiled.
pub(super) struct Ready {
    pub(super) scene: Scene,
    pub(super) system: OpticalSystem,
    /// Number of warnings shown.
    pub(super) warnings: usize,
    file: String,
    text: String,
    places: Places,
}

impl Ready {
    /// Shows warnings that came up later.
    pub(super) fn warn(&self, mut problems: Vec<Problem>) {
        if !problems.is_empty() {
            problems.iter_mut().for_each(|problem| self.places.locate(problem));
            tell(shown(&problems, &self.text, &self.file));
        }
    }
}

/// With an empty line behind: each problem takes several lines.
fn shown(problems: &[Problem], text: &str, file: &str) -> String {
    format!("{}\n", scene::render_problems(problems, text, file).trim_end())
}

/// Whether a path on the command line stands for standard input.
pub(super) fn is_stdin(path: &Path) -> bool {
    path == Path::new("-")
}

/// A path's name in messages.
pub(super) fn name(path: &Path) -> String {
    if is_stdin(path) { "<stdin>".into() } else { legible(path) }
}

/// Refuses a list of scenes that names standard input twice: it can be read only once.
pub(super) fn refuse_two_stdins(scenes: &[PathBuf]) -> Result<(), Mistake> {
    match scenes.iter().filter(|scene| is_stdin(scene)).count() {
        0 | 1 => Ok(()),
        _ => Err(Mistake("standard input '-' can be read only once".into())),
    }
}

/// Reads a scene and makes it ready to trace. Shows its warnings; the fault holds every problem at once.
pub(super) fn prepare(path: &Path, watch: &mut Stopwatch) -> Result<Ready, Fault> {
    let file = name(path);
    let text = read(path, &file)?;
    watch.begin("loading");
    let shown = |problems: &[Problem]| shown(problems, &text, &file);
    let Loaded { scene, places, mut warnings } = scene::load(&text).map_err(|problems| Fault(shown(&problems)))?;
    watch.begin("compiling");
    let placed = |mut problem: Problem| {
        places.locate(&mut problem);
        problem
    };
    let Compiled { system, warnings: more } = compile_checked(&scene).map_err(|problem| {
        let all = warnings.iter().cloned().chain([problem]).map(placed);
        Fault(shown(&all.collect::<Vec<_>>()))
    })?;
    warnings.extend(more.into_iter().map(placed));
    if !warnings.is_empty() {
        tell(shown(&warnings));
    }
    Ok(Ready { scene, system, warnings: warnings.len(), file, text, places })
}

fn read(path: &Path, file: &str) -> Result<String, Fault> {
    let mut bytes = Vec::new();
    // One byte more than a scene may have tells that there is too much, without reading all of it.
    let most = MAX_TEXT_BYTES as u64 + 1;
    let read = if is_stdin(path) {
        io::stdin().lock().take(most).read_to_end(&mut bytes)
    } else {
        File::open(path).and_then(|file| file.take(most).read_to_end(&mut bytes))
    };
    match read {
        Err(error) => Err(Fault(format!("{file}: cannot be read: {}", reason(&error)))),
        Ok(length) if length > MAX_TEXT_BYTES => {
            Err(Fault(format!("{file}: this is too long for a scene: at most {MAX_TEXT_BYTES} bytes are read")))
        }
        Ok(_) => match scene::text_of(&bytes, file) {
            Ok(text) => Ok(text.to_owned()),
            Err(problems) => Err(Fault(format!("{}\n", problems.to_string().trim_end()))),
        },
    }
}
