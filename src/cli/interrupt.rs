//! Ctrl-C, and a request to end: nothing half done stays behind.

use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, Once, PoisonError};
use std::{fs, io, process};

use tempfile::NamedTempFile;

use super::progress;

/// The exit status of what was interrupted, the same as a shell gives.
const STATUS: i32 = 130;

/// The file that is being written. It is held while one is made or moved to its place, and by who ends the process.
static UNFINISHED: Mutex<Option<PathBuf>> = Mutex::new(None);

/// From now on an interrupt removes what is half written and clears the line of progress. Before, the system ends the process,
/// and there is neither.
pub(super) fn install() {
    static INSTALLED: Once = Once::new();
    // Who has a signal ignored, as `nohup` does, keeps that: then there is no handler.
    INSTALLED.call_once(|| drop(ctrlc::try_set_handler(end)));
}

fn end() {
    let unfinished = lock();
    let _line = progress::clear();
    if let Some(path) = unfinished.as_deref() {
        let _ = fs::remove_file(path);
    }
    process::exit(STATUS);
}

/// Makes a file that an interrupt removes until it is complete.
pub(super) fn create(make: impl FnOnce() -> io::Result<NamedTempFile>) -> io::Result<NamedTempFile> {
    install();
    let mut unfinished = lock();
    let file = make()?;
    *unfinished = Some(file.path().into());
    Ok(file)
}

/// Moves a complete file to its place.
pub(super) fn complete(file: NamedTempFile, path: &Path) -> io::Result<()> {
    let mut unfinished = lock();
    file.persist(path).map_err(|failed| failed.error)?;
    *unfinished = None;
    Ok(())
}

fn lock() -> MutexGuard<'static, Option<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}
