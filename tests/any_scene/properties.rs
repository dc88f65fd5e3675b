//! What holds of every text: it is refused with reasons, or every result of it is whole and finite.

use std::sync::OnceLock;

use rayon::{ThreadPool, ThreadPoolBuilder};
use snellius::scene::{Light, Loaded, Places, Problem, Severity, Source, load, render_problems, text_of};
use snellius::trace::{RayTree, Trace, retrace, visit};
use snellius::{Compiled, OpticalSystem, Scene, compile, diagram, summarize, trace};

use super::outputs;
use super::plain_words::is_in_plain_words;

/// Half an ulp of 1: the relative error of one rounding.
const U: f64 = 0.5 * f64::EPSILON;
/// Larger scenes are only read: these are about what is computed, not how long it takes.
const MOST_RAYS: u64 = 1000;
const MOST_SIDES: usize = 500;
const MOST_SEGMENTS: u64 = 50_000;

/// How far a text got.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// With reasons.
    Refused,
    /// Valid, and too much work for a short test.
    Large,
    /// With all results.
    Drawn,
}

/// Holds what comes of some bytes to all properties.
pub fn hold_bytes(bytes: &[u8]) -> Verdict {
    match text_of(bytes, "scene.ron") {
        Ok(text) => hold(text),
        Err(problems) => {
            assert!(problems.to_string().starts_with("scene.ron:"), "{problems}");
            Verdict::Refused
        }
    }
}

/// Holds a scene, written in the scene format, to all properties: reading it gives it back, or refuses it for the faults that it has.
pub fn hold_scene(scene: &Scene, text: &str) -> Verdict {
    // Numbers that are none stop the reader before the checks.
    let has_only_numbers = !text.contains("NaN") && !text.contains("inf");
    let faults = |problems: &[Problem]| {
        let errors = problems.iter().filter(|problem| problem.severity == Severity::Error);
        let mut faults: Vec<_> = errors.map(|problem| (problem.path.clone(), problem.message.clone())).collect();
        faults.sort();
        faults
    };
    let own = faults(&scene.validate());
    let read = load(text);
    match &read {
        Ok(loaded) => {
            assert_eq!(loaded.scene, *scene, "read otherwise than written\n{text}");
            assert_eq!(own, [], "accepted\n{text}");
        }
        Err(problems) if has_only_numbers => assert_eq!(faults(problems), own, "{text}"),
        Err(_) => assert!(!own.is_empty(), "refused\n{text}"),
    }
    hold_read(read, text)
}

/// Holds what comes of a text to all properties.
pub fn hold(text: &str) -> Verdict {
    hold_read(load(text), text)
}

fn hold_read(read: Result<Loaded, Vec<Problem>>, text: &str) -> Verdict {
    let Loaded { mut scene, places, warnings, .. } = match read {
        Ok(loaded) => loaded,
        Err(problems) => {
            assert!(problems.iter().any(|problem| problem.severity == Severity::Error), "refused without an error");
            explained(&problems, text);
            return Verdict::Refused;
        }
    };
    assert!(warnings.iter().all(|problem| problem.severity == Severity::Warning), "{warnings:?}");
    explained(&warnings, text);
    if is_large(&scene) {
        return Verdict::Large;
    }
    scene.trace.max_segments = scene.trace.max_segments.min(MOST_SEGMENTS);
    let Compiled { system, warnings, .. } = match compile(&scene) {
        Ok(compiled) => compiled,
        Err(problems) => {
            explained(&placed(problems.list(), &places), text);
            return Verdict::Refused;
        }
    };
    explained(&placed(&warnings, &places), text);
    let trace = traced(&system);
    balanced(&scene, &trace);
    explained(&placed(&diagram::problems(&scene, &trace.tree), &places), text);
    outputs::whole(&scene, &system, &trace);
    Verdict::Drawn
}

fn is_large(scene: &Scene) -> bool {
    let lines = |source: &Source| source.spectrum.lines().count() as u64;
    let rays: u64 = scene.sources.iter().map(|source| rays(source) * lines(source)).sum();
    rays > MOST_RAYS || outputs::sides(scene) > MOST_SIDES
}

fn placed(problems: &[Problem], places: &Places) -> Vec<Problem> {
    let mut problems = problems.to_vec();
    problems.iter_mut().for_each(|problem| places.locate(problem));
    problems
}

/// Every problem has a place in the text, says what is wrong and what would be right, and is shown under its place.
fn explained(problems: &[Problem], text: &str) {
    for problem in problems {
        let span = problem.span.clone().unwrap_or_else(|| panic!("no place: {problem:?}\n{text}"));
        assert!(text.get(span).is_some(), "a place outside of the text: {problem:?}\n{text}");
        is_in_plain_words(problem, text);
    }
    let shown = render_problems(problems, text, "scene.ron");
    let heads = shown.lines().filter(|line| line.starts_with("scene.ron:")).count();
    assert!(heads >= problems.len(), "{shown}");
}

/// The trace, which is the same for any number of threads, and in all ways to trace.
fn traced(system: &OpticalSystem) -> Trace {
    static POOLS: OnceLock<[ThreadPool; 2]> = OnceLock::new();
    let pool = |threads| ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    let [one, two] = POOLS.get_or_init(|| [pool(1), pool(2)]);
    let trace = one.install(|| trace(system));
    assert!(trace.clone() == trace, "the trace holds numbers that are none");
    let mut again = two.install(|| snellius::trace(system));
    assert!(again == trace, "one thread and two give different traces");
    retrace(system, &mut again);
    assert!(again == trace, "tracing again gives another trace");
    assert_eq!(summarize(system), trace.summary, "the summary alone differs");
    let mut seen = RayTree::default();
    visit(system, &mut seen);
    assert!(seen == trace.tree, "a visitor sees other segments");
    trace
}

/// All that was emitted is accounted for. At every hit the shares of s and p that go on or stay, and their sum, are rounded 8 times
/// at most, by a share of what arrives there; and no more arrives at all hits of one depth than was emitted. Each of the 8 sums
/// is rounded at its end.
fn balanced(scene: &Scene, trace: &Trace) {
    let balance = &trace.summary.balance;
    let emitted = balance.emitted.value();
    let hits = trace.tree.rays.iter().map(outputs::depth).max().unwrap_or(0) as f64;
    let most = (8.0 * (hits + 1.0) + 16.0) * U * emitted;
    assert!(balance.residual().abs() <= most, "{balance:?} leaves {:e}, at most {most:e}", balance.residual());
    // Shared among rays and lines, each share rounded, and halved between s and p.
    let given: f64 = scene.sources.iter().map(|source| source.power).sum();
    let is_object = |source: &Source| matches!(source.light, Light::Object { .. });
    assert!(
        scene.sources.iter().any(is_object) || (emitted - given).abs() <= 8.0 * U * given,
        "{given:e} given, {emitted:e} emitted"
    );
}

/// An object has three at most, and a ray is one.
fn rays(source: &Source) -> u64 {
    match source.light {
        Light::Beam { rays, .. } | Light::Fan { rays, .. } | Light::Point { rays, .. } => rays.into(),
        _ => 3,
    }
}
