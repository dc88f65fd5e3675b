use super::body::check_shares;
use super::checker::{Checker, Text, show, show_point};
use crate::scene::{DiagramSettings, Limit, MAX_PIXELS, MIN_PIXELS, Problem, SecondaryRays, TraceSettings, View};

/// How far rays are followed.
pub(super) fn check_trace(c: &mut Checker<'_>, trace: &TraceSettings) {
    if let SecondaryRays::Fixed { kr, kt } = trace.secondary_rays {
        let path = "trace.secondary_rays";
        check_shares(c, path, [format!("{path}.kr"), format!("{path}.kt")], [kr, kt], ["`kr`", "`kt`"]);
    }
    c.count("trace.max_depth", "`max_depth`", u64::from(trace.max_depth), [1, u64::from(u32::MAX)]);
    c.limited("trace.max_segments", "`max_segments`", trace.max_segments, 1, Limit::Segments);
    check_fraction(c, "trace.min_power", "`min_power`", trace.min_power);
}

/// What the figure shows.
pub(super) fn check_diagram(c: &mut Checker<'_>, diagram: &DiagramSettings) {
    let mut sound = true;
    for (k, what) in ["the figure's width", "the figure's height"].into_iter().enumerate() {
        let bounds = [u64::from(MIN_PIXELS), u64::from(MAX_PIXELS)];
        sound &= c.count(format_args!("diagram.size[{k}]"), what, u64::from(diagram.size[k]), bounds);
    }
    if sound {
        let pixels = diagram.size.iter().map(|side| u64::from(*side)).product();
        c.at_most("diagram.size", "a figure", "pixels", pixels, Limit::Pixels);
    }
    check_fraction(c, "diagram.faintest", "`faintest`", diagram.faintest);
    c.at_most("diagram.deviations", "a figure", "deviations", diagram.deviations.len() as u64, Limit::Deviations);
    if let Some(step) = diagram.wavefronts {
        c.length("diagram.wavefronts", "the optical path between wavefronts", step);
    }
    if let View::Box(first, second) = diagram.view {
        let path = "diagram.view";
        let sound = c.point(format_args!("{path}.corners[0]"), "the first corner", first)
            & c.point(format_args!("{path}.corners[1]"), "the second corner", second);
        c.require(!sound || (second - first).abs().min_element() > 0.0, || {
            let (first, second) = (show_point(first), show_point(second));
            let message = format!("the box from {first} to {second} has no area");
            Problem::error(path.to_string(), message, "write two opposite corners: `Box((-50, -30), (50, 30))`")
                .label("no area")
        });
    }
}

/// A share of a power that may be 0 and is below 1.
fn check_fraction(c: &mut Checker<'_>, path: impl Text, what: impl Text, value: f64) {
    c.require((0.0..1.0).contains(&value), || {
        let message = format!(
            "{what} is a share of the starting power from 0 up to, but not including, 1; here it is {}",
            show(value)
        );
        Problem::error(path.to_string(), message, "write a number such as `0.001`, or `0` to keep every branch")
            .label("out of range")
    });
}
