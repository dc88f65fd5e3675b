use glam::DVec2;

use crate::diagram::Figure;
use crate::diagram::branches::{Branch, FEW_LINES};
use crate::diagram::rays::{Styles, opacity, strength};
use crate::drawing::{Fill, Item, Path, Shape};

/// A shorter piece of ray has no arrowhead, pixels.
const SHORTEST: f64 = 30.0;
/// Two arrowheads are at least this far apart, pixels.
const APART: f64 = 11.0;
/// More would be noise.
const MOST: usize = 400;
/// Branches beyond this many are not looked at.
const MOST_TRIED: usize = 4000;

/// Arrowheads past the middle of the branches, the strongest first, none on top of another.
pub(super) fn arrows(figure: &Figure<'_>) -> Vec<Item> {
    let styles = Styles::new(figure);
    let mut tips: Vec<DVec2> = Vec::new();
    let mut items = Vec::new();
    for branch in figure.branches.iter().rev().take(MOST_TRIED) {
        let tip = tip(branch);
        let free = tips.iter().all(|other| (*other - tip).length() >= APART);
        if items.len() >= MOST || !free || !branch.arrow || branch.length() < SHORTEST {
            continue;
        }
        tips.push(tip);
        let strength = strength(branch.share);
        // One head for a whole spectrum has the color of all lines together.
        let many = !branch.together && branch.lines > FEW_LINES;
        let color = if many { figure.palette.together() } else { styles.color(branch) };
        let fill = Fill { color, opacity: opacity(strength) };
        items.push(Shape::filled(head(branch, tip), fill, "arrow").into());
    }
    // The strongest lie on top.
    items.reverse();
    items
}

fn size(branch: &Branch<'_>) -> f64 {
    8.0 + 4.5 * strength(branch.share)
}

fn tip(branch: &Branch<'_>) -> DVec2 {
    0.5 * (branch.ends[0] + branch.ends[1]) + branch.direction() * (0.5 * size(branch) + 2.0)
}

/// A barbed head with a notch.
fn head(branch: &Branch<'_>, tip: DVec2) -> Path {
    let back = -branch.direction() * size(branch);
    let side = 0.4 * back.perp();
    Path::polygon(&[tip, tip + back + side, tip + 0.8 * back, tip + back - side])
}
