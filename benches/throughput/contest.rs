//! One scene and all that trace it.

use snellius::{Ending, OpticalSystem, Scene, Segment, TracedRay, Visitor, summarize, visit};

use crate::flat::{Flat, Nearest};
use crate::optics::compile;
use crate::parry::{Parry, STRATEGY};
use crate::race::Task;
use crate::scalar::Loop;

pub(crate) const OURS: &str = "ours";
pub(crate) const SCALAR: &str = "scalar loop";
pub(crate) const PARRY: &str = "parry2d";
/// parry2d's hierarchy without its ray cast.
pub(crate) const BOXES: &str = "parry2d's boxes, tests ours";

/// Followed segments after which the scalar loop may stop: a segment costs it the same all along.
const ENOUGH: u64 = 10_000;

pub(crate) struct Contest {
    pub(crate) system: OpticalSystem,
    /// Segments that are followed; cut ones are listed too, and cost next to nothing.
    pub(crate) followed: u64,
    flat: Flat,
    scalar: Loop,
    /// Only where all edges are straight.
    parry: Option<Parry>,
    rays: usize,
}

impl Contest {
    pub(crate) fn new(scene: &Scene) -> Self {
        let system = compile(scene).unwrap().system;
        let flat = Flat::new(&system, scene.trace.min_power, scene.trace.max_depth);
        let parry = (flat.edges == flat.curves.len()).then(|| Parry::new(&flat.curves, STRATEGY));
        let (followed, scalar, rays) = (followed(&system), Loop::new(&flat), flat.starts.len());
        Self { system, followed, flat, scalar, parry, rays }
    }

    /// snellius, and parry2d where it can take part.
    pub(crate) fn tasks(&self) -> Vec<Task<'_>> {
        let mut tasks = vec![self.ours()];
        if let Some(parry) = &self.parry {
            tasks.push(self.other(PARRY, |from, ahead, last| parry.nearest(from, ahead, last)));
            tasks.push(self.other(BOXES, |from, ahead, last| parry.nearest_with_our_tests(from, ahead, last)));
        }
        tasks
    }

    /// The plain trace over all rays with some search, checked.
    fn other<'a>(&'a self, name: &'static str, nearest: impl Nearest + Copy + 'a) -> Task<'a> {
        let light = self.flat.trace(self.rays, nearest);
        self.check(name, light.followed, light.total());
        Task::new(name, light.followed, move || self.flat.trace(self.rays, nearest))
    }

    /// The scalar loop, over as many of the rays as give a fair number of segments.
    pub(crate) fn scalar(&self) -> Task<'_> {
        let trace = |rays| self.flat.trace(rays, |from, ahead, last| self.scalar.nearest(from, ahead, last));
        let mut rays = 1;
        while rays < self.rays && trace(rays).followed < ENOUGH {
            rays = (2 * rays).min(self.rays);
        }
        let light = trace(rays);
        if rays == self.rays {
            self.check(SCALAR, light.followed, light.total());
        }
        Task::new(SCALAR, light.followed, move || trace(rays))
    }

    pub(crate) fn ours(&self) -> Task<'_> {
        Task::new(OURS, self.followed, || summarize(&self.system))
    }

    /// `min_power` and `max_depth`.
    pub(crate) fn cuts(&self) -> (f64, u32) {
        (self.flat.min_power, self.flat.max_depth)
    }

    /// A competitor must do the same work: up to rays that pass within rounding of a corner, and for the same light.
    fn check(&self, name: &str, followed: u64, power: f64) {
        let emitted = summarize(&self.system).balance.emitted.value();
        assert!((power / emitted - 1.0).abs() < 1e-9, "{name}: {power} of {emitted}");
        let ratio = followed as f64 / self.followed as f64;
        assert!((ratio - 1.0).abs() < 2e-3, "{name} follows {followed} segments, not {}", self.followed);
    }
}

/// Segments that a trace follows.
pub(crate) fn followed(system: &OpticalSystem) -> u64 {
    struct Counter(u64);
    impl Visitor for Counter {
        fn segment(&mut self, _: &TracedRay, segment: Segment) {
            let is_cut = matches!(segment.ending, Ending::CutMinPower | Ending::CutMaxDepth | Ending::CutMaxSegments);
            self.0 += u64::from(!is_cut);
        }
    }
    let mut counter = Counter(0);
    visit(system, &mut counter);
    counter.0
}
