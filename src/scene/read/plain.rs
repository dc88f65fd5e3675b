//! Numbers, texts, switches and points.

use glam::DVec2;

use super::node::{Kind, Node};
use super::reader::{Read, Reader};
use crate::scene::Limit;
use crate::scene::problem::shortened;

/// A number that may be infinite.
#[derive(Clone, Copy)]
pub(super) struct MaybeInfinite(pub(super) f64);

impl Read for MaybeInfinite {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let Some(value) = (node.kind() == Kind::Number).then(|| number(node)).flatten() else {
            let help = "write a number such as `1.5` or `2e-3`, without a unit and without quotes";
            r.expected(node, "a number", help);
            return None;
        };
        if value.is_nan() {
            r.refuse(node, "`NaN` is not a number", "not a number", "write a finite number");
            return None;
        }
        if value.is_infinite() && !node.text().contains("inf") {
            let message = format!("`{}` is too large for a number", shortened(node.text()));
            r.refuse(node, message, "too large", "write a number below 1.7e308");
            return None;
        }
        Some(Self(value))
    }

    fn stand_in() -> Self {
        Self(f64::NAN)
    }
}

/// The number as ron reads it; the usual forms are Rust's own.
fn number(node: &Node<'_>) -> Option<f64> {
    let is_usual = node.text().bytes().all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte));
    let usual = is_usual.then(|| node.text().parse().ok()).flatten();
    usual.or_else(|| node.plain())
}

impl Read for f64 {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let MaybeInfinite(value) = MaybeInfinite::read(r, node)?;
        if value.is_infinite() {
            r.refuse(node, "an infinite number has no meaning here", "not finite", "write a finite number");
            return None;
        }
        Some(value)
    }

    fn stand_in() -> Self {
        Self::NAN
    }
}

/// Counts may be written with an exponent, as in `1e6`.
impl Read for u64 {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        if node.kind() != Kind::Number {
            r.expected(node, "a whole number", "write a whole number such as `8`");
            return None;
        }
        let value = node.plain().or_else(|| whole(node.plain()?));
        if value.is_none() {
            let help = "write a whole number such as `8`, without sign, decimals and unit, at most 2^53";
            r.refuse(node, format!("`{}` is not a count", shortened(node.text())), "not a whole number", help);
        }
        value
    }

    fn stand_in() -> Self {
        0
    }
}

/// A count that is at most `MOST`, as far as reading must tell: one that fits is left to the check of the scene.
pub(super) struct UpTo<const MOST: u64>(pub(super) u32);

impl<const MOST: u64> Read for UpTo<MOST> {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        small(r, node, MOST, "").map(Self)
    }

    fn stand_in() -> Self {
        Self(0)
    }
}

/// A count within the limit of this number, as far as reading must tell.
pub(super) struct Within<const LIMIT: usize>(pub(super) u32);

impl<const LIMIT: usize> Read for Within<LIMIT> {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let limit = Limit::ALL[LIMIT];
        small(r, node, r.limits.of(limit), &format!("; {}", limit.cure())).map(Self)
    }

    fn stand_in() -> Self {
        Self(0)
    }
}

fn small(r: &mut Reader, node: &Node<'_>, most: u64, cure: &str) -> Option<u32> {
    let value = u32::try_from(u64::read(r, node)?).ok();
    if value.is_none() {
        let message = format!("`{}` is more than the {most} allowed", shortened(node.text()));
        r.refuse(node, message, "too many", format!("write at most {most}{cure}"));
    }
    value
}

/// A float that is a whole number which it holds exactly.
fn whole(value: f64) -> Option<u64> {
    let exact = value.fract() == 0.0 && (0.0..=9_007_199_254_740_992.0).contains(&value);
    // Through text, which keeps clear of a lossy cast.
    if exact { format!("{value:.0}").parse().ok() } else { None }
}

impl Read for String {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let text = node.plain();
        if text.is_none() {
            r.expected(node, "text in quotes", "put the text in double quotes: `\"…\"`");
        }
        text
    }

    fn stand_in() -> Self {
        Self::new()
    }
}

impl Read for bool {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let switch = node.plain();
        if switch.is_none() {
            r.expected(node, "`true` or `false`", "write `true` or `false`, without quotes");
        }
        switch
    }

    fn stand_in() -> Self {
        false
    }
}

impl Read for DVec2 {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let help = "write a point as two numbers in parentheses: `(3, 4)`";
        r.pair::<f64>(node, "a point `(x, y)`", help).map(Self::from)
    }

    fn stand_in() -> Self {
        Self::NAN
    }
}

/// Points; the quick way first, one by one where one of them is at fault.
impl Read for Vec<DVec2> {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        if !r.has_room(node, "points", Limit::Points) {
            return None;
        }
        let quick = node.plain::<Vec<(f64, f64)>>().unwrap_or_default();
        let points: Self = quick.into_iter().map(DVec2::from).collect();
        let is_sound = !points.is_empty() && points.iter().all(|p| p.is_finite());
        if is_sound { Some(points) } else { r.elements(node, "points", |r, point| r.read(point)) }
    }

    fn stand_in() -> Self {
        Self::new()
    }
}

impl Read for Vec<f64> {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let has_room = r.has_room(node, "numbers", Limit::Lines);
        has_room.then(|| r.elements(node, "numbers", |r, number| r.read(number))).flatten()
    }

    fn stand_in() -> Self {
        Self::new()
    }
}
