//! The computed path as the exact path of slightly different inputs: by how many units each hit's place, normal and
//! direction would have to be changed, so that the laws hold exactly.
//!
//! Lengths are in u times the scene's size (its largest absolute coordinate), angles and indices in u.

use f256::f256;
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;
use snellius::geometry::Curve;
use snellius::system::{Action, Interface};
use snellius::trace::{Segment, TracedRay, Via};

use crate::scenes::{Random, free_scenes};
use crate::support::figures::{U, at_most, counted, size};
use crate::support::wide::{Wide2, narrow, wide};
use crate::support::{Run, run, run_scene, scene_names};

/// The largest change of each kind that some hit needs.
#[derive(Default)]
struct Backward {
    hits: u32,
    off_ray: f64,
    off_curve: f64,
    normal: f64,
    reflection: f64,
    refraction: f64,
}

impl Backward {
    fn add(&mut self, run: &Run) {
        let size = scene_size(run);
        for ray in &run.trace.tree.rays {
            for segment in ray.segments.iter().filter(|segment| segment.to.is_some()) {
                self.hits += 1;
                self.hit(run, ray, segment, size);
            }
        }
    }

    fn hit(&mut self, run: &Run, ray: &TracedRay, segment: &Segment, size: f64) {
        let (Some(to), Some(hit)) = (segment.to, segment.hit) else { return };
        let (v, n) = (Wide2::from(segment.direction).unit(), Wide2::from(hit.normal).unit());
        let way = Wide2::from(to) - Wide2::from(segment.from);
        self.off_ray = self.off_ray.max(narrow(v.cross(way)).abs() / (U * size));
        let at = Wide2::from(to) - Wide2::from(run.system.origin());
        let (interface, off, turn) = self.interface(run, hit.body, at, n);
        self.off_curve = self.off_curve.max(off / (U * size));
        // A hit moved by one unit turns the normal of an arc by one unit times its curvature.
        self.normal = self.normal.max(turn / (U * (1.0 + interface.curve.curvature.abs() * size)));
        for child in ray.segments.iter().filter(|child| child.parent == Some(segment.id)) {
            let d = Wide2::from(child.direction).unit();
            match (child.via, interface.action) {
                (Via::Reflection | Via::TotalInternalReflection, _) => {
                    let reflected = v.cross(n) * -n.perp() - v.dot(n) * n;
                    self.reflection = self.reflection.max(narrow(d.cross(reflected)).abs() / U);
                }
                (Via::Transmission, Action::Refract | Action::Split { .. }) => {
                    let change = snell(v, n, d, hit.n_i, hit.n_t.unwrap());
                    self.refraction = self.refraction.max(change / U);
                }
                _ => {}
            }
        }
    }

    /// The interface of a body that a point lies on, how far off it is, and how far its normal there is turned from `n`.
    fn interface<'a>(&self, run: &'a Run, body: usize, at: Wide2, n: Wide2) -> (&'a Interface, f64, f64) {
        let own = run.system.interfaces().iter().filter(|interface| interface.body == body);
        let fits = own.filter_map(|interface| {
            let (off, normal) = offset(&interface.curve, at)?;
            Some((interface, narrow(off).abs(), narrow(normal.cross(n)).abs()))
        });
        fits.min_by(|a, b| (a.1 + a.2).total_cmp(&(b.1 + b.2))).unwrap()
    }
}

/// Distance of a point from a curve's whole line or circle, and the unit normal there; `None` in the circle's center.
fn offset(curve: &Curve, p: Wide2) -> Option<(f256, Wide2)> {
    let (n, curvature, q) = (Wide2::from(curve.n).unit(), wide(curve.curvature), p - Wide2::from(curve.m));
    let gradient = n - curvature * q;
    let value = wide(2.0) * n.dot(q) - curvature * q.dot(q);
    let length = gradient.length();
    (length > f256::ZERO).then(|| (value / (f256::ONE + length), gradient.unit()))
}

/// By how much V and T must be turned and both indices changed, relatively, for Snell's law to hold.
fn snell(v: Wide2, n: Wide2, t: Wide2, n_i: f64, n_t: f64) -> f64 {
    let (sin_i, sin_t) = (v.cross(n), t.cross(n));
    let off = wide(n_t) * sin_t - wide(n_i) * sin_i;
    let (cos_i, cos_t) = (v.dot(n).abs(), t.dot(n).abs());
    narrow(off.abs() / (wide(n_i) * (sin_i.abs() + cos_i) + wide(n_t) * (sin_t.abs() + cos_t)))
}

/// Largest absolute coordinate of interfaces and ray starts, in the scene and in the compiled system.
fn scene_size(run: &Run) -> f64 {
    let origin = run.system.origin();
    let ends = run.system.interfaces().iter().flat_map(|i| [i.curve.a, i.curve.b, i.curve.m]);
    let starts = run.trace.tree.rays.iter().map(|ray| ray.segments[0].from - origin);
    ends.chain(starts).map(|p| p.abs().max((p + origin).abs()).max_element()).fold(0.0, f64::max)
}

#[test]
fn the_computed_path_is_the_exact_path_of_nearby_inputs() {
    let mut worst = Backward::default();
    for name in scene_names() {
        worst.add(&run(&name));
    }
    let mut runner = TestRunner::deterministic();
    for _ in 0..size(300, 20_000) {
        let Random(scene) = free_scenes().new_tree(&mut runner).unwrap().current();
        worst.add(&run_scene(scene));
    }
    counted("backward error: hits", f64::from(worst.hits));
    at_most("backward error: a hit off its ray in u of the size", worst.off_ray, 6.0);
    at_most("backward error: a hit off its curve in u of the size", worst.off_curve, 6.0);
    at_most("backward error: a normal in u", worst.normal, 2.0);
    at_most("backward error: a reflected direction in u", worst.reflection, 3.0);
    at_most("backward error: Snell's law in u", worst.refraction, 2.0);
}
