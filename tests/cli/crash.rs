//! Output files appear whole or not at all, whatever happens while they are written.

use std::collections::BTreeSet;
use std::fs;
use std::io::{Read, Seek, Write};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::interrupt::{PATIENCE, scene};
use crate::place::{Place, Run, SCENE, skipped};

/// Runs that are killed; at least this share of them while they write.
const KILLED: u32 = 60;

/// Nobody can clean up after a kill: a file `.snellius-…` may stay beside the target, but the target is whole.
#[test]
fn a_killed_run_leaves_the_old_file_or_the_new_one() {
    let place = Place::with(&[("a.ron", &scene(30))]);
    let since = Instant::now();
    place.run(&["trace", "a.ron", "-o", "a.json"]).clean();
    let usual = since.elapsed();
    let whole = fs::read(place.path("a.json")).unwrap();
    let (mut old, mut new, mut half) = (0, 0, 0);
    for k in 0..KILLED {
        fs::write(place.path("a.json"), "before").unwrap();
        let mut child = place.command(&["trace", "a.ron", "-o", "a.json"]).spawn().unwrap();
        let is_writing = || place.files().len() > 2;
        if k % 2 == 0 {
            // At any moment of the run.
            sleep(usual * k / KILLED);
        } else {
            // While it writes, or when it has ended.
            while !is_writing() && child.try_wait().unwrap().is_none() {}
            sleep(usual * (k % 16) / 64);
        }
        child.kill().unwrap();
        child.wait().unwrap();
        let found = fs::read(place.path("a.json")).unwrap();
        match found == whole {
            true => new += 1,
            false if found == b"before" => old += 1,
            false => panic!("{} bytes, neither old nor new", found.len()),
        }
        for left in place.files().iter().filter(|name| !["a.json", "a.ron"].contains(&name.as_str())) {
            assert!(left.starts_with(".snellius-"), "{left}");
            fs::remove_file(place.path(left)).unwrap();
            half += 1;
        }
    }
    println!("killed: {old} kept the old file, {new} had the new one, {half} left a temporary file");
    assert!(
        old > 0 && half > KILLED / 10,
        "runs were killed too late to tell: {old} old, {new} new, {half} half written"
    );
}

#[test]
fn runs_that_write_one_file_at_once_leave_it_whole() {
    const RUNS: usize = 10;
    let text = |k: usize| scene(2).replace("bodies:", &format!("title: \"{}\", bodies:", "run ".repeat(25 * k)));
    let place = Place::new();
    let mut whole = BTreeSet::new();
    for k in 0..RUNS {
        fs::write(place.path(&format!("{k}.ron")), text(k)).unwrap();
        whole.insert(place.run(&["trace", &format!("{k}.ron"), "--format", "json"]).clean());
    }
    assert_eq!(whole.len(), RUNS);
    for runs in [2, RUNS] {
        let start = |k| place.command(&["trace", &format!("{k}.ron"), "-o", "a.json"]).spawn().unwrap();
        let mut children: Vec<_> = (0..runs).map(start).collect();
        let mut looks = 0;
        while children.iter_mut().any(|child| child.try_wait().unwrap().is_none()) {
            if let Ok(found) = fs::read_to_string(place.path("a.json")) {
                assert!(whole.contains(&found), "{} bytes, of no run", found.len());
                looks += 1;
            }
            sleep(Duration::from_millis(1));
        }
        assert!(children.iter_mut().all(|child| child.wait().unwrap().success()));
        assert!(whole.contains(&fs::read_to_string(place.path("a.json")).unwrap()));
        assert!(looks > 0 || runs == 2, "nobody looked at the file");
        assert_eq!(place.files().len(), RUNS + 1, "and nothing is left behind");
    }
}

/// Whoever has the old file open goes on reading it.
#[test]
fn a_file_that_is_open_elsewhere_keeps_its_content_there() {
    let place = Place::with(&[("a.ron", SCENE), ("a.svg", "before")]);
    let mut open = fs::File::options().read(true).write(true).open(place.path("a.svg")).unwrap();
    place.run(&["render", "a.ron"]).clean();
    let new = fs::read_to_string(place.path("a.svg")).unwrap();
    let mut old = String::new();
    open.read_to_string(&mut old).unwrap();
    assert_eq!(old, "before");
    open.rewind().unwrap();
    open.write_all(b"late").unwrap();
    assert_eq!(fs::read_to_string(place.path("a.svg")).unwrap(), new, "and writes into nothing that is new");
}

#[test]
fn a_folder_that_vanishes_is_told() {
    let gone = "cannot be written: its folder does not exist\n";
    let place = Place::with(&[("a.ron", &scene(300))]);
    for arguments in [&["render", "-", "-o", "sub/stdin.svg"][..], &["render", "-", "--out-dir", "sub"]] {
        let is_there = arguments.contains(&"-o");
        if is_there {
            fs::create_dir(place.path("sub")).unwrap();
        }
        let mut command = place.command(arguments);
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        // The folder of --out-dir is made before the scene is read.
        await_that(|| place.path("sub").exists());
        fs::remove_dir(place.path("sub")).unwrap();
        child.stdin.take().unwrap().write_all(SCENE.as_bytes()).unwrap();
        let run = Run(child.wait_with_output().unwrap()).status(1);
        assert_eq!((run.stdout(), run.stderr()), (String::new(), format!("sub/stdin.svg: {gone}")));
    }
    // While the file is being written.
    fs::create_dir(place.path("sub")).unwrap();
    let mut command = place.command(&["trace", "a.ron", "-o", "sub/a.json"]);
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    await_that(|| fs::read_dir(place.path("sub")).unwrap().count() > 0);
    fs::remove_dir_all(place.path("sub")).unwrap();
    let run = Run(child.wait_with_output().unwrap()).status(1);
    assert_eq!(run.stderr(), format!("sub/a.json: {gone}"));
    assert_eq!(place.files(), ["a.ron"]);
}

fn await_that(is_so: impl Fn() -> bool) {
    let since = Instant::now();
    while !is_so() {
        assert!(since.elapsed() < PATIENCE);
        sleep(Duration::from_millis(1));
    }
}

/// A disk may tell only at the end that it could not take the bytes: `fsync` fails then.
#[cfg(target_os = "linux")]
#[test]
fn what_does_not_reach_the_disk_is_not_reported_as_written() {
    let failing = "#include <errno.h>\n#include <stdlib.h>\n\
                   int fsync(int file) { (void)file; errno = atoi(getenv(\"FSYNC_FAILS\")); return errno ? -1 : 0; }\n";
    let place = Place::with(&[("a.ron", SCENE), ("a.svg", "before"), ("fsync.c", failing)]);
    let compiled =
        Command::new("cc").args(["-shared", "-fPIC", "-o", "fsync.so", "fsync.c"]).current_dir(place.path("")).output();
    if !compiled.is_ok_and(|run| run.status.success()) {
        return skipped("fsync that fails", "there is no C compiler 'cc'");
    }
    let run = |error: i32, arguments: &[&str]| {
        let mut command = place.command(arguments);
        let preload = place.path("fsync.so");
        Run(command.env("LD_PRELOAD", preload).env("FSYNC_FAILS", error.to_string()).output().unwrap())
    };
    const EIO: i32 = 5;
    const ENOSPC: i32 = 28;
    let told = [(EIO, "Input/output error"), (ENOSPC, "no space is left")];
    for (error, why) in told {
        let failed = run(error, &["render", "a.ron"]).status(1);
        assert_eq!((failed.stdout(), failed.stderr()), (String::new(), format!("a.svg: cannot be written: {why}\n")));
        assert_eq!(fs::read_to_string(place.path("a.svg")).unwrap(), "before");
        assert_eq!(place.files(), ["a.ron", "a.svg", "fsync.c", "fsync.so"]);
    }
    // Where a file system cannot tell, the file is written all the same.
    const EINVAL: i32 = 22;
    assert_eq!(run(EINVAL, &["render", "a.ron"]).clean(), "a.svg\n");
    assert_eq!(run(0, &["render", "a.ron", "-o", "b.svg"]).clean(), "b.svg\n");
}

/// A file system of 256 kB in memory, that only these processes see and that ends with them.
#[cfg(target_os = "linux")]
#[test]
fn a_full_file_system_is_told_and_keeps_what_it_has() {
    let place = Place::with(&[("a.ron", &scene(3))]);
    fs::create_dir(place.path("full")).unwrap();
    let script = "mount -t tmpfs -o size=256k none full || exit 99
        echo before > full/old.json
        for file in old.json new.json; do \"$0\" trace a.ron -o full/$file; echo $?; done
        ls -A full; cat full/old.json";
    let Some(run) = place.run_where_it_may_mount("a full file system", script) else { return };
    assert_eq!(run.stdout(), "1\n1\nold.json\nbefore\n");
    let told = |file| format!("full/{file}.json: cannot be written: no space is left\n");
    assert_eq!(run.stderr(), told("old") + &told("new"));
}
