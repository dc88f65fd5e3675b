//! Long work: what it tells, and how it ends early.

use std::fs;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::place::{Place, Run, skipped};

/// Hits that take longer than what interrupts them.
const HITS: u32 = 1_000_000;
/// Longer than all that is waited for.
pub(crate) const PATIENCE: Duration = Duration::from_secs(120);

/// 1000 rays that cannot leave a disk, followed for so many hits each.
pub(crate) fn scene(hits: u32) -> String {
    format!(
        "(
            bodies: [(shape: Disk(20), medium: Index(1.5))],
            sources: [(light: Beam(center: (0, 17), direction: Angle(0), width: 2, rays: 1000))],
            trace: (max_depth: {hits}, max_segments: 1000000000),
        )"
    )
}

fn start(place: &Place, arguments: &[&str]) -> Child {
    as_if_started_by_hand(&place.command(arguments)).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

/// The same command with no signal ignored, although these tests may themselves run with some ignored, as under `nohup`.
fn as_if_started_by_hand(command: &Command) -> Command {
    with_signals("--default-signal=INT,TERM,HUP", command)
}

/// The same command with signals set by the `env` of GNU; a system without it runs the command as it is.
fn with_signals(setting: &str, command: &Command) -> Command {
    if !Command::new("env").args([setting, "true"]).output().is_ok_and(|run| run.status.success()) {
        skipped(setting, "env cannot set signals here");
        let mut same = Command::new(command.get_program());
        same.args(command.get_args()).current_dir(command.get_current_dir().unwrap()).stdin(Stdio::null());
        return same;
    }
    let mut env = Command::new("env");
    env.arg(setting).arg(command.get_program()).args(command.get_args());
    env.current_dir(command.get_current_dir().unwrap()).stdin(Stdio::null());
    env
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
        let child = start(&place, &["trace", "a.ron", "--format", "summary", "-o", file]);
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
    for signal in ["-INT", "-TERM", "-HUP"] {
        let child = start(&place, &["trace", "a.ron", "-o", "a.json"]);
        await_writing(&place);
        end(child, signal).status(130);
        assert_eq!(place.files(), ["a.json", "a.ron"]);
        assert_eq!(fs::read_to_string(place.path("a.json")).unwrap(), "before");
    }
}

fn await_writing(place: &Place) {
    let since = Instant::now();
    while place.files().len() < 3 {
        assert!(since.elapsed() < PATIENCE, "nothing is written");
        sleep(Duration::from_millis(1));
    }
}

/// `nohup` has SIGHUP ignored, a shell SIGINT for what it runs in the background: that stays so, and the other signals end it in order.
#[cfg(target_os = "linux")]
#[test]
fn an_ignored_signal_stays_ignored_and_the_others_leave_nothing_behind() {
    let place = Place::with(&[("a.ron", &scene(300)), ("a.json", "before")]);
    for (ignored, signals) in [("INT", ["-INT", "-TERM"]), ("HUP", ["-HUP", "-INT"]), ("INT,HUP", ["-HUP", "-TERM"])] {
        let command = place.command(&["trace", "a.ron", "-o", "a.json"]);
        let mut command = as_if_started_by_hand(&with_signals(&format!("--ignore-signal={ignored}"), &command));
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        await_writing(&place);
        let sent = Command::new("kill").args([signals[0], &child.id().to_string()]).status().unwrap();
        assert!(sent.success());
        sleep(Duration::from_millis(100));
        assert!(child.try_wait().unwrap().is_none(), "{} is ignored", signals[0]);
        end(child, signals[1]).status(130);
        assert_eq!(place.files(), ["a.json", "a.ron"], "{ignored} ignored");
        assert_eq!(fs::read_to_string(place.path("a.json")).unwrap(), "before");
    }
}

/// `script` lends a terminal, if there is one.
#[cfg(target_os = "linux")]
#[test]
fn progress_is_told_on_a_terminal_and_vanishes() {
    let place = Place::with(&[("long.ron", &scene(HITS)), ("short.ron", &scene(1))]);
    let run = |command: &str| {
        let line = format!("{command} --format summary -o a.json");
        let mut script = Command::new("script");
        script.args(["-qec", &line.replace("snellius", env!("CARGO_BIN_EXE_snellius")), "/dev/null"]);
        as_if_started_by_hand(script.current_dir(place.path(""))).env("TERM", "xterm").output().ok().map(Run)
    };
    if Command::new("script").arg("--version").output().is_err() {
        return skipped("progress on a terminal", "there is no command 'script' to lend one");
    }
    let long = run("timeout --foreground --preserve-status -s INT 4 snellius trace long.ron").unwrap();
    let told = long.status(130).stdout();
    assert!(told.contains("tracing, ") && told.contains(" segments so far, 2 s"), "{told:?}");
    assert!(told.ends_with("\r\u{1b}[2K"), "the line is cleared: {told:?}");
    assert_eq!(run("snellius trace short.ron").unwrap().status(0).stdout(), "");
    assert_eq!(place.files(), ["a.json", "long.ron", "short.ron"]);
}
