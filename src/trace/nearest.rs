//! The first interface ahead of a ray.
//!
//! A ray from a face meets only what bounds the stretch of its medium that it runs in: where that is known to be a few
//! interfaces, they are looked at one by one, and else the search tree tells which the ray may meet.

use glam::DVec2;

use crate::geometry::{BoxTree, Curve, Waiting};
use crate::system::{Cells, Interface, MediumId, OpticalSystem, Start};
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
#[non_exhaustive]
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
    ///
    /// A ray on an interface that the system does not have starts free, and one that is not finite may meet anything or nothing.
    pub fn nearest(&mut self, ray: &Ray) -> Option<Crossing> {
        let is_unknown = |interface| interface >= self.system.interfaces.len();
        match ray.start {
            Start::On { interface, .. } if is_unknown(interface) => self.find(&Ray { start: Start::Free, ..*ray }),
            _ => self.find(ray),
        }
    }

    /// The same for a ray of the system's own.
    #[inline(always)]
    pub(crate) fn find(&mut self, ray: &Ray) -> Option<Crossing> {
        let cell = self.cell(ray);
        #[cfg(test)]
        let cell = if self.skips_nothing { Cells::OPEN } else { cell };
        if cell == Cells::NOTHING { None } else { self.first(ray, cell) }
    }

    /// The cell that the ray runs into. At an edge's end rounding may have its direction point to the other side than that which it
    /// counts as heading to: then nothing is known of what it meets.
    #[inline(always)]
    fn cell(&self, ray: &Ray) -> u32 {
        let Start::On { interface, left } = ray.start else { return Cells::OPEN };
        let curve = &self.system.interfaces[interface].curve;
        let heads_left = curve.n.dot(ray.direction) > 0.0;
        if heads_left == left || !curve.is_straight() { self.system.cells.of(interface, left) } else { Cells::OPEN }
    }

    #[inline(always)]
    fn first(&mut self, ray: &Ray, cell: u32) -> Option<Crossing> {
        let probe = Probe::new(self.system, *ray);
        let (left_behind, closed) = (Cells::left_behind(cell), self.system.cells.walls(cell));
        if cell <= self.system.cells.last_convex
            && let Some(crossing) = closed.and_then(|walls| plain_way_out(&probe, walls))
        {
            return Some(crossing);
        }
        let mut first = First::NONE;
        if closed.is_none() && self.system.tree.is_some() {
            first = self.look_everywhere(probe, left_behind);
        } else {
            for &place in closed.unwrap_or(&self.system.cells.few) {
                first.look(&probe, place as usize);
            }
        }
        let is_none = first.place == First::NONE.place;
        let is_lost = is_none && (closed.is_some() || ray.medium != self.system.surroundings);
        let is_plain = !first.is_in_doubt && !is_lost && (is_none || first.next > first.reach);
        #[cfg(test)]
        let is_plain = is_plain && !self.skips_nothing;
        if !is_plain {
            return self.with_care(probe, first.is_in_doubt || is_lost, first.reach);
        }
        let First { place: interface, distance, from_left, .. } = first;
        (!is_none).then_some(Crossing { interface, distance: distance.max(0.0), from_left })
    }

    /// Apart, since it takes more of the processor than a look at a cell.
    #[inline(never)]
    fn look_everywhere(&mut self, probe: Probe, left_behind: u32) -> First {
        let mut first = First::NONE;
        self.candidates(&probe.ray, 0.0, left_behind, |place| {
            first.look(&probe, place);
            first.reach
        });
        first
    }

    /// The first crossing where the nearest is not known to be it: of those that the line has within `reach`, or, where it is
    /// lost on which side of the start some lie, of all that it has.
    #[cold]
    #[inline(never)]
    fn with_care(&mut self, probe: Probe, is_lost: bool, reach: f64) -> Option<Crossing> {
        #[cfg(test)]
        let is_lost = is_lost || self.skips_nothing;
        let mut all = Vec::new();
        let (begin, end) = if is_lost { (f64::NEG_INFINITY, f64::INFINITY) } else { (0.0, reach) };
        self.candidates(&probe.ray, begin, BoxTree::NO_BOX, |place| {
            passages(&probe, place, |passage| all.push(passage));
            end
        });
        all.sort_by_key(|passage| passage.crossing.interface);
        if is_lost {
            put_right(&probe, &mut all);
        }
        let crossing = first_of(&probe, all)?;
        Some(Crossing { distance: crossing.distance.max(0.0), ..crossing })
    }

    /// Visits interfaces of the whole system, at least all whose crossings are at a distance between `begin` and what `visit`
    /// returned last.
    fn candidates(&mut self, ray: &Ray, begin: f64, left_behind: u32, mut visit: impl FnMut(usize) -> f64) {
        let tree = self.system.tree.as_ref();
        #[cfg(test)]
        let tree = tree.filter(|_| !self.skips_nothing);
        if let Some(tree) = tree {
            self.nodes += tree.along(ray.from, ray.direction, begin, left_behind, &mut self.waiting, visit);
        } else {
            for place in 0..self.system.interfaces.len() {
                visit(place);
            }
        }
    }
}

/// The one crossing by which a ray leaves a convex polygon with these edges; `None` if to find it takes care.
#[inline(always)]
fn plain_way_out(probe: &Probe, walls: &[u32]) -> Option<Crossing> {
    for place in walls.iter().map(|wall| *wall as usize).filter(|place| *place != probe.edge) {
        let interface = &probe.system.interfaces[place];
        let sides = probe.sides(&interface.curve);
        if probe.passes_by(&interface.curve, sides) {
            continue;
        }
        let met = probe.plain_edge(interface, sides)?;
        if met.is_ahead {
            return Some(Crossing { interface: place, distance: met.distance, from_left: met.from_left });
        }
    }
    None
}

/// The nearest way out so far.
#[derive(Clone, Copy)]
struct First {
    /// The interface.
    place: usize,
    distance: f64,
    from_left: bool,
    /// No crossing that the ray passes before this one is farther, up to rounding.
    reach: f64,
    /// Distance of the nearest but one.
    next: f64,
    /// Whether some crossing may be on the other side of the start.
    is_in_doubt: bool,
}

impl First {
    const NONE: Self = Self {
        place: usize::MAX,
        distance: f64::INFINITY,
        from_left: false,
        reach: f64::INFINITY,
        next: f64::INFINITY,
        is_in_doubt: false,
    };

    #[inline(always)]
    fn look(&mut self, probe: &Probe, place: usize) {
        if place == probe.edge {
            return;
        }
        let (medium, interface) = (probe.ray.medium, &probe.system.interfaces[place]);
        let sides = probe.sides(&interface.curve);
        if probe.passes_by(&interface.curve, sides) || !interface.bounds(medium) {
            return;
        }
        let met = if interface.curve.is_straight() { probe.plain_edge(interface, sides) } else { None };
        match met {
            Some(met) => self.take(&Passage::new(medium, place, interface, met)),
            None => {
                // Copies, so that these need not be in memory before.
                let (probe, mut found) = (*probe, *self);
                found.meet(&probe, place);
                *self = found;
            }
        }
    }

    #[inline(never)]
    fn meet(&mut self, probe: &Probe, place: usize) {
        passages(probe, place, |passage| self.take(&passage));
    }

    #[inline(always)]
    fn take(&mut self, passage: &Passage) {
        self.is_in_doubt |= passage.is_in_doubt;
        if !passage.is_way_out() {
            return;
        }
        let Crossing { interface, distance, from_left } = passage.crossing;
        self.reach = self.reach.min(passage.reach);
        if distance < self.distance {
            self.next = self.distance;
            (self.place, self.distance, self.from_left) = (interface, distance, from_left);
        } else if distance < self.next {
            self.next = distance;
        }
    }
}

/// Lets as many crossings change sides of the start as the count of those behind it misses, those first whose distances speak
/// least against it.
fn put_right(probe: &Probe, passages: &mut [Passage]) {
    let is_unbounded = probe.ray.medium == probe.system.surroundings;
    let behind: i32 = passages.iter().filter(|passage| !passage.is_ahead).map(|passage| passage.entry).sum();
    let has_way_out = passages.iter().any(Passage::is_way_out);
    let missing = match probe.inside_before_start() {
        Some(expected) => expected - behind - i32::from(is_unbounded),
        None => i32::from(!has_way_out && !is_unbounded),
    };
    for _ in 0..missing.abs() {
        // A medium that has an end has a way out: none is given up for the last, and nothing but one is sought without any.
        let ways_out = passages.iter().filter(|passage| passage.is_way_out()).count();
        let is_kept = |passage: &Passage| passage.is_ahead && (ways_out == 0 || ways_out == 1 && passage.is_way_out());
        let helps = |passage: &&mut Passage| passage.gain() == missing.signum() && (is_unbounded || !is_kept(passage));
        let misplaced = passages.iter_mut().filter(helps).min_by(|u, v| u.against().total_cmp(&v.against()));
        if let Some(passage) = misplaced {
            passage.is_ahead = !passage.is_ahead;
        }
    }
}

/// The way out that the ray passes first. None that is farther than the reach of any can be it.
fn first_of(probe: &Probe, passages: Vec<Passage>) -> Option<Crossing> {
    let ways_out = passages.iter().filter(|passage| passage.is_way_out());
    let reach = ways_out.clone().map(|passage| passage.reach).fold(f64::INFINITY, f64::min);
    let near = ways_out.map(|passage| passage.crossing).filter(|crossing| crossing.distance <= reach);
    let key = |crossing: &Crossing| (crossing.interface, crossing.distance);
    near.reduce(|best, one| if probe.is_before(key(&one), key(&best)) { one } else { best })
}

/// Visits every crossing of the ray's line with an interface, if that bounds the ray's medium.
#[inline(always)]
fn passages(probe: &Probe, place: usize, mut visit: impl FnMut(Passage)) {
    let (medium, interface) = (probe.ray.medium, &probe.system.interfaces[place]);
    if interface.bounds(medium) {
        probe.crossings(place, interface, |met| visit(Passage::new(medium, place, interface, met)));
    }
}

impl Passage {
    #[inline(always)]
    fn new(medium: MediumId, place: usize, interface: &Interface, met: Met) -> Self {
        let Met { distance, slack, from_left, is_ahead, is_in_doubt } = met;
        let from = if from_left { interface.left } else { interface.right };
        let entry = match (interface.left == interface.right, from == medium) {
            (true, _) => 0,
            (false, true) => -1,
            (false, false) => 1,
        };
        let crossing = Crossing { interface: place, distance, from_left };
        Self { crossing, reach: distance + slack, is_ahead, is_in_doubt, entry }
    }

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
