use std::io::{self, Write};

use clap::Args;

use super::console::{Mistake, Status};
use super::output::Target;
use crate::media::catalog::{self, Entry};

/// List the built-in media with index n_d, Abbe number V_d, wavelength range and source.
#[derive(Args)]
pub(super) struct Materials {
    /// Only media whose name, kind or note holds these letters, in either case.
    #[arg(value_name = "PATTERN")]
    pattern: Option<String>,
}

impl Materials {
    pub(super) fn run(&self) -> Result<Status, Mistake> {
        let pattern = self.pattern.as_deref().unwrap_or_default();
        let found: Vec<&Entry> = catalog::entries().iter().filter(|entry| matches(entry, pattern)).collect();
        if found.is_empty() {
            let hint = catalog::nearest(pattern).map_or_else(String::new, |name| format!("; is it '{name}'?"));
            return Err(Mistake(format!("no medium of the catalog matches '{pattern}'{hint}")));
        }
        Ok(Status::of(Target::Stdout.write(|out| list(out, &found))))
    }
}

fn matches(entry: &Entry, pattern: &str) -> bool {
    let pattern = pattern.to_lowercase();
    [entry.name, entry.group, entry.note].iter().any(|words| words.to_lowercase().contains(&pattern))
}

fn list(out: &mut dyn Write, entries: &[&Entry]) -> io::Result<()> {
    let width = |words: fn(&Entry) -> &str| entries.iter().map(|entry| words(entry).chars().count()).max().unwrap_or(0);
    let (name, group) = (width(|entry| entry.name), width(|entry| entry.group));
    writeln!(out, "{:name$}  {:>7}  {:>6}  {:>10}  {:group$}  source", "name", "n_d", "V_d", "nm", "kind")?;
    for entry in entries {
        let (from, to) = entry.range_nm;
        let (range, abbe) = (format!("{from}-{to}"), entry.abbe_number());
        let note = if entry.note.is_empty() { String::new() } else { format!(" ({})", entry.note) };
        write!(out, "{:name$}  {:7.5}  {abbe:6.2}  {range:>10}  ", entry.name, entry.n_d())?;
        writeln!(out, "{:group$}  {}{note}", entry.group, entry.source)?;
    }
    Ok(())
}
