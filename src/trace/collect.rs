//! All rays of a system, many at a time, their results in one order.

use rayon::prelude::*;

use crate::light::Wavelength;
use crate::system::OpticalSystem;
use crate::trace::summary::RaySummary;
use crate::trace::tracer::{Leg, Record, Tracer};
use crate::trace::{Segment, TracedRay, Visitor, Work};

/// One ray at one line, followed: its branches if they were asked for, and what became of its light.
pub(crate) struct Part {
    pub(crate) ray: TracedRay,
    pub(crate) summary: RaySummary,
    pub(crate) work: Work,
}

/// Follows every ray of the system through every hit, in order and on one thread, and hands every segment on.
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
        for (line, wavelength) in placed.lines.iter().enumerate() {
            let traced = plan.ray(source, ray, line);
            let indices = plan.indices(*wavelength);
            let (mut show, mut work) = (Show { ray: &traced, visitor }, Work::default());
            tracer.follow(&placed.starts[ray], placed.power, indices, left, &mut work, &mut show);
            left -= work.followed;
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
    summary: &'a mut RaySummary,
    told: u64,
    progress: &'a (dyn Fn(u64) + Sync),
}

impl Record for Count<'_> {
    #[inline(always)]
    fn record(&mut self, leg: &Leg) {
        self.summary.count(self.ray, leg);
        if self.summary.segments - self.told == ALONE {
            self.told = self.summary.segments;
            (self.progress)(ALONE);
        }
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
/// Rays in one batch at most.
const BATCH: u64 = 1024;
/// Parts of a batch, one of which a thread takes at a time.
const CHUNKS: u64 = 64;

/// Follows every ray of the system and hands the parts on in order. The segments that the system's limit allows are spent in
/// that order too: the result does not depend on the number of threads. `progress` hears now and then how many more segments
/// there are.
pub(crate) fn collect(
    system: &OpticalSystem,
    keeps_tree: bool,
    progress: &(dyn Fn(u64) + Sync),
    mut keep: impl FnMut(&mut Part),
) {
    let plan = Plan::new(system);
    let most = system.settings.max_segments;
    let (mut left, mut longest, mut next) = (most, 1, 0);
    let mut alone = Worker::new(system, &plan, keeps_tree, progress);
    let mut batches = vec![Vec::new()];
    while next < plan.jobs() {
        if most - left < ALONE && left > 0 {
            batches[0].clear();
            alone.lines(next, left, &mut batches[0]);
            next += 1;
        } else {
            let threads = number(rayon::current_num_threads()).min(BATCH);
            let batch = if left == 0 { BATCH } else { (left / longest).clamp(threads, BATCH) };
            let end = plan.jobs().min(next + place(batch));
            let chunk = place(batch / CHUNKS).max(1);
            batches.clear();
            let worker = || Worker::new(system, &plan, keeps_tree, progress);
            let chunks = (0..(end - next).div_ceil(chunk)).into_par_iter().map_init(worker, |worker, k| {
                let begin = next + k * chunk;
                let mut parts = Vec::with_capacity(chunk);
                (begin..end.min(begin + chunk)).for_each(|job| worker.lines(job, left, &mut parts));
                parts
            });
            batches = chunks.collect();
            next = end;
        }
        for part in batches.iter_mut().flatten() {
            longest = longest.max(part.work.followed);
            if part.work.followed > left {
                *part = part.anew();
                alone.follow(part, left);
            }
            left -= part.work.followed;
            keep(part);
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
    keeps_tree: bool,
    segments: Vec<Segment>,
    progress: &'a (dyn Fn(u64) + Sync),
}

impl<'a> Worker<'a> {
    fn new(
        system: &'a OpticalSystem,
        plan: &'a Plan<'a>,
        keeps_tree: bool,
        progress: &'a (dyn Fn(u64) + Sync),
    ) -> Self {
        Self { plan, tracer: Tracer::new(system), keeps_tree, segments: Vec::new(), progress }
    }

    /// Follows a ray at all its lines, with at most so many segments. Light that depends on no index that changes with the
    /// wavelength is followed once.
    fn lines(&mut self, job: usize, most: u64, parts: &mut Vec<Part>) {
        let (source, ray) = self.plan.job(job);
        let lines = &self.plan.system.sources[source].lines;
        let (mut left, first) = (most, parts.len());
        for (line, wavelength) in lines.iter().enumerate() {
            let known = parts.get(first).filter(|first| !first.work.disperses && first.work.followed <= left);
            if let Some(known) = known {
                let part = known.at(*wavelength);
                left -= part.work.followed;
                parts.push(part);
            } else {
                parts.push(Part::new(self.plan.ray(source, ray, line)));
                if let Some(part) = parts.last_mut() {
                    self.follow(part, left);
                    left -= part.work.followed;
                }
            }
        }
    }

    /// Follows the ray of a part.
    fn follow(&mut self, part: &mut Part, most: u64) {
        let Part { ray, summary, work } = part;
        let placed = &self.plan.system.sources[ray.source];
        let indices = self.plan.indices(ray.wavelength);
        let Self { tracer, segments, progress, .. } = self;
        let start = &placed.starts[ray.ray];
        let mut count = Count { ray, summary, told: 0, progress: *progress };
        // Apart, so that no segment is made where none is kept.
        if self.keeps_tree {
            segments.clear();
            let mut keep = Keep { count: &mut count, segments };
            tracer.follow(start, placed.power, indices, most, work, &mut keep);
        } else {
            tracer.follow(start, placed.power, indices, most, work, &mut count);
        }
        progress(count.summary.segments - count.told);
        if self.keeps_tree {
            ray.segments = self.segments.as_slice().to_vec();
        }
    }
}

impl Part {
    /// A ray that is still to be followed.
    fn new(ray: TracedRay) -> Self {
        Self { ray, summary: RaySummary::default(), work: Work::default() }
    }

    fn anew(&self) -> Self {
        Self::new(TracedRay { segments: Vec::new(), ..self.ray })
    }

    /// The same light at another wavelength, which changes nothing on its way.
    fn at(&self, wavelength: Wavelength) -> Self {
        let mut summary = self.summary.clone();
        summary.landed.iter_mut().for_each(|(_, hit)| hit.wavelength = wavelength);
        Self { ray: TracedRay { wavelength, ..self.ray.clone() }, summary, work: self.work.spared() }
    }
}

fn number(count: usize) -> u64 {
    u64::try_from(count).unwrap_or(u64::MAX)
}

fn place(count: u64) -> usize {
    usize::try_from(count).unwrap_or(usize::MAX)
}
