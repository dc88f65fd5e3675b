//! `check`: warnings are those of every command, and JSON says what the text says.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::place::{Place, SCENE};

/// A thin gap, a source on a boundary, a body without light and a deviation of no ray.
const SUSPICIOUS: &str = r#"(
    bodies: [
        (name: "glass", shape: Rectangle(20, 20), medium: Index(1.5)),
        (shape: Rectangle(10, 10), at: (15.0001, 0), medium: Index(1.6)),
        (name: "lost", shape: Disk(4), at: (0, 90), medium: Index(1.5)),
    ],
    sources: [(light: Ray(from: (-10, 0), direction: Angle(0)))],
    trace: (secondary_rays: TransmittedOnly),
    diagram: (deviations: [("0.0:", "0.0:ttttt")]),
)
"#;

#[test]
fn every_command_shows_the_same_warnings_once() {
    let place = Place::with(&[("s.ron", SUSPICIOUS)]);
    let run = place.run(&["check", "s.ron"]).status(0);
    assert_eq!(run.stdout(), "s.ron: ok, 4 warnings\n");
    let told = run.stderr();
    for (at, words) in [
        ("s.ron:4:9", "a gap or sliver of 1.00e-4"),
        ("s.ron:7:33", "ray 0.0 starts on the boundary of `glass`, in the medium of index 1.5"),
        ("s.ron:5:9", "no ray meets `lost`"),
        ("s.ron:9:37", "this deviation is not marked"),
    ] {
        assert_eq!(told.matches(&format!("{at}: warning: {words}")).count(), 1, "{at} {words} in\n{told}");
    }
    for command in [
        &["trace", "s.ron"][..],
        &["trace", "s.ron", "--format", "summary"],
        &["render", "s.ron"],
        &["render", "s.ron", "--panels"],
        &["explain", "s.ron"],
    ] {
        assert_eq!(place.run(command).status(0).stderr(), told, "{command:?}");
    }
}

fn json(run: &str) -> Vec<Value> {
    let report: Value = serde_json::from_str(run).unwrap();
    assert_eq!(report["schema"], 1);
    report["files"].as_array().unwrap().clone()
}

/// What the text form shows of a problem: its first line, the label, the path and the help.
fn in_text(text: &str, file: &str) -> Vec<String> {
    let label = |line: &str| {
        Some(line.split_once('|')?.1.trim_start().strip_prefix('^')?.trim_start_matches('^').trim().to_owned())
    };
    let words = text.lines().filter_map(|line| {
        let is_plain = line.starts_with(file) || line.starts_with("  in: ") || line.starts_with("help: ");
        if is_plain { Some(line.to_owned()) } else { label(line).filter(|label| !label.is_empty()) }
    });
    words.collect()
}

fn in_json(problem: &Value, file: &str) -> Vec<String> {
    let word = |name: &str| problem[name].as_str().unwrap().to_owned();
    let place = [&problem["line"], &problem["column"]].map(|number| number.as_u64().unwrap());
    let first = format!("{file}:{}:{}: {}: {}", place[0], place[1], word("severity"), word("message"));
    let (path, help) = (word("path"), word("help"));
    let path = if path.is_empty() { path } else { format!("  in: {path}") };
    let all = [first, word("label"), path, format!("help: {help}")];
    all.into_iter().filter(|words| !words.is_empty()).collect()
}

#[test]
fn json_says_what_the_text_says_of_every_invalid_scene() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/invalid");
    let place = Place::new();
    let mut files: Vec<String> = Vec::new();
    for entry in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap()) {
        files.push(entry.file_name().into_string().unwrap());
        fs::copy(entry.path(), place.path(&entry.file_name().into_string().unwrap())).unwrap();
    }
    files.sort();
    let arguments: Vec<&str> =
        ["check", "--format", "json"].into_iter().chain(files.iter().map(String::as_str)).collect();
    let run = place.run(&arguments).status(1);
    assert_eq!(run.stderr(), "");
    let reports = json(&run.stdout());
    assert_eq!(reports.len(), files.len());
    for (file, report) in files.iter().zip(&reports) {
        assert_eq!((report["file"].as_str(), report["ok"].as_bool()), (Some(file.as_str()), Some(false)));
        let text = place.run(&["check", file]).status(1).stderr();
        let problems = report["problems"].as_array().unwrap();
        let found: Vec<String> = problems.iter().flat_map(|problem| in_json(problem, file)).collect();
        assert_eq!(found, in_text(&text, &format!("{file}:")));
        assert!(!problems.is_empty());
        let bytes = fs::read(place.path(file)).unwrap();
        let text = String::from_utf8_lossy(&bytes);
        problems
            .iter()
            .filter(|_| matches!(text, std::borrow::Cow::Borrowed(_)))
            .for_each(|problem| assert_place(problem, &text));
    }
}

/// Bytes, lines and columns name the same place.
fn assert_place(problem: &Value, text: &str) {
    let number = |name: &str| usize::try_from(problem[name].as_u64().unwrap()).unwrap();
    let text = text.replace("\r\n", "\u{1}\n").replace('\r', "\n").replace("\u{1}\n", "\r\n");
    let mark = if text.starts_with('\u{feff}') { 3 } else { 0 };
    let place = |byte: usize| {
        let before = &text[mark..byte.max(mark)];
        (1 + before.matches('\n').count(), 1 + before.chars().rev().take_while(|c| *c != '\n').count())
    };
    assert_eq!((number("line"), number("column")), place(number("start_byte")), "{problem}");
    assert_eq!((number("end_line"), number("end_column")), place(number("end_byte")), "{problem}");
}

#[test]
fn json_names_sound_suspicious_and_missing_files() {
    let place = Place::with(&[("good.ron", SCENE), ("s.ron", SUSPICIOUS)]);
    let run = place.run(&["check", "--format", "json", "good.ron", "s.ron"]).status(0);
    let files = json(&run.stdout());
    let [good, suspicious] = &files[..] else { panic!("two files") };
    assert_eq!((good["ok"].as_bool(), good["problems"].as_array().unwrap().len()), (Some(true), 0));
    assert_eq!(suspicious["ok"], true);
    let severities: Vec<_> = suspicious["problems"].as_array().unwrap().iter().map(|p| p["severity"].clone()).collect();
    assert_eq!(severities, ["warning"; 4]);
    let run = place.run(&["check", "--format", "json", "missing.ron", "good.ron"]).status(1);
    assert_eq!(run.stderr(), "");
    let files = json(&run.stdout());
    assert_eq!(files[0]["problems"][0]["message"], "cannot be read: there is no such file or folder");
    assert_eq!((files[0]["ok"].as_bool(), files[1]["ok"].as_bool()), (Some(false), Some(true)));
    assert_eq!(files[0]["problems"][0]["line"], Value::Null);
    let run = place.feed(&["check", "--format", "json", "-"], "(titel: 1)").status(1);
    assert_eq!(json(&run.stdout())[0]["file"], "<stdin>");
}

#[test]
fn no_scene_of_the_collection_and_no_template_brings_a_warning() {
    let chapters = fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes")).unwrap();
    let scenes = chapters.flat_map(|chapter| fs::read_dir(chapter.unwrap().path()).unwrap());
    let mut scenes: Vec<String> = scenes.map(|scene| scene.unwrap().path().to_str().unwrap().to_owned()).collect();
    let place = Place::new();
    for template in ["minimal", "prism", "lens", "tir", "mirror"] {
        fs::write(place.path(template), place.run(&["new", template]).clean()).unwrap();
        scenes.push(template.to_owned());
    }
    let arguments: Vec<&str> = std::iter::once("check").chain(scenes.iter().map(String::as_str)).collect();
    let verdicts = place.run(&arguments).clean();
    assert_eq!(verdicts.lines().count(), scenes.len());
}
