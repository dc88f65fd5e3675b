//! A folder to run the program in, and what comes of a run.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use tempfile::TempDir;

pub(crate) const SCENE: &str = r#"(
    title: "Into glass",
    bodies: [
        (name: "glass", shape: Rectangle(20, 20), medium: Index(1.5)),
        (name: "wall", shape: Flat(from: (30, -20), to: (30, 20)), surface: Screen),
    ],
    sources: [(light: Ray(from: (-30, 0), direction: Angle(0)))],
)
"#;

/// A folder of its own for one test, in which the program runs.
pub(crate) struct Place(TempDir);

impl Place {
    pub(crate) fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    pub(crate) fn with(files: &[(&str, &str)]) -> Self {
        let place = Self::new();
        for (name, text) in files {
            fs::write(place.path(name), text).unwrap();
        }
        place
    }

    pub(crate) fn path(&self, name: &str) -> std::path::PathBuf {
        self.0.path().join(name)
    }

    pub(crate) fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_snellius"));
        command.args(arguments).current_dir(self.0.path()).stdin(Stdio::null());
        command
    }

    pub(crate) fn run(&self, arguments: &[&str]) -> Run {
        Run(self.command(arguments).output().unwrap())
    }

    /// Runs a script, to which `$0` is the program, in a mount namespace of its own. `None`, which is told, where this user may
    /// not mount anything there; the script says so by status 99.
    #[cfg(target_os = "linux")]
    pub(crate) fn run_where_it_may_mount(&self, what: &str, script: &str) -> Option<Run> {
        let mut unshare = Command::new("unshare");
        unshare.args(["--mount", "sh", "-c", script, env!("CARGO_BIN_EXE_snellius")]).current_dir(self.path(""));
        let run = unshare.output().ok().filter(|output| output.status.code() == Some(0)).map(Run);
        if run.is_none() {
            skipped(what, "this user may not mount one with 'unshare --mount'");
        }
        run
    }

    /// Runs with this on standard input.
    pub(crate) fn feed(&self, arguments: &[&str], input: &str) -> Run {
        let mut command = self.command(arguments);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        // A program that refuses its arguments reads nothing.
        let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
        Run(child.wait_with_output().unwrap())
    }

    pub(crate) fn files(&self) -> Vec<String> {
        let mut names: Vec<_> = fs::read_dir(self.0.path())
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }
}

/// Says that something was not tried, past the test runner, which shows no word of a test that passes.
#[cfg(unix)]
pub(crate) fn skipped(what: &str, why: &str) {
    let _ = writeln!(std::io::stderr(), "SKIPPED: {what}: {why}");
}

pub(crate) struct Run(pub(crate) Output);

impl Run {
    pub(crate) fn stdout(&self) -> String {
        String::from_utf8(self.0.stdout.clone()).unwrap()
    }

    pub(crate) fn stderr(&self) -> String {
        String::from_utf8(self.0.stderr.clone()).unwrap()
    }

    #[track_caller]
    pub(crate) fn status(self, expected: i32) -> Self {
        assert_eq!(self.0.status.code(), Some(expected), "stdout:\n{}\nstderr:\n{}", self.stdout(), self.stderr());
        self
    }

    /// All done and nothing to complain of.
    #[track_caller]
    pub(crate) fn clean(self) -> String {
        let run = self.status(0);
        assert_eq!(run.stderr(), "");
        run.stdout()
    }

    /// Refused because of the command line: a word on why and how, no result.
    #[track_caller]
    pub(crate) fn refused(self, why: &str) {
        let run = self.status(2);
        assert_eq!(run.stdout(), "");
        assert!(run.stderr().contains(why) && run.stderr().contains("--help"), "{}", run.stderr());
    }
}

#[track_caller]
pub(crate) fn assert_svg(path: &Path) {
    let text = fs::read_to_string(path).unwrap();
    assert!(text.starts_with('<') && text.contains("<svg") && text.trim_end().ends_with("</svg>"));
}

#[track_caller]
pub(crate) fn assert_png(bytes: &[u8]) {
    assert_eq!(bytes.get(..8), Some(b"\x89PNG\r\n\x1a\n".as_slice()));
}
