//! Data flows one way: a module imports only modules that stand above it in one list. Rust itself allows cycles.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::fs;
use std::path::{Path, PathBuf};

/// Every module of the crate; each may use those before it.
const MODULES: [&str; 17] = [
    "characters",
    "numerics",
    "geometry",
    "light",
    "media",
    "laws",
    "scene",
    "system",
    "compile",
    "trace",
    "analysis",
    "report",
    "explain",
    "drawing",
    "diagram",
    "render",
    "cli",
];

#[test]
fn modules_use_only_those_before_them() {
    let exports = exports(&read(&source().join("lib.rs")));
    let mut wrong = Vec::new();
    for file in rust_files(&source()) {
        let Some(module) = module_of(&file) else { continue };
        for used in upward(&module, depth_of(&file), &read(&file), &exports) {
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
    let later = |code| upward("light", 1, code, &exports);
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
fn super_up_to_the_root_is_found_too() {
    let later = |depth, code| upward("light", depth, code, &[]);
    assert_eq!(later(1, "use super::trace::RayTree;"), ["trace"]);
    assert_eq!(later(1, "use super::{numerics::Sum, render::{svg, png}};"), ["render"]);
    assert_eq!(later(1, "fn f() -> super :: laws::Refracted { self::super::cli::run() }"), ["laws", "cli"]);
    assert_eq!(later(2, "use super::super::trace;"), ["trace"]);
    assert_eq!(later(2, "use super::{Power, super::{trace, numerics}};"), ["trace"]);
    assert_eq!(later(3, "use super::super::super::*;"), ["*"]);
    let inline = "mod tests {\n    use super::*;\n    use super::super::trace;\n}\nuse super::cli;\n";
    assert_eq!(later(1, inline), ["trace", "cli"], "an inline module is one deeper, and ends");
}

#[test]
fn super_within_the_module_passes() {
    for (depth, code) in [
        (2, "use super::Power; use super::color::{self, Rgb};"),
        (3, "use super::super::color; use super::{super::Power, part};"),
        (1, "#[cfg(test)]\nmod tests {\n    use super::*;\n}"),
        (2, "pub(super) struct A;\nmod tests {\n    fn f() {\n    }\n    use super::super::color;\n}"),
    ] {
        assert_eq!(upward("light", depth, code, &[]), Vec::<String>::new(), "{code}");
    }
}

#[test]
fn depths_are_those_of_the_module_tree() {
    let depth = |file: &str| depth_of(&source().join(file));
    assert_eq!(["light/mod.rs", "light/color.rs", "a/b/mod.rs", "a/b/c.rs"].map(depth), [1, 2, 2, 3]);
}

#[test]
fn what_is_allowed_passes() {
    let exports = exports("pub use system::OpticalSystem;\n");
    for code in [
        "use crate::numerics::{Sum, exp};",
        "use crate::geometry::Curve; use crate::light::Power;",
        "// see crate::trace\n/// [`System`](crate::OpticalSystem)\nuse std::fmt;",
    ] {
        assert_eq!(upward("light", 1, code, &exports), Vec::<String>::new(), "{code}");
    }
}

/// Caches of what is part of the program: computed once from constants, so that nobody can tell when.
const CACHES: [&str; 2] =
    ["static ENTRIES: OnceLock<Vec<Entry>>", "static FACES: [OnceLock<Option<Face<'static>>>; 3]"];

/// What a module of the library has no business with: results depend on the arguments alone.
const OUTSIDE: [&str; 11] = [
    "static ",
    "thread_local!",
    "lazy_static!",
    "std::env",
    "env::",
    "Instant",
    "SystemTime",
    "std::process",
    "std::net",
    "rand::",
    "set_hook",
];

#[test]
fn the_library_has_no_state_of_its_own() {
    let mut wrong = Vec::new();
    for file in rust_files(&source()) {
        if module_of(&file).is_some_and(|module| module != "cli") && !is_test(&file) {
            let found = state(&read(&file));
            wrong.extend(found.into_iter().map(|line| format!("{}: {line}", file.display())));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Whether its folder's module has a file for tests only.
fn is_test(file: &Path) -> bool {
    let parent = file.with_file_name("mod.rs");
    let name = file.file_stem().unwrap().to_str().unwrap();
    parent.exists() && read(&parent).contains(&format!("#[cfg(test)]\nmod {name};"))
}

#[test]
fn state_is_found_in_every_form() {
    for line in [
        "static COUNT: AtomicU64 = AtomicU64::new(0);",
        "    pub(crate) static mut LAST: u32 = 0;",
        "static KNOWN: OnceLock<Vec<u8>> = OnceLock::new();",
        "thread_local! { static A: Cell<u8> = Cell::new(0); }",
        "let home = std::env::var(\"HOME\");",
        "use std::time::{Duration, Instant};",
    ] {
        assert_eq!(state(line), [line.trim()], "{line}");
    }
    for line in [
        "fn f() -> &'static str {",
        "/// static thing",
        "const N: u8 = 1; // static N",
        "    static ENTRIES: OnceLock<Vec<Entry>> = OnceLock::new();",
    ] {
        assert_eq!(state(line), Vec::<String>::new(), "{line}");
    }
    let test = "fn f() {}\n#[cfg(test)]\nmod tests {\n    use std::time::Instant;\n}\n";
    assert_eq!(state(test), Vec::<String>::new(), "tests may look at the clock");
}

/// The lines of some code, without comments and unit tests, that hold or reach state outside of their arguments.
fn state(code: &str) -> Vec<String> {
    let library = code.split("#[cfg(test)]\nmod tests {").next().unwrap_or("");
    let is_cache = |line: &str| CACHES.iter().any(|cache| line.starts_with(cache));
    let reaches = |line: &str| {
        let words = line.split("//").next().unwrap_or("").replace("'static ", "");
        OUTSIDE.iter().any(|outside| words.contains(outside)) && !is_cache(line)
    };
    library.lines().map(str::trim).filter(|line| reaches(line)).map(str::to_owned).collect()
}

/// The modules that some code, in a file so deep below the crate's root, uses though they do not stand before its own.
fn upward(module: &str, depth: usize, code: &str, exports: &[(String, String)]) -> Vec<String> {
    let place = |name: &str| MODULES.iter().position(|listed| *listed == name);
    let own = place(module);
    let through_root = |name: String| {
        let export = exports.iter().find(|(exported, _)| *exported == name);
        export.map_or(name, |(_, module)| module.clone())
    };
    let later = |name: &String| place(name).is_none() || place(name) > own;
    used(depth, code).into_iter().map(through_root).filter(later).collect()
}

/// The first names of all paths from the crate's root, by `crate::` or by as many `super::` as lead there.
fn used(depth: usize, code: &str) -> Vec<String> {
    let mut names = Vec::new();
    for (inside, code) in stretches(code) {
        names.extend(starts(&code, "crate").flat_map(|path| from_root(path, 0)));
        names.extend(starts(&code, "super").flat_map(|path| from_root(path, depth + inside - 1)));
    }
    names
}

/// Code without comments, in stretches inside of equally many inline modules, as rustfmt lays them out.
fn stretches(code: &str) -> Vec<(usize, String)> {
    let (mut open, mut stretches) = (Vec::new(), vec![(0, String::new())]);
    for line in code.lines() {
        let words = line.split("//").next().unwrap_or("").trim();
        let indent = line.len() - line.trim_start().len();
        if words == "}" && open.last() == Some(&indent) {
            open.pop();
            stretches.push((open.len(), String::new()));
        }
        stretches.last_mut().unwrap().1 += &format!("{words} ");
        if words.ends_with('{') && words.split(' ').rev().nth(2) == Some("mod") {
            open.push(indent);
            stretches.push((open.len(), String::new()));
        }
    }
    stretches
}

/// What follows `root::` wherever it occurs.
fn starts<'a>(code: &'a str, root: &'a str) -> impl Iterator<Item = &'a str> {
    code.match_indices(root).filter_map(move |(at, _)| {
        let before = code[..at].chars().next_back();
        let is_word = before.is_none_or(|c| !(c.is_alphanumeric() || c == '_' || c == '$'));
        code[at + root.len()..].trim_start().strip_prefix("::").filter(|_| is_word)
    })
}

/// The first names of a path, those of a braced group each, that `up` more `super::` take to the crate's root.
fn from_root(path: &str, up: usize) -> Vec<String> {
    let path = path.trim_start();
    if let Some(group) = path.strip_prefix('{') {
        return paths(group).into_iter().flat_map(|path| from_root(path, up)).collect();
    }
    match up.checked_sub(1) {
        None => first_name(path).into_iter().collect(),
        Some(up) => {
            let above = path.strip_prefix("super").and_then(|rest| rest.trim_start().strip_prefix("::"));
            above.map_or_else(Vec::new, |path| from_root(path, up))
        }
    }
}

/// The paths in a group that was opened already.
fn paths(group: &str) -> Vec<&str> {
    let (mut depth, mut start, mut paths) = (0, 0, Vec::new());
    for (at, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth > 0 => depth -= 1,
            ',' | '}' if depth == 0 => {
                paths.push(group[start..at].trim());
                start = at + 1;
                if c == '}' {
                    break;
                }
            }
            _ => {}
        }
    }
    paths
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
        let names = from_root(rest, 0);
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

/// How many modules deep a file stands below the crate's root.
fn depth_of(file: &Path) -> usize {
    file.strip_prefix(source()).unwrap().with_extension("").iter().filter(|name| *name != "mod").count()
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
