//! Data flows one way: a module imports only modules that stand above it in one list. Rust itself allows cycles.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::fs;
use std::path::{Path, PathBuf};

/// Every module of the crate; each may use those before it.
const MODULES: [&str; 14] = [
    "numerics", "geometry", "light", "media", "laws", "scene", "system", "compile", "trace", "report", "drawing",
    "diagram", "render", "cli",
];

#[test]
fn modules_use_only_those_before_them() {
    let exports = exports(&read(&source().join("lib.rs")));
    let mut wrong = Vec::new();
    for file in rust_files(&source()) {
        let Some(module) = module_of(&file) else { continue };
        for used in upward(&module, &read(&file), &exports) {
            wrong.push(format!("{}: `{module}` uses `{used}`, which stands after it", file.display()));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_list_holds_every_module() {
    let mut found: Vec<String> = rust_files(&source()).iter().filter_map(|file| module_of(file)).collect();
    found.sort();
    found.dedup();
    let mut listed = MODULES;
    listed.sort_unstable();
    assert_eq!(found, listed);
}

#[test]
fn a_use_of_a_later_module_is_found_in_every_form() {
    let exports = exports("pub use scene::{Scene, Problem};\npub use system::OpticalSystem;\n");
    let later = |code| upward("light", code, &exports);
    assert_eq!(later("use crate::trace::RayTree;"), ["trace"]);
    assert_eq!(later("use crate::{numerics::Sum, cli, render::{svg, png}};"), ["cli", "render"]);
    assert_eq!(later("fn f() -> crate::laws::Refracted { crate::numerics::exp(1.0) }"), ["laws"]);
    assert_eq!(
        later("pub(in crate::light) use crate::OpticalSystem as System;"),
        ["system"],
        "through the crate's root"
    );
    assert_eq!(later("use crate :: { Scene };"), ["scene"]);
    assert_eq!(later("use crate::*;"), ["*"], "everything is too much");
}

#[test]
fn what_is_allowed_passes() {
    let exports = exports("pub use system::OpticalSystem;\n");
    for code in [
        "use crate::numerics::{Sum, exp};",
        "use crate::geometry::Curve; use crate::light::Power;",
        "// see crate::trace\n/// [`System`](crate::OpticalSystem)\nuse std::fmt;",
    ] {
        assert_eq!(upward("light", code, &exports), Vec::<String>::new(), "{code}");
    }
}

/// The modules that some code uses though they do not stand before its own.
fn upward(module: &str, code: &str, exports: &[(String, String)]) -> Vec<String> {
    let place = |name: &str| MODULES.iter().position(|listed| *listed == name);
    let own = place(module);
    let through_root = |name: String| {
        let export = exports.iter().find(|(exported, _)| *exported == name);
        export.map_or(name, |(_, module)| module.clone())
    };
    let later = |name: &String| place(name).is_none() || place(name) > own;
    used(code, "crate").into_iter().map(through_root).filter(later).collect()
}

/// The first names after `root::` wherever it occurs, those of a braced group each.
fn used(code: &str, root: &str) -> Vec<String> {
    let code: String = code.lines().map(|line| line.split("//").next().unwrap_or("")).collect::<Vec<_>>().join(" ");
    let mut names = Vec::new();
    for (at, _) in code.match_indices(root) {
        let before = code[..at].chars().next_back();
        let path = code[at + root.len()..].trim_start();
        if before.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == '$') || !path.starts_with("::") {
            continue;
        }
        let path = path[2..].trim_start();
        match path.strip_prefix('{') {
            Some(group) => names.extend(first_names(group)),
            None => names.extend(first_name(path)),
        }
    }
    names
}

/// The first name of each path in a group that was opened already.
fn first_names(group: &str) -> Vec<String> {
    let (mut depth, mut start, mut names) = (0, 0, Vec::new());
    for (at, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth > 0 => depth -= 1,
            ',' | '}' if depth == 0 => {
                names.extend(first_name(group[start..at].trim_start()));
                start = at + 1;
            }
            _ => {}
        }
        if c == '}' && start == at + 1 {
            break;
        }
    }
    names
}

fn first_name(path: &str) -> Option<String> {
    if path.starts_with('*') {
        return Some("*".into());
    }
    let name: String = path.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
    (!name.is_empty()).then_some(name)
}

/// What the crate's root exports, each name with the module that it comes from.
fn exports(lib: &str) -> Vec<(String, String)> {
    let statements = lib.split(';').filter_map(|statement| statement.split("pub use ").nth(1));
    let exported = statements.filter_map(|path| path.split_once("::")).flat_map(|(module, rest)| {
        let names = rest.strip_prefix('{').map_or_else(|| first_name(rest).into_iter().collect(), first_names);
        names.into_iter().map(move |name| (name, module.to_owned()))
    });
    exported.collect()
}

/// The module that a file belongs to; the crate's roots belong to none.
fn module_of(file: &Path) -> Option<String> {
    let inside = file.strip_prefix(source()).unwrap();
    let first = Path::new(inside.iter().next().unwrap()).with_extension("");
    let name = first.to_str().unwrap().to_owned();
    (name != "lib" && name != "main").then_some(name)
}

fn source() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

fn read(file: &Path) -> String {
    fs::read_to_string(file).unwrap()
}

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files.sort();
    files
}
