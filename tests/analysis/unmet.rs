//! Bodies that no light meets.

use snellius::analysis::{problems, unmet_bodies};
use snellius::{Scene, compile, trace};

/// The bodies without light and the warnings about them, alike from the tree and without it.
fn unmet(scene: &str) -> (Vec<usize>, Vec<String>) {
    let scene = Scene::from_ron(scene).unwrap_or_else(|problems| panic!("{problems}"));
    let system = compile(&scene).unwrap().system;
    let tree = trace(&system).tree;
    let bodies = unmet_bodies(&system, Some(&tree));
    assert_eq!(unmet_bodies(&system, None), bodies);
    let warnings = problems(&scene, &system, Some(&tree));
    assert_eq!(problems(&scene, &system, None), warnings);
    (bodies, warnings.into_iter().map(|problem| problem.message).collect())
}

fn with(bodies: &str, light: &str) -> (Vec<usize>, Vec<String>) {
    unmet(&format!("(bodies: [{bodies}], sources: [(light: {light})])"))
}

const ALONG_X: &str = "Ray(from: (-50, 0), direction: Angle(0))";
const NONE: [&str; 0] = [];
const ALL_MET: [usize; 0] = [];

#[test]
fn what_no_light_meets_is_named() {
    let far = "(shape: Disk(4), medium: Index(1.5)), (name: \"far\", shape: Disk(4), medium: Index(1.5), at: (0, 40))";
    assert_eq!(with(far, ALONG_X), (vec![1], vec!["no ray meets `far`".to_owned()]));
    assert_eq!(unmet("(bodies: [(shape: Disk(4), medium: Index(1.5))])").1, NONE, "no light, no warning");
}

#[test]
fn many_are_summed_up() {
    let off: String = (1..8).map(|k| format!("(shape: Disk(4), medium: Index(1.5), at: (0, {})),", 20 * k)).collect();
    let (bodies, warnings) = with(&format!("(shape: Disk(4), medium: Index(1.5)), {off}"), ALONG_X);
    assert_eq!(bodies, [1, 2, 3, 4, 5, 6, 7]);
    assert_eq!(warnings, ["no ray meets 7 of the 8 bodies: `#1`, `#2`, `#3` and 4 more"]);
}

/// Equal media make no hit, and yet light goes through.
#[test]
fn light_that_crosses_a_body_meets_it() {
    let unseen = |at: &str| format!("(shape: Disk(4), medium: Index(1), at: {at})");
    assert_eq!(with(&unseen("(0, 0)"), ALONG_X).0, ALL_MET);
    assert_eq!(with(&unseen("(0, 3.9)"), ALONG_X).0, ALL_MET);
    assert_eq!(with(&unseen("(0, 4.1)"), ALONG_X).0, [0]);
    assert_eq!(with(&unseen("(-70, 0)"), ALONG_X).0, [0], "behind the source");
    let stopped = format!("(shape: Flat(from: (-20, -9), to: (-20, 9)), surface: Screen), {}", unseen("(0, 0)"));
    assert_eq!(with(&stopped, ALONG_X).0, [1], "behind a screen");
}

#[test]
fn light_that_starts_and_ends_inside_of_a_body_meets_it() {
    let inside = "(shape: Disk(40), medium: Index(1)), (shape: Flat(from: (9, -5), to: (9, 5)), surface: Absorber)";
    assert_eq!(with(inside, "Ray(from: (1, 0), direction: Angle(0))").0, ALL_MET);
    assert_eq!(with(inside, "Ray(from: (50, 0), direction: Angle(90))").0, [0, 1]);
}

/// The hits name the silver; the glass behind it is met all the same, and the light ends on it.
#[test]
fn a_coated_body_is_met() {
    let silvered = "(shape: Rectangle(20, 20), medium: Index(1.5)), (shape: Flat(from: (-10, -10), to: (-10, 10)), surface: Mirror)";
    assert_eq!(with(silvered, ALONG_X).0, ALL_MET);
}

#[test]
fn a_cemented_body_is_met_though_the_others_are_named() {
    let block = |x: f64, n: f64| format!("(shape: Rectangle(20, 20), at: ({x}, 0), medium: Index({n})),");
    let stack = block(0.0, 1.5) + &block(-20.0, 1.4) + &block(20.0, 1.6);
    assert_eq!(with(&stack, ALONG_X).0, ALL_MET);
}

#[test]
fn a_stop_is_met_by_light_through_its_opening() {
    let stop = |y: f64| format!("(shape: Stop(opening: 4, height: 10), at: (0, {y}))");
    assert_eq!(with(&stop(0.0), ALONG_X).0, ALL_MET);
    assert_eq!(with(&stop(4.0), ALONG_X).0, ALL_MET);
    assert_eq!(with(&stop(6.0), ALONG_X), (vec![0], vec!["no ray meets `#0`".to_owned()]));
}

#[test]
fn what_is_meant_to_be_missed_or_belongs_to_what_is_met_brings_no_warning() {
    let baffle = "(shape: Flat(from: (0, 5), to: (0, 9)), surface: Absorber)";
    assert_eq!(with(baffle, ALONG_X), (vec![0], vec![]));
    // Total reflection at the first face: the layers below see no light.
    let layer = |y: f64, n: f64| format!("(shape: Rectangle(300, 10), at: (0, {y}), medium: Index({n})),");
    let stack = layer(-15.0, 1.2) + &layer(-25.0, 1.1) + &layer(-35.0, 1.0);
    let scene = format!(
        "(surroundings: Index(1.5), bodies: [{stack}], sources: [(light: Ray(from: (-50, 0), direction: Angle(-20)))], trace: (secondary_rays: TransmittedOnly))"
    );
    assert_eq!(unmet(&scene), (vec![1, 2], vec![]), "in contact with the first layer");
}

#[test]
fn light_that_was_cut_is_told_of_or_keeps_the_warning_back() {
    let scene = |trace: &str| {
        let scene = format!(
            "(bodies: [(shape: Rectangle(9, 9), medium: Index(1.5)), (shape: Disk(4), at: (0, 90), medium: Index(1.5))],
            sources: [(light: Ray(from: (-50, 0), direction: Angle(2)))], trace: ({trace}))"
        );
        let scene = Scene::from_ron(&scene).unwrap();
        let system = compile(&scene).unwrap().system;
        problems(&scene, &system, None).into_iter().map(|problem| problem.help).collect::<Vec<_>>()
    };
    assert_eq!(scene("secondary_rays: TransmittedOnly"), ["move it or the light, or leave it out"]);
    let cut = "move it or the light, or leave it out; branches that `max_depth` or `min_power` cut might meet it";
    assert_eq!(scene("max_depth: 2"), [cut]);
    assert_eq!(scene("max_segments: 3"), NONE);
}

#[test]
fn sources_on_boundaries_are_told_of() {
    let warnings = |bodies: &str, light: &str| {
        let scene = Scene::from_ron(&format!("(bodies: [{bodies}], sources: [(light: {light})])")).unwrap();
        let list = compile(&scene).unwrap().warnings;
        list.into_iter().map(|problem| format!("{}: {}", problem.path, problem.message)).collect::<Vec<_>>()
    };
    let glass = "(name: \"glass\", shape: Rectangle(20, 20), medium: Index(1.5))";
    let on = |index: &str| {
        format!(
            "sources[0].light.from: ray 0.0 starts on the boundary of `glass`, in the medium of index {index} that it heads into"
        )
    };
    assert_eq!(warnings(glass, "Ray(from: (-10, 0), direction: Angle(0))"), [on("1.5")]);
    assert_eq!(warnings(glass, "Ray(from: (-10, 0), direction: Angle(180))"), [on("1")]);
    assert_eq!(warnings(glass, "Ray(from: (-10, 10), direction: Angle(-45))"), [on("1.5")], "at a corner");
    assert_eq!(warnings(glass, "Ray(from: (-9.9, 0), direction: Angle(0))"), NONE);
    let beam = "Beam(center: (-15, 10), direction: Angle(0), width: 20, rays: 5)";
    assert_eq!(warnings(glass, beam), NONE, "ahead of it");
    let beam = "Beam(center: (-10, 10), direction: Angle(0), width: 20, rays: 5)";
    let many = "sources[0].light.center: ray 0.0 starts on the boundary of `glass`, in the medium of index 1.5 that it heads into, \
                and 2 more of its rays on boundaries too";
    assert_eq!(warnings(glass, beam), [many]);
    let line = |surface: &str| format!("(shape: Flat(from: (-10, -5), to: (-10, 5)), surface: {surface})");
    assert_eq!(warnings(&line("Absorber"), "Ray(from: (-10, 0), direction: Angle(0))"), NONE, "an object that shines");
    assert_eq!(warnings(&line("Mirror"), "Ray(from: (-10, 0), direction: Angle(0))").len(), 1);
    let unseen = "(shape: Rectangle(20, 20), medium: Index(1))";
    assert_eq!(warnings(unseen, "Ray(from: (-10, 0), direction: Angle(0))"), NONE, "no interface");
    assert_eq!(warnings(unseen, "Ray(from: (-10, 10), direction: Angle(0))"), NONE, "at its corner");
}
