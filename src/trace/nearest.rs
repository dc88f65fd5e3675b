//! The first interface ahead of a ray.
//!
//! A ray from a face meets only what bounds the stretch of its medium that it runs in: where that is known to be a few
//! interfaces, they are looked at one by one, and else the search tree tells which the ray may meet.

use glam::DVec2;

use crate::geometry::{Curve, Waiting};
use crate::system::{Interface, MediumId, OpticalSystem, Start};
use crate::trace::probe::{Met, Probe};

/// A ray on its way.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Its start, relative to the system's origin.
    pub from: DVec2,
    /// Unit direction.
    pub direction: DVec2,
    /// The medium that it runs in.
    pub medium: MediumId,
    /// What it starts on.
    pub start: Start,
}

/// What a ray meets first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The interface, by its place in the system's list.
    pub interface: usize,
    /// Distance along the ray, at least 0, scene units.
    pub distance: f64,
    /// Whether the ray comes from the interface's left.
    pub from_left: bool,
}

/// Finds what rays meet first. It keeps its working memory from one ray to the next.
#[derive(Clone, Debug)]
pub struct Search<'a> {
    system: &'a OpticalSystem,
    waiting: Waiting,
    crossings: Vec<Crossing>,
    pub(crate) nodes: u64,
    /// Looks at every interface and counts behind every ray.
    #[cfg(test)]
    pub(crate) skips_nothing: bool,
}

/// A crossing of the ray's whole line with the boundary of the ray's medium, or with a surface inside of it.
#[derive(Clone, Copy)]
struct Passage {
    crossing: Crossing,
    /// No crossing that the ray passes before this one is farther, up to rounding.
    reach: f64,
    is_ahead: bool,
    is_in_doubt: bool,
    /// 1 into the ray's medium, −1 out of it, 0 from it into itself.
    entry: i32,
}

impl<'a> Search<'a> {
    /// For the rays of a system.
    #[must_use]
    pub fn new(system: &'a OpticalSystem) -> Self {
        Self {
            system,
            waiting: Waiting::new(),
            crossings: Vec::new(),
            nodes: 0,
            #[cfg(test)]
            skips_nothing: false,
        }
    }

    /// The first interface that the ray crosses out of its medium, or within it; at a corner that two share, the one it passes
    /// first; of several others at one distance the first in the list. `None` if the ray leaves.
    ///
    /// Nothing leaks: a line crosses the closed boundary of a medium as often into it as out of it. Where the ray starts on an
    /// interface beside that which it leaves, up to rounding, or finds no way out of a medium that has an end, the crossings
    /// behind it tell whether it starts inside, and what rounding has put on the wrong side of the start changes sides.
    pub fn nearest(&mut self, ray: &Ray) -> Option<Crossing> {
        let probe = Probe::new(self.system, ray);
        let (mut first, mut reach, mut in_doubt) = (None, f64::INFINITY, false);
        let mut others = std::mem::take(&mut self.crossings);
        others.clear();
        let mut look = |place| {
            passages(&probe, place, |passage| {
                in_doubt |= passage.is_in_doubt;
                if passage.is_way_out() && passage.crossing.distance <= reach {
                    reach = reach.min(passage.reach);
                    others.extend(first.replace(passage.crossing));
                }
            });
            reach
        };
        let cell = self.system.cells.around(ray.start);
        match cell {
            Some(cell) => {
                for &place in cell {
                    look(place as usize);
                }
            }
            None => self.candidates(ray, 0.0, look),
        }
        let leaks = first.is_none() && (cell.is_some() || ray.medium != self.system.surroundings);
        #[cfg(test)]
        let in_doubt = in_doubt || self.skips_nothing;
        if in_doubt || leaks {
            first = self.by_count(&probe);
        } else if !others.is_empty() {
            others.extend(first);
            first = first_of(&probe, &mut others, reach);
        }
        self.crossings = others;
        first.map(|crossing| Crossing { distance: crossing.distance.max(0.0), ..crossing })
    }

    /// Visits interfaces of the whole system, at least all whose crossings are at a distance between `begin` and what `visit`
    /// returned last.
    fn candidates(&mut self, ray: &Ray, begin: f64, mut visit: impl FnMut(usize) -> f64) {
        let tree = self.system.tree.as_ref();
        #[cfg(test)]
        let tree = tree.filter(|_| !self.skips_nothing);
        if let Some(tree) = tree {
            self.nodes += tree.along(ray.from, ray.direction, begin, &mut self.waiting, visit);
        } else {
            for place in 0..self.system.interfaces.len() {
                visit(place);
            }
        }
    }

    /// The first way out, once as many crossings have changed sides of the start as the count of those behind it misses.
    #[cold]
    fn by_count(&mut self, probe: &Probe) -> Option<Crossing> {
        let mut all = Vec::new();
        self.candidates(probe.ray, f64::NEG_INFINITY, |place| {
            passages(probe, place, |passage| all.push(passage));
            f64::INFINITY
        });
        all.sort_by_key(|passage| passage.crossing.interface);
        first_by_count(probe, all)
    }
}

/// The first crossing out of the ray's medium, of all that its whole line has with the boundary of it: once as many have changed
/// sides of the start as the count of those behind it misses, those first whose distances speak least against it.
fn first_by_count(probe: &Probe, mut passages: Vec<Passage>) -> Option<Crossing> {
    let is_unbounded = probe.ray.medium == probe.system.surroundings;
    let behind: i32 = passages.iter().filter(|passage| !passage.is_ahead).map(|passage| passage.entry).sum();
    let has_way_out = passages.iter().any(Passage::is_way_out);
    let missing = match probe.inside_before_start() {
        Some(expected) => expected - behind - i32::from(is_unbounded),
        None => i32::from(!has_way_out && !is_unbounded),
    };
    for _ in 0..missing.abs() {
        let helps = |passage: &&mut Passage| passage.gain() == missing.signum();
        let misplaced = passages.iter_mut().filter(helps).min_by(|u, v| u.against().total_cmp(&v.against()));
        if let Some(passage) = misplaced {
            passage.is_ahead = !passage.is_ahead;
        }
    }
    passages.retain(Passage::is_way_out);
    let reach = passages.iter().map(|passage| passage.reach).fold(f64::INFINITY, f64::min);
    first_of(probe, &mut passages.into_iter().map(|passage| passage.crossing).collect(), reach)
}

/// The crossing that the ray passes first. None that is farther than `reach` can be it.
fn first_of(probe: &Probe, crossings: &mut Vec<Crossing>, reach: f64) -> Option<Crossing> {
    crossings.retain(|crossing| crossing.distance <= reach);
    crossings.sort_by_key(|crossing| crossing.interface);
    let key = |crossing: &Crossing| (crossing.interface, crossing.distance);
    crossings.drain(..).reduce(|best, one| if probe.is_before(key(&one), key(&best)) { one } else { best })
}

/// Visits every crossing of the ray's line with an interface, if that bounds the ray's medium.
#[inline(always)]
fn passages(probe: &Probe, place: usize, mut visit: impl FnMut(Passage)) {
    let (medium, interface) = (probe.ray.medium, &probe.system.interfaces[place]);
    let is_boundary = || interface.left == medium || interface.right == medium;
    // An edge that is not met is no boundary to look at.
    if !interface.curve.is_straight() && !is_boundary() {
        return;
    }
    probe.crossings(place, interface, |Met { distance, slack, from_left, is_ahead, is_in_doubt }| {
        if !is_boundary() {
            return;
        }
        let from = if from_left { interface.left } else { interface.right };
        let entry = match (interface.left == interface.right, from == medium) {
            (true, _) => 0,
            (false, true) => -1,
            (false, false) => 1,
        };
        let crossing = Crossing { interface: place, distance, from_left };
        visit(Passage { crossing, reach: distance + slack, is_ahead, is_in_doubt, entry });
    });
}

impl Passage {
    /// Whether it lies ahead and does not lead into the ray's medium from outside.
    fn is_way_out(&self) -> bool {
        self.is_ahead && self.entry <= 0
    }

    /// What the count of entries behind the start gains if this changes sides.
    fn gain(&self) -> i32 {
        if self.is_ahead { self.entry } else { -self.entry }
    }

    /// How far its distance speaks against its place on the other side of the start.
    fn against(&self) -> f64 {
        let Crossing { distance, .. } = self.crossing;
        (if self.is_ahead { distance } else { -distance }).max(0.0)
    }
}

/// What lies on the other side of that boundary of a ray's medium which is nearest to the ray's start.
pub(crate) fn beyond(interfaces: &[Interface], ray: &Ray) -> MediumId {
    let away = |curve: &Curve| curve.clamp(curve.project(ray.from)).distance_squared(ray.from);
    let is_boundary = |one: &&Interface| (one.left == ray.medium) != (one.right == ray.medium);
    let nearest = interfaces.iter().filter(is_boundary).min_by(|u, v| away(&u.curve).total_cmp(&away(&v.curve)));
    nearest.map_or(ray.medium, |one| if one.left == ray.medium { one.right } else { one.left })
}
