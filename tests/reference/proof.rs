//! The comparison can fail: what is changed on one side only is found.

use snellius::Scene;
use snellius::scene::{Medium, Shape, Substance};

use crate::ceilings::MOST;
use crate::compare::{Findings, compare, compare_with};
use crate::doubts::Doubt;

const PRISM: &str = r#"(
    bodies: [
        (name: "prism", shape: Polygon([(-1, -1), (2, -1), (0, 2)]), rotate: 10, medium: Index(1.5)),
        (name: "ball", shape: Disk(0.5), at: (3, 0), medium: Index(1.3)),
        (name: "mirror", shape: Arc(from: (5, -2), through: (5.5, 0), to: (5, 2)), surface: Mirror),
        (name: "lens", shape: Flat(from: (-3, -2), to: (-3, 2)), surface: ThinLens(focal_length: 8)),
    ],
    sources: [(light: Beam(center: (-6, 0.1), direction: Angle(1), width: 1, rays: 5))],
)"#;

fn scene(text: &str) -> Scene {
    Scene::from_ron(text).unwrap_or_else(|problems| panic!("{problems}"))
}

/// What is found where only snellius gets the changed scene.
fn changed(change: impl FnOnce(&mut Scene)) -> Findings {
    let truth = scene(PRISM);
    let mut other = truth.clone();
    change(&mut other);
    compare_with(&other, &truth)
}

#[test]
fn unchanged_scenes_agree() {
    let findings = changed(|_| ());
    assert!(findings.faults.is_empty() && findings.in_conditions < MOST, "{:?} {}", findings.faults, findings.worst);
    assert!(findings.compared > 90 && findings.set_aside == 0, "{}", findings.compared);
}

#[test]
fn small_changes_of_numbers_are_found() {
    let index = changed(|scene| scene.bodies[1].substance = Substance::Medium(Medium::Index(1.3 + 1e-13)));
    let vertex = changed(|scene| {
        let Shape::Polygon(points) = &mut scene.bodies[0].shape else { panic!("the prism is a polygon") };
        points[2].x += 1e-13;
    });
    let turn = changed(|scene| scene.bodies[0].rotate += 1e-12);
    let place = changed(|scene| scene.bodies[2].at.x += 1e-13);
    let power = changed(|scene| scene.sources[0].power += 1e-13);
    for findings in [index, vertex, turn, place] {
        assert!(findings.in_conditions > MOST, "{}", findings.worst);
    }
    assert!(!power.faults.is_empty());
}

#[test]
fn other_ways_are_found() {
    let swapped = changed(|scene| scene.bodies.swap(1, 2));
    let shallow = changed(|scene| scene.trace.max_depth = 3);
    let strong = changed(|scene| scene.trace.min_power = 2e-3);
    let missing = changed(|scene| scene.bodies[1].at.y += 10.0);
    for findings in [swapped, shallow, strong, missing] {
        assert!(!findings.faults.is_empty());
    }
}

#[test]
fn segments_are_spent_in_the_same_order() {
    for max_segments in [1, 2, 7, 20, 33] {
        let mut scene = scene(PRISM);
        scene.trace.max_segments = max_segments;
        let findings = compare(&scene);
        assert!(findings.faults.is_empty() && findings.set_aside == 0, "{:?}", findings.faults);
    }
}

#[test]
fn starts_on_boundaries_agree() {
    for start in ["(0, 0)", "(2, 0)", "(2, 1)", "(-1, 0.5)"] {
        let text = format!(
            "(
                bodies: [(shape: Rectangle(4, 2), medium: Index(1.5)), (shape: Disk(1.5), at: (3, 0), medium: Index(2))],
                sources: [(light: Point(at: {start}, rays: 7))],
            )"
        );
        let findings = compare(&scene(&text));
        // The angle of ray 5 is 360°·5/7, rounded: half an ulp of that is 4 u.
        assert!(
            findings.faults.is_empty() && findings.in_conditions < 5.0,
            "{start}: {:?} {}",
            findings.faults,
            findings.worst
        );
        assert!(findings.compared > 20, "{start}: {}", findings.compared);
    }
}

#[test]
fn only_what_rounding_decides_is_set_aside() {
    // Towards a corner and past it; at the critical angle (sin θ = 0.8 = 1/n) and beside it.
    let corner = |y: f64| {
        format!(
            "shape: Rectangle(2, 2), medium: Index(1.5))], sources: [(light: Ray(from: (-9, {y:?}), direction: Angle(0)))]"
        )
    };
    let critical = |x: f64| {
        format!(
            "shape: Rectangle(30, 30), medium: Index(1.25))], sources: [(light: Ray(from: (-8, 9), direction: Towards(({x:?}, 15))))]"
        )
    };
    for (rest, doubt) in [
        (corner(1.0), Some(Doubt::Vertex)),
        (corner(1.0 + 1e-15), Some(Doubt::Vertex)),
        (corner(1.0 - 1e-9), None),
        (corner(1.0 + 1e-9), None),
        (critical(0.0), Some(Doubt::Critical)),
        (critical(1e-15), Some(Doubt::Critical)),
        (critical(1e-11), None),
        (critical(-1e-11), None),
    ] {
        let findings = compare(&scene(&format!("(bodies: [({rest}, trace: (max_depth: 2))")));
        assert!(findings.faults.is_empty(), "{rest}: {:?}", findings.faults);
        assert_eq!(findings.doubts.keys().next().copied(), doubt, "{rest}");
    }
}
