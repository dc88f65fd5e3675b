//! What is skipped changes no bit: traces held against those of a tracer that skips nothing.

use std::path::{Path, PathBuf};

use proptest::prelude::*;

use super::collect::{Plan, visit_with};
use super::tracer::Tracer;
use crate::compile::compile;
use crate::scene::Scene;
use crate::system::OpticalSystem;
use crate::trace::{RayTree, summarize, trace, visit};

#[path = "../../tests/support/random.rs"]
#[allow(dead_code, unreachable_pub, reason = "shared with the tests of the library")]
mod random;
#[path = "../../tests/laws/scenes.rs"]
#[allow(
    dead_code,
    unreachable_pub,
    unreachable_patterns,
    clippy::field_reassign_with_default,
    reason = "shared with the tests of the library"
)]
mod scenes;

/// The tree of a tracer that skips nothing: it looks at every interface at every step, counts the crossings behind every
/// ray, and follows every line on one thread.
fn plain(system: &OpticalSystem) -> RayTree {
    let mut tree = RayTree::default();
    visit_with(Tracer::skipping_nothing(system), &Plan::new(system), &mut tree);
    tree
}

fn check(scene: &Scene, name: &str) -> OpticalSystem {
    let system = compile(scene).unwrap_or_else(|problems| panic!("{name}: {problems:?}")).system;
    let traced = trace(&system);
    assert!(traced.tree == plain(&system), "{name}: skipping changes bits");
    assert_eq!(summarize(&system), traced.summary, "{name}");
    system
}

#[test]
fn skipping_changes_no_bit_of_the_scenes() {
    for path in scene_files(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/scenes"))) {
        let text = std::fs::read_to_string(&path).unwrap();
        check(&Scene::from_ron(&text).unwrap(), &path.display().to_string());
    }
}

fn scene_files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries.flat_map(|path| if path.is_dir() { scene_files(&path) } else { vec![path] }).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn skipping_changes_no_bit_of_random_scenes(scene in prop_oneof![scenes::free_scenes(), scenes::turned_scenes()]) {
        check(&scene.0, "random");
    }
}

/// Many bodies of a few media on a lattice, some in others, with mirrors and bubbles: search tree, cells, holes.
#[test]
fn skipping_changes_no_bit_of_crowded_scenes() {
    for seed in 0..24 {
        let system = check(&crowd(seed), &format!("seed {seed}"));
        assert!(system.tree.is_some());
        let closed = system.cells.begins.len() - 2;
        assert!(closed > 20, "{closed} cells");
    }
}

fn crowd(seed: u64) -> Scene {
    let mut random = random::Random(seed + 1);
    let mut bodies = String::new();
    for k in 0..64 {
        let (x, y) = (f64::from(k % 8), f64::from(k / 8));
        let at = format!(
            "at: ({}, {}), rotate: {}",
            x + 0.2 * random.unit(),
            y + 0.2 * random.unit(),
            360.0 * random.unit()
        );
        let outer = ["Disk(0.4)", "RegularPolygon(5, 0.4)", "HalfDisk(0.35)", "Rectangle(0.6, 0.4)"][random.below(4)];
        let inner = ["Disk(0.1)", "RegularPolygon(3, 0.12)", "Rectangle(0.1, 0.2)"][random.below(3)];
        let index = [1.33, 1.5, 1.5, 2.0][random.below(4)];
        bodies += &format!("(shape: {outer}, {at}, medium: Index({index})),\n");
        bodies += &match random.below(4) {
            0 => format!("(shape: {inner}, {at}, medium: Index(1)),\n"),
            1 => format!("(shape: {inner}, {at}, medium: Index(1.5)),\n"),
            2 => format!("(shape: Flat(from: (-0.1, 0), to: (0.1, 0.05)), {at}, surface: Mirror),\n"),
            _ => String::new(),
        };
    }
    let sources = "[(light: Fan(from: (-2, -2), direction: Towards((4, 4)), spread: 50, rays: 9)),
        (light: Point(at: (3.1, 4.2), rays: 7), spectrum: Lines([480, 550, 650]))]";
    let text = format!("(bodies: [{bodies}], sources: {sources}, trace: (min_power: 1e-3, max_depth: 40))");
    Scene::from_ron(&text).unwrap()
}

#[test]
fn no_number_of_threads_changes_a_bit_even_where_segments_run_out() {
    let mut scene = crowd(7);
    scene.trace.min_power = 1e-6;
    for most in [1_000_000, 40_000, 17_001] {
        scene.trace.max_segments = most;
        assert!(check_threads(&scene) > 20_000);
    }
}

/// After very many rays of one segment come some of very many.
#[test]
fn no_number_of_threads_changes_a_bit_where_rays_differ_much() {
    let text = "(
        bodies: [(shape: Rectangle(4, 3), surface: Mirror)],
        sources: [
            (light: Fan(from: (10, 0), direction: Angle(0), spread: 60, rays: 17000)),
            (light: Point(at: (0.1, 0.2), rays: 40)),
        ],
        trace: (max_depth: 20000, min_power: 0, max_segments: 400000),
    )";
    assert!(check_threads(&Scene::from_ron(text).unwrap()) > 400_000);
}

/// Traces a scene one ray after the other and on different numbers of threads; returns how many segments it has.
fn check_threads(scene: &Scene) -> usize {
    let system = compile(scene).unwrap().system;
    let mut one_by_one = RayTree::default();
    visit(&system, &mut one_by_one);
    for threads in [1, 2, 5] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let most = scene.trace.max_segments;
        assert!(pool.install(|| trace(&system)).tree == one_by_one, "{threads} threads, {most} segments");
    }
    one_by_one.rays.iter().map(|ray| ray.segments.len()).sum()
}
