use std::path::Path;

use crate::table::Table;

const OPEN: &str = "<!-- table: ";
const CLOSE: &str = "<!-- end -->";

/// A page with the table `NAME.csv` of a folder between each `<!-- table: NAME -->` and the next `<!-- end -->`; where there
/// is no such file, what stands there stays.
pub(crate) fn filled(page: &str, folder: &Path) -> String {
    let mut parts = page.split(OPEN);
    let mut filled = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (name, rest) = part.split_once(" -->").unwrap_or_else(|| panic!("{OPEN}{part}: no end of the mark"));
        let (old, after) = rest.split_once(CLOSE).unwrap_or_else(|| panic!("table {name} has no {CLOSE}"));
        let table = Table::read(folder, name).map(|table| format!("\n\n{}\n", table.markdown()));
        filled += &format!("{OPEN}{name} -->{}{CLOSE}{after}", table.as_deref().unwrap_or(old));
    }
    filled
}
