use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use super::console::{Fault, Mistake, reason, tell};
use super::stats::Stopwatch;
use crate::compile::compile;
use crate::scene::{self, Problem, Scene};
use crate::system::OpticalSystem;

/// A scene read, checked and compiled.
pub(super) struct Ready {
    pub(super) scene: Scene,
    pub(super) system: OpticalSystem,
    /// Number of warnings shown.
    pub(super) warnings: usize,
}

/// Whether a path on the command line stands for standard input.
pub(super) fn is_stdin(path: &Path) -> bool {
    path == Path::new("-")
}

/// A path's name in messages.
pub(super) fn name(path: &Path) -> String {
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
pub(super) fn prepare(path: &Path, watch: &mut Stopwatch) -> Result<Ready, Fault> {
    let file = name(path);
    let text = read(path, &file)?;
    let shown = |problems: &[Problem]| Fault(scene::render_problems(problems, &text, &file).trim_end().into());
    watch.lap("read");
    let loaded = scene::load(&text).map_err(|problems| shown(&problems))?;
    watch.lap("load");
    let place = |mut problems: Vec<Problem>| {
        problems.iter_mut().for_each(|problem| loaded.places.locate(problem));
        problems
    };
    let compiled = compile(&loaded.scene).map_err(|problems| shown(&place(problems)))?;
    watch.lap("compile");
    let warnings = place(compiled.warnings);
    if !warnings.is_empty() {
        tell(shown(&warnings).0);
    }
    Ok(Ready { scene: loaded.scene, system: compiled.system, warnings: warnings.len() })
}

fn read(path: &Path, file: &str) -> Result<String, Fault> {
    let fault = |error: io::Error| Fault(format!("{file}: cannot be read: {}", reason(&error)));
    let bytes = if is_stdin(path) {
        let mut bytes = Vec::new();
        io::stdin().lock().read_to_end(&mut bytes).map_err(fault)?;
        bytes
    } else {
        fs::read(path).map_err(fault)?
    };
    decode(bytes, file)
}

/// The text of a scene, without the mark that some editors put before it.
fn decode(bytes: Vec<u8>, file: &str) -> Result<String, Fault> {
    let text = String::from_utf8(bytes).map_err(|error| {
        let good = String::from_utf8_lossy(&error.as_bytes()[..error.utf8_error().valid_up_to()]);
        let line = good.matches('\n').count() + 1;
        let column = good.rsplit('\n').next().unwrap_or_default().chars().count() + 1;
        Fault(format!("{file}:{line}:{column}: this is not UTF-8 text: save the scene in the encoding UTF-8"))
    })?;
    Ok(text.strip_prefix('\u{feff}').map_or(text.clone(), str::to_owned))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_byte_that_is_no_text_is_placed() {
        let Fault(message) = decode(b"(\n  title: \"\xff\")".to_vec(), "a.ron").unwrap_err();
        assert!(message.starts_with("a.ron:2:11: "), "{message}");
    }

    #[test]
    fn the_mark_of_some_editors_is_dropped() {
        assert_eq!(decode("\u{feff}()".into(), "a.ron").unwrap(), "()");
    }
}
