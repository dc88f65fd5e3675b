//! Long work: what it tells, and how it ends early.

use std::fs;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::place::{Place, Run};

/// Hits that take longer than what interrupts them.
const HITS: u32 = 1_000_000;
/// As many as the scene asks for.
const SEGMENTS: &str = "segments=1000000000";
/// Longer than all that is waited for.
const PATIENCE: Duration = Duration::from_secs(120);

/// 1000 rays that cannot leave a disk, followed for so many hits each.
fn scene(hits: u32) -> String {
    format!(
        "(
            bodies: [(shape: Disk(20), medium: Index(1.5))],
            sources: [(light: Beam(center: (0, 17), direction: Angle(0), width: 2, rays: 1000))],
            trace: (max_depth: {hits}, max_segments: 1000000000),
        )"
    )
}

fn start(place: &Place, arguments: &[&str]) -> Child {
    let mut command = place.command(arguments);
    command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

/// Sends a signal, and waits until the process has ended.
fn end(mut child: Child, signal: &str) -> Run {
    let sent = Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    let since = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if since.elapsed() > PATIENCE {
            child.kill().unwrap();
        }
        sleep(Duration::from_millis(20));
    }
    Run(child.wait_with_output().unwrap())
}

#[test]
fn an_interrupt_ends_a_long_trace() {
    for (signal, file) in [("-INT", "old.json"), ("-TERM", "new.json")] {
        let place = Place::with(&[("a.ron", &scene(HITS)), ("old.json", "before")]);
        let child = start(&place, &["trace", "a.ron", "--limit", SEGMENTS, "--format", "summary", "-o", file]);
        sleep(Duration::from_secs(2));
        let run = end(child, signal).status(130);
        assert_eq!(run.stdout() + &run.stderr(), "", "no progress where there is no terminal");
        assert_eq!(place.files(), ["a.ron", "old.json"]);
        assert_eq!(fs::read_to_string(place.path("old.json")).unwrap(), "before");
    }
}

#[test]
fn an_interrupt_removes_what_is_half_written() {
    let place = Place::with(&[("a.ron", &scene(300)), ("a.json", "before")]);
    let child = start(&place, &["trace", "a.ron", "--limit", SEGMENTS, "-o", "a.json"]);
    let since = Instant::now();
    while place.files().len() < 3 {
        assert!(since.elapsed() < PATIENCE, "nothing is written");
        sleep(Duration::from_millis(1));
    }
    end(child, "-INT").status(130);
    assert_eq!(place.files(), ["a.json", "a.ron"]);
    assert_eq!(fs::read_to_string(place.path("a.json")).unwrap(), "before");
}

/// `script` lends a terminal, if there is one.
#[cfg(target_os = "linux")]
#[test]
fn progress_is_told_on_a_terminal_and_vanishes() {
    let place = Place::with(&[("long.ron", &scene(HITS)), ("short.ron", &scene(1))]);
    let run = |command: &str| {
        let line = format!("{command} --limit {SEGMENTS} --format summary -o a.json");
        let mut script = Command::new("script");
        script.args(["-qec", &line.replace("snellius", env!("CARGO_BIN_EXE_snellius")), "/dev/null"]);
        script.env("TERM", "xterm").current_dir(place.path("")).stdin(Stdio::null()).output().ok().map(Run)
    };
    let Some(long) = run("timeout --foreground --preserve-status -s INT 4 snellius trace long.ron") else { return };
    let told = long.status(130).stdout();
    assert!(told.contains("tracing, ") && told.contains(" segments so far, 2 s"), "{told:?}");
    assert!(told.ends_with("\r\u{1b}[2K"), "the line is cleared: {told:?}");
    assert_eq!(run("snellius trace short.ron").unwrap().status(0).stdout(), "");
    assert_eq!(place.files(), ["a.json", "long.ron", "short.ron"]);
}
