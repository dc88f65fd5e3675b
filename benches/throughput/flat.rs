//! The Fresnel trace as one writes it first: flat arrays, a stack, and sums. Only the way to find the nearest hit differs
//! between the competitors that use it.

use glam::DVec2;
use snellius::OpticalSystem;
use snellius::geometry::Curve;
use snellius::laws::{Refraction, fresnel, optical_path_length, reflect, refract};
use snellius::light::Power;
use snellius::numerics::Sum;

/// No edge.
pub(crate) const NONE: usize = usize::MAX;

/// A search: from a point ahead, the nearest curve but for one, and its distance.
pub(crate) trait Nearest: Fn(DVec2, DVec2, usize) -> Option<(usize, f64)> {}

impl<F: Fn(DVec2, DVec2, usize) -> Option<(usize, f64)>> Nearest for F {}

/// Interfaces that refract, edges before arcs, and ray starts of a system at the first line of its source.
pub(crate) struct Flat {
    pub(crate) curves: Vec<Curve>,
    /// How many of them are edges.
    pub(crate) edges: usize,
    /// Indices on the left and the right.
    indices: Vec<[f64; 2]>,
    pub(crate) starts: Vec<(DVec2, DVec2, Power)>,
    pub(crate) min_power: f64,
    pub(crate) max_depth: u32,
}

/// What became of the light, summed up as a trace without a tree sums it.
#[derive(Clone, Copy, Default)]
pub(crate) struct Light {
    pub(crate) followed: u64,
    pub(crate) cut: u64,
    escaped: Sum,
    unaccounted: Sum,
}

/// A branch with all that a trace without a tree carries along.
struct Branch {
    id: u32,
    from: DVec2,
    direction: DVec2,
    power: Power,
    optical_path: f64,
    last: usize,
    hits: u32,
}

impl Flat {
    pub(crate) fn new(system: &OpticalSystem, min_power: f64, max_depth: u32) -> Self {
        let line = system.sources()[0].lines[0];
        let mut interfaces: Vec<_> = system.interfaces().iter().collect();
        interfaces.sort_by_key(|interface| !interface.curve.is_straight());
        let starts = system
            .sources()
            .iter()
            .flat_map(|source| source.starts.iter().map(|start| (start.from, start.direction, source.power)));
        Self {
            edges: interfaces.iter().filter(|interface| interface.curve.is_straight()).count(),
            curves: interfaces.iter().map(|interface| interface.curve).collect(),
            indices: interfaces.iter().map(|it| [it.left, it.right].map(|medium| system.index(medium, line))).collect(),
            starts: starts.collect(),
            min_power,
            max_depth,
        }
    }

    /// Traces the first `rays` rays.
    pub(crate) fn trace(&self, rays: usize, nearest: impl Nearest) -> Light {
        let mut light = Light::default();
        let mut waiting = Vec::new();
        for &(from, direction, power) in self.starts.iter().take(rays) {
            let least = self.min_power * power.total();
            let mut next = 0;
            waiting.push(Branch { id: 0, from, direction, power, optical_path: 0.0, last: NONE, hits: 0 });
            while let Some(mut branch) = waiting.pop() {
                branch.id = next;
                next += 1;
                if branch.hits >= self.max_depth || branch.power.total() < least {
                    light.cut += 1;
                    light.unaccounted.add(branch.power.total());
                    continue;
                }
                light.followed += 1;
                match nearest(branch.from, branch.direction, branch.last) {
                    Some((k, distance)) => self.hit(&branch, k, distance, &mut waiting),
                    None => light.escaped.add(branch.power.total()),
                }
            }
        }
        light
    }

    fn hit(&self, branch: &Branch, last: usize, distance: f64, waiting: &mut Vec<Branch>) {
        let curve = &self.curves[last];
        let direction = branch.direction;
        let from = curve.clamp(curve.project(branch.from + distance * direction));
        let left = curve.normal_at(from);
        let [n_left, n_right] = self.indices[last];
        let from_left = left.dot(direction) < 0.0;
        let (n, n_i, n_t) = if from_left { (left, n_left, n_right) } else { (-left, n_right, n_left) };
        let optical_path = branch.optical_path + optical_path_length(n_i, branch.from.distance(from));
        let mut send = |direction, power: Power| {
            if power.total() > 0.0 {
                let (id, hits) = (branch.id, branch.hits + 1);
                waiting.push(Branch { id, from, direction, power, optical_path, last, hits });
            }
        };
        let reflected = reflect(direction, n);
        match refract(direction, n, n_i, n_t) {
            Refraction::TotalInternalReflection { .. } => send(reflected, branch.power),
            Refraction::Refracted { direction, cos_i, sin_i, cos_t, sin_t } => {
                let shares = fresnel(n_i, n_t, cos_i, sin_i, cos_t, sin_t);
                send(reflected, branch.power.times(shares.reflectance));
                send(direction, branch.power.times(shares.transmittance));
            }
        }
    }
}

impl Light {
    /// All power that was sent out.
    pub(crate) fn total(&self) -> f64 {
        self.escaped.value() + self.unaccounted.value()
    }
}
