//! The plainest loop: every curve of every body asked at every step.

use f256::f256;
use glam::DVec2;
use snellius::scene::Surface;
use snellius::{Ending, Scene, Via};

use crate::bench::{Bench, Wall};
use crate::condition::{Bundle, State};
use crate::curve::Crossing;
use crate::doubts::{self, Doubt};
use crate::media::Formula;
use crate::meeting::Meeting;
use crate::sources::{lines, power, starts};
use crate::support::wide::{Wide2, power_of_two, wide};

/// A source ray at one line.
pub(crate) struct Ray {
    pub(crate) nanometers: f256,
    pub(crate) power: f256,
    pub(crate) first: Segment,
}

pub(crate) struct Segment {
    pub(crate) via: Via,
    pub(crate) index: f256,
    pub(crate) start: Bundle,
    /// At the hit; `None` if there is none.
    pub(crate) end: Option<Bundle>,
    pub(crate) ending: Ending,
    pub(crate) body: Option<usize>,
    pub(crate) total_internal_reflection: bool,
    /// Why it is compared no further than its start.
    pub(crate) doubt: Option<Doubt>,
    /// Transmitted before reflected.
    pub(crate) children: Vec<Self>,
}

pub(crate) struct Reference {
    pub(crate) size: f64,
    pub(crate) rays: Vec<Ray>,
}

/// Traces a scene. The origin is that which snellius computes with, for the scene's size alone.
pub(crate) fn reference(scene: &Scene, origin: DVec2) -> Reference {
    let bench = Bench::new(scene, origin);
    let mut segments_left = scene.trace.max_segments;
    let mut rays = Vec::new();
    for source in &scene.sources {
        let (starts, lines) = (starts(&source.light), lines(&source.spectrum));
        let power = power(source, starts.len() * lines.len());
        for &(p, d) in &starts {
            for &nanometers in &lines {
                let whole = power[0] + power[1];
                let mut tracer = Tracer { bench: &bench, nanometers, whole, segments_left };
                let first = tracer.first(State { p, d, power, path: f256::ZERO });
                segments_left = tracer.segments_left;
                rays.push(Ray { nanometers, power: whole, first });
            }
        }
    }
    Reference { size: bench.size, rays }
}

struct Tracer<'a> {
    bench: &'a Bench,
    nanometers: f256,
    /// What the ray starts with.
    whole: f256,
    segments_left: u64,
}

/// Light that is yet to be followed.
struct Branch<'a> {
    via: Via,
    bundle: Bundle,
    medium: &'a Formula,
    /// The walls that it stands on.
    standing: Vec<usize>,
    hits_behind: u32,
}

/// What a ray meets first.
struct Hit<'a> {
    distance: f256,
    exit: bool,
    /// The walls that run there as one, the earliest first; this gives the geometry.
    boundary: Vec<usize>,
    /// What acts there.
    surface: Option<&'a Wall>,
    behind: &'a Formula,
    /// Towards the ray.
    normal: Wide2,
}

impl<'a> Tracer<'a> {
    fn first(&mut self, start: State) -> Segment {
        let standing = doubts::under_start(self.bench, start.p);
        let doubt = doubts::at_start(self.bench, &start, &standing);
        let beside = if standing.is_empty() { start.p } else { start.p + self.bench.step * start.d };
        let medium = self.bench.medium_at(beside);
        let bundle = Bundle::new(start, self.bench.size);
        let branch = Branch { via: Via::Source, bundle, medium, standing, hits_behind: 0 };
        if doubt.is_some() { Segment { doubt, ..self.cut(&branch, Ending::Escaped) } } else { self.follow(branch) }
    }

    fn index(&self, medium: &Formula) -> f256 {
        medium.index(self.nanometers)
    }

    /// A segment that is not followed.
    fn cut(&self, branch: &Branch, ending: Ending) -> Segment {
        Segment {
            via: branch.via,
            index: self.index(branch.medium),
            start: branch.bundle.clone(),
            end: None,
            ending,
            body: None,
            total_internal_reflection: false,
            doubt: None,
            children: Vec::new(),
        }
    }

    fn follow(&mut self, branch: Branch<'a>) -> Segment {
        let settings = self.bench.settings;
        let [s, p] = branch.bundle.truth().power;
        let share = (s + p) / self.whole;
        if branch.hits_behind >= settings.max_depth {
            return self.cut(&branch, Ending::CutMaxDepth);
        }
        if let Some(doubt) = doubts::at_least_power(share, settings.min_power) {
            return Segment { doubt: Some(doubt), ..self.cut(&branch, Ending::CutMinPower) };
        }
        if share < wide(settings.min_power) {
            return self.cut(&branch, Ending::CutMinPower);
        }
        if self.segments_left == 0 {
            return self.cut(&branch, Ending::CutMaxSegments);
        }
        self.segments_left -= 1;
        let hit = self.next_hit(&branch);
        let doubt =
            doubts::on_the_way(self.bench, &branch.bundle, &branch.standing, hit.as_ref().map(|hit| hit.distance));
        match hit {
            _ if doubt.is_some() => Segment { doubt, ..self.cut(&branch, Ending::Escaped) },
            None => self.cut(&branch, Ending::Escaped),
            Some(hit) => self.arrive(&branch, &hit),
        }
    }

    /// The nearest crossing ahead at which something happens.
    fn next_hit(&self, branch: &Branch<'a>) -> Option<Hit<'a>> {
        let &State { p, d, .. } = branch.bundle.truth();
        let mut crossings: Vec<_> = (0..self.bench.walls.len()).flat_map(|wall| self.crossings(branch, wall)).collect();
        crossings.sort_by(|one, other| one.1.distance.partial_cmp(&other.1.distance).unwrap());
        crossings.into_iter().find_map(|(wall, crossing)| self.hit(wall, &crossing, p, d))
    }

    /// Crossings of one wall ahead. Of what the ray stands on, only the far side of a circle.
    fn crossings(&self, branch: &Branch, wall: usize) -> Vec<(usize, Crossing)> {
        let &State { p, d, .. } = branch.bundle.truth();
        let curve = self.bench.walls[wall].curve();
        let least = power_of_two(-100) * wide(self.bench.size);
        let stands_on = branch.standing.contains(&wall);
        let heads_inside = curve.circle.is_some_and(|circle| d.dot(p - circle.center) < f256::ZERO);
        let is_met = |crossing: &Crossing| {
            if stands_on { crossing.exit && heads_inside } else { crossing.distance > least }
        };
        curve.crossings(p, d).into_iter().filter(is_met).map(|crossing| (wall, crossing)).collect()
    }

    /// What is at a crossing; `None` where the same medium is on both sides and no surface, for sure.
    fn hit(&self, wall: usize, crossing: &Crossing, p: Wide2, d: Wide2) -> Option<Hit<'a>> {
        let bench = self.bench;
        let boundary = bench.boundary(wall, p + crossing.distance * d);
        let earliest = bench.walls[boundary[0]].curve();
        let off = |own: &Crossing| (own.distance - crossing.distance).abs();
        let own = earliest.crossings_of_whole(p, d);
        let Crossing { distance, exit } = own.into_iter().min_by(|u, v| off(u).partial_cmp(&off(v)).unwrap())?;
        let at = p + distance * d;
        let normal = earliest.normal(at);
        let normal = if normal.dot(d) > f256::ZERO { -normal } else { normal };
        let surface = boundary.iter().rev().map(|k| &bench.walls[*k]).find(|wall| wall.surface.is_some());
        let [before, behind] = [normal, -normal].map(|side| bench.medium_at(at + bench.step * side));
        let acts = surface.is_some() || before != behind || doubts::hides_medium(bench, at, &boundary);
        acts.then_some(Hit { distance, exit, boundary, surface, behind, normal })
    }

    fn arrive(&mut self, branch: &Branch<'a>, hit: &Hit<'a>) -> Segment {
        let wall = &self.bench.walls[hit.boundary[0]];
        let n_i = self.index(branch.medium);
        let arrived = branch.bundle.at_hit(|state, nudge| {
            let crossings = nudge.curve(wall).crossings_of_whole(state.p, state.d).into_iter();
            let distance =
                crossings.filter(|crossing| crossing.exit == hit.exit).map(|crossing| crossing.distance).next()?;
            let p = nudge.point(state.p + distance * state.d, state.d);
            Some(State { p, path: state.path + nudge.number(nudge.index(n_i) * distance), ..*state })
        });
        let Some(arrived) = arrived else {
            return Segment { doubt: Some(Doubt::Touch), ..self.cut(branch, Ending::Escaped) };
        };
        if let Some(doubt) = doubts::at_hit(self.bench, &arrived, &hit.boundary) {
            return Segment { doubt: Some(doubt), ..self.cut(branch, Ending::Escaped) };
        }
        let outermost = hit.boundary.iter().map(|wall| self.bench.walls[*wall].body).max();
        let segment = Segment {
            end: Some(arrived.clone()),
            body: hit.surface.map(|wall| wall.body).or(outermost),
            ..self.cut(branch, Ending::Absorbed)
        };
        match hit.surface.and_then(|wall| wall.surface) {
            Some(Surface::Absorber) => segment,
            Some(Surface::Screen) => Segment { ending: Ending::Detected, ..segment },
            _ => self.secondary(branch, hit, &arrived, segment),
        }
    }

    /// Spawns what a hit reflects and transmits.
    fn secondary(&mut self, branch: &Branch<'a>, hit: &Hit<'a>, arrived: &Bundle, segment: Segment) -> Segment {
        let meeting = Meeting {
            wall: &self.bench.walls[hit.boundary[0]],
            surface: hit.surface,
            normal: hit.normal,
            n_i: self.index(branch.medium),
            n_t: self.index(hit.behind),
            secondary_rays: self.bench.settings.secondary_rays,
        };
        if let Some(doubt) = meeting.doubt(arrived) {
            return Segment { doubt: Some(doubt), ..segment };
        }
        let total = meeting.is_total(arrived.truth());
        let way =
            |transmitted: bool| arrived.after_hit(!transmitted, |state, nudge| meeting.way(state, nudge, transmitted));
        let reflection = if total { Via::TotalInternalReflection } else { Via::Reflection };
        let mut ways = vec![(reflection, branch.medium, way(false))];
        if !total {
            ways.insert(0, (Via::Transmission, hit.behind, way(true)));
        }
        if ways.iter().any(|(.., bundle)| bundle.is_none()) {
            return Segment { doubt: Some(Doubt::Critical), ..segment };
        }
        let mut children = Vec::new();
        for (via, medium, bundle) in ways {
            let lit = |bundle: &Bundle| bundle.truth().power.iter().any(|power| *power > f256::ZERO);
            let Some(bundle) = bundle.filter(lit) else { continue };
            let (standing, hits_behind) = (hit.boundary.clone(), branch.hits_behind + 1);
            children.push(self.follow(Branch { via, bundle, medium, standing, hits_behind }));
        }
        let ending = if children.is_empty() { Ending::Absorbed } else { Ending::Interface };
        Segment { ending, children, total_internal_reflection: total, ..segment }
    }
}
