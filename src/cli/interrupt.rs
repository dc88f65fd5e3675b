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
    INSTALLED.call_once(|| {
        let _installed = ctrlc::try_set_handler(end);
        // Who has a signal ignored, as `nohup` does, keeps that: then there is no handler, also for the other signals.
        #[cfg(unix)]
        if _installed.is_err() {
            handle_others();
        }
    });
}

/// Handles those of the signals that are not ignored.
#[cfg(unix)]
fn handle_others() {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    let handled =
        [SIGHUP, SIGINT, SIGTERM].into_iter().filter(|signal| !is_ignored(*signal).unwrap_or(*signal != SIGTERM));
    if let Ok(mut signals) = signal_hook::iterator::Signals::new(handled) {
        let _ = std::thread::Builder::new().spawn(move || signals.forever().next().map(|_| end()));
    }
}

/// Whether a signal is ignored, where the system tells: see proc(5).
#[cfg(unix)]
fn is_ignored(signal: i32) -> Option<bool> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"))?;
    Some(u64::from_str_radix(mask.trim(), 16).ok()? >> (signal - 1) & 1 == 1)
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
