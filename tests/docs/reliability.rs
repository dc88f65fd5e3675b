//! Every line of docs/reliability.md can be run again.

use std::fs;

use crate::page::{Page, root};

/// The Rust files of a test: its own and those in the folder of its name.
fn sources(test: &str) -> String {
    let folder = fs::read_dir(root().join("tests").join(test)).into_iter().flatten();
    let files = folder.map(|entry| entry.unwrap().path()).filter(|path| path.extension().is_some_and(|e| e == "rs"));
    let own = root().join(format!("tests/{test}.rs"));
    files
        .chain([own])
        .map(|path| fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path:?}: {error}")))
        .collect()
}

/// Whether a name filters out at least one test.
fn finds(sources: &str, filter: &str) -> bool {
    let lines = || sources.lines().map(str::trim);
    lines().any(|line| line.strip_prefix("fn ").is_some_and(|rest| rest.split('(').next().unwrap().contains(filter)))
        || lines().any(|line| line == format!("mod {filter};"))
}

#[test]
fn every_command_of_the_page_runs_something() {
    let page = Page::read("docs/reliability.md");
    let code =
        page.prose.lines().filter(|line| line.starts_with('|')).flat_map(|line| line.split('`').skip(1).step_by(2));
    let mut tests = 0;
    for command in code.filter(|code| code.contains("cargo test") || code.starts_with("fuzz/")) {
        if let Some(rest) = command.strip_prefix("fuzz/run.sh ") {
            let target = rest.split_whitespace().nth(1).unwrap();
            assert!(root().join(format!("fuzz/fuzz_targets/{target}.rs")).exists(), "{command}");
            continue;
        }
        let mut words = command.split_whitespace().skip_while(|word| *word != "--test").skip(1);
        let test = sources(words.next().unwrap());
        assert!(words.next().is_none_or(|filter| finds(&test, filter)), "{command} runs nothing");
        tests += 1;
    }
    assert!(tests > 25, "{tests}");
    assert!(!finds("fn other() {}\n// mod access;\n", "access"));
}

#[test]
fn its_counts_are_those_of_the_project() {
    let page = Page::read("docs/reliability.md");
    let invalid = fs::read_dir(root().join("tests/invalid")).unwrap().count();
    assert!(page.prose.contains(&format!("{invalid} scenes in `tests/invalid/`")), "{invalid}");
    assert!(page.prose.contains(&format!("all {}, and hostile", snellius::scene::Limit::ALL.len())));
    let counts =
        [("cli/crash", "const KILLED: u32 = ", " runs killed"), ("public_api/hostile", "[f64; ", " extreme numbers")];
    for (file, before, after) in counts {
        let text = fs::read_to_string(root().join(format!("tests/{file}.rs"))).unwrap();
        let number: String = text.split_once(before).unwrap().1.chars().take_while(char::is_ascii_digit).collect();
        assert!(page.prose.contains(&format!("{number}{after}")), "{number}{after}");
    }
}
