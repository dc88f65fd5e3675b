//! Files that nobody means as scenes: a clear answer to each.

use std::fs::{self, File};

use crate::place::{Place, SCENE};

/// What `check` says of a file with these bytes.
fn told(bytes: &[u8]) -> String {
    let place = Place::new();
    fs::write(place.path("a.ron"), bytes).unwrap();
    place.run(&["check", "a.ron"]).status(1).stderr()
}

#[test]
fn a_file_of_a_hundred_megabytes_is_refused() {
    let place = Place::new();
    File::create(place.path("big.ron")).unwrap().set_len(100 << 20).unwrap();
    let told = place.run(&["check", "big.ron"]).status(1).stderr();
    assert!(told.starts_with("big.ron: ") && told.contains("too long for a scene"), "{told}");
}

#[test]
fn marks_and_line_ends_of_all_systems_are_read() {
    let place = Place::new();
    let comment = SCENE.replacen('(', "( // a comment", 1);
    fs::write(place.path("mark.ron"), format!("\u{feff}{SCENE}")).unwrap();
    fs::write(place.path("windows.ron"), comment.replace('\n', "\r\n")).unwrap();
    fs::write(place.path("mac.ron"), comment.replace('\n', "\r")).unwrap();
    let verdict = place.run(&["check", "mark.ron", "windows.ron", "mac.ron"]).clean();
    assert_eq!(verdict, "mark.ron: ok\nwindows.ron: ok\nmac.ron: ok\n");
    let wrong = comment.replace("Rectangle(20", "Rectangle(-20");
    for (end, line) in [("\r\n", "a.ron:4:42: error"), ("\r", "a.ron:4:42: error")] {
        let told = told(wrong.replace('\n', end).as_bytes());
        assert!(told.starts_with(line), "{told}");
        assert!(!told.contains('\r'), "{told:?}");
    }
}

#[test]
fn what_holds_no_scene_is_told() {
    for nothing in ["", "\n\n", "// only\n/* comments */", "\u{feff}"] {
        assert!(told(nothing.as_bytes()).starts_with("a.ron:1:1: error: the file holds no scene\n"), "{nothing:?}");
    }
    let utf_16: Vec<u8> = "\u{feff}(title: \"a\")".encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert!(told(&utf_16).starts_with("a.ron:1:1: error: this is text in UTF-16, not a scene\n"));
    assert!(told(b"\x89PNG\r\n\x1a\n\0\0").starts_with("a.ron:1:1: error: this is a PNG picture, not a scene\n"));
    assert!(told(b"(\n title: \"Pr\xe9s\")").contains("a.ron:2:12: error: the file is not text in UTF-8\n"));
    assert!(told("(".repeat(1_000_000).as_bytes()).contains("nested too deep"));
}

#[cfg(unix)]
#[test]
fn what_is_no_file_is_told() {
    let place = Place::new();
    let told = place.run(&["check", "/dev/null", "."]).status(1).stderr();
    assert!(told.contains("/dev/null:1:1: error: the file holds no scene"), "{told}");
    assert!(told.contains(".: cannot be read: this is a folder, not a file"), "{told}");
    assert!(std::process::Command::new("mkfifo").arg(place.path("pipe")).status().unwrap().success());
    let mut writer =
        std::process::Command::new("sh").args(["-c", ": > pipe"]).current_dir(place.path("")).spawn().unwrap();
    let told = place.run(&["check", "pipe"]).status(1).stderr();
    assert!(told.starts_with("pipe:1:1: error: the file holds no scene"), "{told}");
    assert!(writer.wait().unwrap().success());
}

#[test]
fn of_a_very_long_line_only_the_place_is_shown() {
    let points = "(0, 0), ".repeat(1_250_000);
    let told = told(format!("(bodies: [(shape: Polygon([{points}]), medium: Index(0.5))])").as_bytes());
    assert!(told.contains("a.ron:1:10000046: error: the refractive index is 0.5"), "{told}");
    assert!(told.lines().all(|line| line.chars().count() < 300) && told.len() < 3000, "{} bytes", told.len());
}

/// Whether a terminal would do anything but write.
fn commands(text: &str) -> bool {
    text.contains(|c: char| {
        c.is_control() && c != '\n'
            || matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
    })
}

#[test]
fn nothing_in_a_scene_or_its_name_commands_the_terminal() {
    let hostile = "\u{1b}]0;owned\u{7}\u{1b}[2J\u{9b}31m\u{202e}\u{2066}\u{200f}";
    let place = Place::new();
    let texts = [
        format!("(titel{hostile}: \"a\")"),
        format!("({hostile}title: \"a\")"),
        format!(
            "(title: \"a\", bodies: [(name: \"{hostile}\", shape: Disk(-4), medium: Catalog(\"{hostile}\"), color: \"{hostile}\")])"
        ),
        format!(
            "(bodies: [(name: \"{hostile}\", shape: Disk(4), at: (0, 90), medium: Index(1.5))], sources: [(light: Ray(from: (0, 0), direction: Angle(0)))])"
        ),
        format!("/* {hostile} */ (titel: 1) {hostile}"),
    ];
    for (k, text) in texts.iter().enumerate() {
        let file = format!("{k}{}.ron", if cfg!(unix) { hostile } else { "" });
        fs::write(place.path(&file), text).unwrap();
        for run in [
            place.run(&["check", &file]),
            place.run(&["trace", &file, "-o", "a.json"]),
            place.run(&["check", &format!("missing{hostile}")]),
        ] {
            assert!(!commands(&run.stderr()) && !run.stderr().is_empty(), "{k}: {:?}", run.stderr());
            assert!(!commands(&run.stdout()), "{k}: {:?}", run.stdout());
        }
    }
}
