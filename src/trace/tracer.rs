//! The tracer: a work queue of branches, each followed to its next interface. It hands every segment to a visitor and
//! keeps none, so that its memory grows with the depth of the tree and not with its size.

use glam::DVec2;

use crate::laws::optical_path_length;
use crate::light::Power;
use crate::scene::TraceSettings;
use crate::system::{MediumId, OpticalSystem, RayStart, Start, rounding};
use crate::trace::hit::{Arrival, Outcome, Secondary};
use crate::trace::nearest::{Crossing, Ray, beyond, nearest};
use crate::trace::{Ending, Segment, SegmentId, TracedRay, Via};

/// Receives the segments of a trace: rays in the order of sources, rays and lines, and each ray's segments depth-first,
/// transmitted before reflected. `ray` carries no segments.
pub trait Visitor {
    /// One segment, followed or cut.
    fn segment(&mut self, ray: &TracedRay, segment: Segment);
}

/// Follows every ray of the system through every hit.
pub fn visit(system: &OpticalSystem, visitor: &mut impl Visitor) {
    let mut tracer = Tracer::new(system);
    for (number, source) in system.sources.iter().enumerate() {
        for (ray, start) in source.starts.iter().enumerate() {
            for &wavelength in &source.lines {
                let traced = TracedRay {
                    source: number,
                    ray,
                    wavelength,
                    power: source.power.total(),
                    one_of_several_lines: source.lines.len() > 1,
                    segments: Vec::new(),
                };
                tracer.follow(&traced, start, source.power, visitor);
            }
        }
    }
}

/// A branch that waits to be followed; positions relative to the system's origin.
struct Branch {
    parent: Option<SegmentId>,
    via: Via,
    ray: Ray,
    power: Power,
    optical_path: f64,
    hits_behind: u32,
}

struct Tracer<'a> {
    system: &'a OpticalSystem,
    settings: TraceSettings,
    /// Distances below this are rounding.
    near: f64,
    segments_left: u64,
    waiting: Vec<Branch>,
    /// Index of every medium at the line being followed.
    indices: Vec<f64>,
}

impl<'a> Tracer<'a> {
    fn new(system: &'a OpticalSystem) -> Self {
        Self {
            system,
            settings: system.settings,
            near: rounding(&system.interfaces, system.origin),
            segments_left: system.settings.max_segments,
            waiting: Vec::new(),
            indices: Vec::new(),
        }
    }

    fn follow(&mut self, traced: &TracedRay, start: &RayStart, power: Power, visitor: &mut impl Visitor) {
        self.indices.clear();
        self.indices.extend(self.system.media.iter().map(|medium| medium.index(traced.wavelength)));
        let RayStart { from, direction, medium, start } = *start;
        self.waiting.push(Branch {
            parent: None,
            via: Via::Source,
            ray: Ray { from, direction, medium, start },
            power,
            optical_path: 0.0,
            hits_behind: 0,
        });
        let mut next = 0;
        while let Some(branch) = self.waiting.pop() {
            let id = SegmentId(next);
            next += 1;
            visitor.segment(traced, self.segment(id, branch, traced.power));
        }
    }

    /// Follows one branch to its end and queues what it spawns, the reflected ray first so that the transmitted one is
    /// followed first.
    fn segment(&mut self, id: SegmentId, mut branch: Branch, started_with: f64) -> Segment {
        let ending = self.cut(&branch, started_with);
        let mut crossing = None;
        if ending.is_none() {
            self.segments_left -= 1;
            crossing = nearest(self.system, self.near, &branch.ray);
            let is_outside = branch.ray.medium == self.system.surroundings;
            if branch.parent.is_none() && crossing.is_none() && !is_outside {
                (branch.ray.medium, crossing) = self.meet_beyond(&branch.ray);
            }
        }
        let segment = Segment {
            id,
            parent: branch.parent,
            via: branch.via,
            from: branch.ray.from + self.system.origin,
            to: None,
            direction: branch.ray.direction,
            medium_index: self.index(branch.ray.medium),
            power: branch.power,
            optical_path: branch.optical_path,
            ending: ending.unwrap_or(Ending::Escaped),
            hit: None,
        };
        crossing.map_or(segment, |crossing| self.arrive(&branch, &crossing, segment))
    }

    /// The medium that a source's ray runs in whose line misses the one it was found in, and what it meets there. Such a ray
    /// starts beside a boundary up to rounding: it runs in what lies beyond the nearest one, or else in the surroundings.
    fn meet_beyond(&self, ray: &Ray) -> (MediumId, Option<Crossing>) {
        let outside = self.system.surroundings;
        let meet = |medium| Some((medium, Some(nearest(self.system, self.near, &Ray { medium, ..*ray })?)));
        let media = [beyond(&self.system.interfaces, ray), outside];
        media.into_iter().find_map(meet).unwrap_or((outside, None))
    }

    fn cut(&self, branch: &Branch, started_with: f64) -> Option<Ending> {
        if branch.hits_behind >= self.settings.max_depth {
            Some(Ending::CutMaxDepth)
        } else if branch.power.total() < self.settings.min_power * started_with {
            Some(Ending::CutMinPower)
        } else {
            (self.segments_left == 0).then_some(Ending::CutMaxSegments)
        }
    }

    fn index(&self, medium: MediumId) -> f64 {
        self.indices[medium.place()]
    }

    fn arrive(&mut self, branch: &Branch, crossing: &Crossing, segment: Segment) -> Segment {
        let interface = &self.system.interfaces[crossing.interface];
        let Branch { ray, power, .. } = branch;
        // The rounded point is put back on its curve, between its ends.
        let at = interface.curve.clamp(interface.curve.project(ray.from + crossing.distance * ray.direction));
        let left_normal = interface.curve.normal_at(at);
        let (normal, behind) =
            if crossing.from_left { (left_normal, interface.right) } else { (-left_normal, interface.left) };
        let (n_i, n_t) = (self.index(ray.medium), self.index(behind));
        let Outcome { hit, transmitted, reflected } =
            Arrival { interface, at, direction: ray.direction, normal, n_i, n_t, near: self.near }
                .outcome(self.settings.secondary_rays);
        let optical_path = branch.optical_path + optical_path_length(n_i, ray.from.distance(at));
        let mut spawn = |secondary: Option<Secondary>, share: Power, medium: MediumId, left: bool| {
            let power = power.times(share);
            let Some((via, direction)) = secondary.filter(|_| power.total() > 0.0) else { return false };
            let start = Start::On { interface: crossing.interface, left };
            let ray = Ray { from: at, direction, medium, start };
            let hits_behind = branch.hits_behind + 1;
            self.waiting.push(Branch { parent: Some(segment.id), via, ray, power, optical_path, hits_behind });
            true
        };
        let reflected = spawn(reflected, hit.reflectance, ray.medium, crossing.from_left);
        let transmitted = spawn(transmitted, hit.transmittance, behind, !crossing.from_left);
        let ending = match (reflected || transmitted, hit.position) {
            (true, _) => Ending::Interface,
            (false, Some(_)) => Ending::Detected,
            (false, None) => Ending::Absorbed,
        };
        Segment { to: Some(self.out(at)), optical_path, ending, hit: Some(hit), ..segment }
    }

    /// A point in scene coordinates.
    fn out(&self, p: DVec2) -> DVec2 {
        p + self.system.origin
    }
}
