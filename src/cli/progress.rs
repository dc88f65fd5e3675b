//! The line on the terminal that tells what goes on. It appears where a job takes longer than a second, and vanishes with it.

use std::io::{self, IsTerminal};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard, Once, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use indicatif::{HumanCount, ProgressBar};

use super::interrupt;

/// A job that takes longer has a thread look after its line; starting that costs a short job too much.
const LONG: Duration = Duration::from_millis(100);
/// A job that takes longer has a line.
const SHOWN: Duration = Duration::from_secs(1);
/// From one look at the clock to the next.
const STRIDE: u64 = 16_384;

/// The line. Nothing else may be written to the terminal while it is there.
pub(super) struct Line {
    /// The phase of the job, and when the job began.
    doing: Option<(&'static str, Instant)>,
    bar: Option<ProgressBar>,
}

static LINE: Mutex<Line> = Mutex::new(Line { doing: None, bar: None });
/// Segments that this phase has traced.
static SEGMENTS: AtomicU64 = AtomicU64::new(0);

/// A phase begins of a job that goes on since some time.
pub(super) fn begin(phase: &'static str, since: Instant) {
    SEGMENTS.store(0, Ordering::Relaxed);
    lock().doing = Some((phase, since));
    attend();
}

/// So many more segments are traced.
pub(super) fn count(more: u64) {
    let before = SEGMENTS.fetch_add(more, Ordering::Relaxed);
    if before / STRIDE != (before + more) / STRIDE {
        attend();
    }
}

/// Makes room on the terminal until the next phase begins; none does while the result is held.
pub(super) fn clear() -> MutexGuard<'static, Line> {
    let mut line = lock();
    line.doing = None;
    if let Some(bar) = line.bar.take() {
        bar.finish_and_clear();
    }
    line
}

/// What takes long can be interrupted, and on a terminal tells what it does.
fn attend() {
    static ATTENDED: Once = Once::new();
    if ATTENDED.is_completed() || lock().doing.is_none_or(|(_, since)| since.elapsed() < LONG) {
        return;
    }
    ATTENDED.call_once(|| {
        interrupt::install();
        if io::stderr().is_terminal() {
            // Without a thread there is no line, and the job goes on.
            let _ = thread::Builder::new().spawn(|| {
                loop {
                    lock().tick();
                    thread::sleep(LONG);
                }
            });
        }
    });
}

impl Line {
    fn tick(&mut self) {
        let Some((phase, since)) = self.doing.filter(|(_, since)| since.elapsed() > SHOWN) else { return };
        let segments = match SEGMENTS.load(Ordering::Relaxed) {
            0 => String::new(),
            many => format!(", {} segments so far", HumanCount(many)),
        };
        let bar = self.bar.get_or_insert_with(ProgressBar::new_spinner);
        bar.set_message(format!("{phase}{segments}, {} s", since.elapsed().as_secs()));
        bar.tick();
    }
}

fn lock() -> MutexGuard<'static, Line> {
    LINE.lock().unwrap_or_else(PoisonError::into_inner)
}
