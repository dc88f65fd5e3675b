//! snellius beside the reference, ray by ray and branch by branch.

use std::collections::BTreeMap;

use f256::f256;
use glam::DVec2;
use snellius::scene::{Direction, Light};
use snellius::{OpticalSystem, Scene, Segment, TracedRay, compile, trace};

use crate::condition::Bundle;
use crate::doubts::Doubt;
use crate::support::figures::U;
use crate::support::wide::{Wide2, narrow, wide};
use crate::tracer::{self, Reference, reference};

/// A child of less than this share of the source ray is nothing but rounding, at Brewster's angle, and passed over.
const NOTHING: f64 = 1e-26;

/// What a comparison finds.
#[derive(Default)]
pub(crate) struct Findings {
    pub(crate) rays: usize,
    /// Segments compared.
    pub(crate) compared: usize,
    /// Segments set aside, and branches by the reason of it.
    pub(crate) set_aside: usize,
    pub(crate) doubts: BTreeMap<Doubt, usize>,
    /// Largest error of a position, in sizes of the scene.
    pub(crate) in_sizes: f64,
    /// Largest error of any number, in u × condition.
    pub(crate) in_conditions: f64,
    /// Where that is.
    pub(crate) worst: String,
    /// What is not the same way, or no number.
    pub(crate) faults: Vec<String>,
}

/// Traces a scene with both and compares.
pub(crate) fn compare(scene: &Scene) -> Findings {
    compare_with(scene, scene)
}

/// Traces one scene with snellius and another with the reference.
pub(crate) fn compare_with(scene: &Scene, truth: &Scene) -> Findings {
    let system = compile(scene).unwrap_or_else(|problems| panic!("{problems}")).system;
    let (origin, tree) = (system.origin(), trace(&system).tree);
    let Reference { size, rays } = reference(&with_rays_of_objects(truth, &system), origin);
    let mut findings = Findings { rays: rays.len(), ..Findings::default() };
    assert_eq!(tree.rays.len(), rays.len());
    for (traced, ray) in tree.rays.iter().zip(&rays) {
        let [nm, power] = [(traced.wavelength.nanometers(), ray.nanometers), (traced.power, ray.power)]
            .map(|(actual, expected)| narrow((wide(actual) - expected).abs() / expected));
        if nm.max(power) > 4.0 * U {
            findings.faults.push(format!("{}: wavelength or power is off by {nm:e}, {power:e}", traced.name()));
        }
        let mut comparison = Comparison { findings: &mut findings, traced, origin, size, whole: ray.power };
        comparison.segment(&traced.segments[0], &ray.first);
    }
    findings
}

/// The same scene with every object as the rays that snellius lays out for it. Where those head is no matter of accuracy.
fn with_rays_of_objects(scene: &Scene, system: &OpticalSystem) -> Scene {
    // Toward a point so far away that the start's coordinates round nothing off the direction.
    const FAR: f64 = 1_048_576.0;
    let sources = scene.sources.iter().zip(system.sources()).flat_map(|(source, placed)| {
        let Light::Object { to: from, .. } = source.light else { return vec![source.clone()] };
        let power = source.power / placed.starts.len() as f64;
        let light = |direction| Light::Ray { from, direction: Direction::Towards(from + FAR * direction) };
        placed
            .starts
            .iter()
            .map(|start| {
                let mut source = source.clone();
                source.light = light(start.direction);
                source.power = power;
                source
            })
            .collect()
    });
    let mut scene = scene.clone();
    scene.sources = sources.collect();
    scene
}

struct Comparison<'a> {
    findings: &'a mut Findings,
    traced: &'a TracedRay,
    origin: DVec2,
    size: f64,
    whole: f256,
}

impl Comparison<'_> {
    fn segment(&mut self, actual: &Segment, expected: &tracer::Segment) {
        self.start(actual, &expected.start);
        if let Some(doubt) = expected.doubt {
            *self.findings.doubts.entry(doubt).or_default() += 1;
            self.findings.set_aside += self.descendants(actual);
            return;
        }
        self.findings.compared += 1;
        self.same(actual, "ending", actual.ending, expected.ending);
        self.same(actual, "body", actual.hit.map(|hit| hit.body), expected.body);
        let total = actual.hit.is_some_and(|hit| hit.total_internal_reflection);
        self.same(actual, "total internal reflection", total, expected.total_internal_reflection);
        let index = narrow((wide(actual.medium_index) - expected.index).abs() / expected.index);
        self.number(actual, "index", index, 1.0);
        match (actual.to, &expected.end) {
            (None, None) => self.path(actual, &expected.start),
            (Some(to), Some(end)) => {
                self.position(actual, "to", to, end);
                self.path(actual, end);
            }
            (to, end) => self.same(actual, "hit", to.is_some(), end.is_some()),
        }
        self.children(actual, expected);
    }

    fn children(&mut self, actual: &Segment, expected: &tracer::Segment) {
        let (traced, whole) = (self.traced, narrow(self.whole));
        let children = traced.segments.iter().filter(|child| child.parent == Some(actual.id));
        let is_nothing = |power: f64| power / whole < NOTHING;
        let nothings = children.clone().filter(|child| is_nothing(child.power.total()));
        self.findings.set_aside += nothings.map(|child| self.descendants(child)).sum::<usize>();
        let mut children = children.filter(|child| !is_nothing(child.power.total())).peekable();
        for child in &expected.children {
            let [s, p] = child.start.truth().power;
            if is_nothing(narrow(s + p)) {
                continue;
            }
            match children.next_if(|next| next.via == child.via) {
                Some(next) => self.segment(next, child),
                None => self.same(actual, "child", None, Some(child.via)),
            }
        }
        if let Some(more) = children.next() {
            self.same(actual, "child", Some(more.via), None);
        }
    }

    fn descendants(&self, segment: &Segment) -> usize {
        let children = self.traced.segments.iter().filter(|child| child.parent == Some(segment.id));
        1 + children.map(|child| self.descendants(child)).sum::<usize>()
    }

    fn start(&mut self, actual: &Segment, expected: &Bundle) {
        let truth = expected.truth();
        self.position(actual, "from", actual.from, expected);
        let direction = narrow((Wide2::from(actual.direction) - truth.d).length());
        self.number(actual, "direction", direction, expected.of_direction());
        let power = [(actual.power.s, truth.power[0]), (actual.power.p, truth.power[1])]
            .map(|(actual, expected)| narrow((wide(actual) - expected).abs() / self.whole));
        self.number(actual, "power", power[0].max(power[1]), expected.of_power(self.whole));
    }

    fn position(&mut self, actual: &Segment, what: &str, p: DVec2, expected: &Bundle) {
        let off = (Wide2::from(p) - expected.truth().p).narrow().abs();
        // snellius computes about its origin; its coordinates in the scene are rounded once more, which is no error of its.
        let rounding = |x: f64, origin: f64| if origin == 0.0 { 0.0 } else { 0.5 * (x.abs().next_up() - x.abs()) };
        let rounded = DVec2::new(rounding(p.x, self.origin.x), rounding(p.y, self.origin.y));
        let error = (off - rounded).max(DVec2::ZERO).length() / self.size;
        self.findings.in_sizes = self.findings.in_sizes.max(error);
        self.number(actual, what, error, expected.of_position());
    }

    fn path(&mut self, actual: &Segment, expected: &Bundle) {
        let error = narrow((wide(actual.optical_path) - expected.truth().path).abs()) / self.size;
        self.number(actual, "optical path", error, expected.of_path());
    }

    fn number(&mut self, actual: &Segment, what: &str, error: f64, condition: f64) {
        let in_conditions = error / (U * condition);
        if !in_conditions.is_finite() {
            self.findings.faults.push(format!("{}: {what} is no number", self.traced.address(actual.id)));
        } else if in_conditions > self.findings.in_conditions {
            self.findings.in_conditions = in_conditions;
            let address = self.traced.address(actual.id);
            self.findings.worst = format!("{address} {what}: {error:.1e}, condition {condition:.1e}");
        }
    }

    fn same<T: PartialEq + std::fmt::Debug>(&mut self, segment: &Segment, what: &str, actual: T, expected: T) {
        if actual != expected {
            let address = self.traced.address(segment.id);
            self.findings.faults.push(format!("{address}: {what} is {actual:?}, not {expected:?}"));
        }
    }
}
