use std::collections::BTreeMap;

use glam::DVec2;

use crate::diagram::branches::Branch;

/// Lines of one ray whose ends are all within this many pixels are one line to the eye.
const COINCIDENT: f64 = 0.25;

/// A bundle in groups of branches that coincide with the first of their group; groups and their members are in the
/// bundle's order.
pub(super) fn groups<'a>(bundle: &[Branch<'a>], across: DVec2) -> Vec<Vec<Branch<'a>>> {
    let mut groups: Vec<Vec<Branch<'a>>> = Vec::new();
    // Groups by where their first branch stands, so that a branch is compared only with those nearby.
    let mut cells: BTreeMap<i64, Vec<usize>> = BTreeMap::new();
    for branch in bundle {
        let cell = cell(branch, across);
        let nearby =
            (cell.saturating_sub(1)..=cell.saturating_add(1)).filter_map(|cell| cells.get(&cell)).flatten().copied();
        match nearby.filter(|k| coincide(&groups[*k][0], branch)).min() {
            Some(k) => groups[k].push(*branch),
            None => {
                cells.entry(cell).or_default().push(groups.len());
                groups.push(vec![*branch]);
            }
        }
    }
    groups
}

/// A strip across the bundle. Both ends of coincident branches are within a strip's width, so is their middle: they lie
/// in one strip or in neighboring ones.
fn cell(branch: &Branch<'_>, across: DVec2) -> i64 {
    #[allow(clippy::cast_possible_truncation, reason = "a place inside the figure")]
    let cell = (0.5 * (branch.ends[0] + branch.ends[1]).dot(across) / COINCIDENT).floor() as i64;
    cell
}

fn coincide(a: &Branch<'_>, b: &Branch<'_>) -> bool {
    let apart = [a.ends[0] - b.ends[0], a.ends[1] - b.ends[1]];
    apart.iter().all(|d| d.length() <= COINCIDENT)
}
