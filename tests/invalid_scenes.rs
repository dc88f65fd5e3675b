//! Every scene in `tests/invalid` is refused with the words in `snapshots/invalid`: place, fault and cure.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

#[path = "support/plain_words.rs"]
mod plain_words;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use plain_words::is_in_plain_words;
use snellius::scene::{Problem, Scene, Severity, load, render_problems, text_of};

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

fn files(name: &str, extension: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder(name)).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<PathBuf> = entries.filter(|path| path.extension().is_some_and(|e| e == extension)).collect();
    files.sort();
    files
}

fn stem(path: &Path) -> String {
    path.file_stem().unwrap().to_str().unwrap().to_owned()
}

fn problems(text: &str) -> Vec<Problem> {
    match load(text) {
        Ok(loaded) => loaded.warnings,
        Err(problems) => problems,
    }
}

/// The problems of a file, with the text that their places count in.
fn of_file(path: &Path) -> (Vec<Problem>, String) {
    match text_of(&fs::read(path).unwrap(), "") {
        Ok(text) => (problems(text), text.to_owned()),
        Err(problems) => (problems.list().to_vec(), problems.text().to_owned()),
    }
}

fn shown(path: &Path) -> String {
    let (problems, text) = of_file(path);
    render_problems(&problems, &text, &format!("{}.ron", stem(path)))
}

#[test]
fn every_invalid_scene_is_refused_in_these_words() {
    let scenes = files("tests/invalid", "ron");
    assert!(scenes.len() >= 80, "{}", scenes.len());
    for path in scenes {
        insta::with_settings!({
            snapshot_path => folder("snapshots/invalid"),
            prepend_module_to_snapshot => false,
            omit_expression => true,
        }, {
            insta::assert_snapshot!(stem(&path), shown(&path));
        });
    }
}

#[test]
fn no_snapshot_is_left_without_its_scene() {
    let scenes = files("tests/invalid", "ron");
    let expected: BTreeSet<String> = scenes.iter().map(|path| format!("{}.snap", stem(path))).collect();
    let entries = fs::read_dir(folder("snapshots/invalid")).unwrap();
    let found: BTreeSet<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    assert_eq!(found, expected);
}

#[test]
fn every_message_has_place_fault_and_cure_in_plain_words() {
    for path in files("tests/invalid", "ron") {
        let (found, text) = of_file(&path);
        assert!(found.iter().any(|problem| problem.severity == Severity::Error), "{path:?} has no error");
        for problem in found {
            let span = problem.span.clone().unwrap_or_else(|| panic!("{path:?} has no place: {problem:?}"));
            assert!(text.get(span).is_some(), "{path:?}: {problem:?}");
            is_in_plain_words(&problem, "");
        }
    }
}

#[test]
fn each_problem_begins_with_its_place() {
    let text = "(\r\n    // é\r\n    bodies: [(shape: Disk(-1), medium: Index(0.5))],\r\n)\r\n";
    let shown = render_problems(&problems(text), text, "a b.ron");
    let places: Vec<&str> = shown.lines().filter(|line| line.starts_with("a b.ron:")).collect();
    assert_eq!(places.len(), 2, "{shown}");
    assert!(places[0].starts_with("a b.ron:3:27: error: "), "{shown}");
    assert!(places[1].starts_with("a b.ron:3:46: error: "), "{shown}");
}

#[test]
fn five_faults_are_five_problems_in_one_run() {
    let text = r#"(
        titel: "typo",
        bodies: [
            (name: "a", shape: Disk("4"), medium: Index(1.5)),
            (name: "b", shape: Disk(4), medium: Index(0.5)),
        ],
        sources: [(light: Fan(from: (0, 0), direction: Angle(0), spread: 400, rays: 8), power: NaN)],
    )"#;
    let found = problems(text);
    let paths: Vec<&str> = found.iter().map(|problem| problem.path.as_str()).collect();
    let expected =
        ["titel", "bodies[0].shape.radius", "bodies[1].medium.n", "sources[0].light.spread", "sources[0].power"];
    assert_eq!(paths, expected);
}

#[test]
fn long_and_deep_texts_are_refused_at_once() {
    for text in ["(".repeat(1_000_000), "[".repeat(1_000_000), format!("(bodies: {}", "Some(".repeat(500_000))] {
        assert_eq!(problems(&text).len(), 1);
        assert!(problems(&text)[0].message.contains("nested"), "{:?}", problems(&text)[0].message);
    }
    let comments = "/*".repeat(1_000_000);
    assert_eq!(problems(&comments)[0].message, "the comment never ends");
    let long = " ".repeat(100 << 20);
    assert!(problems(&long)[0].message.contains("bytes"));
}

#[test]
fn a_source_of_a_million_million_rays_is_refused_at_once() {
    let text = "(sources: [(light: Point(at: (0, 0), rays: 1000000000000))])";
    assert!(problems(text)[0].message.contains("1000000000000"), "{:?}", problems(text));
}

#[test]
fn bytes_that_are_no_text_are_shown_where_they_begin() {
    let shown = text_of(b"(\n  title: \"caf\xe9\",\n)", "latin1.ron").unwrap_err().to_string();
    assert!(
        shown.starts_with("latin1.ron:2:14: error: the file is not text in UTF-8\n2 |   title: \"caf\u{fffd}\",\n"),
        "{shown}"
    );
}

#[test]
fn a_library_user_sees_what_the_command_shows() {
    let error = Scene::from_ron("(titel: \"t\")").unwrap_err();
    assert_eq!(error.list().len(), 1);
    assert!(error.to_string().starts_with("scene:1:2: error: a scene has no field `titel`\n"), "{error}");
}

#[test]
fn a_scene_built_in_rust_is_checked_alike() {
    let mut scene = Scene::from_ron("(bodies: [(shape: Disk(4), medium: Index(1.5))])").unwrap();
    assert_eq!(scene.validate(), []);
    scene.bodies[0].rotate = f64::NAN;
    scene.diagram.size = [0, 9];
    let paths: Vec<String> = scene.validate().into_iter().map(|problem| problem.path).collect();
    assert_eq!(paths, ["bodies[0].rotate", "diagram.size[0]", "diagram.size[1]"]);
}

/// Every word that the reader and the checks can say about a scene is in some snapshot: no message is without its scene.
#[test]
fn every_message_has_its_scene() {
    let said: String =
        files("snapshots/invalid", "snap").iter().map(|path| fs::read_to_string(path).unwrap()).collect();
    let sources = ["src/scene/check", "src/scene/read"].into_iter().flat_map(|place| files(place, "rs"));
    let others = ["src/scene/medium.rs", "src/scene/names.rs", "src/scene/color.rs", "src/laws/index.rs"].map(folder);
    let quiet = ["tests.rs", "stress.rs"];
    let sources = sources.chain(others).filter(|path| !quiet.contains(&path.file_name().unwrap().to_str().unwrap()));
    let mut unsaid = Vec::new();
    for path in sources {
        let code = fs::read_to_string(&path).unwrap();
        let words = literals(code.split("#[cfg(test)]").next().unwrap()).into_iter().flat_map(|text| pieces(&text));
        unsaid.extend(words.filter(|words| !said.contains(words.as_str())).map(|words| (stem(&path), words)));
    }
    let expected: BTreeSet<&str> = UNSAID.into();
    assert_eq!(unsaid.iter().map(|(_, words)| words.as_str()).collect::<BTreeSet<_>>(), expected, "{unsaid:#?}");
}

/// What no scene of this folder can make the program say.
const UNSAID: [&str; 17] = [
    // Of values that only a program can build.
    "a body needs a `medium` or a `surface` unless it is a lens group",
    "give what fills the shape or what its boundary does",
    "must be a finite number, not",
    "the wavelength",
    "the refractive index must be a finite number, not",
    // Of files too large for this folder.
    "the outline has too many long edges side by side to check that none of them cross",
    "use fewer points, or several bodies",
    "bytes long; at most",
    "split the scene, or give curved outlines as arcs instead of many points",
    "points so far, all outlines together; at most",
    "spectral lines have",
    "refractive indices; at most",
    "use fewer different media or spectral lines;",
    // Of faults that ron names otherwise in what a scene can be.
    "expected `]`, found",
    "expected a closing bracket, found",
    "close the parenthesis with `)`",
    "the end of the text",
];

/// The texts in double quotes of Rust code without raw ones, comments left out.
fn literals(code: &str) -> Vec<String> {
    let lines = code.lines().filter(|line| !line.trim_start().starts_with("//"));
    let code: String = lines.map(|line| format!("{line}\n")).collect();
    let (mut texts, mut rest) = (Vec::new(), code.replace("'\"'", "").replace("'\\\"'", ""));
    while let Some(start) = rest.find('"') {
        let (mut text, mut escaped, mut end) = (String::new(), false, rest.len());
        for (at, c) in rest[start + 1..].char_indices() {
            match (c, escaped) {
                ('"', false) => {
                    end = start + 1 + at;
                    break;
                }
                ('\\', false) => escaped = true,
                (c, true) => {
                    escaped = false;
                    text.push(if c == 'n' { '\n' } else { c });
                }
                (c, false) => text.push(c),
            }
        }
        texts.push(text);
        rest = rest[(end + 1).min(rest.len())..].to_owned();
    }
    texts
}

/// The fixed words of a text with places to fill in, as long as they are prose.
fn pieces(text: &str) -> Vec<String> {
    let fixed = text.split('{').map(|piece| piece.split_once('}').map_or(piece, |(_, rest)| rest));
    let fixed = fixed.flat_map(|piece| piece.split('\n')).map(|piece| piece.trim().to_owned());
    fixed.filter(|piece| piece.len() >= 10 && piece.contains(' ')).collect()
}
