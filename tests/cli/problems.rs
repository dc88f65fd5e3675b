//! Problems of scenes: all of them, each with its place.

use std::fs;

use crate::place::{Place, SCENE};

#[test]
fn every_problem_of_every_scene_is_shown_with_its_place() {
    let bad = "(\n    title: 3,\n    bodies: [(shape: Disk(-1), medium: Index(0.5))],\n    colour: 1,\n)\n";
    let place = Place::with(&[("bad.ron", bad), ("good.ron", SCENE), ("worse.ron", "(\n  sources: [\n")]);
    let run = place.run(&["check", "bad.ron", "good.ron", "worse.ron", "missing.ron"]).status(1);
    assert_eq!(run.stdout(), "good.ron: ok\n");
    let stderr = run.stderr();
    for place in ["bad.ron:2:", "bad.ron:3:", "bad.ron:4:", "worse.ron:"] {
        assert!(stderr.lines().any(|line| line.starts_with(place)), "{place} in\n{stderr}");
    }
    assert!(stderr.contains("missing.ron: cannot be read: there is no such file"), "{stderr}");
    for command in ["trace", "render", "explain"] {
        let again = place.run(&[command, "bad.ron"]).status(1);
        assert_eq!(again.stdout(), "");
        assert!(stderr.starts_with(&again.stderr()), "the same words from {command}:\n{}", again.stderr());
    }
    assert_eq!(place.files(), ["bad.ron", "good.ron", "worse.ron"]);
}

#[test]
fn problems_on_standard_input_have_a_name_too() {
    let run = Place::new().feed(&["check", "-"], "(\n  title: \"a\",\n  bodys: [],\n)\n").status(1);
    assert!(run.stderr().starts_with("<stdin>:3:"), "{}", run.stderr());
}

#[test]
fn what_is_no_text_file_is_told() {
    let place = Place::new();
    fs::write(place.path("latin.ron"), b"(\n  title: \"Pr\xe9sentation\",\n)").unwrap();
    let run = place.run(&["check", ".", "latin.ron"]).status(1);
    let stderr = run.stderr();
    assert!(stderr.contains(".: cannot be read: this is a folder"), "{stderr}");
    assert!(stderr.contains("latin.ron:2:13: error: the file is not text in UTF-8"), "{stderr}");
}

#[test]
fn warnings_are_shown_and_do_not_count() {
    let sliver = SCENE.replace(
        "    ],\n    sources",
        "        (shape: Rectangle(10, 10), at: (15.0001, 0), medium: Index(1.6)),\n    ],\n    sources",
    );
    let place = Place::with(&[("sliver.ron", &sliver)]);
    let run = place.run(&["check", "sliver.ron"]).status(0);
    assert_eq!(run.stdout(), "sliver.ron: ok, 1 warning\n");
    assert!(run.stderr().starts_with("sliver.ron:"), "{}", run.stderr());
    let traced = place.run(&["trace", "sliver.ron"]).status(0);
    assert_eq!(traced.stderr(), run.stderr());
}
