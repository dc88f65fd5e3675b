//! How branches end, and how a hit shares power.

use proptest::prelude::*;
use snellius::Scene;
use snellius::scene::SecondaryRays;
use snellius::trace::{Ending, Trace, TracedRay, Via, summarize};

use crate::properties::check;
use crate::scenes::{Random, free_scenes, settings, towards};
use crate::support::{run_scene, run_text};
use crate::{U, config};

/// A glass square with light that meets its far face, traced with these settings.
fn square(trace: &str) -> Trace {
    run_text(&format!(
        "(bodies: [(shape: Rectangle(4, 4), medium: Index(1.5))], sources: [(light: Ray(from: (-5, 0.25), direction: \
         Angle(3)))], trace: ({trace}))"
    ))
    .trace
}

fn endings(trace: &Trace) -> Vec<Ending> {
    trace.tree.rays.iter().flat_map(|ray| &ray.segments).map(|s| s.ending).collect()
}

#[test]
fn a_segment_with_max_depth_hits_behind_it_is_listed_and_not_followed() {
    let trace = square("max_depth: 1, min_power: 0");
    assert_eq!(endings(&trace), [Ending::Interface, Ending::CutMaxDepth, Ending::CutMaxDepth]);
    let cut = trace.tree.rays[0].segments[1];
    assert!(cut.to.is_none() && cut.hit.is_none() && cut.optical_path > 0.0);
    assert!((trace.summary.balance.cut_max_depth.value() - 1.0).abs() <= 2.0 * U);
}

#[test]
fn min_power_is_a_share_of_what_the_line_started_with() {
    for (share, expected) in [(0.03, Ending::Escaped), (0.05, Ending::CutMinPower)] {
        assert_eq!(endings(&square(&format!("min_power: {share}"))).last(), Some(&expected), "R is 4 %");
    }
    let strong = run_text(
        "(bodies: [(shape: Rectangle(4, 4), medium: Index(1.5))], sources: [(power: 1000, spectrum: White(samples: 9), \
         light: Ray(from: (-5, 0.25), direction: Angle(3)))], trace: (min_power: 0.05))",
    );
    assert!(strong.trace.tree.rays.iter().all(|ray| ray.segments.last().unwrap().ending == Ending::CutMinPower));
}

#[test]
fn depth_is_named_before_power_and_power_before_segments() {
    assert_eq!(endings(&square("max_depth: 1, min_power: 0.05, max_segments: 1"))[1..], [Ending::CutMaxDepth; 2]);
    assert_eq!(
        endings(&square("min_power: 0.05, max_segments: 1"))[1..],
        [Ending::CutMaxSegments, Ending::CutMinPower]
    );
    assert_eq!(endings(&square("min_power: 0, max_segments: 1"))[1..], [Ending::CutMaxSegments; 2]);
}

#[test]
fn max_segments_is_spent_in_order_and_every_ray_is_listed() {
    let run = run_text(
        "(bodies: [(shape: Rectangle(4, 4), medium: Index(1.5))], sources: [(light: Beam(center: (-5, 0), \
         direction: Angle(3), width: 2, rays: 5))], trace: (max_segments: 4))",
    );
    let trace = &run.trace;
    assert_eq!(trace.tree.rays.len(), 5);
    let followed =
        endings(trace).iter().filter(|ending| !matches!(ending, Ending::CutMaxSegments | Ending::CutMinPower)).count();
    assert_eq!(followed, 4);
    assert!(trace.tree.rays[1..].iter().skip(1).all(|ray| ray.segments.len() == 1));
    assert!((trace.summary.balance.emitted.value() - 1.0).abs() <= 4.0 * U);
    assert!(trace.summary.balance.residual().abs() <= 4.0 * U);
}

#[test]
fn fixed_shares_leave_the_rest_at_the_hit() {
    let trace = square("secondary_rays: Fixed(kr: 0.25, kt: 0.5), max_depth: 1");
    let [hit, t, r] = [0, 1, 2].map(|k| trace.tree.rays[0].segments[k]);
    assert_eq!(hit.hit.unwrap().absorptance, 0.25);
    assert_eq!((t.via, t.power.s, r.via, r.power.p), (Via::Transmission, 0.25, Via::Reflection, 0.125));
    let nothing = square("secondary_rays: Fixed(kr: 0, kt: 0)");
    assert_eq!(endings(&nothing), [Ending::Absorbed]);
    assert_eq!(nothing.summary.balance.absorbed.value(), 1.0);
    assert_eq!(
        endings(&square("secondary_rays: Fixed(kr: 0, kt: 1)")),
        [Ending::Interface, Ending::Interface, Ending::Escaped]
    );
}

#[test]
fn past_the_critical_angle_everything_is_reflected_under_every_rule() {
    for rule in ["Fresnel", "TransmittedOnly", "Fixed(kr: 0, kt: 0)"] {
        let run = run_text(&format!(
            "(bodies: [(shape: Rectangle(4, 40), medium: Index(1.5))], sources: [(light: Ray(from: (0, 0), direction: \
             Angle(50)))], trace: (max_depth: 3, secondary_rays: {rule}))"
        ));
        let ways: Vec<_> = run.trace.tree.rays[0].segments.iter().map(|s| (s.via, s.power.total())).collect();
        assert_eq!(ways[1..], [(Via::TotalInternalReflection, 1.0); 3], "{rule}");
    }
}

#[test]
fn transmitted_only_spawns_one_ray() {
    let trace = square("secondary_rays: TransmittedOnly");
    assert_eq!(endings(&trace), [Ending::Interface, Ending::Interface, Ending::Escaped]);
    assert!(trace.tree.rays[0].segments.iter().all(|s| s.power.total() == 1.0));
}

#[test]
fn a_secondary_ray_of_no_power_is_not_spawned() {
    // p light at Brewster's angle of 4/3, where the reflected amplitude is exactly 0.
    let run = run_text(
        "(surroundings: Index(1), bodies: [(shape: Rectangle(4, 40), medium: Index(1.3333333333333333))], sources: [(polarization: P, \
         light: Ray(from: (-5, -4), direction: Towards((-2, 0))))], trace: (min_power: 0, max_depth: 1))",
    );
    let segments = &run.trace.tree.rays[0].segments;
    let reflected: f64 = segments.iter().filter(|s| s.via == Via::Reflection).map(|s| s.power.total()).sum();
    assert!(reflected < 1e-30, "{reflected:e}");
    let s_light = run_text(
        "(bodies: [(shape: Flat(from: (0, -1), to: (0, 1)), surface: BeamSplitter(reflect: 0, transmit: 0))], sources: \
         [(light: Ray(from: (-5, 0), direction: Angle(0)))])",
    );
    assert_eq!(endings(&s_light.trace), [Ending::Absorbed]);
}

proptest! {
    #![proptest_config(config(300))]

    #[test]
    fn a_summary_alone_is_that_of_the_whole_trace(Random(scene) in free_scenes()) {
        let run = run_scene(scene);
        prop_assert_eq!(summarize(&run.system), run.trace.summary);
    }

    #[test]
    fn every_cut_keeps_the_balance(Random(mut scene) in free_scenes(), max_segments in 1..40_u64, min_power in 0.0..0.5) {
        scene.trace.max_segments = max_segments;
        scene.trace.min_power = min_power;
        let run = run_scene(scene);
        check(&run);
        let followed = run.trace.tree.rays.iter().flat_map(|ray| &ray.segments);
        let followed = followed.filter(|s| !matches!(s.ending, Ending::CutMaxSegments | Ending::CutMinPower | Ending::CutMaxDepth));
        prop_assert!(u64::try_from(followed.count()).unwrap() <= max_segments);
    }

    /// A path of transmissions alone, sent back from beyond its last hit, comes back to its start.
    #[test]
    fn a_path_traced_backward_returns(Random(mut scene) in free_scenes()) {
        scene.trace = settings(12);
        scene.trace.secondary_rays = SecondaryRays::TransmittedOnly;
        let run = run_scene(scene.clone());
        for ray in run.trace.tree.rays.iter().filter(|ray| is_refracted_only(ray)) {
            let [way_back, shifted, tilted] = [(0.0, 0.0), (STEP, STEP), (STEP, 0.0)].map(|by| aside(&scene, ray, by));
            let (Some(missed), Some(shifted), Some(tilted)) = (way_back, shifted, tilted) else { continue };
            // What a change of place and of direction at the last hit grows to at the start.
            let growth = 1.0 + ((shifted - missed).abs() + (tilted - missed).abs()) / STEP;
            let hits = f64::from(u32::try_from(ray.segments.len()).unwrap());
            prop_assert!(missed.abs() <= 64.0 * U * REACH * hits * growth, "{missed:e} aside, {growth} {:?}", ray.segments);
        }
    }
}

/// Largest coordinate of a random scene.
const REACH: f64 = 30.0;
/// A small change, large against rounding.
const STEP: f64 = 1e-8;

fn is_refracted_only(ray: &TracedRay) -> bool {
    let [_, rest @ ..] = &ray.segments[..] else { return false };
    let escapes = rest.last().is_some_and(|last| last.ending == Ending::Escaped);
    escapes && rest.iter().all(|segment| segment.via == Via::Transmission)
}

/// How far beside the start of a ray its way back runs, sent out from 5 beyond its last hit, shifted there and at the last
/// hit; `None` where it takes another way.
fn aside(scene: &Scene, ray: &TracedRay, (shift_far, shift_hit): (f64, f64)) -> Option<f64> {
    let last = ray.segments.last()?;
    let across = last.direction.perp();
    let far = last.from + 5.0 * last.direction + shift_far * across;
    let sources = vec![towards(far, last.from + shift_hit * across)];
    let mut scene = scene.clone();
    scene.sources = sources;
    let back = run_scene(scene);
    let home = back.trace.tree.rays[0].segments.get(ray.segments.len() - 1)?;
    let same_way = back.trace.tree.rays[0].segments.iter().zip(ray.segments.iter().rev());
    let same_way = same_way.take(ray.segments.len() - 1).all(|(there, here)| there.medium_index == here.medium_index);
    same_way.then(|| (ray.segments[0].from - home.from).perp_dot(home.direction))
}
