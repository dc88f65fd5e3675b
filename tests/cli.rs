//! Every command and flag through the real program: results, streams, files and exit statuses.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use tempfile::TempDir;

const TEMPLATES: [&str; 5] = ["minimal", "prism", "lens", "tir", "mirror"];

const SCENE: &str = r#"(
    title: "Into glass",
    bodies: [
        (name: "glass", shape: Rectangle(20, 20), medium: Index(1.5)),
        (name: "wall", shape: Flat(from: (30, -20), to: (30, 20)), surface: Screen),
    ],
    sources: [(light: Ray(from: (-30, 0), direction: Angle(0)))],
)
"#;

/// A folder of its own for one test, in which the program runs.
struct Place(TempDir);

impl Place {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn with(files: &[(&str, &str)]) -> Self {
        let place = Self::new();
        for (name, text) in files {
            fs::write(place.path(name), text).unwrap();
        }
        place
    }

    fn path(&self, name: &str) -> std::path::PathBuf {
        self.0.path().join(name)
    }

    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_snellius"));
        command.args(arguments).current_dir(self.0.path()).stdin(Stdio::null());
        command
    }

    fn run(&self, arguments: &[&str]) -> Run {
        Run(self.command(arguments).output().unwrap())
    }

    /// Runs with this on standard input.
    fn feed(&self, arguments: &[&str], input: &str) -> Run {
        let mut command = self.command(arguments);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        // A program that refuses its arguments reads nothing.
        let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
        Run(child.wait_with_output().unwrap())
    }

    fn files(&self) -> Vec<String> {
        let mut names: Vec<_> = fs::read_dir(self.0.path())
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }
}

struct Run(Output);

impl Run {
    fn stdout(&self) -> String {
        String::from_utf8(self.0.stdout.clone()).unwrap()
    }

    fn stderr(&self) -> String {
        String::from_utf8(self.0.stderr.clone()).unwrap()
    }

    #[track_caller]
    fn status(self, expected: i32) -> Self {
        assert_eq!(self.0.status.code(), Some(expected), "stdout:\n{}\nstderr:\n{}", self.stdout(), self.stderr());
        self
    }

    /// All done and nothing to complain of.
    #[track_caller]
    fn clean(self) -> String {
        let run = self.status(0);
        assert_eq!(run.stderr(), "");
        run.stdout()
    }

    /// Refused because of the command line: a word on why and how, no result.
    #[track_caller]
    fn refused(self, why: &str) {
        let run = self.status(2);
        assert_eq!(run.stdout(), "");
        assert!(run.stderr().contains(why) && run.stderr().contains("--help"), "{}", run.stderr());
    }
}

#[track_caller]
fn assert_svg(path: &Path) {
    let text = fs::read_to_string(path).unwrap();
    assert!(text.starts_with('<') && text.contains("<svg") && text.trim_end().ends_with("</svg>"));
}

#[track_caller]
fn assert_png(bytes: &[u8]) {
    assert_eq!(bytes.get(..8), Some(b"\x89PNG\r\n\x1a\n".as_slice()));
}

// The program as a whole.

#[test]
fn help_and_version_are_results() {
    let place = Place::new();
    let help = place.run(&["--help"]).clean();
    for command in ["render", "trace", "check", "materials", "new"] {
        assert!(help.contains(command), "{help}");
        assert!(place.run(&[command, "--help"]).clean().contains("Usage:"));
    }
    assert!(!help.contains("explain"));
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
    for arguments in [&["trace", "a.ron"][..], &["materials"], &["new", "lens"], &["check", "a.ron"], &["--help"]] {
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
    let run = place.run(&["trace", "a.ron", "-o", "/dev/full", "--format", "json"]).status(1);
    assert!(run.stderr().contains("no space is left"));
}

// Problems.

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
    for command in ["trace", "render"] {
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

// check, materials, new.

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

// trace.

#[test]
fn trace_has_four_forms() {
    let place = Place::with(&[("a.ron", SCENE)]);
    let text = place.run(&["trace", "a.ron"]).clean();
    assert_eq!(place.run(&["trace", "a.ron", "--format", "text"]).clean(), text);
    assert!(text.starts_with("Into glass\n") && text.contains("0.0:tt "), "{text}");

    let json: serde_json::Value =
        serde_json::from_str(&place.run(&["trace", "a.ron", "--format", "json"]).clean()).unwrap();
    assert_eq!(json["schema"], 1);
    assert_eq!(json["rays"][0]["segments"][0]["hit"]["body"], "glass");
    assert_eq!(json["screens"][0]["hits"][0]["position"], 20.0);

    let csv = place.run(&["trace", "a.ron", "--format", "csv"]).clean();
    assert!(csv.starts_with("source,ray,wavelength_nm,id,parent,via,"));
    assert_eq!(csv.lines().count() as u64, 1 + json["counts"]["segments"].as_u64().unwrap());

    let summary: serde_json::Value =
        serde_json::from_str(&place.run(&["trace", "a.ron", "--format", "summary"]).clean()).unwrap();
    assert!(summary.get("rays").is_none());
    assert_eq!(summary["power_balance"], json["power_balance"]);
    assert_eq!(summary["screens"], json["screens"]);
    place.run(&["trace", "a.ron", "--format", "yaml"]).refused("invalid value 'yaml'");
}

#[test]
fn trace_reads_and_writes_the_standard_streams() {
    let place = Place::with(&[("a.ron", SCENE)]);
    let text = place.run(&["trace", "a.ron"]).clean();
    assert_eq!(place.feed(&["trace", "-"], SCENE).clean(), text);
    assert_eq!(place.feed(&["trace", "-", "-o", "-"], SCENE).clean(), text);
    assert_eq!(place.feed(&["trace", "-"], &format!("\u{feff}{SCENE}")).clean(), text, "with an editor's mark");
}

#[test]
fn trace_writes_a_file_in_the_form_of_its_extension() {
    let place = Place::with(&[("a.ron", SCENE)]);
    for (file, format) in [("o.txt", "text"), ("o.json", "json"), ("o.CSV", "csv")] {
        assert_eq!(place.run(&["trace", "a.ron", "-o", file]).clean(), "");
        let printed = place.run(&["trace", "a.ron", "--format", format]).clean();
        assert_eq!(fs::read_to_string(place.path(file)).unwrap(), printed);
    }
    assert_eq!(place.run(&["trace", "a.ron", "-o", "o.dat", "--format", "summary"]).clean(), "");
    place.run(&["trace", "a.ron", "-o", "o.xml"]).refused("'o.xml'");
    place.run(&["trace", "a.ron", "-o", "a.ron", "--format", "json"]).refused("would overwrite the scene 'a.ron'");
    assert_eq!(place.files(), ["a.ron", "o.CSV", "o.dat", "o.json", "o.txt"]);
}

#[test]
fn stats_go_to_standard_error() {
    let place = Place::with(&[("a.ron", SCENE)]);
    let plain = place.run(&["trace", "a.ron"]).clean();
    let run = place.run(&["trace", "a.ron", "--stats"]).status(0);
    assert_eq!(run.stdout(), plain);
    for word in ["stats of a.ron", "interfaces", "rays", "segments", "cut_min_power", "compile", "trace", " ms"] {
        assert!(run.stderr().contains(word), "{word} in\n{}", run.stderr());
    }
    let run = place.run(&["trace", "a.ron", "--stats", "--format", "summary"]).status(0);
    assert!(run.stderr().contains("interfaces"));
    let run = place.run(&["render", "a.ron", "--stats"]).status(0);
    assert!(run.stderr().contains("draw"));
    assert_eq!(run.stdout(), "a.svg\n");
}

// render.

#[test]
fn render_draws_an_svg_under_the_stem_into_the_current_directory() {
    let place = Place::new();
    fs::create_dir(place.path("scenes")).unwrap();
    fs::write(place.path("scenes/in.glass.ron"), SCENE).unwrap();
    assert_eq!(place.run(&["render", "scenes/in.glass.ron"]).clean(), "in.glass.svg\n");
    assert_svg(&place.path("in.glass.svg"));
    assert_eq!(place.feed(&["render", "-"], SCENE).clean(), "stdin.svg\n");
    assert_eq!(place.files(), ["in.glass.svg", "scenes", "stdin.svg"]);
}

#[test]
fn render_to_a_file_follows_its_extension() {
    let place = Place::with(&[("a.ron", SCENE)]);
    assert_eq!(place.run(&["render", "a.ron", "-o", "x.svg"]).clean(), "x.svg\n");
    assert_svg(&place.path("x.svg"));
    assert_eq!(place.run(&["render", "a.ron", "-o", "x.PNG"]).clean(), "x.PNG\n");
    assert_png(&fs::read(place.path("x.PNG")).unwrap());
    assert_eq!(place.run(&["render", "a.ron", "-o", "picture", "--format", "png"]).clean(), "picture\n");
    assert_png(&fs::read(place.path("picture")).unwrap());
    place.run(&["render", "a.ron", "-o", "x.pdf"]).refused("neither svg nor png");
    place.run(&["render", "a.ron", "-o", "x"]).refused("neither svg nor png");
    assert_eq!(place.files(), ["a.ron", "picture", "x.PNG", "x.svg"]);
}

#[test]
fn render_to_standard_output_prints_no_path() {
    let place = Place::with(&[("a.ron", SCENE)]);
    let svg = place.run(&["render", "a.ron", "-o", "-"]).clean();
    place.run(&["render", "a.ron"]).clean();
    assert_eq!(fs::read_to_string(place.path("a.svg")).unwrap(), svg);
    let png = place.run(&["render", "a.ron", "-o", "-", "--format", "png"]).status(0);
    assert_png(&png.0.stdout);
}

#[test]
fn render_many_into_a_folder() {
    let place = Place::with(&[("a.ron", SCENE), ("b.ron", SCENE), ("bad.ron", "(title: 1)")]);
    let run = place.run(&["render", "a.ron", "bad.ron", "b.ron", "--out-dir", "out/deep", "--format", "svg,png"]);
    let run = run.status(1);
    let paths: Vec<_> = run.stdout().lines().map(String::from).collect();
    let expected = ["a.svg", "a.png", "b.svg", "b.png"].map(|name| Path::new("out/deep").join(name));
    assert_eq!(paths, expected.each_ref().map(|path| path.display().to_string()), "one bad scene stops no other");
    assert!(run.stderr().starts_with("bad.ron:1:"), "{}", run.stderr());
    assert_svg(&place.path("out/deep/a.svg"));
    assert_png(&fs::read(place.path("out/deep/b.png")).unwrap());
}

#[test]
fn render_refuses_what_would_overwrite() {
    let place = Place::with(&[("a.ron", SCENE), ("b.ron", SCENE), ("c.svg", SCENE)]);
    fs::create_dir(place.path("sub")).unwrap();
    fs::write(place.path("sub/a.ron"), SCENE).unwrap();
    place.run(&["render", "a.ron", "b.ron", "-o", "x.svg"]).refused("several scenes");
    place.run(&["render", "a.ron", "sub/a.ron", "--out-dir", "out"]).refused("two scenes");
    place.run(&["render", "a.ron", "sub/a.ron"]).refused("two scenes");
    place.run(&["render", "a.ron", "-o", "x.svg", "--format", "svg,png"]).refused("several formats");
    place.run(&["render", "a.ron", "-o", "x.svg", "--out-dir", "out"]).refused("--out-dir");
    place.run(&["render", "a.ron", "--format", "gif"]).refused("invalid value 'gif'");
    place.run(&["render", "c.svg"]).refused("would overwrite the scene 'c.svg'");
    place.run(&["render", "a.ron", "-o", "sub/../a.ron", "--format", "svg"]).refused("would overwrite");
    assert_eq!(place.files(), ["a.ron", "b.ron", "c.svg", "sub"]);
}

// Files.

#[test]
fn a_file_appears_whole_or_not_at_all() {
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
    assert!(run.stderr().starts_with("a.ron: cannot be made"), "{}", run.stderr());
    assert_eq!(place.files(), ["a.ron", "a.svg", "bad.ron", "bad.svg", "folder.svg"], "and nothing is left behind");
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
