use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use crate::figures::Figures;
use crate::page;
use crate::plot::{Panel, draw};
use crate::table::Table;

/// One run of all studies: how much is measured, where it is written, and the key figures so far.
pub(crate) struct Study {
    name: &'static str,
    page: &'static str,
    is_quick: bool,
    folder: PathBuf,
    pub(crate) figures: Figures,
}

impl Study {
    /// The study `name` fills the page docs/`page`.md and the folder docs/`page`; a quick one writes target/`name`.
    pub(crate) fn new(name: &'static str, page: &'static str, is_quick: bool) -> Self {
        let folder = if is_quick { root().join("target").join(name) } else { root().join("docs").join(page) };
        fs::create_dir_all(&folder).unwrap();
        Self { name, page, is_quick, folder, figures: Figures::default() }
    }

    /// The same, but it writes target/`name`: a run of some studies only.
    pub(crate) fn aside(mut self) -> Self {
        self.folder = root().join("target").join(self.name);
        fs::create_dir_all(&self.folder).unwrap();
        self
    }

    /// The size of a measurement.
    pub(crate) fn size<T>(&self, quick: T, full: T) -> T {
        if self.is_quick { quick } else { full }
    }

    /// Writes a table and prints it.
    pub(crate) fn save(&self, table: &Table) {
        table.write(&self.folder);
        println!("\n{}:\n\n{}", table.name, table.markdown());
    }

    /// Draws a plot.
    pub(crate) fn draw(&self, name: &str, panels: &[Panel]) {
        draw(&self.folder.join(name).with_extension("svg"), panels);
    }

    /// Writes the key figures and the page with all tables; fails if a figure is missed.
    pub(crate) fn finish(self) -> ExitCode {
        self.save(&self.figures.table(self.name));
        let page = root().join("docs").join(self.page).with_extension("md");
        let filled = page::filled(&fs::read_to_string(page).unwrap(), &self.folder);
        fs::write(self.folder.with_extension("md"), filled).unwrap();
        println!("written: {}", self.folder.display());
        self.figures.verdict()
    }
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}
