//! Files that are written: whole or not at all, and with the permissions that they have.

use std::fs;

use crate::place::{Place, SCENE, assert_svg};

#[test]
fn what_fails_leaves_files_as_they_are() {
    let place = Place::with(&[("a.ron", SCENE), ("a.svg", "before"), ("bad.ron", "(title: 1)"), ("bad.svg", "before")]);
    fs::create_dir(place.path("folder.svg")).unwrap();
    place.run(&["render", "a.ron", "bad.ron"]).status(1);
    assert_svg(&place.path("a.svg"));
    assert_eq!(fs::read_to_string(place.path("bad.svg")).unwrap(), "before");
    let run = place.run(&["render", "a.ron", "-o", "folder.svg"]).status(1);
    assert!(run.stderr().contains("folder.svg: cannot be written: this is a folder"), "{}", run.stderr());
    let run = place.run(&["render", "a.ron", "-o", "nowhere/a.svg"]).status(1);
    assert!(run.stderr().contains("nowhere/a.svg: cannot be written: its folder does not exist"), "{}", run.stderr());
    let run = place.run(&["render", "a.ron", "--out-dir", "a.ron"]).status(1);
    assert!(run.stderr().starts_with("a.ron: cannot be made: this is a file, not a folder\n"), "{}", run.stderr());
    assert_eq!(place.files(), ["a.ron", "a.svg", "bad.ron", "bad.svg", "folder.svg"], "and nothing is left behind");
}

/// A result is complete before it takes the place of what was there: another link to that keeps the old bytes.
#[test]
fn a_file_is_replaced_and_not_written_over() {
    let place = Place::with(&[("a.ron", SCENE), ("a.svg", "before"), ("a.json", "before")]);
    for (arguments, file) in [(&["render", "a.ron"][..], "a.svg"), (&["trace", "a.ron", "-o", "a.json"], "a.json")] {
        fs::hard_link(place.path(file), place.path("link")).unwrap();
        place.run(arguments).status(0);
        assert_eq!(fs::read_to_string(place.path("link")).unwrap(), "before", "{file}");
        assert_ne!(fs::read_to_string(place.path(file)).unwrap(), "before", "{file}");
        fs::remove_file(place.path("link")).unwrap();
    }
}

/// Files of more than 512 bytes cannot be written: the program fails, or the system ends it, in the middle of its result.
#[cfg(unix)]
#[test]
fn a_result_that_breaks_off_changes_nothing() {
    let place = Place::with(&[("a.ron", SCENE), ("old.json", "before")]);
    let run = |signal: &str, file: &str| {
        let line = format!("{signal} ulimit -f 1; exec \"$0\" trace a.ron -o {file}");
        let mut shell = std::process::Command::new("sh");
        shell.args(["-c", &line, env!("CARGO_BIN_EXE_snellius")]).current_dir(place.path("")).output().unwrap()
    };
    for file in ["old.json", "new.json"] {
        let told = String::from_utf8(run("trap '' XFSZ;", file).stderr).unwrap();
        assert!(told.starts_with(&format!("{file}: cannot be written: ")) && !told.contains("os error"), "{told}");
    }
    assert_eq!(place.files(), ["a.ron", "old.json"], "nothing is left behind");
    for file in ["old.json", "new.json"] {
        assert_eq!(run("", file).status.code(), None, "ended by the system");
    }
    assert_eq!(fs::read_to_string(place.path("old.json")).unwrap(), "before");
    assert!(!place.path("new.json").exists());
}

#[cfg(unix)]
#[test]
fn a_replaced_file_keeps_its_permissions() {
    use std::os::unix::fs::PermissionsExt;
    let place = Place::with(&[("a.ron", SCENE)]);
    for mode in [0o600, 0o640, 0o755] {
        fs::write(place.path("a.svg"), "before").unwrap();
        fs::set_permissions(place.path("a.svg"), fs::Permissions::from_mode(mode)).unwrap();
        place.run(&["render", "a.ron"]).clean();
        assert_svg(&place.path("a.svg"));
        assert_eq!(fs::metadata(place.path("a.svg")).unwrap().permissions().mode() & 0o777, mode);
    }
}

#[test]
fn a_read_only_file_is_not_replaced() {
    let place = Place::with(&[("a.ron", SCENE), ("a.svg", "before")]);
    let writable = fs::metadata(place.path("a.svg")).unwrap().permissions();
    let mut read_only = writable.clone();
    read_only.set_readonly(true);
    fs::set_permissions(place.path("a.svg"), read_only).unwrap();
    let run = place.run(&["render", "a.ron"]).status(1);
    assert_eq!(run.stderr(), "a.svg: cannot be written: this file is read-only\n");
    assert_eq!(run.stdout(), "");
    assert_eq!(fs::read_to_string(place.path("a.svg")).unwrap(), "before");
    assert_eq!(place.files(), ["a.ron", "a.svg"]);
    fs::set_permissions(place.path("a.svg"), writable).unwrap();
}

#[cfg(unix)]
#[test]
fn files_have_ordinary_permissions_and_links_stay_links() {
    use std::os::unix::fs::{MetadataExt, symlink};
    let place = Place::with(&[("a.ron", SCENE), ("plain", ""), ("target.svg", "")]);
    symlink(place.path("target.svg"), place.path("link.svg")).unwrap();
    place.run(&["render", "a.ron", "-o", "x.svg"]).clean();
    place.run(&["render", "a.ron", "-o", "link.svg"]).clean();
    let mode = |name| fs::metadata(place.path(name)).unwrap().mode();
    assert_eq!(mode("x.svg"), mode("plain"));
    assert!(fs::symlink_metadata(place.path("link.svg")).unwrap().is_symlink());
    assert_svg(&place.path("target.svg"));
}

#[cfg(unix)]
#[test]
fn a_device_is_written_to_and_not_replaced() {
    use std::os::unix::fs::FileTypeExt;
    let place = Place::with(&[("a.ron", SCENE)]);
    assert_eq!(place.run(&["render", "a.ron", "-o", "/dev/null", "--format", "svg"]).clean(), "/dev/null\n");
    assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
}
