use glam::DVec2;

use crate::diagram::Figure;
use crate::diagram::branches::Branch;
use crate::diagram::generations::Aged;
use crate::diagram::styles::strength;
use crate::drawing::{Fill, Path, Shape};

/// A shorter piece of ray has no arrowhead, pixels.
const SHORTEST: f64 = 11.0;
/// A head takes no more of its branch than this share.
const LARGEST: f64 = 0.55;
/// Two arrowheads are at least this far apart, pixels.
const APART: f64 = 11.0;
/// Two of opposite ways on one line are at least this far apart, pixels.
const OPPOSED: f64 = 40.0;
/// More would be noise.
const MOST: usize = 400;
/// Branches beyond this many are not looked at.
const MOST_TRIED: usize = 4000;

/// Places of a head along its branch, the next where the one before is too close to light that runs back.
const PLACES: [f64; 3] = [0.5, 0.3, 0.7];

/// Arrowheads past the middle of the branches, the strongest first, none on top of another.
pub(super) fn arrows(figure: &Figure<'_>) -> Vec<Aged> {
    let styles = &figure.styles;
    let mut heads: Vec<Head> = Vec::new();
    let mut items: Vec<Aged> = Vec::new();
    let tried = figure.branches.iter().rev().take(MOST_TRIED);
    for branch in tried.filter(|branch| branch.arrow && branch.length() >= SHORTEST) {
        if heads.len() >= MOST {
            break;
        }
        let Some(head) = free(branch, &heads) else { continue };
        // One head for lines that the eye does not tell apart has the color of all of them.
        let closed = branch.fan.is_some_and(|fan| fan.closed());
        let color = if closed { styles.together(branch) } else { styles.color(branch) };
        let fill = Fill { color, opacity: styles.opacity(strength(branch.share)) };
        let shape = Shape::filled(head.path(size(branch)), fill, "arrow");
        items.push((branch.generation(), shape.into()));
        heads.push(head);
    }
    // The strongest lie on top.
    items.reverse();
    items
}

/// An arrowhead.
struct Head {
    tip: DVec2,
    along: DVec2,
}

impl Head {
    /// Whether two heads stand clear of each other. Opposed ones on one line would look like a star.
    fn clear_of(&self, other: &Self) -> bool {
        let apart = other.tip - self.tip;
        let opposed = self.along.dot(other.along) < -0.9 && apart.perp_dot(self.along).abs() < APART;
        apart.length() >= if opposed { OPPOSED } else { APART }
    }

    /// A barbed head with a notch.
    fn path(&self, size: f64) -> Path {
        let back = -self.along * size;
        let side = 0.4 * back.perp();
        Path::polygon(&[self.tip, self.tip + back + side, self.tip + 0.8 * back, self.tip + back - side])
    }
}

/// The first place where a branch's head stands clear; only light that runs back moves a head, a crowd drops it.
fn free(branch: &Branch<'_>, heads: &[Head]) -> Option<Head> {
    let along = branch.direction();
    for place in PLACES {
        let middle = branch.ends[0].lerp(branch.ends[1], place);
        let head = Head { tip: middle + along * past_middle(branch), along };
        let in_the_way: Vec<&Head> = heads.iter().filter(|other| !head.clear_of(other)).collect();
        if in_the_way.is_empty() {
            return Some(head);
        }
        if in_the_way.iter().any(|other| other.along.dot(along) >= -0.9) {
            return None;
        }
    }
    None
}

/// How far the tip stands past the head's place.
fn past_middle(branch: &Branch<'_>) -> f64 {
    (0.5 * size(branch) + 2.0).min(0.4 * branch.length())
}

fn size(branch: &Branch<'_>) -> f64 {
    (8.0 + 4.5 * strength(branch.share)).min(LARGEST * branch.length())
}
