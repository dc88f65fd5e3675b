use std::collections::HashSet;

use glam::DVec2;

use super::checker::{Checker, Text, show};
use crate::scene::{Direction, Light, Limit, Problem, Scene, Shape, Source, Spectrum, facing};

/// Rays of an object, at most.
const OBJECT_RAYS: u64 = 3;

/// One source by itself.
pub(super) fn check_source(c: &mut Checker<'_>, path: impl Text, source: &Source) {
    check_light(c, format_args!("{path}.light"), &source.light);
    check_spectrum(c, format_args!("{path}.spectrum"), &source.spectrum);
    let power = format!("{path}.power");
    let is_positive = |c: &mut Checker<'_>| {
        c.require(source.power > 0.0, || {
            let message = format!("the power must be above 0, not {}", show(source.power));
            Problem::error(&power, message, "write a positive number; the whole source has this power")
                .label("no light")
        })
    };
    if c.finite(&power, "the power", source.power) && is_positive(c) {
        c.within(&power, "the power", source.power, [1e-100, 1e100]);
    }
}

fn check_light(c: &mut Checker<'_>, path: impl Text, light: &Light) {
    match light {
        Light::Ray { from, direction } => check_start(c, path, "from", *from, direction),
        Light::Beam { center, direction, width, rays } => {
            check_start(c, path, "center", *center, direction);
            if c.coordinate(format_args!("{path}.width"), "the width", *width) {
                c.require(*width >= 0.0, || {
                    let message = format!("the width must not be negative, but is {}", show(*width));
                    Problem::error(format!("{path}.width"), message, "write the distance between the outermost rays")
                        .label("negative")
                });
            }
            check_rays(c, path, *rays);
        }
        Light::Fan { from, direction, spread, rays } => {
            check_start(c, path, "from", *from, direction);
            check_spread(c, format_args!("{path}.spread"), *spread, *rays);
            check_rays(c, path, *rays);
        }
        Light::Point { at: start, rays } => {
            c.point(format_args!("{path}.at"), "the start", *start);
            check_rays(c, path, *rays);
        }
        Light::Object { from, to } => {
            c.point(format_args!("{path}.from"), "the foot", *from);
            c.point(format_args!("{path}.to"), "the tip", *to);
            c.require(from != to, || {
                let message = "the object has no height: its tip is its foot";
                Problem::error(format!("{path}.to"), message, "write a point other than `from`")
                    .label("the foot itself")
            });
        }
    }
}

fn check_start(c: &mut Checker<'_>, path: impl Text, name: &str, start: DVec2, direction: &Direction) {
    c.point(format_args!("{path}.{name}"), "the start", start);
    match direction {
        Direction::Angle(degrees) => {
            c.finite(format_args!("{path}.direction.degrees"), "the angle", *degrees);
        }
        Direction::Towards(point) => {
            let target = format!("{path}.direction.point");
            c.point(&target, "the target", *point);
            c.require(*point != start, || {
                let message = "the ray is to head towards its own start";
                Problem::error(&target, message, format!("write a point other than `{name}`, or use `Angle(…)`"))
                    .label("the start itself")
            });
        }
    }
}

fn check_rays(c: &mut Checker<'_>, path: impl Text, rays: u32) {
    c.limited(format_args!("{path}.rays"), "the number of rays", u64::from(rays), 1, Limit::Rays);
}

fn check_spread(c: &mut Checker<'_>, path: impl Text, spread: f64, rays: u32) {
    if !c.finite(path, "the spread", spread) {
        return;
    }
    c.require(spread >= 0.0, || {
        let message = format!("the spread must not be negative, but is {}°", show(spread));
        Problem::error(path.to_string(), message, "write the full angle of the fan in degrees").label("negative")
    });
    c.require(spread < 360.0, || {
        let why =
            if spread > 360.0 { "more than once round" } else { "all the way round: its first and last ray coincide" };
        let message = format!("a fan of {}° goes {why}", show(spread));
        Problem::error(path.to_string(), message, format!("use `Point(at: …, rays: {rays})`, or a spread below 360"))
            .label("360° or more")
    });
}

fn check_spectrum(c: &mut Checker<'_>, path: impl Text, spectrum: &Spectrum) {
    match spectrum {
        Spectrum::Line(nm) => drop(check_line(c, format_args!("{path}.nm"), *nm)),
        Spectrum::Lines(lines) => check_lines(c, format_args!("{path}.nm"), lines),
        Spectrum::White { samples } => {
            c.limited(format_args!("{path}.samples"), "the number of samples", u64::from(*samples), 1, Limit::Lines);
        }
    }
}

fn check_lines(c: &mut Checker<'_>, path: impl Text, lines: &[f64]) {
    if !(c.at_least(path, "a spectrum", "lines", lines.len(), 1)
        && c.at_most(path, "a spectrum", "lines", lines.len() as u64, Limit::Lines))
    {
        return;
    }
    let mut seen = HashSet::new();
    for (k, nm) in lines.iter().enumerate() {
        let at = format!("{path}[{k}]");
        if check_line(c, &at, *nm) {
            c.require(seen.insert(nm.to_bits()), || {
                let message = format!("the line at {} nm is given twice", show(*nm));
                Problem::error(&at, message, "write every wavelength once").label("second time")
            });
        }
    }
}

fn check_line(c: &mut Checker<'_>, path: impl Text, nm: f64) -> bool {
    c.finite(path, "the wavelength", nm)
        && c.require(nm > 0.0, || {
            let message = format!("a wavelength must be above 0 nm, not {}", show(nm));
            Problem::error(
                path.to_string(),
                message,
                "write a vacuum wavelength in nanometers; visible light has 380 to 780",
            )
            .label("not a wavelength")
        })
}

/// Objects face something that makes an image of them. What is wrong with a body may be the reason that they do not: that
/// comes first.
pub(super) fn check_objects(c: &mut Checker<'_>, scene: &Scene) {
    let are_bodies_sound = !c.has_faulty_body
        && scene.bodies.iter().all(|body| !matches!(body.shape, Shape::Disk { radius } if radius.is_nan()));
    let objects = scene.sources.iter().filter(|source| matches!(source.light, Light::Object { .. })).count();
    let are_few = c.at_most("sources", "a scene", "objects", objects as u64, Limit::Objects);
    for (k, source) in scene.sources.iter().enumerate().filter(|_| are_bodies_sound && are_few) {
        let Light::Object { from, to } = source.light else { continue };
        if !from.is_finite() || !to.is_finite() || from == to {
            continue;
        }
        let path = || format!("sources[{k}].light");
        let Some((body, axis)) = facing(&scene.bodies, from) else {
            let message = "nothing in the scene makes an image of this object";
            let help =
                "add a `ThinLens`, a `Mirror` on an `Arc` or a `Flat`, a `Lens` or a `LensGroup`, or use a `Fan`";
            c.push(Problem::error(path(), message, help).label("faces nothing"));
            continue;
        };
        c.require(axis.along_light(to).is_some(), || {
            let name = scene.bodies[body].name.clone().unwrap_or_else(|| format!("#{body}"));
            let message = format!("the tip of the object stands within or beside `{name}`, which it faces");
            Problem::error(path(), message, "move the whole object in front of it or behind it").label("not in front")
        });
    }
}

/// The rays of all sources together, before any memory is taken for them; tells whether they are few enough.
pub(super) fn check_ray_total(c: &mut Checker<'_>, sources: &[Source]) -> bool {
    let most = c.limits.of(Limit::Rays);
    let mut total: u64 = 0;
    for (k, source) in sources.iter().enumerate() {
        let before = total;
        total = total.saturating_add(rays(&source.light).saturating_mul(lines(&source.spectrum)));
        if before <= most && total > most {
            let message =
                format!("the scene has {total} rays so far, each counted once per line; at most {most} are allowed");
            let help = format!("lower `rays` or the number of spectral lines; {}", Limit::Rays.cure());
            c.push(Problem::error(format!("sources[{k}].light"), message, help).label("too many"));
        }
    }
    total <= most && sources.iter().all(|source| lines(&source.spectrum) <= c.limits.of(Limit::Lines))
}

fn rays(light: &Light) -> u64 {
    match light {
        Light::Ray { .. } => 1,
        Light::Object { .. } => OBJECT_RAYS,
        Light::Beam { rays, .. } | Light::Fan { rays, .. } | Light::Point { rays, .. } => u64::from(*rays),
    }
}

fn lines(spectrum: &Spectrum) -> u64 {
    match spectrum {
        Spectrum::Line(_) => 1,
        Spectrum::Lines(lines) => lines.len() as u64,
        Spectrum::White { samples } => u64::from(*samples),
    }
}
