//! Pages of documentation and the blocks in them.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

pub(crate) fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// A page of documentation.
pub(crate) struct Page {
    pub(crate) name: String,
    /// Its text without the blocks.
    pub(crate) prose: String,
    pub(crate) blocks: Vec<Block>,
}

/// A fenced block.
pub(crate) struct Block {
    pub(crate) line: usize,
    pub(crate) mark: String,
    pub(crate) text: String,
    /// Whether nothing but blank lines stands between it and the block before.
    pub(crate) follows: bool,
}

impl Page {
    pub(crate) fn read(name: &str) -> Self {
        let text = fs::read_to_string(root().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
        Self::parse(name, &text)
    }

    pub(crate) fn parse(name: &str, text: &str) -> Self {
        let mut page = Self { name: name.into(), prose: String::new(), blocks: Vec::new() };
        let mut open: Option<Block> = None;
        let mut follows = false;
        for (number, line) in text.lines().enumerate() {
            match (&mut open, line.strip_prefix("```")) {
                (None, Some(mark)) => {
                    let mark = mark.trim().to_owned();
                    open = Some(Block { line: number + 1, mark, text: String::new(), follows });
                }
                (Some(_), Some("")) => {
                    page.blocks.extend(open.take());
                    follows = true;
                }
                (Some(block), _) => block.text += &format!("{line}\n"),
                (None, None) => {
                    follows &= line.trim().is_empty();
                    page.prose += &format!("{line}\n");
                }
            }
        }
        assert!(open.is_none(), "{name}: a block never ends");
        page
    }

    pub(crate) fn marked<'a>(&'a self, mark: &'a str) -> impl Iterator<Item = &'a Block> {
        self.blocks.iter().filter(move |block| block.mark == mark)
    }

    pub(crate) fn place(&self, block: &Block) -> String {
        format!("{}:{}", self.name, block.line)
    }

    /// Where its links and pictures lead.
    pub(crate) fn targets(&self) -> impl Iterator<Item = &str> {
        self.prose.split("](").skip(1).filter_map(|rest| rest.split(')').next())
    }

    /// The words in inline code.
    pub(crate) fn code_words(&self) -> BTreeSet<String> {
        self.prose.lines().flat_map(|line| line.split('`').skip(1).step_by(2)).flat_map(words).collect()
    }

    /// The part under a heading of the second level.
    pub(crate) fn section(&self, heading: &str) -> &str {
        let start = self.prose.find(&format!("\n## {heading}\n")).unwrap_or_else(|| panic!("no section {heading}"));
        let rest = &self.prose[start + 1..];
        rest.find("\n## ").map_or(rest, |end| &rest[..end])
    }
}

/// README.md, if there is one, and everything in docs/.
pub(crate) fn pages() -> Vec<Page> {
    let mut names: Vec<String> = fs::read_dir(root().join("docs"))
        .unwrap()
        .map(|entry| format!("docs/{}", entry.unwrap().file_name().into_string().unwrap()))
        .filter(|name| Path::new(name).extension().is_some_and(|extension| extension == "md"))
        .collect();
    names.extend(Some("README.md".to_owned()).filter(|name| root().join(name).exists()));
    names.sort();
    names.iter().map(|name| Page::read(name)).collect()
}

pub(crate) fn words(text: &str) -> Vec<String> {
    let parts = text.split(|c: char| !(c.is_alphanumeric() || c == '_'));
    parts.filter(|word| !word.is_empty()).map(str::to_owned).collect()
}

/// The first cells of the tables in some text, without their backquotes; cells that are no inline code are left out.
pub(crate) fn first_cells(text: &str) -> Vec<&str> {
    text.lines().filter_map(|line| line.strip_prefix("| `")?.split('`').next()).collect()
}
