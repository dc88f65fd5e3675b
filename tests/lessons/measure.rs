//! What lessons measure, and the closed forms that they hold it against.

use glam::DVec2;
use snellius::light::Wavelength;
use snellius::media::catalog;
use snellius::numerics::{Turn, acos_degrees, asin_degrees, atan2_degrees, cross};
use snellius::scene::Scene;
use snellius::trace::{Ending, Segment, TracedRay};

use crate::support::{Run, run_scene, segment};

pub(crate) fn sin(degrees: f64) -> f64 {
    Turn::degrees(degrees).sin
}

pub(crate) fn cos(degrees: f64) -> f64 {
    Turn::degrees(degrees).cos
}

pub(crate) fn tan(degrees: f64) -> f64 {
    sin(degrees) / cos(degrees)
}

pub(crate) fn asin(x: f64) -> f64 {
    asin_degrees(x)
}

pub(crate) fn acos(x: f64) -> f64 {
    acos_degrees(x)
}

pub(crate) fn atan(x: f64) -> f64 {
    atan2_degrees(x, 1.0)
}

/// Index of a catalog medium at the helium d line.
pub(crate) fn index(medium: &str) -> f64 {
    index_at(medium, Wavelength::D)
}

/// Index of a catalog medium.
pub(crate) fn index_at(medium: &str, wavelength: Wavelength) -> f64 {
    catalog::find(medium).unwrap().dispersion().index(wavelength)
}

/// Reflected fractions (s, p) by the Fresnel equations in their usual form, at an angle of incidence in degrees.
pub(crate) fn fresnel(n_i: f64, n_t: f64, theta_i: f64) -> (f64, f64) {
    let (cos_i, cos_t) = (cos(theta_i), cos(asin(n_i * sin(theta_i) / n_t)));
    let s = (n_i * cos_i - n_t * cos_t) / (n_i * cos_i + n_t * cos_t);
    let p = (n_t * cos_i - n_i * cos_t) / (n_t * cos_i + n_i * cos_t);
    (s * s, p * p)
}

/// A source's ray, of its first line.
pub(crate) fn ray(run: &Run, source: usize, number: usize) -> &TracedRay {
    run.trace.tree.rays.iter().find(|ray| ray.source == source && ray.ray == number).unwrap()
}

/// The only ray of a scene.
pub(crate) fn only_ray(run: &Run) -> &TracedRay {
    assert_eq!(run.trace.tree.rays.len(), 1);
    &run.trace.tree.rays[0]
}

/// The branch of a ray that escapes, where only one does.
pub(crate) fn exit(ray: &TracedRay) -> &Segment {
    let mut escaped = ray.segments.iter().filter(|segment| segment.ending == Ending::Escaped);
    let exit = escaped.next().unwrap();
    assert!(escaped.next().is_none(), "ray {} leaves twice", ray.name());
    exit
}

/// The letters of a branch's way.
pub(crate) fn path(ray: &TracedRay, segment: &Segment) -> String {
    ray.address(segment.id).rsplit(':').next().unwrap().to_owned()
}

/// Angle from one direction to another in degrees, counter-clockwise positive.
pub(crate) fn turn(from: DVec2, to: DVec2) -> f64 {
    atan2_degrees(cross(from, to), from.dot(to))
}

/// Angle of incidence at the end of the branch with this path, in degrees.
pub(crate) fn theta_i(ray: &TracedRay, path: &str) -> f64 {
    segment(ray, path).hit.unwrap().theta_i_degrees()
}

/// Angle of transmission at the end of the branch with this path, in degrees.
pub(crate) fn theta_t(ray: &TracedRay, path: &str) -> f64 {
    segment(ray, path).hit.unwrap().theta_t_degrees().unwrap()
}

/// Distance of a branch's start from another branch's line, positive to the left of that line.
pub(crate) fn offset(line: &Segment, branch: &Segment) -> f64 {
    cross(line.direction, branch.from - line.from)
}

/// Fails if a ray has a branch with this path.
#[track_caller]
pub(crate) fn no_branch(ray: &TracedRay, letters: &str) {
    assert!(ray.segments.iter().all(|segment| path(ray, segment) != letters), "{letters} in ray {}", ray.name());
}

/// The same scene, changed and traced again.
pub(crate) fn changed(run: &Run, change: impl FnOnce(&mut Scene)) -> Run {
    let mut scene = run.scene.clone();
    change(&mut scene);
    run_scene(scene)
}

/// Fails unless two numbers differ by at most `tolerance`.
#[track_caller]
pub(crate) fn near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} is not {expected} ± {tolerance:e}");
}

/// Fails unless two directions agree within `tolerance`.
#[track_caller]
pub(crate) fn along(found: DVec2, expected: DVec2, tolerance: f64) {
    assert!((found - expected).length() <= tolerance, "{found} is not along {expected}");
}
