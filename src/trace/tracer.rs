//! The tracer: a work queue of branches, each followed to its next interface. It hands every segment on and keeps none, so
//! that its memory grows with the depth of the tree and not with its size.

use glam::DVec2;

use crate::laws::{Incidence, optical_path_length};
use crate::light::Power;
use crate::scene::{SecondaryRays, TraceSettings};
use crate::system::{Action, MediumId, OpticalSystem, RayStart, Start};
use crate::trace::hit::{Arrival, Outcome, Secondary};
use crate::trace::nearest::beyond;
use crate::trace::{Crossing, Ending, Hit, Ray, Search, Segment, SegmentId, Via, Work};

/// A branch that waits to be followed; positions relative to the system's origin.
struct Branch {
    parent: Option<SegmentId>,
    via: Via,
    ray: Ray,
    power: Power,
    optical_path: f64,
    hits_behind: u32,
}

/// A branch that was followed or cut, on its way to whoever wants to know.
pub(crate) struct Leg<'a> {
    pub(crate) id: SegmentId,
    branch: &'a Branch,
    origin: DVec2,
    medium_index: f64,
    pub(crate) ending: Ending,
    arrived: Option<Arrived>,
}

/// Where a branch met an interface, and what happened there.
struct Arrived {
    at: DVec2,
    optical_path: f64,
    hit: Hit,
}

impl Leg<'_> {
    pub(crate) fn power(&self) -> f64 {
        self.branch.power.total()
    }

    pub(crate) fn hit(&self) -> Option<&Hit> {
        self.arrived.as_ref().map(|arrived| &arrived.hit)
    }

    #[inline]
    pub(crate) fn segment(&self) -> Segment {
        let Branch { parent, via, ray, power, optical_path, .. } = self.branch;
        let (to, optical_path, hit) = match &self.arrived {
            Some(arrived) => (Some(arrived.at + self.origin), arrived.optical_path, Some(arrived.hit)),
            None => (None, *optical_path, None),
        };
        Segment {
            id: self.id,
            parent: *parent,
            via: *via,
            from: ray.from + self.origin,
            to,
            direction: ray.direction,
            medium_index: self.medium_index,
            power: *power,
            optical_path,
            ending: self.ending,
            hit,
        }
    }
}

/// Follows rays, one after the other.
pub(crate) struct Tracer<'a> {
    system: &'a OpticalSystem,
    settings: TraceSettings,
    search: Search<'a>,
    waiting: Vec<Branch>,
    /// Index of every medium at the line being followed.
    indices: &'a [f64],
    /// How many segments may still be followed.
    segments_left: u64,
    work: Work,
}

impl<'a> Tracer<'a> {
    pub(crate) fn new(system: &'a OpticalSystem) -> Self {
        Self {
            system,
            settings: system.settings,
            search: Search::new(system),
            waiting: Vec::new(),
            indices: &[],
            segments_left: 0,
            work: Work::default(),
        }
    }

    /// A tracer that looks at every interface at every step.
    #[cfg(test)]
    pub(crate) fn skipping_nothing(system: &'a OpticalSystem) -> Self {
        let mut tracer = Self::new(system);
        tracer.search.skips_nothing = true;
        tracer
    }

    /// Follows a ray at a line to the end of all its branches, at most `most` segments, transmitted before reflected. `indices`
    /// holds the index of every medium at that line. Returns what that took.
    pub(crate) fn follow(
        &mut self,
        start: &RayStart,
        power: Power,
        indices: &'a [f64],
        most: u64,
        mut visit: impl FnMut(&Leg),
    ) -> Work {
        self.indices = indices;
        self.segments_left = most;
        let RayStart { from, direction, medium, start } = *start;
        self.meet_medium(medium);
        self.waiting.push(Branch {
            parent: None,
            via: Via::Source,
            ray: Ray { from, direction, medium, start },
            power,
            optical_path: 0.0,
            hits_behind: 0,
        });
        let started_with = power.total();
        let mut next = 0;
        while let Some(mut branch) = self.waiting.pop() {
            let id = SegmentId(next);
            let (ending, arrived) = self.step(id, &mut branch, started_with);
            next += 1;
            self.work.ended[ending as usize] += 1;
            let medium_index = self.index(branch.ray.medium);
            visit(&Leg { id, branch: &branch, origin: self.system.origin, medium_index, ending, arrived });
        }
        self.work.followed = most - self.segments_left;
        self.work.nodes = std::mem::take(&mut self.search.nodes);
        std::mem::take(&mut self.work)
    }

    /// Follows one branch to its end and queues what it spawns, the reflected ray first so that the transmitted one is
    /// followed first.
    #[inline]
    fn step(&mut self, id: SegmentId, branch: &mut Branch, started_with: f64) -> (Ending, Option<Arrived>) {
        if let Some(ending) = self.cut(branch, started_with) {
            return (ending, None);
        }
        self.segments_left -= 1;
        let mut crossing = self.search.nearest(&branch.ray);
        let is_outside = branch.ray.medium == self.system.surroundings;
        if branch.parent.is_none() && crossing.is_none() && !is_outside {
            (branch.ray.medium, crossing) = self.meet_beyond(&branch.ray);
        }
        match crossing {
            Some(crossing) => self.arrive(id, branch, &crossing),
            None => (Ending::Escaped, None),
        }
    }

    /// The medium that a source's ray runs in whose line misses the one it was found in, and what it meets there. Such a ray
    /// starts beside a boundary up to rounding: it runs in what lies beyond the nearest one, or else in the surroundings.
    fn meet_beyond(&mut self, ray: &Ray) -> (MediumId, Option<Crossing>) {
        let outside = self.system.surroundings;
        let media = [beyond(&self.system.interfaces, ray), outside];
        media.iter().for_each(|medium| self.meet_medium(*medium));
        let mut meet = |medium: MediumId| Some((medium, Some(self.search.nearest(&Ray { medium, ..*ray })?)));
        media.into_iter().find_map(&mut meet).unwrap_or((outside, None))
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

    /// Takes note of a medium whose index the light depends on.
    fn meet_medium(&mut self, medium: MediumId) {
        self.work.disperses |= self.system.media[medium.place()].is_dispersive();
    }

    #[inline]
    fn arrive(&mut self, id: SegmentId, branch: &Branch, crossing: &Crossing) -> (Ending, Option<Arrived>) {
        let interface = &self.system.interfaces[crossing.interface];
        let Branch { ray, power, .. } = branch;
        // The rounded point is put back on its curve, between its ends.
        let at = interface.curve.clamp(interface.curve.project(ray.from + crossing.distance * ray.direction));
        let left_normal = interface.curve.normal_at(at);
        let (normal, behind) =
            if crossing.from_left { (left_normal, interface.right) } else { (-left_normal, interface.left) };
        self.meet_medium(behind);
        let (n_i, n_t) = (self.index(ray.medium), self.index(behind));
        let incidence = Incidence::new(ray.direction, normal);
        let Outcome { hit, transmitted, reflected } =
            Arrival { interface, at, direction: ray.direction, normal, incidence, n_i, n_t, near: self.system.near }
                .outcome(self.settings.secondary_rays);
        let by_fresnel = interface.action == Action::Refract && self.settings.secondary_rays == SecondaryRays::Fresnel;
        self.work.fresnel += u64::from(by_fresnel && transmitted.is_some());
        let optical_path = branch.optical_path + optical_path_length(n_i, ray.from.distance(at));
        let mut spawn = |secondary: Option<Secondary>, share: Power, medium: MediumId, left: bool| {
            let power = power.times(share);
            let Some((via, direction)) = secondary.filter(|_| power.total() > 0.0) else { return false };
            let start = Start::On { interface: crossing.interface, left };
            let ray = Ray { from: at, direction, medium, start };
            let hits_behind = branch.hits_behind + 1;
            self.waiting.push(Branch { parent: Some(id), via, ray, power, optical_path, hits_behind });
            true
        };
        let reflected = spawn(reflected, hit.reflectance, ray.medium, crossing.from_left);
        let transmitted = spawn(transmitted, hit.transmittance, behind, !crossing.from_left);
        let ending = match (reflected || transmitted, hit.position) {
            (true, _) => Ending::Interface,
            (false, Some(_)) => Ending::Detected,
            (false, None) => Ending::Absorbed,
        };
        (ending, Some(Arrived { at, optical_path, hit }))
    }
}
