//! Command lines that are shown run as they stand, and print what is shown.

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use tempfile::TempDir;

use crate::page::{Block, Page, pages, root};

/// Command lines that need the project's own folder, word for word. They alone are not run with their page; what stands in
/// a block with one of them must be in this list too.
const IN_THE_REPOSITORY: [&str; 6] = [
    "cargo run --release -- render scenes/prisms/right-angle.ron",
    "cargo test",
    "cargo install --path .",
    "cargo bench --bench throughput",
    "docs/accuracy/regenerate.sh",
    "benches/instructions.sh",
];

/// A folder with the named scenes of a page.
pub(crate) fn folder(page: &Page) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    page.marked("ron").for_each(|block| write(block, folder.path()));
    folder
}

/// Writes a scene that has a name into the folder.
fn write(block: &Block, folder: &Path) {
    let name = block.text.lines().next().and_then(|line| line.strip_prefix("// "));
    if let Some(name) = name.filter(|name| name.ends_with(".ron") && !name.contains(' ')) {
        fs::write(folder.join(name), &block.text).unwrap();
    }
}

/// Runs a script and returns what it prints.
pub(crate) fn run(script: &str, folder: &Path) -> Result<String, String> {
    let output = shell(script, folder);
    let [stdout, stderr] = texts(&output);
    if output.status.success() { Ok(stdout) } else { Err(format!("{script}\n{stdout}{stderr}")) }
}

fn shell(script: &str, folder: &Path) -> Output {
    let program = Path::new(env!("CARGO_BIN_EXE_snellius"));
    let path = std::env::var("PATH").unwrap_or_default();
    let path = format!("{}:{path}", program.parent().unwrap().display());
    let mut command = Command::new("sh");
    command.args(["-e", "-c", script]).current_dir(folder).env("PATH", path).stdin(Stdio::null());
    command.output().unwrap()
}

fn texts(output: &Output) -> [String; 2] {
    [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes).into_owned())
}

/// Whether a block is for the project's own folder.
fn is_for_the_repository(block: &Block) -> bool {
    block.text.lines().any(|line| IN_THE_REPOSITORY.contains(&line))
}

/// Runs a page from top to bottom in a folder, which is empty at first.
pub(crate) fn run_page(page: &Page, folder: &Path) -> Result<(), String> {
    let mut printed = String::new();
    for block in &page.blocks {
        let place = page.place(block);
        match block.mark.as_str() {
            "ron" => write(block, folder),
            "sh" if is_for_the_repository(block) => {
                let other = block.text.lines().find(|line| !IN_THE_REPOSITORY.contains(line));
                other.map_or(Ok(()), |line| Err(format!("{place}: {line} is not in the list")))?;
            }
            "sh" => printed = run(&block.text, folder).map_err(|error| format!("{place}: {error}"))?,
            "sh fails" => {
                let output = shell(&block.text, folder);
                if output.status.success() {
                    return Err(format!("{place}: it does not fail"));
                }
                printed = texts(&output).concat();
            }
            "text" if block.follows && block.text != printed => {
                return Err(format!("{place}: it prints\n{printed}"));
            }
            _ => {}
        }
    }
    Ok(())
}

#[cfg(unix)]
#[test]
fn every_page_runs_and_prints_what_is_shown() {
    for page in pages() {
        let folder = tempfile::tempdir().unwrap();
        run_page(&page, folder.path()).unwrap_or_else(|error| panic!("{error}"));
    }
}

#[cfg(unix)]
#[test]
fn what_is_wrong_on_a_page_is_found() {
    let fault = |text: &str| run_page(&Page::parse("page", text), tempfile::tempdir().unwrap().path()).unwrap_err();
    assert!(fault("```sh\nsnellius new prsim > prism.ron\n```\n").starts_with("page:1: snellius new prsim"));
    assert!(fault("```sh\nsnellius chekc\nsnellius materials\n```\n").contains("chekc"), "not the last line alone");
    assert!(fault("```sh\nsnellius check prism.ron\n```\n").contains("prism.ron"), "no page sees another's files");
    assert!(fault("```sh\ncargo test\ncargo tset\n```\n").contains("cargo tset is not in the list"));
    assert!(fault("```sh\ncargo tset\n```\n").contains("tset"));
    assert!(fault("```sh fails\nsnellius materials\n```\n").contains("it does not fail"));
    assert!(fault("```sh\nsnellius materials water\n```\n\n```text\nwine\n```\n").contains("water"));
    let late = "```sh\nsnellius check a.ron\n```\n\n```ron\n// a.ron\n()\n```\n";
    assert!(fault(late).contains("a.ron"), "a file is there once it is shown");
}

#[cfg(unix)]
#[test]
fn every_command_line_for_the_repository_is_shown_and_there() {
    let pages = pages();
    let folder = tempfile::tempdir().unwrap();
    for line in IN_THE_REPOSITORY {
        let shows = |page: &Page| page.marked("sh").any(|block| block.text.lines().any(|shown| shown == line));
        assert!(pages.iter().any(shows), "{line} stands on no page");
        if let Some((_, arguments)) = line.split_once(" -- ") {
            let scenes = format!(" {}/scenes/", root().display());
            run(&format!("snellius {arguments}").replace(" scenes/", &scenes), folder.path()).unwrap();
        } else if let Some((_, bench)) = line.split_once("--bench ") {
            assert!(root().join(format!("benches/{bench}.rs")).exists(), "{line}");
        } else {
            assert!(line.starts_with("cargo ") || root().join(line).is_file(), "{line}");
        }
    }
}
