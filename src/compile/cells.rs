//! Stretches of one medium that a few interfaces enclose.

use crate::compile::leaders::Leaders;
use crate::compile::region::{crosses, signed_area};
use crate::geometry::{Bounds, BoxTree};
use crate::system::{Cells, Interface, MediumId};

/// A cell has at most this many interfaces: so many are looked at one by one faster than a search finds them.
const MOST: usize = 12;

/// Finds the cells of a system, `boxes` and `tree` being those of its interfaces.
///
/// Sides of interfaces that share a vertex and a medium bound one stretch of it, or several that touch there; what encloses a
/// finite area and holds no other boundary of its medium is a cell.
pub(crate) fn cells(interfaces: &[Interface], boxes: &[Bounds], tree: &BoxTree) -> Cells {
    let groups = Groups::new(interfaces);
    let mut cells = Cells { of_sides: vec![[Cells::OPEN; 2]; interfaces.len()], begins: vec![0, 0], walls: Vec::new() };
    for sides in groups.in_order() {
        let walls = walls(sides);
        if walls.len() > MOST || !encloses(interfaces, sides, &walls, boxes, tree) {
            continue;
        }
        let cell = number(cells.begins.len() - 1);
        for &side in sides {
            cells.of_sides[side as usize / 2][side as usize % 2] = cell;
        }
        cells.walls.extend(&walls);
        cells.begins.push(number(cells.walls.len()));
    }
    cells
}

/// The interfaces of sides in order, each once.
fn walls(sides: &[u32]) -> Vec<u32> {
    let mut walls: Vec<u32> = sides.iter().map(|side| side / 2).collect();
    walls.dedup();
    walls
}

/// Whether sides that belong together enclose a finite stretch of their medium, with no other boundary of it inside.
fn encloses(interfaces: &[Interface], sides: &[u32], walls: &[u32], boxes: &[Bounds], tree: &BoxTree) -> bool {
    let bounds = walls.iter().fold(Bounds::EMPTY, |all, &wall| all.union(boxes[wall as usize]));
    let about = bounds.center();
    let area = |&side: &u32| {
        let area = signed_area(&interfaces[side as usize / 2].curve, about);
        if side.is_multiple_of(2) { area } else { -area }
    };
    if sides.iter().map(area).sum::<f64>() <= 0.0 {
        return false;
    }
    let medium = medium_of(interfaces, sides[0]);
    let mut encloses = true;
    tree.meeting(bounds, |place| {
        let Interface { curve, left, right, .. } = &interfaces[place];
        let is_other = (*left == medium || *right == medium) && walls.binary_search(&number(place)).is_err();
        if encloses && is_other {
            let middle = curve.midpoint();
            let bounding = walls.iter().map(|&wall| &interfaces[wall as usize]).filter(|wall| wall.left != wall.right);
            let around = bounding.filter(|wall| crosses(&wall.curve, middle));
            encloses = around.count() % 2 == 0;
        }
    });
    encloses
}

fn medium_of(interfaces: &[Interface], side: u32) -> MediumId {
    let interface = &interfaces[side as usize / 2];
    if side.is_multiple_of(2) { interface.left } else { interface.right }
}

/// Sides of interfaces by what they bound. A side is twice its interface's place, and 1 more on the right.
struct Groups {
    /// Sides, those of a group together and ascending.
    sides: Vec<u32>,
    /// Where each group begins; one more than groups.
    begins: Vec<u32>,
}

impl Groups {
    fn new(interfaces: &[Interface]) -> Self {
        let mut leaders = Leaders::new(2 * interfaces.len());
        let mut at_vertices: Vec<_> = Vec::with_capacity(4 * interfaces.len());
        for (side, interface) in (0..).zip(interfaces.iter().flat_map(|one| [one, one])) {
            let medium = medium_of(interfaces, side);
            at_vertices.extend(interface.ends.map(|vertex| (vertex, medium, side)));
        }
        at_vertices.sort_unstable();
        for two in at_vertices.windows(2) {
            if (two[0].0, two[0].1) == (two[1].0, two[1].1) {
                leaders.unite(two[0].2 as usize, two[1].2 as usize);
            }
        }
        Self::of(&leaders, number(2 * interfaces.len()))
    }

    /// Sides by their leaders.
    fn of(leaders: &Leaders, count: u32) -> Self {
        let mut by_leader: Vec<_> = (0..count).map(|side| (number(leaders.of(side as usize)), side)).collect();
        by_leader.sort_unstable();
        let mut begins: Vec<u32> = Vec::new();
        for (k, pair) in (0..).zip(&by_leader) {
            if k == 0 || by_leader[k as usize - 1].0 != pair.0 {
                begins.push(k);
            }
        }
        begins.push(number(by_leader.len()));
        Self { sides: by_leader.into_iter().map(|(_, side)| side).collect(), begins }
    }

    fn in_order(&self) -> impl Iterator<Item = &[u32]> {
        self.begins.windows(2).map(|two| &self.sides[two[0] as usize..two[1] as usize])
    }
}

/// A place in a list as a number; lists are far shorter than 2^32.
fn number(place: usize) -> u32 {
    u32::try_from(place).unwrap_or(u32::MAX)
}
