//! docs/gallery.md, which shows every scene's figure with its words and its file.

use snellius::Scene;

use super::{run, scene_names};

const HEAD: &str = "# Gallery

<!-- INSTA_UPDATE=always cargo test --test scenes writes this page. -->

Every scene in `scenes/`, as snellius draws it. Under each figure stands its file: copy it, change a number, draw your own.

";

/// Chapters in the order of a lecture; others follow after them.
const CHAPTERS: [&str; 6] = ["refraction", "total-reflection", "prisms", "lenses", "mirrors", "nature"];

/// The page.
pub fn page() -> String {
    let names = scene_names();
    let mut chapters: Vec<&str> = names.iter().map(|name| chapter(name)).collect();
    chapters.dedup();
    chapters.sort_by_key(|chapter| CHAPTERS.iter().position(|known| known == chapter).unwrap_or(CHAPTERS.len()));
    let contents: Vec<_> = chapters.iter().map(|chapter| format!("[{}](#{chapter})", heading(chapter))).collect();
    let mut page = format!("{HEAD}{}\n", contents.join(" · "));
    for chapter_name in chapters {
        let here: Vec<_> = names.iter().filter(|name| chapter(name) == chapter_name).collect();
        page += &format!("\n## {}\n\n<table>\n", heading(chapter_name));
        for row in here.chunks(2) {
            let cells: String = row.iter().map(|name| cell(name, &run(name).scene)).collect();
            page += &format!("<tr>\n{cells}</tr>\n");
        }
        page += "</table>\n";
    }
    page
}

/// A scene's place in the table.
pub fn cell(name: &str, scene: &Scene) -> String {
    let file = format!("scenes/{name}.ron");
    let (title, caption) = (markdown(&scene.title), markdown(&scene.caption));
    let figure = format!("![{title}](../snapshots/{name}.svg)");
    format!("<td width=\"50%\">\n\n{figure}\n\n**{title}**<br>{caption}<br>[{file}](../{file})\n\n</td>\n")
}

fn chapter(name: &str) -> &str {
    name.split_once('/').map_or("", |(chapter, _)| chapter)
}

/// `total-reflection` as words.
fn heading(chapter: &str) -> String {
    let words = chapter.replace('-', " ");
    let first: String = words.chars().take(1).flat_map(char::to_uppercase).collect();
    first + &words.chars().skip(1).collect::<String>()
}

/// Words on one line in which no character is a sign of Markdown.
fn markdown(words: &str) -> String {
    let mut escaped = String::new();
    let mut before = ' ';
    for c in words.trim().chars() {
        let is_link = (before, c) == (':', '/') || c == '.' && escaped.to_ascii_lowercase().ends_with("www");
        match c {
            c if c.is_control() => escaped.push(' '),
            c if is_link || r"\`*_[]<>|~$&@#{}^".contains(c) => escaped.extend(['\\', c]),
            _ => escaped.push(c),
        }
        before = c;
    }
    escaped
}
