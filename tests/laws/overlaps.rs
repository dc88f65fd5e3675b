//! Who fills an overlap, what is one boundary, and what a gap is.

use glam::DVec2;
use proptest::prelude::*;
use snellius::Scene;
use snellius::compile::compile;
use snellius::trace::{Ending, Trace};

use crate::support::{Run, run_text};
use crate::{U, config};

/// Index and end of the segments along `path`, each letter a hit.
fn stations(run: &Run) -> Vec<(f64, f64)> {
    let segments = &run.trace.tree.rays[0].segments;
    segments.iter().filter_map(|s| Some((s.medium_index, s.to?.x))).collect()
}

fn along_x(bodies: &str) -> Run {
    run_text(&format!(
        "(bodies: [{bodies}], sources: [(light: Ray(from: (-9, 0.25), direction: Angle(0)))], \
         trace: (secondary_rays: TransmittedOnly))"
    ))
}

fn warnings(bodies: &str) -> Vec<String> {
    let scene = Scene::from_ron(&format!("(bodies: [{bodies}])")).unwrap();
    compile(&scene).unwrap().warnings.into_iter().map(|problem| problem.message).collect()
}

/// Everything but the bodies' numbers: cementing is the same however it is written.
fn ways(trace: &Trace) -> Vec<(Option<DVec2>, DVec2, f64, Ending)> {
    let segments = trace.tree.rays.iter().flat_map(|ray| &ray.segments);
    segments.map(|s| (s.to, s.direction, s.power.total(), s.ending)).collect()
}

#[test]
fn the_later_body_fills_an_overlap_and_indices_are_absolute() {
    let glass = "(shape: Rectangle(4, 4), medium: Index(1.5))";
    let water = "(shape: Rectangle(8, 8), medium: Index(1.33))";
    let run = along_x(&format!("{water}, {glass}"));
    assert_eq!(stations(&run), [(1.0, -4.0), (1.33, -2.0), (1.5, 2.0), (1.33, 4.0)]);
    let buried = along_x(&format!("{glass}, {water}"));
    assert_eq!(stations(&buried), [(1.0, -4.0), (1.33, 4.0)]);
    assert_eq!(buried.system.dropped_boundaries(), 4);
}

#[test]
fn an_air_lens_is_a_hole_in_glass() {
    let run = along_x("(shape: Rectangle(8, 8), medium: Index(1.5)), (shape: Disk(2), medium: Index(1))");
    let indices: Vec<_> = run.trace.tree.rays[0].segments.iter().map(|s| s.medium_index).collect();
    assert_eq!(indices, [1.0, 1.5, 1.0, 1.5, 1.0]);
}

#[test]
fn boundaries_between_equal_media_are_no_interfaces() {
    let run = along_x(
        "(shape: Rectangle(4, 4), medium: Index(1.5)), (shape: Rectangle(4, 4), at: (3, 0), medium: Index(1.5))",
    );
    assert_eq!(stations(&run), [(1.0, -2.0), (1.5, 5.0)]);
    // Not merely the same index at one wavelength.
    let by_name = "(shape: Rectangle(4, 4), medium: Catalog(\"N-BK7\")), (shape: Rectangle(4, 4), at: (4, 0), medium: ";
    let dropped = |medium: &str| along_x(&format!("{by_name}{medium})")).system.dropped_boundaries();
    assert_eq!(dropped("Catalog(\"N-BK7\")"), 1);
    assert_eq!(dropped("Index(1.5168000345005885)"), 0);
    assert_eq!(along_x("(shape: Disk(1), medium: Index(1))").system.interfaces().len(), 0);
    assert_eq!(along_x("(shape: Disk(1), medium: Speed(299792458))").system.interfaces().len(), 0);
}

#[test]
fn a_hit_on_coincident_outlines_names_the_later_body() {
    let run = along_x(
        "(shape: Rectangle(4, 4), medium: Index(1.5)), (shape: Rectangle(4, 4), at: (4, 0), medium: Index(1.7))",
    );
    let bodies: Vec<_> = run.trace.tree.rays[0].segments.iter().filter_map(|s| Some(s.hit?.body)).collect();
    assert_eq!(bodies, [0, 1, 1]);
    assert_eq!(run.system.interfaces().len(), 7);
}

#[test]
fn a_body_exactly_on_another_replaces_it() {
    for shape in ["Disk(2)", "HalfDisk(2)", "Lens(radii: (9, -9), thickness: 2, diameter: 4)", "RegularPolygon(7, 2)"] {
        for rotate in [0.0, 33.3, 90.0, 217.0] {
            let body =
                |medium: f64| format!("(shape: {shape}, rotate: {rotate}, at: (0.1, 0.2), medium: Index({medium}))");
            let both = along_x(&format!("{}, {}", body(1.5), body(1.8)));
            let one = along_x(&body(1.8));
            assert_eq!(ways(&both.trace), ways(&one.trace), "{shape} rotated by {rotate}");
            assert_eq!(both.system.interfaces().len(), one.system.interfaces().len());
        }
    }
}

proptest! {
    #![proptest_config(config(300))]

    /// Two half disks whose rotations place the same arc by different roundings: the disk of both is whole.
    #[test]
    fn arcs_coincide_after_rotation(rotate in -180.0..180.0, x in -50.0..50.0, y in -50.0..50.0, radius in 0.1..20.0) {
        let half = |turn: f64| format!("(shape: HalfDisk({radius}), rotate: {turn}, at: ({x}, {y}), medium: Index(1.5))");
        let disk = format!("(shape: Disk({radius}), rotate: {}, at: ({x}, {y}), medium: Index(1.7))", 0.37 * rotate);
        let halves = along_x(&format!("{}, {}", half(rotate), half(rotate + 180.0)));
        prop_assert_eq!(halves.system.dropped_boundaries(), 1, "the flat faces are one");
        prop_assert_eq!(halves.system.interfaces().len(), 2);
        let covered = along_x(&format!("{}, {disk}", half(rotate)));
        let inner = covered.system.interfaces().iter().filter(|i| i.left != covered.system.surroundings()
            && i.right != covered.system.surroundings()).count();
        prop_assert_eq!(inner, 0, "the disk covers the half disk, arc and all");
    }

    /// A whole prescription equals its elements as bodies of their own, to the rounding of their places.
    #[test]
    fn a_lens_group_equals_its_cemented_lenses(
        r1 in 12.0..60.0, r2 in -60.0..-12.0, r3 in -90.0..-30.0, rotate in -180.0..180.0, height in -4.0..4.0,
    ) {
        let (t1, t2) = (4.5, 3.5);
        let group = format!("LensGroup(diameter: 10, surfaces: [(radius: {r1}, thickness: {t1}, medium: Index(1.52)), \
            (radius: {r2}, thickness: {t2}, medium: Index(1.62)), (radius: {r3})])");
        let lens = |radii: (f64, f64), thickness: f64, vertex: f64, index: f64| {
            let turn = snellius::numerics::Turn::degrees(rotate);
            let at = turn.apply(DVec2::new(vertex + 0.5 * thickness, 0.0));
            format!("(shape: Lens(radii: {radii:?}, thickness: {thickness}, diameter: 10), at: ({}, {}), rotate: {rotate}, \
                medium: Index({index}))", at.x, at.y)
        };
        let source = format!("(light: Ray(from: (-40, {height}), direction: Towards((3, 0.5))))");
        let scene = |bodies: &str| run_text(&format!("(bodies: [{bodies}], sources: [{source}], trace: (max_depth: 6))"));
        let whole = scene(&format!("(shape: {group}, rotate: {rotate})"));
        let parts = scene(&format!("{}, {}", lens((r1, r2), t1, 0.0, 1.52), lens((r2, r3), t2, t1, 1.62)));
        prop_assert_eq!(whole.system.interfaces().len(), parts.system.interfaces().len());
        let (whole, parts) = (ways(&whole.trace), ways(&parts.trace));
        prop_assert_eq!(whole.len(), parts.len());
        for (a, b) in whole.iter().zip(&parts) {
            // Six bounces amplify the rounding by the curvature of the faces.
            prop_assert!(a.1.distance(b.1) <= 1e5 * U && a.3 == b.3, "{a:?} {b:?}");
        }
    }
}

#[test]
fn a_gap_thinner_than_light_is_a_warning_with_its_width() {
    let pair = |gap: f64| {
        let left = "(name: \"left\", shape: Rectangle(4, 4), medium: Index(1.5))";
        format!("{left}, (name: \"right\", shape: Rectangle(4, 4), at: ({}, 0), medium: Index(1.6))", 4.0 + gap)
    };
    let found = warnings(&pair(1e-4));
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].contains("1.00e-4") && found[0].contains("left") && found[0].contains("right"), "{found:?}");
    assert_eq!(warnings(&pair(1e-3)), Vec::<String>::new());
    assert_eq!(warnings(&pair(0.0)), Vec::<String>::new());
    assert_eq!(warnings(&pair(1e-15)), Vec::<String>::new(), "coincident");
    assert_eq!(warnings(&pair(1e-12)).len(), 1);
}

#[test]
fn the_cure_for_a_gap_is_no_gap() {
    // The later body overlaps the earlier by more than it missed it: light meets one boundary.
    let pair =
        "(shape: Rectangle(4, 4), medium: Index(1.5)), (shape: Rectangle(4, 4), at: (3.9999, 0), medium: Index(1.6))";
    assert_eq!(warnings(pair), Vec::<String>::new());
    assert_eq!(stations(&along_x(pair)).len(), 3);
}

#[test]
fn arcs_almost_in_contact_are_a_warning() {
    let disks = |gap: f64| {
        format!("(shape: Disk(2), medium: Index(1.5)), (shape: Disk(3), at: ({}, 0), medium: Index(1.5))", 5.0 + gap)
    };
    assert_eq!(warnings(&disks(1e-4)).len(), 1);
    assert_eq!(warnings(&disks(1e-3)).len(), 0);
    assert_eq!(warnings(&disks(0.0)).len(), 0);
}
