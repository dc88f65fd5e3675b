//! The same scene elsewhere, larger, turned or in a mirror gives the same light.

use glam::DVec2;
use proptest::collection::vec;
use proptest::prelude::*;
use snellius::Scene;
use snellius::scene::{Direction, Light, Medium, Shape, Substance, Surface};
use snellius::trace::Trace;

use crate::config;
use crate::scenes::{body, settings, towards};
use crate::support::run_scene;

/// Glass triangles, rectangles, disks, half disks and lenses at whole coordinates, some of them mirrors or splitters instead,
/// and rays aimed at whole coordinates.
fn whole_scenes() -> impl Strategy<Value = Scene> {
    let point = || (-40..40_i32, -40..40_i32).prop_map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
    let triangle = (point(), point(), point())
        .prop_filter("on a line", |(a, b, c)| (*b - *a).perp_dot(*c - *a).abs() > 4.0)
        .prop_map(|(a, b, c)| Shape::Polygon(vec![a, b, c]));
    let rectangle = (1..20_i32, 1..20_i32)
        .prop_map(|(w, h)| Shape::Rectangle { width: 2.0 * f64::from(w), height: 2.0 * f64::from(h) });
    let disk = (0..5_i32).prop_map(|k| Shape::Disk { radius: [1.0, 2.0, 4.0, 8.0, 16.0][usize::try_from(k).unwrap()] });
    let half_disk = (1..12_i32).prop_map(|radius| Shape::HalfDisk { radius: f64::from(radius) });
    let radii = prop_oneof![Just([30.0, -30.0]), Just([f64::INFINITY, -40.0]), Just([-50.0, 70.0])];
    let lens = radii.prop_map(|radii| Shape::Lens { radii, thickness: 8.0, diameter: 20.0, facets: None });
    let flat = (point(), point())
        .prop_filter("no line", |(from, to)| from != to)
        .prop_map(|(from, to)| (Shape::Flat { from, to }, Substance::Surface(Surface::Mirror)));
    let substance = prop_oneof![
        4 => (1.0..2.0).prop_map(|n| Substance::Medium(Medium::Index(n))),
        1 => Just(Substance::Surface(Surface::Mirror)),
        1 => Just(Substance::Surface(Surface::BeamSplitter { reflect: 0.25, transmit: 0.5 })),
    ];
    let closed = (prop_oneof![triangle, rectangle, disk, half_disk, lens], substance);
    let filled = (prop_oneof![5 => closed, 1 => flat], point(), 0..4_i32)
        .prop_map(|((shape, substance), at, quarters)| body(shape, substance).placed(at, 90.0 * f64::from(quarters)));
    let rays = vec((point(), point()).prop_filter("no direction", |(a, b)| a != b), 1..6);
    (vec(filled, 1..4), rays).prop_map(|(bodies, rays)| {
        let sources = rays.into_iter().map(|(from, to)| towards(from, to)).collect();
        let mut scene = Scene::new(bodies, sources);
        scene.trace = settings(6);
        scene
    })
}

/// The scene with every point and length mapped; for shapes of [`whole_scenes`].
fn mapped(scene: &Scene, point: impl Fn(DVec2) -> DVec2, vector: impl Fn(DVec2) -> DVec2, scale: f64) -> Scene {
    let bodies = scene.bodies.iter().map(|body| {
        let shape = match &body.shape {
            Shape::Polygon(points) => Shape::Polygon(points.iter().map(|p| vector(*p)).collect()),
            Shape::Rectangle { width, height } => Shape::Rectangle { width: scale * width, height: scale * height },
            Shape::Disk { radius } => Shape::Disk { radius: scale * radius },
            Shape::HalfDisk { radius } => Shape::HalfDisk { radius: scale * radius },
            Shape::Lens { radii, thickness, diameter, facets } => Shape::Lens {
                radii: radii.map(|radius| scale * radius),
                thickness: scale * thickness,
                diameter: scale * diameter,
                facets: *facets,
            },
            Shape::Flat { from, to } => Shape::Flat { from: vector(*from), to: vector(*to) },
            other => panic!("{other:?} is not mapped"),
        };
        let mut body = body.clone();
        (body.shape, body.at) = (shape, point(body.at));
        body
    });
    let sources = scene.sources.iter().map(|source| {
        let Light::Ray { from, direction: Direction::Towards(to) } = source.light else { return source.clone() };
        towards(point(from), point(to))
    });
    let mut scene = scene.clone();
    scene.bodies = bodies.collect();
    scene.sources = sources.collect();
    scene
}

/// Address and ending, direction, power, and the hit's body, cosine and sine.
type Branch = (String, DVec2, f64, Option<(usize, f64, f64)>);

/// What does not depend on where and how large a scene is.
fn light(trace: &Trace) -> Vec<Branch> {
    let rays = trace.tree.rays.iter();
    let segments = rays.flat_map(|ray| ray.segments.iter().map(move |s| (ray.address(s.id), s)));
    segments
        .map(|(address, s)| {
            let hit = s.hit.map(|hit| (hit.body, hit.cos_i, hit.sin_i));
            (format!("{address} {}", s.ending.word()), s.direction, s.power.total(), hit)
        })
        .collect()
}

/// Whether a segment comes within `near` of a vertex, where a tie decides.
fn meets_a_vertex(scene: &Scene, near: f64) -> bool {
    let run = run_scene(scene.clone());
    let ends: Vec<_> =
        run.system.interfaces().iter().flat_map(|i| [i.curve.a, i.curve.b]).map(|p| p + run.system.origin()).collect();
    run.trace.tree.rays.iter().flat_map(|ray| &ray.segments).any(|s| {
        ends.iter().any(|p| (*p - s.from).perp_dot(s.direction).abs() < near)
            || ends.iter().any(|p| p.distance(s.from) < near)
    })
}

/// Plus or minus a power of two above the size of the scenes.
fn power() -> impl Strategy<Value = f64> {
    (8..=26_i32, any::<bool>()).prop_map(|(exponent, negative)| {
        let power = libm::scalbn(1.0, exponent);
        if negative { -power } else { power }
    })
}

proptest! {
    #![proptest_config(config(400))]

    #[test]
    fn moving_by_powers_of_two_changes_no_bit(scene in whole_scenes(), shift in (power(), power())) {
        // Far from the coordinate origin rounding is larger, and decides in a wider berth.
        prop_assume!(!meets_a_vertex(&scene, 1e-5));
        let shift = DVec2::from(shift);
        let moved = run_scene(mapped(&scene, |p| p + shift, |p| p, 1.0));
        prop_assert_eq!(light(&run_scene(scene).trace), light(&moved.trace));
    }

    #[test]
    fn scaling_by_a_power_of_two_changes_no_bit(scene in whole_scenes(), exponent in prop_oneof![Just(-20), -40..40_i32]) {
        let scale = if exponent < 0 { 0.5_f64 } else { 2.0 };
        let scale = (0..exponent.abs()).fold(1.0, |product, _| product * scale);
        let scaled = run_scene(mapped(&scene, |p| scale * p, |p| scale * p, scale));
        prop_assert_eq!(light(&run_scene(scene).trace), light(&scaled.trace));
    }

    #[test]
    fn a_mirror_image_gives_mirrored_light(scene in whole_scenes()) {
        prop_assume!(!meets_a_vertex(&scene, 1e-9));
        let flip = |p: DVec2| DVec2::new(-p.x, p.y);
        let mut image = mapped(&scene, flip, flip, 1.0);
        for body in &mut image.bodies {
            // These are given along +x.
            let half_turn = matches!(body.shape, Shape::HalfDisk { .. } | Shape::Lens { .. });
            body.rotate = if half_turn { 180.0 - body.rotate } else { -body.rotate };
        }
        agree(&light(&run_scene(scene).trace), &light(&run_scene(image).trace), flip)?;
    }

    #[test]
    fn a_quarter_turn_turns_the_light(scene in whole_scenes()) {
        prop_assume!(!meets_a_vertex(&scene, 1e-9));
        let mut turned = mapped(&scene, DVec2::perp, |p| p, 1.0);
        turned.bodies.iter_mut().for_each(|body| body.rotate += 90.0);
        agree(&light(&run_scene(scene).trace), &light(&run_scene(turned).trace), DVec2::perp)?;
    }
}

/// The same tree, with directions that differ by rounding.
fn agree(scene: &[Branch], image: &[Branch], map: impl Fn(DVec2) -> DVec2) -> Result<(), TestCaseError> {
    prop_assert_eq!(scene.len(), image.len());
    for (a, b) in scene.iter().zip(image) {
        prop_assert_eq!(&a.0, &b.0);
        prop_assert!(map(a.1).distance(b.1) <= 1e-10, "{:?} {:?}", a, b);
    }
    Ok(())
}
