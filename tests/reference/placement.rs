//! Angles in degrees and the places of bodies.

use ::f256::{consts::PI, f256};
use snellius::scene::Body;

use crate::numbers::Numbers;
use crate::support::wide::{Wide2, wide};

/// Cosine and sine of an angle in degrees; multiples of 90° are exact.
pub(crate) fn direction(degrees: f256) -> Wide2 {
    let quarters = (degrees / wide(90.0)).round();
    let rest = degrees - quarters * wide(90.0);
    let (sin, cos) = if rest == f256::ZERO { (f256::ZERO, f256::ONE) } else { (rest * PI / wide(180.0)).sin_cos() };
    let turns = quarters - wide(4.0) * (quarters / wide(4.0)).floor();
    match [0.0, 1.0, 2.0].map(|quarter| turns == wide(quarter)) {
        [true, ..] => Wide2 { x: cos, y: sin },
        [_, true, _] => Wide2 { x: -sin, y: cos },
        [.., true] => Wide2 { x: -cos, y: -sin },
        _ => Wide2 { x: sin, y: -cos },
    }
}

/// A vector turned by the angle of a unit direction from +x.
pub(crate) fn turned(v: Wide2, by: Wide2) -> Wide2 {
    Wide2 { x: by.x * v.x - by.y * v.y, y: by.y * v.x + by.x * v.y }
}

/// Where a body stands: turned about its own origin, then moved.
#[derive(Clone, Copy)]
pub(crate) struct Placement {
    turn: Wide2,
    at: Wide2,
}

impl Placement {
    pub(crate) fn of(body: &Body, numbers: &Numbers) -> Self {
        let [x, y] = [body.at.x, body.at.y].map(|x| numbers.length(x));
        Self { turn: direction(numbers.number(wide(body.rotate))), at: Wide2 { x, y } }
    }

    pub(crate) fn point(&self, p: Wide2) -> Wide2 {
        turned(p, self.turn) + self.at
    }
}
