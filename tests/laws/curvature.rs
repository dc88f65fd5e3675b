//! Arcs from nearly plane to tangent: a face never vanishes when its radius grows.

use proptest::prelude::*;
use snellius::trace::Ending;

use crate::support::{Run, run_text};
use crate::{U, config};

fn lens(radii: &str, height: f64, slope: f64) -> Run {
    run_text(&format!(
        "(bodies: [(shape: Lens(radii: ({radii}), thickness: 6, diameter: 30), medium: Index(1.5))], \
         sources: [(light: Ray(from: (-20, {height}), direction: Towards((0, {}))))], trace: (max_depth: 6, min_power: 0))",
        height + 20.0 * slope
    ))
}

proptest! {
    #![proptest_config(config(200))]

    /// At a height h on a radius R the face is tilted by h/R and lies h²/2R aside: the light differs by no more than that and
    /// rounding.
    #[test]
    fn a_lens_of_vast_radii_is_a_plane_slab(height in -12.0..12.0, slope in -0.1..0.1) {
        let slab = lens("inf, inf", height, slope);
        for (radii, radius) in [("1e12, inf", 1e12), ("inf, -1e12", 1e12), ("1e15, -1e15", 1e15), ("-1e15, 3e15", 1e15),
            ("1e18, inf", 1e18)] {
            let lens = lens(radii, height, slope);
            let (flat, bent) = (&slab.trace.tree.rays[0].segments, &lens.trace.tree.rays[0].segments);
            prop_assert_eq!(flat.len(), bent.len());
            let bound = 200.0 * 15.0 / radius + 64.0 * U;
            for (a, b) in flat.iter().zip(bent) {
                prop_assert!(a.direction.distance(b.direction) <= bound, "{} {:?} {:?}", radii, a, b);
                prop_assert_eq!((a.via, a.ending, a.to.is_some()), (b.via, b.ending, b.to.is_some()));
                if let (Some(p), Some(q)) = (a.to, b.to) {
                    prop_assert!(p.distance(q) <= 40.0 * bound, "{} {} {}", radii, p, q);
                }
            }
        }
    }

    /// A mirror whose sagitta is far below an ulp of its size is a flat one.
    #[test]
    fn an_arc_all_but_straight_is_met_like_its_chord(height in -9.0..9.0, sagitta in prop_oneof![Just(1e-9), Just(1e-13), Just(1e-300)]) {
        let end = |shape: &str| run_text(&format!(
            "(bodies: [(shape: {shape}, surface: Mirror)], sources: [(light: Ray(from: (-20, {height}), \
             direction: Towards((0, {height}))))])"));
        let flat = end("Flat(from: (0, -10), to: (0, 10))");
        let arc = end(&format!("Arc(from: (0, -10), through: ({sagitta}, 0), to: (0, 10))"));
        let (a, b) = (&flat.trace.tree.rays[0].segments, &arc.trace.tree.rays[0].segments);
        prop_assert_eq!((a.len(), b.len()), (2, 2));
        prop_assert!(a[0].to.unwrap().distance(b[0].to.unwrap()) <= sagitta + 64.0 * U);
        prop_assert!(a[1].direction.distance(b[1].direction) <= sagitta + 8.0 * U);
    }
}

#[test]
fn a_tangent_passes_by_and_a_chord_goes_in_and_out() {
    let disk = |height: f64, angle: f64| {
        let turn = snellius::numerics::Turn::degrees(angle).direction();
        let from = height * turn.perp() - 20.0 * turn;
        run_text(&format!(
            "(bodies: [(shape: Disk(5), medium: Index(1.5))], sources: [(light: Ray(from: ({:?}, {:?}), \
             direction: Angle({angle})))], trace: (secondary_rays: TransmittedOnly))",
            from.x, from.y
        ))
    };
    let count = |run: &Run| run.trace.tree.rays[0].segments.len();
    for angle in [0.0, 30.0, 45.0, 90.0, 123.0, 180.0, 270.0] {
        for side in [1.0, -1.0] {
            assert_eq!(count(&disk(side * 5.0, angle)), 1, "tangent at {angle}°");
            assert_eq!(count(&disk(side * (5.0 + 1e-12), angle)), 1, "outside at {angle}°");
            let chord = disk(side * (5.0 - 1e-12), angle);
            assert_eq!(count(&chord), 3, "chord at {angle}°");
            assert_eq!(chord.trace.tree.rays[0].segments[2].ending, Ending::Escaped);
        }
    }
}

#[test]
fn far_from_the_origin_a_cap_above_the_rounding_of_its_place_is_met() {
    let segments = |below_the_top: f64| {
        let run = run_text(&format!(
            "(bodies: [(shape: Disk(1), at: (1e6, 0), medium: Index(1.5))], trace: (secondary_rays: TransmittedOnly), \
             sources: [(light: Ray(from: (999990, {:?}), direction: Angle(0)))])",
            1.0 - below_the_top
        ));
        run.trace.tree.rays[0].segments.len()
    };
    // An ulp of the place is 1.2e-10.
    assert_eq!(segments(1e-8), 3);
    assert_eq!(segments(1e-10), 1);
}
