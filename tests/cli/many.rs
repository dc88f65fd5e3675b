//! Many scenes in one command: each is worked on, and those that failed are named at the end.

use std::fs;

use crate::place::{Place, SCENE, assert_svg};

const BAD: &str = "(title: 1)";

#[test]
fn bad_scenes_stop_no_other_and_are_named_at_the_end() {
    let place =
        Place::with(&[("a.ron", SCENE), ("bad.ron", BAD), ("b.ron", SCENE), ("worse.ron", "("), ("c.ron", SCENE)]);
    let scenes = ["a.ron", "bad.ron", "b.ron", "worse.ron", "c.ron"];
    let summary = "\n2 of 5 scenes failed: bad.ron, worse.ron\n";
    let run = place.run(&[&["check"], &scenes[..]].concat()).status(1);
    assert_eq!(run.stdout(), "a.ron: ok\nb.ron: ok\nc.ron: ok\n");
    assert!(run.stderr().starts_with("bad.ron:1:") && run.stderr().ends_with(summary), "{}", run.stderr());
    let run = place.run(&[&["render"], &scenes[..]].concat()).status(1);
    assert_eq!(run.stdout(), "a.svg\nb.svg\nc.svg\n");
    assert!(run.stderr().ends_with(summary), "{}", run.stderr());
    ["a.svg", "b.svg", "c.svg"].iter().for_each(|name| assert_svg(&place.path(name)));
}

#[test]
fn nothing_is_summed_up_where_there_is_nothing_to_sum_up() {
    let place = Place::with(&[("a.ron", SCENE), ("b.ron", SCENE), ("bad.ron", BAD)]);
    for command in ["check", "render"] {
        assert!(!place.run(&[command, "a.ron", "b.ron"]).clean().contains("scenes"));
        let alone = place.run(&[command, "bad.ron"]).status(1);
        assert!(!alone.stderr().contains("failed"), "{}", alone.stderr());
    }
}

#[test]
fn a_picture_that_cannot_be_written_counts_as_its_scene() {
    let place = Place::with(&[("a.ron", SCENE), ("b.ron", SCENE)]);
    fs::create_dir(place.path("a.svg")).unwrap();
    let run = place.run(&["render", "a.ron", "b.ron"]).status(1);
    assert_eq!(run.stdout(), "b.svg\n");
    let told = "a.svg: cannot be written: this is a folder, not a file\n1 of 2 scenes failed: a.ron\n";
    assert_eq!(run.stderr(), told);
    let run = place.feed(&["check", "a.ron", "-", "none.ron"], BAD).status(1);
    assert!(run.stderr().ends_with("\n2 of 3 scenes failed: <stdin>, none.ron\n"), "{}", run.stderr());
}

#[test]
fn panels_that_lack_a_scene_are_not_drawn() {
    let place = Place::with(&[("a.ron", SCENE), ("bad.ron", BAD), ("b.ron", SCENE), ("panels.svg", "before")]);
    let run = place.run(&["render", "--panels", "a.ron", "bad.ron", "b.ron"]).status(1);
    assert_eq!(run.stdout(), "");
    assert!(run.stderr().starts_with("bad.ron:1:"), "{}", run.stderr());
    assert!(run.stderr().ends_with("\n1 of 3 scenes failed, so nothing is drawn: bad.ron\n"), "{}", run.stderr());
    assert_eq!(fs::read_to_string(place.path("panels.svg")).unwrap(), "before");
}
