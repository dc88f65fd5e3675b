//! Sides of interfaces from which a ray meets nothing of the whole scene, or of what is next to it in the search tree, since that
//! lies behind them.

use std::ops::Range;

use glam::DVec2;

use crate::geometry::{Curve, CurveTree};
use crate::system::{Cells, Interface};

/// In larger scenes few rays leave from such a side, and the search for it is quadratic.
const MOST: usize = 64;

/// Notes these sides where no cell is known. Distances below `near` are rounding.
pub(crate) fn note(cells: &mut Cells, interfaces: &[Interface], tree: Option<&CurveTree>, near: f64) {
    for (number, run) in (0..).zip(tree.into_iter().flat_map(CurveTree::runs)) {
        note_outward(cells, interfaces, run, near, Cells::open(number));
    }
    if interfaces.len() <= MOST {
        note_outward(cells, interfaces, 0..interfaces.len(), near, Cells::NOTHING);
    }
}

/// Notes the sides of some interfaces that have all of these behind them.
fn note_outward(cells: &mut Cells, interfaces: &[Interface], places: Range<usize>, near: f64, cell: u32) {
    for (place, left) in places.clone().flat_map(|place| [(place, true), (place, false)]) {
        let known = &mut cells.of_sides[place][usize::from(!left)];
        if Cells::is_open(*known) && is_behind(interfaces[places.clone()].iter(), &interfaces[place], left, near) {
            *known = cell;
        }
    }
}

/// Whether interfaces lie behind the tangents of one of them, seen from a side: an edge's line, or the lines that touch an arc,
/// which bulges to that side.
pub(super) fn is_behind<'a>(
    mut interfaces: impl Iterator<Item = &'a Interface>,
    one: &Interface,
    left: bool,
    near: f64,
) -> bool {
    let sense = if left { 1.0 } else { -1.0 };
    if one.curve.curvature * sense > 0.0 {
        return false;
    }
    // What lies behind the tangents at an arc's ends and behind its chord lies behind every tangent between.
    let Curve { a, b, .. } = one.curve;
    let is_before = |end: DVec2, normal: DVec2, p: DVec2| sense * normal.dot(p - end) >= -near;
    let is_point_behind = |p: DVec2| {
        let is_straight = one.curve.is_straight();
        let is_before_bulge = || is_before(a, (b - a).normalize().perp(), p) || is_before(b, one.curve.normal_at(b), p);
        !(is_before(a, one.curve.normal_at(a), p) || !is_straight && is_before_bulge())
    };
    interfaces.all(|other| {
        let is_known = |end: usize| one.ends.contains(&other.ends[end]);
        other.curve.same_circle(&one.curve)
            || ((is_known(0) || is_point_behind(other.curve.a))
                && (is_known(1) || is_point_behind(other.curve.b))
                && (other.curve.is_straight() || tip(&other.curve).is_some_and(is_point_behind)))
    })
}

/// Where the tangents at an arc's ends meet, beyond the arc: it runs inside the triangle. `None` for about half a circle.
fn tip(arc: &Curve) -> Option<DVec2> {
    let chord = arc.b - arc.a;
    let sin = 0.5 * chord.length() * arc.curvature;
    let cos = ((1.0 - sin) * (1.0 + sin)).max(0.0).sqrt();
    (cos > 0.01).then(|| 0.5 * (arc.a + arc.b) - 0.5 * sin / cos * chord.perp())
}

#[cfg(test)]
mod tests {
    use crate::compile::compile;
    use crate::scene::Scene;
    use crate::system::Cells;

    /// How many sides of the interfaces of some bodies see nothing.
    fn outward(bodies: &str) -> usize {
        let scene = Scene::from_ron(&format!("(bodies: [{bodies}])")).unwrap();
        let system = compile(&scene).unwrap().system;
        system.cells.of_sides.iter().flatten().filter(|cell| **cell == Cells::NOTHING).count()
    }

    #[test]
    fn sides_see_nothing_where_the_whole_scene_lies_behind_them() {
        let triangle = "(shape: Polygon([(0, 0), (4, 0), (0, 3)]), medium: Index(1.5))";
        assert_eq!(outward(triangle), 3);
        // An L has an inner corner, whose two sides see each other.
        let angle = "Polygon([(0, 0), (4, 0), (4, 1), (1, 1), (1, 4), (0, 4)])";
        assert_eq!(outward(&format!("(shape: {angle}, medium: Index(1.5))")), 4);
        // A mirror far to the left stands before one side and ends on the line of another; its own left side sees nothing.
        let mirror = "(shape: Flat(from: (-9, 0), to: (-9, 1)), surface: Mirror)";
        assert_eq!(outward(&format!("{triangle}, {mirror}")), 2);
    }

    #[test]
    fn of_many_bodies_those_are_known_that_are_convex_and_what_is_left_behind() {
        let angle = "Polygon([(0, 0), (4, 0), (4, 1), (1, 1), (1, 4), (0, 4)])";
        let many = |shape: &str| {
            let body = |k: u32| format!("(shape: {shape}, at: ({}, 0), medium: Index(1.5))", 9 * k);
            let bodies: Vec<_> = (0..20).map(body).collect();
            let scene = Scene::from_ron(&format!("(bodies: [{}])", bodies.join(", "))).unwrap();
            let cells = compile(&scene).unwrap().system.cells;
            let sides = cells.of_sides.iter().flatten();
            let leaving = sides.filter(|cell| Cells::is_open(**cell) && **cell != Cells::OPEN).count();
            (cells.last_convex, leaving)
        };
        assert_eq!(many("Rectangle(4, 4)"), (20, 80));
        assert_eq!(many(angle), (0, 80), "all sides of an L but those of its inner corner");
        assert_eq!(many("Disk(2)").0, 0, "no polygon");
    }

    #[test]
    fn arcs_see_nothing_on_the_side_to_which_they_bulge() {
        assert_eq!(outward("(shape: Disk(2), medium: Index(1.5))"), 2);
        let lens =
            |radii: &str| format!("(shape: Lens(radii: {radii}, thickness: 2, diameter: 4), medium: Index(1.5))");
        assert_eq!(outward(&lens("(9, -9)")), 4);
        assert_eq!(outward(&lens("(-9, -9)")), 3);
    }
}
