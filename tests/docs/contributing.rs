//! What is told to contributors is true, and every system passes the same steps.

use std::fs;

use crate::page::{Page, root};

fn read(name: &str) -> String {
    fs::read_to_string(root().join(name)).unwrap()
}

/// The steps that `.ci/run` takes when none is named.
fn steps() -> Vec<String> {
    let script = read(".ci/run");
    let all = script.lines().find_map(|line| line.split_once("|| set -- ")).unwrap().1.to_owned();
    let steps: Vec<String> = all.split_whitespace().map(str::to_owned).collect();
    for step in &steps {
        assert!(script.contains(&format!("\n{step}() {{\n")), "{step} is no step");
    }
    assert!(steps.len() > 4);
    steps
}

#[test]
fn every_system_passes_the_steps_of_the_script() {
    let workflow = read(".github/workflows/ci.yml");
    let job = workflow.split("\n  stable:\n").nth(1).unwrap().split("\n\n").next().unwrap();
    let run: Vec<&str> = job.lines().filter_map(|line| line.trim().strip_prefix("- run: .ci/run ")).collect();
    assert_eq!(run, steps());
    for system in ["ubuntu-latest", "macos-latest", "windows-latest"] {
        assert!(job.contains(system), "{system}");
    }
}

#[test]
fn every_file_and_name_that_contributors_are_sent_to_exists() {
    let page = Page::read("CONTRIBUTING.md");
    let names: Vec<&str> = page.prose.split('`').skip(1).step_by(2).collect();
    let files: Vec<&&str> = names.iter().filter(|name| name.contains('/') && !name.contains([' ', '<'])).collect();
    assert!(files.len() > 12, "{files:?}");
    for file in files {
        assert!(root().join(file).exists(), "{file}");
    }
    for command in names.iter().filter(|name| name.contains("cargo test")) {
        let words = command.split_whitespace();
        let test = words.skip_while(|word| *word != "--test").nth(1);
        assert!(test.is_none_or(|test| root().join(format!("tests/{test}.rs")).exists()), "{command}");
    }
    for step in names.iter().filter_map(|name| name.strip_prefix(".ci/run ")).flat_map(str::split_whitespace) {
        assert!(steps().iter().any(|known| known == step), "{step}");
    }
}
