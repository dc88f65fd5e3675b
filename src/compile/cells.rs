//! Stretches of one medium that a few interfaces enclose.

use crate::compile::effort::Effort;
use crate::compile::leaders::Leaders;
use crate::compile::lists::Lists;
use crate::compile::outlook::is_behind;
use crate::compile::region::{crosses, signed_area};
use crate::geometry::{Bounds, CurveTree};
use crate::system::{Cells, Interface, MediumId};

/// A cell has at most this many interfaces: so many are looked at one by one faster than a search finds them.
const MOST: usize = 12;
/// Interfaces that are looked at to find cells, at most: what is found by then serves most rays.
const MOST_LOOKED_AT: u64 = 200_000_000;

/// Finds the cells of a system, `tree` being that of its interfaces.
///
/// Sides of interfaces that share a vertex and a medium bound one stretch of it, or several that touch there; what encloses a
/// finite area and holds no other boundary of its medium is a cell.
pub(crate) fn cells(interfaces: &[Interface], tree: &CurveTree, near: f64) -> Cells {
    let (groups, effort) = (groups(interfaces), Effort::new(MOST_LOOKED_AT));
    let mut cells =
        Cells { of_sides: vec![[Cells::OPEN; 2]; interfaces.len()], begins: vec![0, 0], ..Cells::default() };
    let enclosing = groups.filled().map(|sides| (sides, walls(sides)));
    let enclosing =
        enclosing.filter(|(sides, walls)| walls.len() <= MOST && encloses(interfaces, sides, walls, tree, &effort));
    let (convex, others): (Vec<_>, Vec<_>) =
        enclosing.partition(|(sides, walls)| is_convex(interfaces, sides, walls, near));
    cells.last_convex = number(convex.len());
    for (sides, walls) in convex.into_iter().chain(others) {
        let cell = number(cells.begins.len() - 1);
        for &side in sides {
            cells.of_sides[side / 2][side % 2] = cell;
        }
        cells.walls.extend(&walls);
        cells.begins.push(number(cells.walls.len()));
    }
    cells
}

/// Whether a cell is a convex polygon: seen from outside, all walls lie behind each.
fn is_convex(interfaces: &[Interface], sides: &[usize], walls: &[u32], near: f64) -> bool {
    let walls = || walls.iter().map(|wall| &interfaces[*wall as usize]);
    walls().all(|wall| wall.curve.is_straight())
        && sides.iter().all(|side| is_behind(walls(), &interfaces[side / 2], !side.is_multiple_of(2), near))
}

/// The interfaces of sides in order, each once.
fn walls(sides: &[usize]) -> Vec<u32> {
    let mut walls: Vec<u32> = sides.iter().map(|side| number(side / 2)).collect();
    walls.dedup();
    walls
}

/// Whether sides that belong together enclose a finite stretch of their medium, with no other boundary of it inside.
fn encloses(interfaces: &[Interface], sides: &[usize], walls: &[u32], tree: &CurveTree, effort: &Effort) -> bool {
    let bounds =
        walls.iter().map(|wall| Bounds::from(&interfaces[*wall as usize].curve)).fold(Bounds::EMPTY, Bounds::union);
    let about = bounds.center();
    let area = |&side: &usize| {
        let area = signed_area(&interfaces[side / 2].curve, about);
        if side.is_multiple_of(2) { area } else { -area }
    };
    if sides.iter().map(area).sum::<f64>() <= 0.0 || effort.is_spent() {
        return false;
    }
    let medium = medium_of(interfaces, sides[0]);
    let (mut encloses, mut looked_at) = (true, 0);
    let nodes = tree.meeting(bounds, |place| {
        looked_at += 1;
        let Interface { curve, left, right, .. } = &interfaces[place];
        let is_other = (*left == medium || *right == medium) && walls.binary_search(&number(place)).is_err();
        if encloses && is_other {
            let middle = curve.midpoint();
            let bounding = walls.iter().map(|&wall| &interfaces[wall as usize]).filter(|wall| wall.left != wall.right);
            let around = bounding.filter(|wall| crosses(&wall.curve, middle));
            encloses = around.count() % 2 == 0;
        }
    });
    effort.spend(looked_at + nodes);
    encloses
}

fn medium_of(interfaces: &[Interface], side: usize) -> MediumId {
    let interface = &interfaces[side / 2];
    if side.is_multiple_of(2) { interface.left } else { interface.right }
}

/// Sides of interfaces by what they bound, ascending. A side is twice its interface's place, and 1 more on the right.
fn groups(interfaces: &[Interface]) -> Lists {
    let mut leaders = Leaders::new(2 * interfaces.len());
    let vertices = interfaces.iter().flat_map(|one| one.ends).map(|end| end.0 as usize + 1).max().unwrap_or(0);
    let at_ends = || interfaces.iter().enumerate().flat_map(|(k, one)| one.ends.map(|end| (end.0 as usize, k)));
    let mut sides: Vec<(MediumId, usize)> = Vec::new();
    for at_vertex in Lists::sorted(vertices, at_ends).filled() {
        sides.clear();
        sides.extend(at_vertex.iter().flat_map(|k| [2 * k, 2 * k + 1]).map(|side| (medium_of(interfaces, side), side)));
        sides.sort_unstable();
        for two in sides.windows(2) {
            if two[0].0 == two[1].0 {
                leaders.unite(two[0].1, two[1].1);
            }
        }
    }
    let count = 2 * interfaces.len();
    Lists::sorted(count, || (0..count).map(|side| (leaders.of(side), side)))
}

/// A place in a list as a number; lists are far shorter than 2^32.
fn number(place: usize) -> u32 {
    u32::try_from(place).unwrap_or(u32::MAX)
}
