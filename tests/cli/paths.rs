//! Names of files: spaces, other scripts, line breaks, bytes that are no text, links, and the longest there are.

use std::ffi::{OsStr, OsString};
use std::fs;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::symlink;

use crate::place::{Place, Run, SCENE, assert_svg};

fn run(place: &Place, arguments: &[&OsStr]) -> Run {
    Run(place.command(&[]).args(arguments).output().unwrap())
}

/// The longest name of a file.
const LONGEST: usize = 255;

#[test]
fn files_may_have_any_name() {
    let long = "x".repeat(LONGEST - 4);
    let names: [&[u8]; 7] = [
        b"with two  spaces",
        "Gr\u{f6}\u{df}e \u{5d0}\u{5d1} \u{5149} \u{1f642}".as_bytes(),
        b"-o",
        b"line\nbreak",
        b"quote'\"$`\\*?",
        #[cfg(target_os = "linux")]
        b"no \xff text \xc3",
        long.as_bytes(),
    ];
    for name in names {
        let place = Place::new();
        let file = |extension: &str| -> OsString {
            let mut file = OsStr::from_bytes(name).to_owned();
            file.push(extension);
            file
        };
        let path = |extension| fs::canonicalize(place.path("")).unwrap().join(file(extension));
        fs::write(path(".ron"), SCENE).unwrap();
        let (command, dashes) = (OsStr::new("render"), OsStr::new("--"));
        // Printed byte for byte, for other programs.
        let drawn = run(&place, &[command, dashes, &file(".ron")]).status(0);
        assert_eq!(drawn.0.stdout, [file(".svg").as_bytes(), b"\n"].concat());
        assert_svg(&path(".svg"));
        fs::write(path(".svg"), "before").unwrap();
        let output = [OsStr::new("--output="), &file(".svg")].map(OsStr::to_owned).join(OsStr::new(""));
        run(&place, &[command, &output, dashes, &file(".ron")]).status(0);
        assert_svg(&path(".svg"));
        assert_eq!(fs::read_dir(place.path("")).unwrap().count(), 2, "and nothing else is there");
    }
}

#[test]
fn a_name_that_is_too_long_is_told() {
    let place = Place::with(&[("a.ron", SCENE)]);
    let name = format!("{}.svg", "x".repeat(LONGEST - 3));
    let run = place.run(&["render", "a.ron", "-o", &name]).status(1);
    assert_eq!(
        (run.stdout(), run.stderr()),
        (String::new(), format!("{name}: cannot be written: the name is too long, or no name for a file\n"))
    );
    assert_eq!(place.files(), ["a.ron"]);
}

#[test]
fn strange_targets_are_told() {
    let place = Place::with(&[("a.ron", SCENE), ("file", "before")]);
    for (target, why) in [
        ("none/x.svg", "its folder does not exist"),
        ("none/", "this is a folder, not a file"),
        (".", "this is a folder, not a file"),
        ("file/x.svg", "part of the path is a file, not a folder"),
    ] {
        let run = place.run(&["render", "a.ron", "--format", "svg", "-o", target]).status(1);
        assert_eq!(run.stderr(), format!("{target}: cannot be written: {why}\n"));
        assert_eq!(run.stdout(), "");
    }
    place.run(&["render", "a.ron", "--format", "svg", "-o", ""]).refused("a value is required");
    assert_eq!(place.files(), ["a.ron", "file"]);
}

#[test]
fn links_lead_to_what_is_written() {
    let place = Place::with(&[("a.ron", SCENE)]);
    fs::create_dir(place.path("sub")).unwrap();
    symlink("loop.svg", place.path("loop.svg")).unwrap();
    symlink("made.svg", place.path("dangling.svg")).unwrap();
    symlink("../far.svg", place.path("sub/link.svg")).unwrap();
    symlink("sub/link.svg", place.path("twice.svg")).unwrap();
    symlink("none/x.svg", place.path("nowhere.svg")).unwrap();
    for (link, made) in [("dangling.svg", "made.svg"), ("sub/link.svg", "far.svg"), ("twice.svg", "far.svg")] {
        assert_eq!(place.run(&["render", "a.ron", "-o", link]).clean(), format!("{link}\n"));
        assert!(fs::symlink_metadata(place.path(link)).unwrap().is_symlink(), "{link}");
        assert_svg(&place.path(made));
        fs::remove_file(place.path(made)).unwrap();
    }
    let run = place.run(&["render", "a.ron", "-o", "nowhere.svg"]).status(1);
    assert_eq!(run.stderr(), "nowhere.svg: cannot be written: its folder does not exist\n");
    let run = place.run(&["render", "a.ron", "-o", "loop.svg"]).status(1);
    assert!(
        run.stderr().starts_with("loop.svg: cannot be written: ") && run.stderr().contains("links"),
        "{}",
        run.stderr()
    );
    assert_eq!(place.files(), ["a.ron", "dangling.svg", "loop.svg", "nowhere.svg", "sub", "twice.svg"]);
}

#[test]
fn a_scene_is_not_lost_by_any_link() {
    let place = Place::with(&[("a.ron", SCENE), ("b.svg", SCENE)]);
    symlink("a.ron", place.path("a.svg")).unwrap();
    place.run(&["render", "a.ron"]).refused("would overwrite the scene 'a.ron'");
    symlink("b.svg", place.path("b.ron")).unwrap();
    place.run(&["render", "b.ron"]).refused("would overwrite the scene 'b.ron'");
    // The other name of the file is replaced, the scene's own stays.
    fs::remove_file(place.path("a.svg")).unwrap();
    fs::hard_link(place.path("a.ron"), place.path("a.svg")).unwrap();
    place.run(&["render", "a.ron"]).clean();
    assert_svg(&place.path("a.svg"));
    for scene in ["a.ron", "b.svg"] {
        assert_eq!(fs::read_to_string(place.path(scene)).unwrap(), SCENE, "{scene}");
    }
}
