use super::checker::{Checker, Text, show, show_at_least, show_rounded};
use super::medium::check_medium;
use crate::scene::{Element, MIN_LENGTH, Problem};

/// A single lens: both faces reach the rim and do not cross there. Between vertex and rim the distance of two circular
/// faces grows or shrinks steadily, so the rim decides.
pub(super) fn check_lens(c: &mut Checker<'_>, path: impl Text, radii: [f64; 2], thickness: f64, diameter: f64) {
    let wide = c.length(format_args!("{path}.diameter"), "the diameter", diameter);
    let thick = c.length(format_args!("{path}.thickness"), "the thickness", thickness);
    let reach = [0, 1].map(|k| check_radius(c, format_args!("{path}.radii[{k}]"), radii[k], wide.then_some(diameter)));
    if wide && thick && reach == [true, true] {
        check_edge(c, format_args!("{path}.thickness"), radii, thickness, diameter);
    }
}

/// A radius that is not 0 and lets the face reach the rim.
fn check_radius(c: &mut Checker<'_>, path: impl Text, radius: f64, diameter: Option<f64>) -> bool {
    let sound = c.require(radius.abs() >= MIN_LENGTH, || {
        let message = format!("a radius of {} makes no face", show(radius));
        let help = "write `inf` for a plane face, a positive radius where the center lies to the right";
        Problem::error(path.to_string(), message, help).label("not a radius")
    });
    let Some(diameter) = diameter else { return sound };
    sound
        && c.require(radius.abs() >= 0.5 * diameter, || {
            let (radius, half) = (show(radius), show(0.5 * diameter));
            let message = format!("a face of radius {radius} does not reach the rim at half the diameter, {half}");
            let help = format!("make the radius at least {half} in size, or the diameter smaller");
            Problem::error(path.to_string(), message, help).label("too small")
        })
}

/// The faces do not cross inside of the diameter; `path` is that of the thickness.
fn check_edge(c: &mut Checker<'_>, path: impl Text, radii: [f64; 2], thickness: f64, diameter: f64) {
    let [left, right] = radii.map(|radius| sag(radius, 0.5 * diameter));
    let edge = thickness + right - left;
    let rounding = 16.0 * f64::EPSILON * thickness.max(left.abs()).max(right.abs());
    c.require(edge >= -rounding, || {
        let message =
            format!("the faces cross inside of the diameter: at the rim the thickness is {}", show_rounded(edge));
        let help = format!("make the thickness at least {}, or the diameter smaller", show_at_least(left - right));
        Problem::error(path.to_string(), message, help).label("too thin")
    });
}

/// How far a face at height h stands to the right of its vertex: h²/(r (1 + √(1 − h²/r²))).
fn sag(radius: f64, height: f64) -> f64 {
    let slope = height / radius;
    height * slope / (1.0 + (1.0 - slope * slope).max(0.0).sqrt())
}

/// A lens prescription, surface by surface.
pub(super) fn check_group(c: &mut Checker<'_>, path: impl Text, diameter: f64, surfaces: &[Element]) {
    let wide = c.length(format_args!("{path}.diameter"), "the diameter", diameter);
    let list = format!("{path}.surfaces");
    if !c.at_least(&list, "a lens group", "surfaces", surfaces.len(), 2) {
        return;
    }
    let reach: Vec<bool> = (surfaces.iter().enumerate())
        .map(|(k, s)| check_radius(c, format_args!("{list}[{k}].radius"), s.radius, wide.then_some(diameter)))
        .collect();
    for (k, pair) in surfaces.windows(2).enumerate() {
        let thickness = check_element(c, format_args!("{list}[{k}]"), &pair[0]);
        if let (Some(thickness), [true, true], true) = (thickness, &reach[k..k + 2], wide) {
            check_edge(c, format_args!("{list}[{k}].thickness"), [pair[0].radius, pair[1].radius], thickness, diameter);
        }
    }
    if let Some(last) = surfaces.last() {
        check_last(c, format_args!("{list}[{}]", surfaces.len() - 1), last);
    }
}

/// A surface that another one follows; its thickness if that is sound.
fn check_element(c: &mut Checker<'_>, path: impl Text, element: &Element) -> Option<f64> {
    for (name, missing) in [("thickness", element.thickness.is_none()), ("medium", element.medium.is_none())] {
        c.require(!missing, || {
            let message = format!("a surface that is not the last one needs the field `{name}`");
            Problem::error(path.to_string(), message, "write `(radius: …, thickness: …, medium: …)`")
                .label(format!("no `{name}`"))
        });
    }
    if let Some(medium) = &element.medium {
        check_medium(c, format_args!("{path}.medium"), medium);
    }
    element.thickness.filter(|t| c.length(format_args!("{path}.thickness"), "the thickness", *t))
}

/// Nothing of the group follows the last surface.
fn check_last(c: &mut Checker<'_>, path: impl Text, last: &Element) {
    for (name, given) in [("thickness", last.thickness.is_some()), ("medium", last.medium.is_some())] {
        c.require(!given, || {
            let message = format!("the last surface of a lens group has no `{name}`: the group ends there");
            Problem::error(format!("{path}.{name}"), message, format!("leave `{name}` out")).label("not on the last")
        });
    }
}
