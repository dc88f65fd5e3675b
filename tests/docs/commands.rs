//! Command lines that are shown, and what they print.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use tempfile::TempDir;

use crate::page::{Page, pages, root};

/// A folder with the named scenes of a page.
pub(crate) fn folder(page: &Page) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for block in page.marked("ron") {
        let name = block.text.lines().next().and_then(|line| line.strip_prefix("// "));
        if let Some(name) = name.filter(|name| name.ends_with(".ron") && !name.contains(' ')) {
            fs::write(folder.path().join(name), &block.text).unwrap();
        }
    }
    folder
}

/// What runs in a page's folder for a command line that it shows; `None` for one that is not this program's.
fn runnable(line: &str) -> Option<String> {
    let line = line.strip_prefix("$ ").unwrap_or(line);
    if line == "snellius" || line.starts_with("snellius ") {
        return Some(line.into());
    }
    // From the project's own folder: its scenes are meant.
    let (_, arguments) = line.strip_prefix("cargo run ")?.split_once("-- ")?;
    Some(format!("snellius {arguments}").replace(" scenes/", &format!(" {}/scenes/", root().display())))
}

/// Runs a command line and returns what it prints.
pub(crate) fn run(line: &str, folder: &Path) -> Result<String, String> {
    let program = Path::new(env!("CARGO_BIN_EXE_snellius"));
    let path = std::env::var("PATH").unwrap_or_default();
    let path = format!("{}:{path}", program.parent().unwrap().display());
    let mut command = Command::new("sh");
    command.args(["-c", line]).current_dir(folder).env("PATH", path).stdin(Stdio::null());
    let output = command.output().unwrap();
    let [stdout, stderr] = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    if output.status.success() { Ok(stdout) } else { Err(format!("{line}\n{stdout}{stderr}")) }
}

#[cfg(unix)]
#[test]
fn every_command_line_runs_and_prints_what_is_shown() {
    for page in pages() {
        let folder = folder(&page);
        let mut printed = String::new();
        for block in &page.blocks {
            match block.mark.as_str() {
                "sh" => {
                    let lines = block.text.lines().filter(|line| !line.trim().is_empty() && !line.starts_with('#'));
                    for line in lines {
                        let Some(line) = runnable(line) else {
                            let is_script = root().join(line).is_file();
                            assert!(is_script || line.starts_with("cargo ") || line.starts_with("git "), "{line}");
                            continue;
                        };
                        printed =
                            run(&line, folder.path()).unwrap_or_else(|error| panic!("{}: {error}", page.place(block)));
                    }
                }
                "text" if block.follows => assert_eq!(block.text, printed, "{}", page.place(block)),
                _ => {}
            }
        }
    }
}
