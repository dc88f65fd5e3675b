//! Sides of interfaces from which a ray meets nothing any more, since the whole scene lies behind them.

use glam::DVec2;

use crate::geometry::Curve;
use crate::system::Interface;

/// In larger scenes few rays leave from such a side, and the search for it is quadratic.
const MOST: usize = 64;

/// Interfaces with whether the side is their left one. Distances below `near` are rounding.
pub(crate) fn outward_sides(interfaces: &[Interface], near: f64) -> Vec<(usize, bool)> {
    if interfaces.len() > MOST {
        return Vec::new();
    }
    let sides = (0..interfaces.len()).flat_map(|place| [(place, true), (place, false)]);
    sides.filter(|&(place, left)| is_behind(interfaces.iter(), &interfaces[place], left, near)).collect()
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
    let is_point_behind = |p: DVec2| {
        let behind = |end: DVec2| sense * one.curve.normal_at(end).dot(p - end) < -near;
        let chord = sense * (one.curve.b - one.curve.a).normalize().perp();
        behind(one.curve.a) && behind(one.curve.b) && chord.dot(p - one.curve.a) < -near
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
    fn arcs_see_nothing_on_the_side_to_which_they_bulge() {
        assert_eq!(outward("(shape: Disk(2), medium: Index(1.5))"), 2);
        let lens =
            |radii: &str| format!("(shape: Lens(radii: {radii}, thickness: 2, diameter: 4), medium: Index(1.5))");
        assert_eq!(outward(&lens("(9, -9)")), 4);
        assert_eq!(outward(&lens("(-9, -9)")), 3);
    }
}
