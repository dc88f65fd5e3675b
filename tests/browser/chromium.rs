//! A browser without a window.

use std::fs;
use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use snellius::drawing::Font;
use tempfile::TempDir;
use tiny_skia::Pixmap;

const PROGRAMS: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "chromium-headless-shell"];
/// Longer than any page takes.
const PATIENCE: Duration = Duration::from_secs(100);

/// A browser with a folder for its pages, and with the font of figures and no other.
pub(crate) struct Chromium {
    program: &'static str,
    folder: TempDir,
}

impl Chromium {
    /// The browser of this machine; without one it is said loudly, or the test fails if one is required.
    pub(crate) fn find(test: &str) -> Option<Self> {
        let runs =
            |program: &&&str| Command::new(program).arg("--version").output().is_ok_and(|run| run.status.success());
        let Some(program) = PROGRAMS.iter().find(runs) else {
            let cure = "install it (Debian: apt-get install chromium) and run cargo test --test browser";
            let is_required = std::env::var("SNELLIUS_BROWSER").is_ok_and(|value| value == "required");
            assert!(!is_required, "{test}: Chromium is not found: {cure}");
            // Past the test runner, which shows no word of a test that passes.
            let _ = writeln!(std::io::stderr(), "SKIPPED: browser test {test}: Chromium is not found: {cure}");
            return None;
        };
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().display();
        for (name, font) in [("r.ttf", Font::Regular), ("b.ttf", Font::Bold), ("o.ttf", Font::Oblique)] {
            fs::write(folder.path().join(name), font.data()).unwrap();
        }
        let fonts = format!("<fontconfig><dir>{path}</dir><cachedir>{path}/cache</cachedir></fontconfig>");
        fs::write(folder.path().join("fonts.conf"), fonts).unwrap();
        Some(Self { program, folder })
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Puts a file beside its pages.
    pub(crate) fn put(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).unwrap();
    }

    /// What a file has become once it is loaded and its scripts have run.
    pub(crate) fn dom(&self, name: &str) -> String {
        let run = self.run(&["--dump-dom"], name);
        let dom = String::from_utf8(run.stdout).unwrap();
        assert!(dom.contains('<'), "{name}: {}", String::from_utf8_lossy(&run.stderr));
        dom
    }

    /// What it shows of a file.
    pub(crate) fn picture(&self, name: &str, [width, height]: [u32; 2]) -> Pixmap {
        let (size, file) = (format!("--window-size={width},{height}"), self.path("picture.png"));
        let run = self.run(&[&size, &format!("--screenshot={}", file.display())], name);
        let picture = Pixmap::load_png(&file)
            .unwrap_or_else(|error| panic!("{name}: {error}: {}", String::from_utf8_lossy(&run.stderr)));
        assert_eq!([picture.width(), picture.height()], [width, height]);
        picture
    }

    fn run(&self, arguments: &[&str], name: &str) -> Output {
        let mut command = Command::new(self.program);
        // The superuser's browser has no sandbox. Files may look into each other, as those of one site may.
        command.args([
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--allow-file-access-from-files",
            "--hide-scrollbars",
        ]);
        command.args([
            "--force-device-scale-factor=1",
            "--disable-lcd-text",
            "--font-render-hinting=none",
            "--no-first-run",
        ]);
        command.arg(format!("--user-data-dir={}", self.path("profile").display())).args(arguments);
        command.arg(format!("file://{}", self.path(name).display()));
        command.env("FONTCONFIG_FILE", self.path("fonts.conf")).env("HOME", self.folder.path()).stdin(Stdio::null());
        let output = |name| fs::File::create(self.path(name)).unwrap();
        let mut child = command.stdout(output("stdout")).stderr(output("stderr")).spawn().unwrap();
        let since = Instant::now();
        let status = loop {
            if let Some(status) = child.try_wait().unwrap() {
                break status;
            }
            if since.elapsed() > PATIENCE {
                child.kill().unwrap();
            }
            sleep(Duration::from_millis(20));
        };
        let read = |name| fs::read(self.path(name)).unwrap();
        Output { status, stdout: read("stdout"), stderr: read("stderr") }
    }
}
