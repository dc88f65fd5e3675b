//! What is where, by the plainest means: none of it shared with the compiler or the tracer.

use glam::DVec2;
use snellius::OpticalSystem;
use snellius::geometry::Curve;
use snellius::light::Wavelength;

/// Index at a point more than `clear` off all outlines: that of the last body that holds it.
pub(crate) fn index_at(system: &OpticalSystem, wavelength: Wavelength, p: DVec2, clear: f64) -> f64 {
    // Off the chords of arcs, too, which run through bodies.
    let p = p + clear * DVec2::new(0.11, 0.27);
    let outlines = system.bodies().iter().flat_map(|body| &body.outlines);
    let last = outlines.rev().find(|outline| outline.medium.is_some() && holds(&outline.curves, p));
    system.index(last.and_then(|outline| outline.medium).unwrap_or(system.surroundings()), wavelength)
}

/// Winding number of the chords, and of the caps between chord and arc.
pub(crate) fn holds(curves: &[Curve], p: DVec2) -> bool {
    curves.iter().map(|curve| chord_winding(curve, p) + cap_winding(curve, p)).sum::<i32>() != 0
}

fn chord_winding(curve: &Curve, p: DVec2) -> i32 {
    let left = (curve.b - curve.a).perp_dot(p - curve.a);
    match (curve.a.y <= p.y, curve.b.y <= p.y) {
        (true, false) if left > 0.0 => 1,
        (false, true) if left < 0.0 => -1,
        _ => 0,
    }
}

fn cap_winding(curve: &Curve, p: DVec2) -> i32 {
    if curve.curvature == 0.0 {
        return 0;
    }
    let in_circle = (p - curve.center()).length() < curve.curvature.abs().recip();
    let right_of_chord = (curve.b - curve.a).perp_dot(p - curve.a) < 0.0;
    match (in_circle, right_of_chord, curve.curvature > 0.0) {
        (true, true, true) => 1,
        (true, false, false) => -1,
        _ => 0,
    }
}

/// Distance from a point to the nearest outline of any body, at least.
pub(crate) fn clearance(system: &OpticalSystem, p: DVec2) -> f64 {
    let curves = system.bodies().iter().flat_map(|body| &body.outlines).flat_map(|outline| &outline.curves);
    curves.map(|curve| distance(curve, p)).fold(f64::INFINITY, f64::min)
}

/// Distance from a point to a curve.
pub(crate) fn distance(curve: &Curve, p: DVec2) -> f64 {
    let to_ends = p.distance(curve.a).min(p.distance(curve.b));
    let foot = foot(curve, p);
    if is_between(curve, foot) { to_ends.min(p.distance(foot)) } else { to_ends }
}

/// The nearest point of a curve's line or circle.
fn foot(curve: &Curve, p: DVec2) -> DVec2 {
    if curve.curvature == 0.0 {
        let chord = curve.b - curve.a;
        return curve.a + (p - curve.a).dot(chord) / chord.length_squared() * chord;
    }
    let center = curve.center();
    center + (p - center).normalize_or_zero() / curve.curvature.abs()
}

/// Whether a point of a curve's line or circle lies on the curve.
fn is_between(curve: &Curve, p: DVec2) -> bool {
    let chord = curve.b - curve.a;
    if curve.curvature == 0.0 {
        let along = (p - curve.a).dot(chord);
        return 0.0 <= along && along <= chord.length_squared();
    }
    chord.perp_dot(p - curve.a) * curve.curvature <= 0.0
}

/// Where the line through `from` along `direction` meets a curve: distances along it.
pub(crate) fn crossings(curve: &Curve, from: DVec2, direction: DVec2) -> Vec<f64> {
    let distances = if curve.curvature == 0.0 {
        let chord = curve.b - curve.a;
        vec![(curve.a - from).perp_dot(chord) / direction.perp_dot(chord)]
    } else {
        let to_center = curve.center() - from;
        let (along, across) = (to_center.dot(direction), to_center.perp_dot(direction));
        let half = ((curve.curvature * curve.curvature).recip() - across * across).sqrt();
        vec![along - half, along + half]
    };
    distances.into_iter().filter(|t| t.is_finite() && is_between(curve, from + *t * direction)).collect()
}
