use glam::DVec2;

use super::checker::{Checker, Text, show_point};
use super::crossing::{Fault, MOST_STEPS, first_fault};
use crate::geometry::Curve;
use crate::numerics::{Sum, cross};
use crate::scene::{MAX_LENGTH, PathStep, Problem};

/// The vertices of a simple polygon; `path` is that of their list.
pub(super) fn check_polygon(c: &mut Checker<'_>, path: impl Text, points: &[DVec2]) {
    let at = |k: usize| format!("{path}[{k}]");
    let enough = c.at_least(path, "a polygon", "points", points.len(), 3);
    // One far point is enough to tell.
    let sound =
        points.iter().enumerate().all(|(k, p)| is_near(*p) || c.point(format_args!("{path}[{k}]"), "a point", *p));
    let Some(first) = points.first().filter(|_| enough && sound) else { return };
    let repeated = points.windows(2).position(|pair| pair[0] == pair[1]);
    if let Some(k) = repeated {
        let message = format!("the point {} stands twice in a row", show_point(points[k]));
        c.push(Problem::error(at(k + 1), message, "leave one of the two out").label("same as before"));
    } else if points.last() == Some(first) {
        let help = "leave the last point out: an outline closes by itself";
        let problem = Problem::error(at(points.len() - 1), "the last point repeats the first one", help);
        c.push(problem.label("same as the first"));
    } else {
        let next = points.iter().cycle().skip(1);
        let edges: Vec<Curve> = points.iter().zip(next).map(|(a, b)| Curve::line(*a, *b)).collect();
        check_chain(c, path, at, &edges);
    }
}

/// Whether a point is sound at first sight; spares a long list the texts that a problem would need.
fn is_near(p: DVec2) -> bool {
    // The larger of a number and NaN is the number.
    p.x.abs() <= MAX_LENGTH && p.y.abs() <= MAX_LENGTH
}

/// Edges and arcs in order; `path` is that of the shape.
pub(super) fn check_outline(c: &mut Checker<'_>, path: impl Text, start: DVec2, steps: &[PathStep]) {
    let list = format!("{path}.path");
    let mut sound = c.point(format_args!("{path}.start"), "the start", start);
    sound &= c.at_least(&list, "an outline", "steps", steps.len(), 1);
    let mut here = start;
    let mut curves = Vec::new();
    for (k, step) in steps.iter().enumerate() {
        let curve = check_step(c, format_args!("{list}[{k}]"), here, *step);
        let (PathStep::LineTo(to) | PathStep::ArcTo { to, .. }) = step;
        here = *to;
        sound &= curve.is_some();
        curves.extend(curve);
    }
    if sound {
        if here != start {
            curves.push(Curve::line(here, start));
        }
        check_chain(c, &list, |k| format!("{list}[{}]", k.min(steps.len() - 1)), &curves);
    }
}

fn check_step(c: &mut Checker<'_>, path: impl Text, from: DVec2, step: PathStep) -> Option<Curve> {
    match step {
        PathStep::LineTo(to) => {
            let sound = c.point(format_args!("{path}.to"), "a point", to)
                && c.require(to != from, || {
                    let message = format!("the edge to {} has no length: it begins there", show_point(to));
                    Problem::error(path.to_string(), message, "leave the step out").label("no length")
                });
            sound.then(|| Curve::line(from, to))
        }
        PathStep::ArcTo { through, to } => {
            let sound = c.point(format_args!("{path}.through"), "a point", through)
                & c.point(format_args!("{path}.to"), "a point", to);
            sound.then(|| check_three_points(c, path, from, through, to)).flatten()
        }
    }
}

/// An open arc; `path` is that of the shape.
pub(super) fn check_arc(c: &mut Checker<'_>, path: impl Text, from: DVec2, through: DVec2, to: DVec2) {
    let points = [("from", from), ("through", through), ("to", to)];
    let sound = points.map(|(name, p)| c.point(format_args!("{path}.{name}"), "a point", p));
    if sound == [true; 3] {
        check_three_points(c, path, from, through, to);
    }
}

fn check_three_points(c: &mut Checker<'_>, path: impl Text, from: DVec2, through: DVec2, to: DVec2) -> Option<Curve> {
    let arc = Curve::arc(from, through, to).filter(|arc| arc.curvature.is_finite() && arc.curvature != 0.0);
    let points = || [from, through, to].map(show_point);
    let (message, help) = if from == to {
        (format!("the arc ends where it begins, at {}", points()[0]), "use a `Disk` for a full circle, or two arcs")
    } else if through == from || through == to {
        (format!("the arc's middle point {} is one of its ends", points()[1]), "write a point between the two ends")
    } else {
        let [from, through, to] = points();
        let message = format!("no arc goes through {from}, {through} and {to}: they lie on one line");
        (message, "move the middle point off the line, or draw a straight line")
    };
    c.require(arc.is_some(), || Problem::error(path.to_string(), message, help).label("not an arc"));
    arc
}

/// A closed chain of sound curves encloses an area and does not meet itself; `at` names the place of a curve.
fn check_chain(c: &mut Checker<'_>, path: impl Text, at: impl Fn(usize) -> String, curves: &[Curve]) {
    let area = c.require(encloses_area(curves), || {
        Problem::error(path.to_string(), "the outline encloses no area", "move the points apart: they lie on one line")
            .label("no area")
    });
    if c.comparisons > MOST_STEPS {
        // Told of the outline before.
        return;
    }
    let problem = match first_fault(curves, &mut c.comparisons).filter(|_| area) {
        None => return,
        Some(Fault::Meet(i, j)) => {
            let [first, second] = [i, j].map(|k| described(&curves[k]));
            let message = format!("the outline crosses or touches itself: {first} meets {second}");
            let help = "put the points in the order in which they follow each other around the shape";
            Problem::error(at(i), message, help).label("one of the two begins here")
        }
        Some(Fault::TooTangled) => {
            let message = "the outline has too many long edges side by side to check that none of them cross";
            Problem::error(path.to_string(), message, "use fewer points, or several bodies").label("too many")
        }
    };
    c.push(problem);
}

fn described(curve: &Curve) -> String {
    let what = if curve.is_straight() { "the edge" } else { "the arc" };
    format!("{what} from {} to {}", show_point(curve.a), show_point(curve.b))
}

/// Whether some point lies off the first curve's chord, or the arcs alone enclose something.
fn encloses_area(curves: &[Curve]) -> bool {
    let Some(first) = curves.first() else { return false };
    let flat = curves.iter().all(Curve::is_straight);
    if flat {
        return curves.iter().any(|curve| cross(first.b - first.a, curve.b - first.a) != 0.0);
    }
    let (mut area, mut size) = (Sum::default(), Sum::default());
    for curve in curves {
        let [a, m, b] = [curve.a, curve.midpoint(), curve.b].map(|p| p - first.a);
        // A third of the bulge between chord and arc is missing, which leaves the sign of the whole alone.
        let part = cross(a, m) + cross(m, b);
        area.add(part);
        size.add(part.abs());
    }
    area.value().abs() > 1e-12 * size.value()
}
