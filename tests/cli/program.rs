//! The program as a whole, and the commands that need no scene.

use std::fs;
use std::process::Stdio;

use crate::place::{Place, Run, SCENE};

const TEMPLATES: [&str; 5] = ["minimal", "prism", "lens", "tir", "mirror"];

#[test]
fn help_and_version_are_results() {
    let place = Place::new();
    let help = place.run(&["--help"]).clean();
    for command in ["render", "trace", "explain", "check", "materials", "new"] {
        assert!(help.contains(command), "{help}");
        assert!(place.run(&[command, "--help"]).clean().contains("Usage:"));
    }
    assert_eq!(place.run(&["--version"]).clean(), format!("snellius {}\n", env!("CARGO_PKG_VERSION")));
}

#[test]
fn a_command_line_that_says_nothing_sensible_is_refused() {
    let place = Place::new();
    for arguments in [&[][..], &["explain"], &["rendr", "a.ron"], &["render"], &["trace"], &["check"], &["new"]] {
        place.run(arguments).refused("");
    }
    place.run(&["trace", "a.ron", "b.ron"]).refused("unexpected argument");
    place.run(&["check", "-", "-"]).refused("only once");
    place.run(&["render", "-", "-", "--out-dir", "o"]).refused("only once");
}

#[test]
fn a_pipe_that_nobody_reads_ends_quietly() {
    let place = Place::with(&[("a.ron", SCENE)]);
    for arguments in [
        &["trace", "a.ron"][..],
        &["explain", "a.ron"],
        &["materials"],
        &["new", "lens"],
        &["check", "a.ron"],
        &["--help"],
    ] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let mut command = place.command(arguments);
        let run = Run(command.stdout(writer).stderr(Stdio::piped()).spawn().unwrap().wait_with_output().unwrap());
        assert_eq!(run.status(0).stderr(), "", "{arguments:?}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    let place = Place::with(&[("a.ron", SCENE)]);
    let full = fs::File::options().write(true).open("/dev/full").unwrap();
    let run = Run(place.command(&["trace", "a.ron"]).stdout(full).output().unwrap()).status(1);
    assert!(run.stderr().contains("<stdout>: cannot be written: no space is left"), "{}", run.stderr());
    for arguments in [&["--help"][..], &["trace", "--help"], &["--version"], &["materials"], &["new", "lens"]] {
        let full = fs::File::options().write(true).open("/dev/full").unwrap();
        let run = Run(place.command(arguments).stdout(full).output().unwrap()).status(1);
        assert!(run.stderr().contains("no space is left"), "{arguments:?}: {}", run.stderr());
    }
    let run = place.run(&["trace", "a.ron", "-o", "/dev/full", "--format", "json"]).status(1);
    assert!(run.stderr().contains("no space is left"));
}

#[test]
fn every_template_passes_check_and_is_drawn() {
    let place = Place::new();
    for template in TEMPLATES {
        let scene = place.run(&["new", template]).clean();
        assert!(scene.starts_with("//"), "commented");
        assert_eq!(place.feed(&["check", "-"], &scene).clean(), "<stdin>: ok\n", "{template}");
        let svg = place.feed(&["render", "-", "-o", "-"], &scene).clean();
        assert!(svg.contains("<svg"), "{template}");
    }
    place.run(&["new", "telescope"]).refused("minimal, prism, lens, tir, mirror");
}

#[test]
fn materials_lists_what_a_pattern_asks_for() {
    let place = Place::new();
    let all = place.run(&["materials"]).clean();
    assert!(all.lines().count() > 25 && all.lines().next().unwrap().contains("n_d"));
    let some = place.run(&["materials", "bk7"]).clean();
    let row = some.lines().find(|line| line.starts_with("N-BK7 ")).unwrap();
    assert!(row.contains("1.51680") && row.contains("64.17") && row.contains("300-2500"), "{row}");
    assert!(some.lines().count() < all.lines().count());
    place.run(&["materials", "unobtainium"]).refused("'unobtainium'");
}
