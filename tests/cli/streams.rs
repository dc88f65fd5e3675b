//! Standard streams that are closed, or close in the middle.

use std::fs;
use std::io::Read;
use std::process::{Command, Stdio};

use crate::interrupt::scene;
use crate::place::{Place, Run, SCENE, assert_svg};

/// Runs with redirections of the shell.
fn redirected(place: &Place, arguments: &[&str], redirections: &str) -> Run {
    let mut shell = Command::new("sh");
    shell.args(["-c", &format!("exec \"$0\" \"$@\" {redirections}"), env!("CARGO_BIN_EXE_snellius")]).args(arguments);
    Run(shell.current_dir(place.path("")).output().unwrap())
}

#[test]
fn a_pipe_that_closes_in_the_middle_ends_quietly() {
    let place = Place::with(&[("a.ron", &scene(3))]);
    for arguments in [
        &["trace", "a.ron"][..],
        &["trace", "a.ron", "--format", "json"],
        &["trace", "a.ron", "--format", "csv"],
        &["explain", "a.ron", "--format", "latex"],
        &["render", "a.ron", "-o", "-"],
        &["render", "a.ron", "-o", "-", "--format", "png", "--scale", "4"],
    ] {
        for wanted in [0, 1, 100] {
            let (mut reader, writer) = std::io::pipe().unwrap();
            let mut command = place.command(arguments);
            let child = command.stdout(writer).stderr(Stdio::piped()).spawn().unwrap();
            // The command holds the other end of the pipe.
            drop(command);
            reader.read_exact(&mut vec![0; wanted]).unwrap();
            drop(reader);
            let run = Run(child.wait_with_output().unwrap());
            assert_eq!(run.status(0).stderr(), "", "{arguments:?} after {wanted} bytes");
        }
    }
    let whole = place.run(&["trace", "a.ron", "--format", "csv"]).clean();
    assert!(whole.len() > 100 * 1024, "more than a pipe holds: {}", whole.len());
}

/// Files go on being written where nobody reads their names.
#[test]
fn a_pipe_for_paths_that_closes_stops_no_picture() {
    let place = Place::with(&[("a.ron", SCENE), ("b.ron", SCENE)]);
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    Run(place.command(&["render", "a.ron", "b.ron"]).stdout(writer).output().unwrap()).clean();
    ["a.svg", "b.svg"].iter().for_each(|name| assert_svg(&place.path(name)));
}

#[test]
fn closed_streams_put_nothing_into_files() {
    let place = Place::with(&[("a.ron", SCENE), ("bad.ron", "(")]);
    place.run(&["render", "a.ron", "-o", "whole.svg"]).clean();
    let whole = fs::read(place.path("whole.svg")).unwrap();
    for closed in [">&-", "<&-", "2>&-", ">&- 2>&-", "<&- >&- 2>&-"] {
        redirected(&place, &["render", "a.ron", "-o", "x.svg"], closed).status(0);
        assert_eq!(fs::read(place.path("x.svg")).unwrap(), whole, "{closed}");
        fs::remove_file(place.path("x.svg")).unwrap();
        redirected(&place, &["render", "bad.ron", "-o", "x.svg"], closed).status(1);
        redirected(&place, &["rendr"], closed).status(2);
        assert_eq!(place.files(), ["a.ron", "bad.ron", "whole.svg"], "{closed}");
    }
    // Whoever closes standard output wants no result.
    assert_eq!(redirected(&place, &["trace", "a.ron"], ">&-").clean(), "");
    let run = redirected(&place, &["check", "-"], "<&-").status(1);
    assert!(run.stderr().starts_with("<stdin>"), "an empty scene: {}", run.stderr());
}

/// Characters that a terminal would obey do not reach it, from wherever they come.
#[test]
fn nothing_steers_the_terminal() {
    let hostile = r#"(
        title: "\u{1b}]0;title\u{7} \u{9b}31m red \u{202e}desrever",
        bodies: [(name: "\u{1b}[2J\rglass\n\u{7f}", shape: Rectangle(20, 20), medium: Index(1.5))],
        sources: [(name: "\u{1b}[1mlamp", light: Ray(from: (-30, 0), direction: Angle(0)))],
    )"#;
    let bad = "(\u{1b}[2J title: 1, \u{202e})";
    let place = Place::with(&[("h.ron", hostile), ("e\u{1b}[2J\r.ron", bad), ("é\n\u{9b}.ron", SCENE)]);
    let runs: [&[&str]; 11] = [
        &["check", "h.ron", "e\u{1b}[2J\r.ron", "é\n\u{9b}.ron", "none\u{1b}.ron"],
        &["trace", "h.ron"],
        &["trace", "h.ron", "--format", "json"],
        &["trace", "h.ron", "--format", "csv"],
        &["explain", "h.ron"],
        &["explain", "h.ron", "--format", "markdown"],
        &["explain", "h.ron", "--format", "latex"],
        &["render", "h.ron", "-o", "none\u{1b}/x.svg"],
        &["render", "h.ron", "-o", "\u{1b}[31m.gif"],
        &["render", "h.ron", "--\u{1b}[31m"],
        &["materials", "\u{1b}[31m"],
    ];
    for arguments in runs {
        let run = place.run(arguments);
        let told = run.stdout() + &run.stderr();
        let steers = |c: char| (c.is_control() && c != '\n') || ('\u{202a}'..='\u{202e}').contains(&c);
        assert!(!told.contains(steers) && told.len() > 20, "{arguments:?}: {told:?}");
    }
    let checked = place.run(runs[0]).status(1);
    assert_eq!(checked.stdout(), "h.ron: ok\né\\u{a}\\u{9b}.ron: ok\n");
    assert!(
        checked.stderr().ends_with("2 of 4 scenes failed: e\\u{1b}[2J\\u{d}.ron, none\\u{1b}.ron\n"),
        "{}",
        checked.stderr()
    );
}
