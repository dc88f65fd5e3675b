//! The tracer: a work queue of branches, each followed to its next interface. It hands every segment on and keeps none, so
//! that its memory grows with the depth of the tree and not with its size.

use glam::DVec2;

use crate::laws::{Incidence, Refraction, Shares, optical_path_length};
use crate::light::Power;
use crate::scene::{SecondaryRays, TraceSettings};
use crate::system::{Action, MediumId, OpticalSystem, RayStart, Start};
use crate::trace::hit::{Arrival, Outcome, Transmitted};
use crate::trace::nearest::beyond;
use crate::trace::{Crossing, Ending, Ray, Search, Segment, SegmentId, Via, Work};

/// A segment that looks at more nodes of the search tree counts as several, so that `max_segments` bounds the work.
const NODES_PER_SEGMENT: u64 = 1024;

/// A branch that waits to be followed; positions relative to the system's origin.
#[derive(Clone, Copy)]
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
    arrived: Option<(&'a Arrival<'a>, &'a Outcome)>,
}

/// Takes note of branches.
pub(crate) trait Record {
    fn record(&mut self, leg: &Leg);
}

impl Leg<'_> {
    pub(crate) fn power(&self) -> f64 {
        self.branch.power.total()
    }

    /// Fraction of the power that stays at the hit; 0 without one.
    pub(crate) fn absorptance(&self) -> f64 {
        self.arrived.map_or(0.0, |(_, outcome)| outcome.shares.absorptance)
    }

    /// The body of the screen on which it landed, and where on it.
    pub(crate) fn landed(&self) -> Option<(usize, f64)> {
        let (arrival, _) = self.arrived.filter(|_| self.ending == Ending::Detected)?;
        Some((arrival.interface.body, arrival.position()?))
    }

    #[inline]
    pub(crate) fn segment(&self) -> Segment {
        let Branch { parent, via, ray, power, optical_path, .. } = self.branch;
        let (to, optical_path, hit) = match self.arrived {
            Some((arrival, outcome)) => {
                (Some(arrival.at + self.origin), arrival.optical_path, Some(arrival.hit(outcome)))
            }
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
    /// holds the index of every medium at that line. Returns how many segments it followed.
    pub(crate) fn follow(
        &mut self,
        start: &RayStart,
        power: Power,
        indices: &'a [f64],
        most: u64,
        record: &mut impl Record,
    ) -> u64 {
        self.indices = indices;
        self.segments_left = most;
        let RayStart { from, direction, medium, start } = *start;
        self.meet_medium(medium);
        let mut branch = Branch {
            parent: None,
            via: Via::Source,
            ray: Ray { from, direction, medium, start },
            power,
            optical_path: 0.0,
            hits_behind: 0,
        };
        let started_with = power.total();
        let mut id = 0;
        loop {
            let next = self.step(SegmentId(id), &branch, started_with, record);
            id += 1;
            if let Some(next) = next {
                branch = next;
                continue;
            }
            let Some(&waiting) = self.waiting.last() else { break };
            self.waiting.pop();
            branch = waiting;
        }
        most - self.segments_left
    }

    /// What following took since this was asked last, but for how many segments were followed.
    pub(crate) fn take_work(&mut self) -> Work {
        Work { nodes: std::mem::take(&mut self.search.nodes), ..std::mem::take(&mut self.work) }
    }

    /// Follows one branch to its end. Of what it spawns it returns the transmitted ray, to be followed next, and queues the
    /// reflected one.
    #[inline(always)]
    fn step(&mut self, id: SegmentId, branch: &Branch, started_with: f64, record: &mut impl Record) -> Option<Branch> {
        let mut medium = branch.ray.medium;
        if let Some(ending) = self.cut(branch, started_with) {
            self.end(record, id, branch, medium, ending);
            return None;
        }
        self.segments_left -= 1;
        let nodes = self.search.nodes;
        let mut crossing = self.search.find(&branch.ray);
        if branch.parent.is_none() && crossing.is_none() && medium != self.system.surroundings {
            (medium, crossing) = self.meet_beyond(branch.ray);
        }
        self.segments_left -= ((self.search.nodes - nodes) / NODES_PER_SEGMENT).min(self.segments_left);
        match crossing {
            Some(crossing) => self.arrive(record, id, branch, medium, &crossing),
            None => {
                self.end(record, id, branch, medium, Ending::Escaped);
                None
            }
        }
    }

    /// Records a branch that meets nothing.
    #[inline(always)]
    fn end(&mut self, record: &mut impl Record, id: SegmentId, branch: &Branch, medium: MediumId, ending: Ending) {
        self.work.ended[ending as usize] += 1;
        let medium_index = self.index(medium);
        record.record(&Leg { id, branch, origin: self.system.origin, medium_index, ending, arrived: None });
    }

    /// The medium that a source's ray runs in whose line misses the one it was found in, and what it meets there. Such a ray
    /// starts beside a boundary up to rounding: it runs in what lies beyond the nearest one, or else in the surroundings.
    #[cold]
    #[inline(never)]
    fn meet_beyond(&mut self, ray: Ray) -> (MediumId, Option<Crossing>) {
        let outside = self.system.surroundings;
        let media = [beyond(&self.system.interfaces, &ray), outside];
        media.iter().for_each(|medium| self.meet_medium(*medium));
        let mut meet = |medium: MediumId| Some((medium, Some(self.search.find(&Ray { medium, ..ray })?)));
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

    #[inline(always)]
    fn arrive(
        &mut self,
        record: &mut impl Record,
        id: SegmentId,
        branch: &Branch,
        medium: MediumId,
        crossing: &Crossing,
    ) -> Option<Branch> {
        let interface = &self.system.interfaces[crossing.interface];
        let Ray { from, direction, .. } = branch.ray;
        // The rounded point is put back on its curve, between its ends.
        let at = interface.curve.clamp(interface.curve.project(from + crossing.distance * direction));
        let left_normal = interface.curve.normal_at(at);
        let (normal, behind) =
            if crossing.from_left { (left_normal, interface.right) } else { (-left_normal, interface.left) };
        self.meet_medium(behind);
        let (n_i, n_t) = (self.index(medium), self.index(behind));
        let arrival = Arrival {
            interface,
            place: crossing.interface,
            from_left: crossing.from_left,
            medium,
            behind,
            optical_path: branch.optical_path + optical_path_length(n_i, from.distance(at)),
            at,
            direction,
            normal,
            incidence: Incidence::new(direction, normal),
            n_i,
            n_t,
            near: self.system.near,
        };
        if interface.action != Action::Refract {
            return self.part(record, id, branch, &arrival, &arrival.at_surface());
        }
        match arrival.refract() {
            Refraction::Refracted { direction, cos_t: cos, sin_t: sin, .. } => {
                let transmitted = Transmitted { direction, cos, sin };
                let shares = arrival.shares(self.settings.secondary_rays, &transmitted);
                self.work.fresnel += u64::from(self.settings.secondary_rays == SecondaryRays::Fresnel);
                self.part(record, id, branch, &arrival, &arrival.refracted(transmitted, shares))
            }
            Refraction::TotalInternalReflection { critical, .. } => {
                let outcome = arrival.totally_reflected(critical, Shares::total_reflection());
                self.part(record, id, branch, &arrival, &outcome)
            }
        }
    }

    /// Records a branch that arrived, and sends on what it spawns.
    #[inline(always)]
    fn part(
        &mut self,
        record: &mut impl Record,
        id: SegmentId,
        branch: &Branch,
        arrival: &Arrival,
        outcome: &Outcome,
    ) -> Option<Branch> {
        let Arrival { place, from_left, medium, behind, at, optical_path, .. } = *arrival;
        let Outcome { shares, transmitted, reflected, total } = outcome;
        let child = |via: Via, share: Power, direction: DVec2, medium: MediumId, left: bool| {
            let ray = Ray { from: at, direction, medium, start: Start::On { interface: place, left } };
            let (power, hits_behind) = (branch.power.times(share), branch.hits_behind + 1);
            Branch { parent: Some(id), via, ray, power, optical_path, hits_behind }
        };
        let carries = |branch: &Branch| branch.power.total() > 0.0;
        let via = if total.is_some() { Via::TotalInternalReflection } else { Via::Reflection };
        let reflected = reflected.map(|direction| child(via, shares.reflectance, direction, medium, from_left));
        let transmitted = transmitted.as_ref().map(|transmitted| {
            child(Via::Transmission, shares.transmittance, transmitted.direction, behind, !from_left)
        });
        let (reflected, transmitted) = (reflected.filter(carries), transmitted.filter(carries));
        let spawns = reflected.is_some() || transmitted.is_some();
        let ending = match arrival.interface.action {
            _ if spawns => Ending::Interface,
            Action::Detect { .. } => Ending::Detected,
            _ => Ending::Absorbed,
        };
        self.work.ended[ending as usize] += 1;
        let (origin, medium_index) = (self.system.origin, arrival.n_i);
        record.record(&Leg { id, branch, origin, medium_index, ending, arrived: Some((arrival, outcome)) });
        if transmitted.is_none() {
            return reflected;
        }
        if let Some(reflected) = reflected {
            self.waiting.push(reflected);
        }
        transmitted
    }
}
