//! The least that a trace can cost: a replay that is told what every ray meets, and does the arithmetic of the hit, the law,
//! the powers and the record.

use std::slice::Iter;

use glam::DVec2;
use snellius::geometry::{CircleRoots, Curve};
use snellius::laws::{Refraction, Shares, fresnel, optical_path_length, reflect, refract};
use snellius::light::Power;
use snellius::system::{Interface, RayStart};
use snellius::{Ending, Hit, OpticalSystem, Segment, SegmentId, TracedRay, Via, Visitor, visit};

use crate::flat::NONE;

/// A trace that is known in advance.
pub(crate) struct Replay<'a> {
    system: &'a OpticalSystem,
    /// What every followed segment meets, in order, and whether it comes from its left.
    plan: Vec<Option<(usize, bool)>>,
    min_power: f64,
    max_depth: u32,
    /// A ray and a segment of the trace, of which every other is made.
    ray: TracedRay,
    segment: Segment,
    /// Indices on the left and the right of every interface.
    indices: Vec<[f64; 2]>,
}

struct Branch {
    parent: Option<SegmentId>,
    via: Via,
    from: DVec2,
    direction: DVec2,
    n: f64,
    power: Power,
    optical_path: f64,
    hits: u32,
    last: usize,
}

/// One ray on its way through the plan.
struct Run<'plan, 'run, V> {
    replay: &'plan Replay<'plan>,
    ray: &'run TracedRay,
    next: &'run mut Iter<'plan, Option<(usize, bool)>>,
    waiting: &'run mut Vec<Branch>,
    visitor: &'run mut V,
}

impl<'a> Replay<'a> {
    /// Records the trace of a system whose interfaces all refract, at one wavelength.
    pub(crate) fn new(system: &'a OpticalSystem, min_power: f64, max_depth: u32) -> Self {
        let line = system.sources()[0].lines[0];
        let indices = |one: &Interface| [one.left, one.right].map(|medium| system.index(medium, line));
        let indices = system.interfaces().iter().map(indices).collect();
        let mut recorder = Recorder { system, plan: Vec::new(), first_hit: None };
        visit(system, &mut recorder);
        let (ray, segment) = recorder.first_hit.unwrap();
        Self { system, plan: recorder.plan, min_power, max_depth, ray, segment, indices }
    }

    /// Hands every segment of the trace to a visitor.
    pub(crate) fn visit(&self, visitor: &mut impl Visitor) {
        let (mut next, mut waiting) = (self.plan.iter(), Vec::new());
        for (number, source) in self.system.sources().iter().enumerate() {
            for (k, start) in source.starts.iter().enumerate() {
                let mut ray = self.ray.clone();
                (ray.source, ray.ray, ray.wavelength) = (number, k, source.lines[0]);
                ray.power = source.power.total();
                let n = self.system.index(start.medium, ray.wavelength);
                let (next, waiting, visitor) = (&mut next, &mut waiting, &mut *visitor);
                let mut run = Run { replay: self, ray: &ray, next, waiting, visitor };
                run.follow(start, source.power, n);
            }
        }
    }
}

impl<V: Visitor> Run<'_, '_, V> {
    fn follow(&mut self, start: &RayStart, power: Power, n: f64) {
        let RayStart { from, direction, .. } = *start;
        let (parent, via) = (None, Via::Source);
        self.waiting.push(Branch { parent, via, from, direction, n, power, optical_path: 0.0, hits: 0, last: NONE });
        let mut id = 0;
        while let Some(branch) = self.waiting.pop() {
            let segment = self.segment(SegmentId(id), &branch);
            self.visitor.segment(self.ray, segment);
            id += 1;
        }
    }

    #[inline]
    fn segment(&mut self, id: SegmentId, branch: &Branch) -> Segment {
        let is_deep = branch.hits >= self.replay.max_depth;
        let is_weak = branch.power.total() < self.replay.min_power * self.ray.power;
        let met = if is_deep || is_weak { None } else { *self.next.next().unwrap() };
        let ending = match (is_deep, is_weak) {
            (true, _) => Ending::CutMaxDepth,
            (_, true) => Ending::CutMinPower,
            _ => Ending::Escaped,
        };
        let segment = branch.segment(self.replay.segment, id, branch.from + self.replay.system.origin(), ending);
        match met {
            Some((interface, from_left)) => self.arrive(branch, interface, from_left, segment),
            None => segment,
        }
    }

    #[inline]
    fn arrive(&mut self, branch: &Branch, interface: usize, from_left: bool, mut segment: Segment) -> Segment {
        let met = &self.replay.system.interfaces()[interface];
        let distance = distance(&met.curve, branch, branch.last == interface, from_left);
        let at = met.curve.clamp(met.curve.project(branch.from + distance * branch.direction));
        let left = met.curve.normal_at(at);
        let [n_left, n_right] = self.replay.indices[interface];
        let (normal, n_i, n_t) = if from_left { (left, n_left, n_right) } else { (-left, n_right, n_left) };
        let mut hit = self.replay.segment.hit.unwrap();
        (hit.body, hit.normal, hit.n_i, hit.n_t) = (met.body, normal, n_i, Some(n_t));
        let transmitted = refraction(branch.direction, &mut hit);
        let optical_path = branch.optical_path + optical_path_length(n_i, branch.from.distance(at));
        let mut send = |via, direction, share: Power, n| {
            let power = branch.power.times(share);
            if power.total() > 0.0 {
                let (parent, hits) = (Some(segment.id), branch.hits + 1);
                let branch = Branch { parent, via, from: at, direction, n, power, optical_path, hits, last: interface };
                self.waiting.push(branch);
            }
        };
        let via = if hit.total_internal_reflection { Via::TotalInternalReflection } else { Via::Reflection };
        send(via, reflect(branch.direction, normal), hit.reflectance, n_i);
        if let Some(direction) = transmitted {
            send(Via::Transmission, direction, hit.transmittance, n_t);
        }
        segment.to = Some(at + self.replay.system.origin());
        (segment.optical_path, segment.ending, segment.hit) = (optical_path, Ending::Interface, Some(hit));
        segment
    }
}

impl Branch {
    /// As it is recorded where it meets nothing.
    fn segment(&self, mut segment: Segment, id: SegmentId, from: DVec2, ending: Ending) -> Segment {
        (segment.id, segment.parent, segment.via) = (id, self.parent, self.via);
        (segment.from, segment.to, segment.direction) = (from, None, self.direction);
        (segment.medium_index, segment.power, segment.optical_path) = (self.n, self.power, self.optical_path);
        (segment.ending, segment.hit) = (ending, None);
        segment
    }
}

/// Where a ray meets a curve that it is known to meet.
fn distance(curve: &Curve, branch: &Branch, stands_on_it: bool, from_left: bool) -> f64 {
    let (from, direction) = (branch.from, branch.direction);
    if curve.is_straight() {
        return curve.n.dot(curve.m - from) / curve.n.dot(direction);
    }
    if stands_on_it {
        return 2.0 * curve.normal_at(from).dot(direction) / curve.curvature;
    }
    let roots = CircleRoots::new(curve, from, direction);
    if from_left { roots.from_left } else { roots.from_right }
}

/// Snell and Fresnel: the transmitted direction; angles and shares go into the hit.
fn refraction(v: DVec2, hit: &mut Hit) -> Option<DVec2> {
    let (n_i, n_t) = (hit.n_i, hit.n_t?);
    let refraction = refract(v, hit.normal, n_i, n_t);
    (hit.cos_i, hit.sin_i) = (refraction.cos_i(), refraction.sin_i());
    let (direction, shares) = match refraction {
        Refraction::Refracted { direction, cos_i, sin_i, cos_t, sin_t } => {
            (hit.cos_t, hit.sin_t) = (Some(cos_t), Some(sin_t));
            (Some(direction), Shares::fresnel(fresnel(n_i, n_t, cos_i, sin_i, cos_t, sin_t)))
        }
        Refraction::TotalInternalReflection { .. } => {
            (hit.cos_t, hit.sin_t) = (None, None);
            (None, Shares::total_reflection())
        }
    };
    hit.total_internal_reflection = direction.is_none();
    (hit.reflectance, hit.transmittance) = (shares.reflectance, shares.transmittance);
    direction
}

/// Writes the plan of a trace.
struct Recorder<'a> {
    system: &'a OpticalSystem,
    plan: Vec<Option<(usize, bool)>>,
    first_hit: Option<(TracedRay, Segment)>,
}

impl Visitor for Recorder<'_> {
    fn segment(&mut self, ray: &TracedRay, segment: Segment) {
        if self.first_hit.is_none() && segment.hit.is_some() {
            self.first_hit = Some((ray.clone(), segment));
        }
        match (segment.ending, segment.to.zip(segment.hit)) {
            (Ending::CutMinPower | Ending::CutMaxDepth, _) => {}
            (Ending::Escaped, _) => self.plan.push(None),
            (_, Some((to, hit))) => self.plan.push(Some(self.met(to - self.system.origin(), &hit))),
            (ending, None) => panic!("a trace that ends so cannot be replayed: {ending:?}"),
        }
    }
}

impl Recorder<'_> {
    /// The interface of a hit, and whether it was met from its left: of the body's own the nearest with that normal.
    fn met(&self, at: DVec2, hit: &Hit) -> (usize, bool) {
        let off = |curve: &Curve| {
            let cosine = curve.normal_at(at).dot(hit.normal);
            curve.clamp(curve.project(at)).distance(at) + (1.0 - cosine.abs())
        };
        let of_body = self.system.interfaces().iter().enumerate().filter(|(_, one)| one.body == hit.body);
        let (k, one) = of_body.min_by(|a, b| off(&a.1.curve).total_cmp(&off(&b.1.curve))).unwrap();
        (k, one.curve.normal_at(at).dot(hit.normal) > 0.0)
    }
}
