//! Bodies that are lost in the rounding of a scene that reaches far.

use crate::geometry::Bounds;
use crate::scene::Problem;
use crate::system::PlacedBody;

/// A body has to be so many times larger than the scene's rounding.
const LEAST: f64 = 10.0;

/// A warning if bodies are so small against the whole scene that rays pass them by, or meet them in the wrong place: places nearer than
/// `near` to each other are one.
pub(super) fn warning(bodies: &[PlacedBody], near: f64) -> Option<Problem> {
    let size = |body: &PlacedBody| {
        let curves = body.outlines.iter().flat_map(|outline| &outline.curves);
        curves.fold(Bounds::EMPTY, |bounds, curve| bounds.union(Bounds::from(curve))).size().max_element()
    };
    let is_lost = |body: &&PlacedBody| (0.0..LEAST * near).contains(&size(body));
    let first = bodies.iter().position(|body| is_lost(&body))?;
    let others = bodies[first + 1..].iter().filter(is_lost).count();
    let others = match others {
        0 => String::new(),
        1 => ", as is 1 other body".into(),
        _ => format!(", as are {others} other bodies"),
    };
    let (name, size) = (&bodies[first].name, size(&bodies[first]));
    let message =
        format!("`{name}` is {size:.1e} across, too small in a scene whose places round to {near:.1e}{others}");
    let help = "rays may pass it by or meet it in the wrong place: bring nearer what is far away, or draw it larger";
    Some(Problem::warning(format!("bodies[{first}].shape"), message, help).label("lost in rounding"))
}
