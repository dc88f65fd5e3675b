//! All rays of a system, many at a time, their results in one order.

use std::ops::Range;
use std::sync::Mutex;

use rayon::prelude::*;

use crate::light::Wavelength;
use crate::system::OpticalSystem;
use crate::trace::summary::LightSummary;
use crate::trace::tracer::{Leg, Record, Tracer};
use crate::trace::{Segment, TracedRay, Visitor, Work};

/// Rays in a row, followed at all their lines: their branches if they were asked for, and what became of their light.
#[derive(Clone, Default)]
pub(crate) struct Stretch {
    /// Their places in the plan.
    jobs: Range<usize>,
    /// Empty if they were not asked for.
    pub(crate) rays: Vec<TracedRay>,
    pub(crate) summary: LightSummary,
    pub(crate) work: Work,
}

/// Follows every ray of the system through every hit, in order and on one thread, and hands every segment on, for as long as the
/// visitor goes on.
///
/// It needs memory for the depth of a tree and not for its size.
pub fn visit(system: &OpticalSystem, visitor: &mut impl Visitor) {
    visit_with(Tracer::new(system), &Plan::new(system), visitor);
}

pub(crate) fn visit_with<'a>(mut tracer: Tracer<'a>, plan: &'a Plan<'a>, visitor: &mut impl Visitor) {
    let mut left = plan.system.settings.max_segments;
    for job in 0..plan.jobs() {
        let (source, ray) = plan.job(job);
        let placed = &plan.system.sources[source];
        for line in 0..placed.lines.len() {
            if !visitor.goes_on() {
                return;
            }
            let traced = plan.ray(source, ray, line);
            let indices = plan.indices(traced.wavelength);
            let mut show = Show { ray: &traced, visitor };
            left -= tracer.follow(&placed.starts[ray], placed.power, indices, left, &mut show);
        }
    }
}

/// Hands segments to a visitor.
struct Show<'a, V> {
    ray: &'a TracedRay,
    visitor: &'a mut V,
}

impl<V: Visitor> Record for Show<'_, V> {
    #[inline(always)]
    fn record(&mut self, leg: &Leg) {
        self.visitor.segment(self.ray, leg.segment());
    }
}

/// Counts what becomes of a ray's light, and tells how far it is.
struct Count<'a> {
    ray: &'a TracedRay,
    summary: &'a mut LightSummary,
    progress: &'a (dyn Fn(u64) + Sync),
}

impl Record for Count<'_> {
    #[inline(always)]
    fn record(&mut self, leg: &Leg) {
        self.summary.count(self.ray, leg);
        if self.summary.segments - self.summary.told == ALONE {
            self.tell();
        }
    }
}

impl Count<'_> {
    #[cold]
    fn tell(&mut self) {
        self.summary.tell(self.progress);
    }
}

/// Counts, and keeps the segments.
struct Keep<'a, 'b> {
    count: &'a mut Count<'b>,
    segments: &'a mut Vec<Segment>,
}

impl Record for Keep<'_, '_> {
    #[inline(always)]
    fn record(&mut self, leg: &Leg) {
        self.count.record(leg);
        self.segments.push(leg.segment());
    }
}

/// So many segments are followed before other threads are asked for help: starting them takes as long.
const ALONE: u64 = 16_384;
/// Stretches that are followed at once, at most.
const STRETCHES: u64 = 1024;
/// Rays in a stretch at most.
const RAYS: usize = 64;
/// Of the first stretch, the others have such a part.
const PART: usize = 16;

/// Lists that may hold the segments of rays, the first ray's last.
pub(crate) type Memory = Mutex<Vec<Vec<Segment>>>;

/// Follows every ray of the system and hands them on in order, in stretches. The segments that the system's limit allows are spent
/// in that order too. Neither the result nor where a stretch ends depends on the number of threads: the first ends where so many
/// segments are followed that others could help, and tells how many rays are worth the trouble of one more stretch. `progress` hears
/// now and then how many more segments there are. Segments are kept if there is memory for them, if only an empty one.
pub(crate) fn collect(
    system: &OpticalSystem,
    memory: Option<Memory>,
    progress: &(dyn Fn(u64) + Sync),
    mut keep: impl FnMut(Stretch),
) {
    let plan = Plan::new(system);
    let worker = || Worker::new(system, &plan, memory.as_ref(), progress);
    let mut alone = worker();
    let mut left = system.settings.max_segments;
    let mut first = Stretch::default();
    while first.jobs.end < plan.jobs() && first.work.followed < ALONE.min(left) {
        alone.ray(&mut first, left);
    }
    alone.end(&mut first);
    let (mut longest, mut next) = (first.work.followed.max(1), first.jobs.end);
    let rays = (next / PART).clamp(1, RAYS);
    left -= first.work.followed;
    keep(first);
    while next < plan.jobs() {
        // A stretch of much more light than those before it is followed again, alone, and the batch ends there.
        let cap = left.min(ALONE.max(2 * longest));
        let threads = number(rayon::current_num_threads()).min(STRETCHES);
        let most = (2 * left).checked_div(cap).unwrap_or(STRETCHES).clamp(threads, STRETCHES);
        let end = plan.jobs().min(next + rays * place(most));
        let follow = |worker: &mut Worker, k: usize| {
            let begin = next + k * rays;
            worker.follow(begin..end.min(begin + rays), cap)
        };
        let stretches = (0..(end - next).div_ceil(rays)).into_par_iter().map_init(worker, follow);
        let is_capped = cap < left;
        for mut stretch in stretches.collect::<Vec<_>>() {
            let is_unfinished = is_capped && stretch.work.followed == cap;
            if is_unfinished || stretch.work.followed > left {
                stretch = alone.follow(stretch.jobs, left);
            }
            longest = longest.max(stretch.work.followed);
            left -= stretch.work.followed;
            next = stretch.jobs.end;
            keep(stretch);
            if is_unfinished {
                break;
            }
        }
    }
}

/// The rays of a system in order, and the index of every medium at every wavelength.
pub(crate) struct Plan<'a> {
    system: &'a OpticalSystem,
    /// Number of the first ray of each source, and of all.
    firsts: Vec<usize>,
    wavelengths: Vec<Wavelength>,
    indices: Vec<Vec<f64>>,
}

impl<'a> Plan<'a> {
    pub(crate) fn new(system: &'a OpticalSystem) -> Self {
        let count = |first: &mut usize, rays: usize| {
            *first += rays;
            Some(*first)
        };
        let rays = system.sources.iter().map(|source| source.starts.len());
        let firsts = std::iter::once(0).chain(rays).scan(0, |first, rays| count(first, rays)).collect();
        let wavelengths = system.wavelengths();
        let of_media = |line: &Wavelength| system.media.iter().map(|medium| medium.index(*line)).collect();
        Self { system, firsts, indices: wavelengths.iter().map(of_media).collect(), wavelengths }
    }

    /// How many rays there are, each with all its lines.
    fn jobs(&self) -> usize {
        self.firsts.last().copied().unwrap_or(0)
    }

    /// The source and the ray within it.
    fn job(&self, job: usize) -> (usize, usize) {
        let source = self.firsts.partition_point(|first| *first <= job) - 1;
        (source, job - self.firsts[source])
    }

    /// A ray without its branches.
    fn ray(&self, source: usize, ray: usize, line: usize) -> TracedRay {
        let placed = &self.system.sources[source];
        TracedRay {
            source,
            ray,
            wavelength: placed.lines[line],
            power: placed.power.total(),
            one_of_several_lines: placed.lines.len() > 1,
            segments: Vec::new(),
        }
    }

    fn indices(&self, line: Wavelength) -> &[f64] {
        let place = self.wavelengths.binary_search_by(|known| known.nanometers().total_cmp(&line.nanometers()));
        place.map_or(&[], |place| &self.indices[place])
    }
}

/// Follows rays on one thread.
struct Worker<'a> {
    plan: &'a Plan<'a>,
    tracer: Tracer<'a>,
    memory: Option<&'a Memory>,
    segments: Vec<Segment>,
    progress: &'a (dyn Fn(u64) + Sync),
}

impl<'a> Worker<'a> {
    fn new(
        system: &'a OpticalSystem,
        plan: &'a Plan<'a>,
        memory: Option<&'a Memory>,
        progress: &'a (dyn Fn(u64) + Sync),
    ) -> Self {
        Self { plan, tracer: Tracer::new(system), memory, segments: Vec::new(), progress }
    }

    /// Follows rays in a row, with at most so many segments.
    fn follow(&mut self, jobs: Range<usize>, most: u64) -> Stretch {
        let mut stretch = Stretch { jobs: jobs.start..jobs.start, ..Stretch::default() };
        jobs.for_each(|_| self.ray(&mut stretch, most));
        self.end(&mut stretch);
        stretch
    }

    /// Follows the ray after a stretch and adds it to that, which then has at most so many segments.
    fn ray(&mut self, stretch: &mut Stretch, most: u64) {
        let (source, ray) = self.plan.job(stretch.jobs.end);
        stretch.jobs.end += 1;
        if self.plan.system.sources[source].lines.len() == 1 {
            self.line(stretch, (source, ray, 0), most);
        } else {
            self.end(stretch);
            self.lines(stretch, (source, ray), most);
        }
    }

    /// Follows a ray at all its lines. Light that depends on no index that changes with the wavelength is followed once.
    fn lines(&mut self, stretch: &mut Stretch, (source, ray): (usize, usize), most: u64) {
        let mut known: Option<Stretch> = None;
        for (line, wavelength) in self.plan.system.sources[source].lines.iter().enumerate() {
            let left = most - stretch.work.followed;
            if let Some(known) = known.as_ref().filter(|known| known.work.followed <= left) {
                stretch.append(known.at(*wavelength));
                continue;
            }
            let mut one = Stretch::default();
            self.line(&mut one, (source, ray, line), left);
            self.end(&mut one);
            if line == 0 && !one.work.disperses {
                known = Some(one.clone());
            }
            stretch.append(one);
        }
    }

    /// Follows a ray at one line.
    fn line(&mut self, stretch: &mut Stretch, (source, ray, line): (usize, usize, usize), most: u64) {
        let placed = &self.plan.system.sources[source];
        let mut traced = self.plan.ray(source, ray, line);
        let (start, indices) = (&placed.starts[ray], self.plan.indices(traced.wavelength));
        let left = most - stretch.work.followed;
        let Self { tracer, memory, segments, progress, .. } = self;
        let mut count = Count { ray: &traced, summary: &mut stretch.summary, progress: *progress };
        // Apart, so that no segment is made where none is kept.
        let Some(memory) = memory else {
            stretch.work.followed += tracer.follow(start, placed.power, indices, left, &mut count);
            return;
        };
        let mut kept = memory.lock().ok().and_then(|mut lists| lists.pop()).unwrap_or_default();
        let is_fresh = kept.capacity() == 0;
        let list = if is_fresh { segments } else { &mut kept };
        list.clear();
        let mut keep = Keep { count: &mut count, segments: list };
        stretch.work.followed += tracer.follow(start, placed.power, indices, left, &mut keep);
        traced.segments = if is_fresh { self.segments.as_slice().to_vec() } else { kept };
        stretch.rays.push(traced);
    }

    /// Adds to a stretch what its rays took.
    fn end(&mut self, stretch: &mut Stretch) {
        stretch.work.add(&self.tracer.take_work());
        stretch.summary.tell(self.progress);
    }
}

impl Stretch {
    fn append(&mut self, mut other: Self) {
        self.rays.append(&mut other.rays);
        self.summary.append(other.summary);
        self.work.add(&other.work);
    }

    /// The same light at another wavelength, which changes nothing on its way.
    fn at(&self, wavelength: Wavelength) -> Self {
        let mut same = Self { work: self.work.spared(), ..self.clone() };
        same.summary.told = 0;
        same.rays.iter_mut().for_each(|ray| ray.wavelength = wavelength);
        same.summary.landed.iter_mut().for_each(|(_, hit)| hit.wavelength = wavelength);
        same
    }
}

fn number(count: usize) -> u64 {
    u64::try_from(count).unwrap_or(u64::MAX)
}

fn place(count: u64) -> usize {
    usize::try_from(count).unwrap_or(usize::MAX)
}
