use glam::DVec2;

use super::checker::{Checker, Text, show};
use super::lens::{check_group, check_lens};
use super::medium::check_medium;
use super::outline::{check_arc, check_outline, check_polygon};
use crate::scene::{Body, Limit, Problem, Shape, Substance, Surface};

/// One body by itself.
pub(super) fn check_body(c: &mut Checker<'_>, path: impl Text, body: &Body) {
    c.point(format_args!("{path}.at"), "the body's place", body.at);
    c.finite(format_args!("{path}.rotate"), "the angle", body.rotate);
    if let Some(label) = &body.label {
        c.words(format_args!("{path}.label"), label);
    }
    check_shape(c, format_args!("{path}.shape"), &body.shape);
    match &body.substance {
        Substance::Medium(medium) => {
            check_medium(c, format_args!("{path}.medium"), medium);
            check_filling(c, format_args!("{path}.medium"), &body.shape);
        }
        Substance::Surface(surface) => check_surface(c, format_args!("{path}.surface"), *surface, &body.shape),
        Substance::Elements => {
            c.require(matches!(body.shape, Shape::LensGroup { .. }), || {
                let message = "a body needs a `medium` or a `surface` unless it is a lens group";
                Problem::error(path.to_string(), message, "give what fills the shape or what its boundary does")
            });
        }
    }
}

fn check_filling(c: &mut Checker<'_>, path: impl Text, shape: &Shape) {
    let fault = match shape {
        Shape::Flat { .. } | Shape::Arc { .. } | Shape::Stop { .. } => {
            Some(("an open shape encloses nothing that a `medium` could fill", "give it a `surface`, such as `Mirror`"))
        }
        Shape::LensGroup { .. } => Some((
            "a lens group has no `medium` of its own: each of its surfaces names what follows it",
            "leave the body's `medium` out",
        )),
        _ => None,
    };
    if let Some((message, help)) = fault {
        c.push(Problem::error(path.to_string(), message, help).label("not on this shape"));
    }
}

fn check_surface(c: &mut Checker<'_>, path: impl Text, surface: Surface, shape: &Shape) {
    c.require(!matches!(shape, Shape::LensGroup { .. }), || {
        let message = "a lens group has no `surface` of its own";
        Problem::error(path.to_string(), message, "leave it out, or lay the surface on the face as a body of its own")
            .label("not here")
    });
    match surface {
        Surface::BeamSplitter { reflect, transmit } => {
            let names = ["reflect", "transmit"].map(|name| format!("{path}.{name}"));
            check_shares(c, path, names, [reflect, transmit], ["`reflect`", "`transmit`"]);
        }
        Surface::ThinLens { focal_length } => {
            let length = format!("{path}.focal_length");
            if c.coordinate(&length, "the focal length", focal_length) {
                c.require(focal_length != 0.0, || {
                    let help = "write the distance from lens to focus, positive for a converging lens";
                    Problem::error(&length, "a focal length of 0 has no meaning", help).label("zero")
                });
            }
            c.require(matches!(shape, Shape::Flat { .. }), || {
                let help = "use `shape: Flat(from: …, to: …)` for it";
                Problem::error(path.to_string(), "the ideal thin lens is a straight line", help)
                    .label("only on a `Flat`")
            });
        }
        Surface::Mirror | Surface::Absorber | Surface::Screen => {}
    }
}

/// Two shares of a power, each from 0 to 1, and not above 1 together.
pub(super) fn check_shares(
    c: &mut Checker<'_>,
    path: impl Text,
    names: [String; 2],
    shares: [f64; 2],
    what: [&str; 2],
) {
    let first = c.within(&names[0], what[0], shares[0], [0.0, 1.0]);
    let second = c.within(&names[1], what[1], shares[1], [0.0, 1.0]);
    let sum = shares[0] + shares[1];
    c.require(!first || !second || sum <= 1.0, || {
        let message = format!("{} and {} are {} together: more than arrives", what[0], what[1], show(sum));
        Problem::error(path.to_string(), message, "make their sum at most 1; what is left of 1 stays at the hit")
            .label("above 1")
    });
}

fn check_shape(c: &mut Checker<'_>, path: impl Text, shape: &Shape) {
    match shape {
        Shape::Polygon(points) => check_polygon(c, format_args!("{path}.points"), points),
        Shape::Rectangle { width, height } => {
            c.length(format_args!("{path}.width"), "the width", *width);
            c.length(format_args!("{path}.height"), "the height", *height);
        }
        Shape::RegularPolygon { sides, radius } => {
            c.limited(format_args!("{path}.sides"), "the number of sides", u64::from(*sides), 3, Limit::Sides);
            c.length(format_args!("{path}.radius"), "the radius", *radius);
        }
        Shape::Prism { apex_angle, side } => {
            check_apex(c, format_args!("{path}.apex_angle"), *apex_angle);
            c.length(format_args!("{path}.side"), "the side", *side);
        }
        Shape::RightAnglePrism { leg } => {
            c.length(format_args!("{path}.leg"), "the leg", *leg);
        }
        Shape::Disk { radius } | Shape::HalfDisk { radius } => {
            c.length(format_args!("{path}.radius"), "the radius", *radius);
        }
        Shape::Lens { radii, thickness, diameter, facets } => {
            check_lens(c, path, *radii, *thickness, *diameter);
            if let Some(facets) = facets {
                let path = format_args!("{path}.facets");
                c.limited(path, "the number of facets", u64::from(*facets), 1, Limit::Sides);
            }
        }
        Shape::Outline { start, path: steps } => check_outline(c, path, *start, steps),
        Shape::LensGroup { diameter, surfaces } => check_group(c, path, *diameter, surfaces),
        Shape::Flat { from, to } => check_flat(c, path, *from, *to),
        Shape::Arc { from, through, to } => check_arc(c, path, *from, *through, *to),
        Shape::Stop { opening, height } => check_stop(c, path, *opening, *height),
    }
}

fn check_flat(c: &mut Checker<'_>, path: impl Text, from: DVec2, to: DVec2) {
    let end = format!("{path}.to");
    if c.point(format_args!("{path}.from"), "the first point", from) & c.point(&end, "the last point", to) {
        c.require(from != to, || {
            let message = "the line ends where it begins";
            Problem::error(&end, message, "write two different points").label("same as `from`")
        });
    }
}

fn check_apex(c: &mut Checker<'_>, path: impl Text, angle: f64) {
    c.require(angle > 0.0 && angle < 180.0, || {
        let message = format!("the apex angle must lie between 0° and 180°, not be {}°", show(angle));
        Problem::error(path.to_string(), message, "write an angle in degrees such as `60`").label("out of range")
    });
}

fn check_stop(c: &mut Checker<'_>, path: impl Text, opening: f64, height: f64) {
    let at = format!("{path}.opening");
    if c.length(&at, "the opening", opening) & c.length(format_args!("{path}.height"), "the height", height) {
        c.require(height > opening, || {
            let message = format!("the opening of {} leaves nothing of a stop {} high", show(opening), show(height));
            Problem::error(&at, message, "make `height` larger than `opening`").label("not below `height`")
        });
    }
}
