//! What may not be read or written. Permissions do not count for the superuser: then the program runs as nobody.

use std::fs::{self, Permissions};
use std::os::unix::fs::{MetadataExt, PermissionsExt};
use std::os::unix::process::CommandExt;
use std::process::Command;

use crate::place::{Place, Run, SCENE, assert_svg, skipped};

const NOBODY: u32 = 65534;

fn set_mode(place: &Place, name: &str, mode: u32) {
    fs::set_permissions(place.path(name), Permissions::from_mode(mode)).unwrap();
}

fn is_superuser(place: &Place) -> bool {
    fs::metadata(place.path("")).unwrap().uid() == 0
}

/// A place that everyone may write to, with a copy of the program that everyone may run.
fn open_place() -> Place {
    let place = Place::with(&[("a.ron", SCENE)]);
    // By a process of its own: what another thread starts meanwhile would hold the copy open for writing, and it could not run.
    let mut cp = Command::new("cp");
    assert!(cp.arg(env!("CARGO_BIN_EXE_snellius")).arg(place.path("program")).status().unwrap().success());
    set_mode(&place, "program", 0o755);
    set_mode(&place, "", 0o777);
    place
}

/// Runs as a user for whom permissions count.
fn run(place: &Place, arguments: &[&str]) -> Run {
    let mut command = Command::new(place.path("program"));
    command.args(arguments).current_dir(place.path(""));
    // A build that measures coverage would complain that it may not write its counts.
    command.env("LLVM_PROFILE_FILE", "/dev/null");
    if is_superuser(place) {
        command.uid(NOBODY).gid(NOBODY);
    }
    Run(command.output().unwrap())
}

/// Gives a file or folder to the user of [`run`].
fn give(place: &Place, name: &str) {
    if is_superuser(place) {
        std::os::unix::fs::chown(place.path(name), Some(NOBODY), Some(NOBODY)).unwrap();
    }
}

#[track_caller]
fn denied(place: &Place, arguments: &[&str], told: &str) {
    let run = run(place, arguments).status(1);
    assert_eq!((run.stdout(), run.stderr()), (String::new(), format!("{told}: permission denied\n")));
}

#[test]
fn a_read_only_folder_is_told_and_keeps_its_files() {
    let place = open_place();
    fs::create_dir(place.path("sub")).unwrap();
    fs::write(place.path("sub/old.svg"), "before").unwrap();
    ["sub", "sub/old.svg"].iter().for_each(|name| give(&place, name));
    for mode in [0o555, 0o000] {
        set_mode(&place, "sub", mode);
        denied(&place, &["render", "a.ron", "-o", "sub/old.svg"], "sub/old.svg: cannot be written");
        denied(&place, &["render", "a.ron", "-o", "sub/new.svg"], "sub/new.svg: cannot be written");
        denied(&place, &["trace", "a.ron", "-o", "sub/new.csv"], "sub/new.csv: cannot be written");
        denied(&place, &["explain", "a.ron", "-o", "sub/new.md"], "sub/new.md: cannot be written");
        denied(&place, &["render", "a.ron", "--out-dir", "sub/deep"], "sub/deep: cannot be made");
    }
    set_mode(&place, "sub", 0o755);
    assert_eq!(fs::read_to_string(place.path("sub/old.svg")).unwrap(), "before");
    assert_eq!(fs::read_dir(place.path("sub")).unwrap().count(), 1, "nothing is left behind");
    run(&place, &["render", "a.ron", "-o", "sub/old.svg"]).clean();
    assert_svg(&place.path("sub/old.svg"));
}

#[test]
fn a_scene_that_may_not_be_read_is_told() {
    let place = open_place();
    give(&place, "a.ron");
    set_mode(&place, "a.ron", 0o000);
    for command in ["check", "trace", "render", "explain"] {
        denied(&place, &[command, "a.ron"], "a.ron: cannot be read");
    }
}

#[test]
fn a_file_of_another_user_is_not_replaced() {
    let place = open_place();
    if !is_superuser(&place) {
        return skipped("files of another user", "only the superuser can make some");
    }
    fs::write(place.path("old.svg"), "before").unwrap();
    denied(&place, &["render", "a.ron", "-o", "old.svg"], "old.svg: cannot be written");
    // In a folder as /tmp a file that everyone may write to can be replaced by its owner alone.
    set_mode(&place, "old.svg", 0o666);
    set_mode(&place, "", 0o1777);
    denied(&place, &["render", "a.ron", "-o", "old.svg"], "old.svg: cannot be written");
    assert_eq!(fs::read_to_string(place.path("old.svg")).unwrap(), "before");
    assert_eq!(place.files(), ["a.ron", "old.svg", "program"]);
}

/// What even the superuser may not write to.
#[cfg(target_os = "linux")]
#[test]
fn a_read_only_file_system_is_told() {
    let place = Place::with(&[("a.ron", SCENE)]);
    fs::create_dir(place.path("sub")).unwrap();
    fs::write(place.path("sub/old.svg"), "before").unwrap();
    let script = "mount --bind sub sub && mount -o remount,bind,ro sub || exit 99
        for file in old new; do \"$0\" render a.ron -o sub/$file.svg; echo $?; done; \"$0\" render a.ron --out-dir sub/deep; echo $?";
    let Some(run) = place.run_where_it_may_mount("a read-only file system", script) else { return };
    assert_eq!(run.stdout(), "1\n1\n1\n");
    let lines: Vec<_> = ["old.svg: cannot be written", "new.svg: cannot be written", "deep: cannot be made"]
        .map(|told| format!("sub/{told}: Read-only file system\n"))
        .concat()
        .lines()
        .map(String::from)
        .collect();
    assert_eq!(run.stderr().lines().collect::<Vec<_>>(), lines);
    assert_eq!(fs::read_to_string(place.path("sub/old.svg")).unwrap(), "before");
}

/// Files that the system alone writes.
#[cfg(target_os = "linux")]
#[test]
fn files_of_the_system_are_told() {
    let place = Place::with(&[("a.ron", SCENE)]);
    for target in ["/proc/version", "/proc/none.svg", "/sys/none.svg"] {
        let run = place.run(&["render", "a.ron", "--format", "svg", "-o", target]).status(1);
        assert!(run.stderr().starts_with(&format!("{target}: cannot be written: ")), "{}", run.stderr());
        assert_eq!(run.stdout(), "");
    }
}
