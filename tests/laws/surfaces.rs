//! What surfaces do, where they lie on bodies, and where a screen says that light landed.

use glam::DVec2;
use snellius::trace::{Ending, Hit, Via};

use crate::U;
use crate::support::{Run, run_text, segment};

fn scene(bodies: &str, light: &str) -> Run {
    run_text(&format!("(bodies: [{bodies}], sources: [(light: {light})])"))
}

fn hit(run: &Run, path: &str) -> Hit {
    segment(&run.trace.tree.rays[0], path).hit.unwrap()
}

fn letters(run: &Run) -> Vec<String> {
    let ray = &run.trace.tree.rays[0];
    ray.segments.iter().map(|s| ray.address(s.id).rsplit(':').next().unwrap().to_owned()).collect()
}

/// Positions on the first screen, in the order of rays.
fn positions(bodies: &str, lights: &str) -> Vec<f64> {
    let sources: Vec<_> = lights.split('\n').map(|light| format!("(light: {})", light.trim())).collect();
    let run = run_text(&format!("(bodies: [{bodies}], sources: [{}])", sources.join(", ")));
    run.trace.summary.screens[0].hits.iter().map(|hit| hit.position).collect()
}

fn close(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() <= 32.0 * U * (1.0 + b.abs()), "{found:?}, not {expected:?}");
    }
}

const SQUARE: &str = "(shape: Rectangle(4, 4), medium: Index(1.5))";
const MIRROR: &str = "(shape: Flat(from: (2, -1), to: (2, 1)), surface: Mirror)";

#[test]
fn a_coating_covers_its_stretch_of_a_face() {
    let bodies = format!("{SQUARE}, {MIRROR}");
    let silvered = hit(&scene(&bodies, "Ray(from: (-5, 0.5), direction: Angle(0))"), "t");
    assert_eq!((silvered.body, silvered.n_t, silvered.reflectance.s), (1, None, 1.0));
    let bare = hit(&scene(&bodies, "Ray(from: (-5, 1.5), direction: Angle(0))"), "t");
    assert_eq!((bare.body, bare.n_t), (0, Some(1.0)));
    // From outside too, and laid on first or last.
    for bodies in [bodies, format!("{MIRROR}, {SQUARE}")] {
        let run = scene(&bodies, "Ray(from: (5, 0.5), direction: Angle(180))");
        assert_eq!(letters(&run), ["", "r"]);
    }
}

#[test]
fn a_coating_overrides_total_internal_reflection() {
    for surface in ["Mirror", "Absorber", "Screen"] {
        let bodies = format!("{SQUARE}, (shape: Flat(from: (2, -2), to: (2, 2)), surface: {surface})");
        let hit = hit(&scene(&bodies, "Ray(from: (0, -1), direction: Angle(50))"), "");
        assert!(!hit.total_internal_reflection && hit.theta_t_degrees().is_none() && hit.critical_degrees().is_none());
    }
}

#[test]
fn of_coincident_surfaces_the_later_wins() {
    let absorber = "(shape: Flat(from: (2, 3), to: (2, -3)), surface: Absorber)";
    let light = "Ray(from: (-5, 0.5), direction: Angle(0))";
    assert_eq!(letters(&scene(&format!("{MIRROR}, {absorber}"), light)), [""]);
    assert_eq!(letters(&scene(&format!("{absorber}, {MIRROR}"), light)), ["", "r"]);
}

#[test]
fn a_later_body_covers_no_surface() {
    let run =
        scene(&format!("{MIRROR}, (shape: Disk(4), medium: Index(1.5))"), "Ray(from: (0, 0.5), direction: Angle(0))");
    assert_eq!((hit(&run, "").body, hit(&run, "").n_i), (0, 1.5));
}

#[test]
fn a_closed_surface_is_hollow() {
    let box_ = "(shape: Rectangle(4, 4), surface: BeamSplitter(reflect: 0.25, transmit: 0.75))";
    let run =
        scene(&format!("(shape: Disk(5), medium: Index(1.5)), {box_}"), "Ray(from: (0, 0.5), direction: Angle(0))");
    let [first, behind] = ["", "t"].map(|path| *segment(&run.trace.tree.rays[0], path));
    assert_eq!((first.medium_index, behind.medium_index), (1.5, 1.5));
    assert_eq!(first.direction, behind.direction);
}

#[test]
fn a_stop_takes_light_beside_its_opening() {
    let stop = "(shape: Stop(opening: 2, height: 8))";
    for (y, passes) in [(0.0, true), (0.999, true), (-0.999, true), (1.001, false), (-3.9, false), (4.1, true)] {
        let run = scene(stop, &format!("Ray(from: (-5, {y}), direction: Angle(0))"));
        assert_eq!(run.trace.tree.rays[0].segments[0].ending == Ending::Escaped, passes, "y = {y}");
    }
    let screen = "(shape: Stop(opening: 2, height: 8), surface: Screen)";
    close(
        &positions(screen, "Ray(from: (-5, -3), direction: Angle(0))\nRay(from: (-5, 3), direction: Angle(0))"),
        &[1.0, 7.0],
    );
}

#[test]
fn a_beam_splitter_on_a_face_refracts_its_share() {
    let face = |reflect: f64, transmit: f64| {
        format!(
            "{SQUARE}, (shape: Flat(from: (2, -2), to: (2, 2)), surface: BeamSplitter(reflect: {reflect}, transmit: {transmit}))"
        )
    };
    let run = scene(&face(0.25, 0.5), "Ray(from: (0, 0), direction: Angle(30))");
    let [there, through] = ["", "t"].map(|path| *segment(&run.trace.tree.rays[0], path));
    let hit = there.hit.unwrap();
    assert_eq!((hit.n_t, hit.reflectance.s, hit.transmittance.p, hit.absorptance), (Some(1.0), 0.25, 0.5, 0.25));
    assert!((1.5 * there.direction.y - through.direction.y).abs() <= 4.0 * U, "refracted");
    assert_eq!(through.power.total(), 0.5);
}

#[test]
fn past_the_critical_angle_a_beam_splitter_reflects_both_shares() {
    let face = "(shape: Flat(from: (2, -9), to: (2, 9)), surface: BeamSplitter(reflect: 0.25, transmit: 0.5))";
    let run = scene(
        &format!("(shape: Rectangle(4, 18), medium: Index(1.5)), {face}"),
        "Ray(from: (0, 0), direction: Angle(50))",
    );
    let hit = hit(&run, "");
    assert!(hit.total_internal_reflection && hit.theta_t_degrees().is_none());
    assert_eq!((hit.reflectance.s, hit.transmittance.s, hit.absorptance), (0.75, 0.0, 0.25));
    let children: Vec<_> =
        run.trace.tree.rays[0].segments.iter().filter(|s| s.parent.is_some_and(|p| p.0 == 0)).collect();
    assert_eq!(children.len(), 1);
    assert_eq!((children[0].via, children[0].power.total()), (Via::TotalInternalReflection, 0.75));
}

#[test]
fn an_ideal_lens_works_from_both_sides() {
    for (center, ends) in
        [(DVec2::ZERO, "from: (0, -5), to: (0, 5)"), (DVec2::new(7.0, 3.0), "from: (7, 8), to: (7, -2)")]
    {
        for focal_length in [12.0, -12.0] {
            let lens = format!("(shape: Flat({ends}), surface: ThinLens(focal_length: {focal_length}))");
            for (side, angle) in [(-1.0, 0), (1.0, 180)] {
                let light =
                    format!("Ray(from: ({}, {}), direction: Angle({angle}))", center.x + 9.0 * side, center.y + 2.0);
                let run = scene(&lens, &light);
                let out = segment(&run.trace.tree.rays[0], "t");
                // Parallel light runs through the focus behind the lens, or from that before it.
                let focus = center - DVec2::new(side * focal_length, 0.0);
                let aside = (focus - out.from).perp_dot(out.direction);
                assert!(aside.abs() <= 64.0 * U * 12.0, "from {side}, f = {focal_length}: {aside:e}");
                assert_eq!(hit(&run, "").transmittance.s, 1.0);
            }
            let run = scene(
                &lens,
                &format!(
                    "Ray(from: ({}, {}), direction: Towards(({}, {})))",
                    center.x - 9.0,
                    center.y + 4.0,
                    center.x,
                    center.y
                ),
            );
            let segments = &run.trace.tree.rays[0].segments;
            // The center is hit up to rounding.
            assert!(segments[0].direction.distance(segments[1].direction) <= 8.0 * U, "the center ray");
        }
    }
}

#[test]
fn position_on_an_open_screen_counts_from_its_first_point() {
    let light = "Ray(from: (-5, 1), direction: Angle(0))";
    close(&positions("(shape: Flat(from: (0, -2), to: (0, 2)), surface: Screen)", light), &[3.0]);
    close(&positions("(shape: Flat(from: (0, 2), to: (0, -2)), surface: Screen)", light), &[1.0]);
    let arc = "(shape: Arc(from: (0, -2), through: (2, 0), to: (0, 2)), surface: Screen)";
    close(
        &positions(arc, "Ray(from: (0, 0), direction: Angle(-45))\nRay(from: (0, 0), direction: Angle(45))"),
        &[0.5, 1.5].map(|q| q * std::f64::consts::PI),
    );
    // Three quarters of a circle, from both sides.
    let arc = "(shape: Arc(from: (0, -2), through: (2, 0), to: (-2, 0)), surface: Screen)";
    close(
        &positions(arc, "Ray(from: (0, 0), direction: Angle(135))\nRay(from: (3, 0), direction: Angle(180))"),
        &[2.5, 1.0].map(|q| q * std::f64::consts::PI),
    );
}

#[test]
fn position_on_a_closed_screen_counts_from_its_first_vertex_in_the_order_written() {
    let lights = "Ray(from: (1, 1), direction: Angle(-90))\nRay(from: (1, 1), direction: Angle(0))\nRay(from: (1, 1), direction: Angle(180))";
    close(&positions("(shape: Polygon([(0, 0), (4, 0), (4, 3), (0, 3)]), surface: Screen)", lights), &[1.0, 5.0, 13.0]);
    close(&positions("(shape: Polygon([(0, 0), (0, 3), (4, 3), (4, 0)]), surface: Screen)", lights), &[13.0, 9.0, 1.0]);
    let drop = "(shape: Outline(start: (0, 0), path: [LineTo((4, 0)), ArcTo(through: (6, 2), to: (4, 4)), LineTo((0, 4))]), surface: Screen)";
    let lights = "Ray(from: (4, 2), direction: Angle(0))\nRay(from: (1, 1), direction: Angle(90))\nRay(from: (1, 1), direction: Angle(180))";
    let half = 2.0 * std::f64::consts::PI;
    close(&positions(drop, lights), &[4.0 + 0.5 * half, 4.0 + half + 3.0, 4.0 + half + 4.0 + 3.0]);
}

#[test]
fn a_screen_cut_by_other_bodies_still_counts_from_its_first_point() {
    let screen = "(shape: Flat(from: (0, -4), to: (0, 4)), surface: Screen)";
    let slab = "(shape: Rectangle(6, 2), medium: Index(1.5))";
    let lights = "Ray(from: (-2, 3), direction: Angle(0))\nRay(from: (-2, 0.5), direction: Angle(0))\nRay(from: (2, -3), direction: Angle(180))";
    close(&positions(&format!("{screen}, {slab}"), lights), &[7.0, 4.5, 1.0]);
    close(&positions(&format!("{slab}, {screen}"), lights), &[7.0, 4.5, 1.0]);
}

#[test]
fn a_screen_on_an_earlier_body_counts_its_own_way() {
    // The merged curve is the body's and runs the other way, or in other pieces.
    let body = "(shape: Rectangle(4, 4), medium: Index(1.5))";
    let screen = "(shape: Flat(from: (2, 3), to: (2, -1)), surface: Screen)";
    let lights = "Ray(from: (0, 1), direction: Angle(0))\nRay(from: (5, 2.5), direction: Angle(180))\nRay(from: (5, -0.5), direction: Angle(180))";
    close(&positions(&format!("{screen}, {body}"), lights), &[2.0, 0.5, 3.5]);
    close(&positions(&format!("{body}, {screen}"), lights), &[2.0, 0.5, 3.5]);
    let disk = "(shape: Disk(2), rotate: 20, medium: Index(1.5))";
    let arc = "(shape: Arc(from: (0, 2), through: (2, 0), to: (0, -2)), surface: Screen)";
    let lights = "Ray(from: (0, 0), direction: Angle(45))\nRay(from: (3, 0), direction: Angle(180))\nRay(from: (0, 0), direction: Angle(-45))";
    close(&positions(&format!("{disk}, {arc}"), lights), &[0.5, 1.0, 1.5].map(|q| q * std::f64::consts::PI));
}

#[test]
fn the_first_point_of_a_closed_screen_is_at_0() {
    let disk = "(shape: Disk(10), surface: Screen)";
    let around = "Ray(from: (30, 0), direction: Angle(180))
        Ray(from: (0, 0), direction: Angle(0))
        Ray(from: (0, 0), direction: Angle(180))";
    let found = positions(disk, around);
    assert_eq!(found[..2], [0.0, 0.0]);
    close(&found[2..], &[10.0 * std::f64::consts::PI]);
    let just_before = positions(disk, "Ray(from: (30, -1e-9), direction: Angle(180))");
    close(&just_before, &[20.0 * std::f64::consts::PI - 1e-9]);
    for turn in [0, 30, 77, 180] {
        let disk = format!("(shape: Disk(10), at: (4, 3), rotate: {turn}, surface: Screen)");
        let found = positions(&disk, &format!("Ray(from: (4, 3), direction: Angle({turn}))"));
        assert!(found[0] < 1e-13, "{found:?} at {turn}");
    }
    let square = "(shape: Polygon([(0, 0), (4, 0), (4, 4), (0, 4)]), surface: Screen)";
    close(&positions(square, "Ray(from: (-3, -3), direction: Towards((0, 0)))"), &[0.0]);
    close(&positions(square, "Ray(from: (2, 2), direction: Towards((0, 0)))"), &[0.0]);
    // An open screen ends where it ends.
    let arc = "(shape: Arc(from: (0, -2), through: (2, 0), to: (0, 2)), surface: Screen)";
    close(&positions(arc, "Ray(from: (0.5, 2), direction: Angle(180))"), &[2.0 * std::f64::consts::PI]);
}
