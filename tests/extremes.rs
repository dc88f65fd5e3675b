//! The largest, the smallest and the most: numbers at the ends of their ranges, and work that must end.

#![allow(
    clippy::unwrap_used,
    clippy::float_cmp,
    reason = "a test fails by panicking and compares exact bits on purpose"
)]

mod support;

use glam::DVec2;
use snellius::numerics::Turn;
use snellius::scene::{Body, Direction, Light, Medium, Shape, Source, Surface};
use snellius::trace::{Ending, Segment};
use snellius::{Scene, compile, diagram, render, report, summarize};
use support::{Run, run_scene, run_text};

/// What holds in every scene: the light adds up, and no output holds a number that is none.
fn is_sound(run: &Run) {
    let balance = &run.trace.summary.balance;
    assert!(balance.residual().abs() <= 1e-12 * balance.emitted.value(), "{balance:?}");
    let svg = render::svg(&diagram::draw(&run.scene, &run.system, &run.trace.tree));
    roxmltree::Document::parse(&svg).unwrap();
    let json = report::json(&run.system, &run.trace);
    serde_json::from_str::<serde_json::Value>(&json).unwrap();
    for (what, text) in [("JSON", json), ("SVG", svg)] {
        assert!(!text.contains("NaN") && !text.contains("inf"), "{what} holds what is no number");
    }
}

/// The transmitted branch after so many hits.
fn transmitted(run: &Run, hits: usize) -> &Segment {
    support::segment(&run.trace.tree.rays[0], &"t".repeat(hits))
}

fn body(shape: Shape, index: f64) -> Body {
    Body::new(shape, Medium::Index(index))
}

fn ray(from: DVec2, direction: f64) -> Source {
    Source::new(Light::Ray { from, direction: Direction::Angle(direction) })
}

#[test]
fn a_slab_of_a_picometer_and_a_mirror_a_gigameter_away_share_a_scene() {
    let run = run_text(
        "(bodies: [
            (shape: Rectangle(1e-12, 1e-9), medium: Index(1.5)),
            (shape: Flat(from: (1e12, -1e12), to: (1e12, 1e12)), surface: Mirror, name: \"far\"),
        ], sources: [(light: Ray(from: (-1e-12, 0), direction: Angle(30)))])",
    );
    is_sound(&run);
    let (inside, behind) = (transmitted(&run, 1), transmitted(&run, 2));
    // Both faces, in their order, by Snell's law; along a face places are as good as the largest coordinate rounds.
    assert!((inside.from.x + 0.5e-12).abs() < 1e-26 && (behind.from.x - 0.5e-12).abs() < 1e-26);
    assert!((inside.direction.y - 0.5 / 1.5).abs() < 1e-15 && (behind.direction.y - 0.5).abs() < 1e-15);
    assert_eq!((inside.medium_index, inside.hit.unwrap().body), (1.5, 0));
    assert_eq!(behind.medium_index, 1.0);
    let far = behind.to.unwrap();
    assert!(far.distance(DVec2::new(1e12, 1e12 / 3.0_f64.sqrt())) < 1e-2, "{far}");
    assert_eq!(behind.hit.unwrap().body, 1);
}

#[test]
fn the_smallest_angles_and_places_are_as_good_as_zero() {
    let scene = |x: &str, angle: &str, power: &str| {
        run_text(&format!(
            "(bodies: [(shape: Lens(radii: (50, -50), thickness: 6, diameter: 30), medium: Index(1.5))],
            sources: [(light: Ray(from: (-30, {x}), direction: Angle({angle})), power: {power})])"
        ))
    };
    let plain = scene("0", "0", "1");
    for run in [scene("5e-324", "0", "1"), scene("0", "5e-324", "1"), scene("-5e-324", "-2e-310", "1")] {
        is_sound(&run);
        let ends =
            |run: &Run| run.trace.tree.rays[0].segments.iter().map(|one| (one.to, one.power)).collect::<Vec<_>>();
        let pairs = || ends(&run).into_iter().zip(ends(&plain));
        assert!(pairs().all(|((to, power), (expected, all))| {
            to.zip(expected).is_none_or(|(to, expected)| to.distance(expected) < 1e-300) && power == all
        }));
    }
    for power in [1e-100, 1e100] {
        let run = scene("0", "0", &format!("{power:e}"));
        is_sound(&run);
        let share = |run: &Run, power: f64| run.trace.summary.balance.escaped.value() / power;
        assert!((share(&run, power) - share(&plain, 1.0)).abs() < 1e-15);
    }
}

#[test]
fn a_power_below_the_range_is_an_error() {
    let text = "(sources: [(light: Ray(from: (0, 0), direction: Angle(0)), power: 5e-324)])";
    assert!(Scene::from_ron(text).unwrap_err().to_string().contains("1e-100"));
}

#[test]
fn an_index_of_one_and_its_nearest_neighbors_refract_as_they_must() {
    // The critical angle of n = 1 + δ lies √(2δ) = 2.7e-6° from grazing, and a ray g from grazing leaves at √(g² − 2δ).
    let index = 1.0 + 1e-15_f64;
    let grazing = |degrees: f64| {
        let glass = body(Shape::Rectangle { width: 2e9, height: 1.0 }, index);
        let run = run_scene(Scene::new(vec![glass], vec![ray(DVec2::new(0.0, 0.25), degrees)]));
        is_sound(&run);
        run
    };
    let critical = (2.0 * (index - 1.0)).sqrt();
    let degrees = |radians: f64| radians.to_degrees();
    let reflected = grazing(degrees(0.999 * critical));
    assert!(reflected.trace.tree.rays[0].segments[0].hit.unwrap().total_internal_reflection);
    let run = grazing(degrees(1.25 * critical));
    let out = transmitted(&run, 1);
    assert!((out.direction.y - 0.75 * critical).abs() < 1e-9 * critical, "{out:?}");
    assert_eq!(out.medium_index, 1.0);
    // Nothing is there where the index is 1.
    let none =
        run_scene(Scene::new(vec![body(Shape::Disk { radius: 1.0 }, 1.0)], vec![ray(DVec2::new(-3.0, 0.5), 0.0)]));
    is_sound(&none);
    assert_eq!(none.trace.tree.rays[0].segments.len(), 1);
}

#[test]
fn of_a_thousand_coincident_bodies_the_last_counts() {
    let slab = |k: u32| body(Shape::Rectangle { width: 10.0, height: 40.0 }, 1.1 + 5e-4 * f64::from(k));
    let run = run_scene(Scene::new((0..1000).map(slab).collect(), vec![ray(DVec2::new(-20.0, 0.0), 30.0)]));
    is_sound(&run);
    assert_eq!(run.system.interfaces().len(), 4);
    let inside = transmitted(&run, 1);
    assert_eq!(inside.medium_index, 1.1 + 5e-4 * 999.0);
    assert!((inside.direction.y - 0.5 / inside.medium_index).abs() < 1e-15);
    assert_eq!(inside.hit.unwrap().body, 999);
}

#[test]
fn a_polygon_of_a_million_corners_is_a_disk() {
    let corner = |k: u32| 100.0 * Turn::degrees(360.0 * f64::from(k) / 1e6).direction();
    let source = ray(DVec2::new(-200.0, 50.0), 0.0);
    let with = |shape: Shape| run_scene(Scene::new(vec![body(shape, 1.5)], vec![source.clone()]));
    let polygon = with(Shape::Polygon((0..1_000_000).map(corner).collect()));
    let disk = with(Shape::Disk { radius: 100.0 });
    is_sound(&polygon);
    assert_eq!(polygon.system.interfaces().len(), 1_000_000);
    for hits in 1..=2 {
        let [one, other] = [&polygon, &disk].map(|run| transmitted(run, hits));
        // An edge turns from its neighbor by 6.3e-6 rad.
        assert!(one.from.distance(other.from) < 1e-3 && one.direction.distance(other.direction) < 2e-5);
    }
}

/// Places in a scene that reaches to 1e12 round to a hundredth.
#[test]
fn what_is_lost_in_the_rounding_of_a_scene_that_reaches_far_is_told() {
    let told = |size: f64, far: f64| {
        let wall = Shape::Flat { from: DVec2::new(far, -far), to: DVec2::splat(far) };
        let bodies = vec![body(Shape::Disk { radius: 0.5 * size }, 1.5), Body::new(wall, Surface::Screen)];
        let scene = Scene::new(bodies, vec![ray(DVec2::new(-1.0, 0.0), 0.0)]);
        compile(&scene).unwrap().warnings.iter().any(|warning| warning.message.contains("too small in a scene"))
    };
    assert!(told(2e-4, 1e12) && told(2e-12, 1e3));
    assert!(!told(2e-4, 1e6) && !told(1.0, 1e12) && !told(2e-12, 1.0));
    // What is told to be large enough is met.
    for far in [1e6, 1e9, 1e12] {
        let disk = format!("(shape: Disk({}), medium: Index(1.5))", 1e-13 * far);
        let text = format!(
            "(bodies: [{disk}, (shape: Flat(from: ({far}, -1), to: ({far}, 1)), surface: Screen)],
            sources: [(light: Ray(from: (-1, 0), direction: Angle(0)))])"
        );
        assert_eq!(transmitted(&run_text(&text), 2).medium_index, 1.0, "{far}");
    }
}

/// A comb of upright teeth, side by side; `turned` lays it down.
fn comb(teeth: u32, turned: bool) -> Body {
    let pitch = 100.0 / f64::from(teeth);
    let tooth = |k: u32| {
        let x = pitch * f64::from(k);
        [(x, 0.0), (x, 100.0), (x + 0.5 * pitch, 100.0), (x + 0.5 * pitch, 0.0)]
    };
    let points = (0..teeth).flat_map(tooth).chain([(100.0, -1.0), (-pitch, -1.0)]);
    let place = |(x, y): (f64, f64)| if turned { DVec2::new(y - 3.3, x) } else { DVec2::new(x, y - 3.3) };
    body(Shape::Polygon(points.map(place).collect()), 1.5)
}

/// The errors of a scene that is too much to lay out.
fn refusal(bodies: Vec<Body>) -> String {
    compile(&Scene::new(bodies, vec![])).map(|_| ()).unwrap_err().to_string()
}

#[test]
fn combs_that_cross_everywhere_have_every_crossing() {
    let run = run_scene(Scene::new(vec![comb(50, false), comb(50, true)], vec![ray(DVec2::new(-20.0, 50.3), 0.0)]));
    is_sound(&run);
    // The teeth reach over 97 of the other's 100 sides; some of their own 404 corners are covered.
    let known: std::collections::BTreeSet<_> = run.system.interfaces().iter().flat_map(|one| one.ends).collect();
    let crossings = 97 * 97;
    assert!((crossings..=crossings + 404).contains(&known.len()), "{}", known.len());
}

#[test]
fn what_crosses_in_too_many_places_is_refused_at_once() {
    let message = refusal(vec![comb(2_400, false), comb(2_400, true)]);
    assert!(message.contains("20000000 comparisons") && message.contains("use fewer edges"), "{message}");
}

#[test]
fn of_very_many_gaps_a_thousand_are_told() {
    let disk = |k: u32| body(Shape::Disk { radius: 1e-7 }, 1.5).placed(DVec2::new(1e-5 * f64::from(k), 0.0), 0.0);
    let scene = |count| Scene::new((0..count).map(disk).collect(), vec![]);
    let warnings = |count| compile(&scene(count)).unwrap().warnings;
    // Each is nearer than 420 nm to the 42 before it, as millimeters.
    assert_eq!(warnings(10).len(), 45);
    let many = warnings(200);
    assert_eq!(many.len(), 1001);
    assert!(many[1000].message.contains("more bodies almost touch"), "{:?}", many[1000]);
}

#[test]
fn too_many_bodies_in_one_place_are_refused() {
    let disk = |k: u32| {
        let at = 1e-4 * Turn::degrees(0.37 * f64::from(k)).direction();
        body(Shape::Disk { radius: 1e-8 }, 1.5).placed(at, 0.0)
    };
    let message = refusal((0..30_000).map(disk).collect());
    assert!(message.contains("comparisons"), "{message}");
}

#[test]
fn trapped_rays_end_with_the_segments_that_a_scene_may_follow() {
    let run = run_text(
        "(bodies: [(shape: Rectangle(10, 10), surface: Mirror), (shape: Disk(1), medium: Index(1.5))],
        sources: [(light: Point(at: (3, 2), rays: 500)), (light: Point(at: (-3, 2), rays: 500))],
        trace: (max_depth: 4294967295, min_power: 0, max_segments: 20000))",
    );
    is_sound(&run);
    let segments = || run.trace.tree.rays.iter().flat_map(|ray| &ray.segments);
    let cut = segments().filter(|segment| segment.ending == Ending::CutMaxSegments).count();
    assert_eq!(segments().count() - cut, 20_000, "followed");
    assert!(cut <= 20_000 + 1000, "each hit leaves at most one branch waiting, and each ray its start");
    assert_eq!(summarize(&run.system).segments, run.trace.summary.segments);
}

/// A ray between two mirrors along a diagonal, and short edges beside it whose boxes it meets, every one.
fn stairs(edges: u32) -> Scene {
    let flat = |from: (f64, f64), to: (f64, f64), surface: Surface| {
        Body::new(Shape::Flat { from: from.into(), to: to.into() }, surface)
    };
    let step = |k: u32| {
        let k = f64::from(k);
        flat((k, k + 0.1), (k + 0.9, k + 1.0), Surface::Absorber)
    };
    let far = f64::from(edges) + 1.0;
    let mirrors = [((-2.0, -1.0), (-1.0, -2.0)), ((far, far + 1.0), (far + 1.0, far))];
    let mirrors = mirrors.map(|(from, to)| flat(from, to, Surface::Mirror));
    let bodies = (0..edges).map(step).chain(mirrors).collect();
    let mut scene = Scene::new(bodies, vec![ray(DVec2::splat(-0.5), 45.0)]);
    (scene.trace.max_depth, scene.trace.min_power, scene.trace.max_segments) = (u32::MAX, 0.0, 1000);
    scene
}

#[test]
fn segments_that_pass_by_everything_count_as_several() {
    let listed = |edges| {
        let run = run_scene(stairs(edges));
        let last = run.trace.tree.rays[0].segments.last().unwrap().ending;
        assert_eq!(last, Ending::CutMaxSegments);
        run.trace.summary.segments
    };
    assert_eq!(listed(100), 1001);
    assert!(listed(20_000) < 300);
}

#[test]
fn a_way_of_thousands_of_hits_is_listed_in_bounded_text() {
    let run = run_text(
        "(bodies: [(shape: Rectangle(10, 10), surface: Mirror)], sources: [(light: Ray(from: (0, 0), direction: Angle(33)))],
        trace: (max_depth: 20000, min_power: 0))",
    );
    let text = report::text(&run.system, &run.trace);
    let longest = text.lines().map(|line| line.chars().count()).max().unwrap();
    assert!(text.lines().count() > 20_000 && longest < 600, "{longest}");
}

#[test]
fn labels_beyond_what_can_be_placed_in_time_are_counted_below_the_figure() {
    let gear = |k: u32| {
        let at = DVec2::new(f64::from(k % 10), f64::from(k / 10));
        let mut gear = body(Shape::RegularPolygon { sides: 20_000, radius: 0.4 }, 1.5).placed(at, 0.0);
        gear.label = Some(format!("gear {k}"));
        gear
    };
    let scene = |count| Scene::new((0..count).map(gear).collect(), vec![]);
    let svg = |count| {
        let run = run_scene(scene(count));
        render::svg(&diagram::draw(&run.scene, &run.system, &run.trace.tree))
    };
    let few = svg(3);
    assert!(few.contains("gear 2") && !few.contains("too many labels"));
    let many = svg(40);
    assert!(many.contains("gear 0") && !many.contains("gear 39") && many.contains("too many labels: those of"));
}
