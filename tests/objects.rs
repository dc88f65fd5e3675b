//! Object arrows: the rays from their tips, and their images against the laws of first-order optics.

#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

mod support;

use glam::DVec2;
use snellius::analysis::{ObjectImage, object_images};
use snellius::numerics::Turn;
use snellius::trace::{Segment, TracedRay};
use support::{Run, run_text};

fn found(run: &Run) -> Vec<ObjectImage> {
    object_images(&run.system, &run.trace.tree)
}

/// A scene of bodies and one object, without reflections at glass.
fn scene(bodies: &str, from: DVec2, to: DVec2) -> Run {
    scene_with(bodies, from, to, "", "trace: (secondary_rays: TransmittedOnly),")
}

fn scene_with(bodies: &str, from: DVec2, to: DVec2, source: &str, settings: &str) -> Run {
    let point = |p: DVec2| format!("({:?}, {:?})", p.x, p.y);
    let light = format!("light: Object(from: {}, to: {})", point(from), point(to));
    run_text(&format!("(bodies: [{bodies}], sources: [({light}, {source})], {settings})"))
}

fn thin_lens(f: f64, rotate: f64, at: DVec2) -> String {
    let shape = "Flat(from: (0, -60), to: (0, 60))";
    format!(
        "(shape: {shape}, rotate: {rotate:?}, at: ({:?}, {:?}), surface: ThinLens(focal_length: {f:?}))",
        at.x, at.y
    )
}

/// A mirror with its vertex at the origin that light along +x meets, hollow for it if R is above 0.
fn mirror(radius: f64) -> String {
    let x = -5.0_f64.copysign(radius);
    let y = (radius * radius - (radius.abs() - 5.0) * (radius.abs() - 5.0)).sqrt();
    format!("(shape: Arc(from: ({x:?}, {:?}), through: (0, 0), to: ({x:?}, {y:?})), surface: Mirror)", -y)
}

const THICK: &str = "(shape: Lens(radii: (40, -40), thickness: 16, diameter: 30), medium: Index(1.5))";

#[track_caller]
fn assert_point(actual: DVec2, expected: DVec2, tolerance: f64) {
    assert!(actual.distance(expected) <= tolerance, "{actual}, not {expected} within {tolerance:e}");
}

/// Heights at which rays cross the plane x = 0.
fn heights(run: &Run) -> Vec<f64> {
    let first = run.trace.tree.rays.iter().map(|ray| &ray.segments[0]);
    first.map(|segment| segment.from.y - segment.from.x * segment.direction.y / segment.direction.x).collect()
}

fn last(ray: &TracedRay) -> &Segment {
    ray.segments.last().unwrap()
}

#[test]
fn a_thin_lens_images_by_its_equation_wherever_it_stands() {
    for (f, s) in [(40.0, 60.0), (40.0, 25.0), (40.0, 300.0), (40.0, 39.0), (-40.0, 60.0), (-40.0, 10.0), (25.0, 50.0)]
    {
        for (rotate, at) in [(0.0, DVec2::ZERO), (30.0, DVec2::new(17.0, -5.0)), (180.0, DVec2::X), (-90.0, DVec2::Y)] {
            let place = |x: f64, y: f64| at + Turn::degrees(rotate).apply(DVec2::new(x, y));
            let behind = 1.0 / (1.0 / f - 1.0 / s);
            let m = -behind / s;
            // The foot stands beside the axis.
            for (from, to) in [(0.0, 12.0), (-3.0, 9.0), (2.0, -8.0)] {
                let run = scene(&thin_lens(f, rotate, at), place(-s, from), place(-s, to));
                let all = found(&run);
                let [image] = all.as_slice() else { panic!("f = {f}, s = {s}: {all:?}") };
                let tolerance = 1e-11 * (behind.abs() + s);
                assert_point(image.tip, place(behind, m * to), tolerance);
                assert_point(image.foot, place(behind, m * from), tolerance);
                assert_eq!((image.is_real, image.is_intermediate, image.segments.len()), (behind > 0.0, false, 3));
            }
        }
    }
}

#[test]
fn light_from_the_focal_plane_makes_no_image() {
    for (height, foot, rotate) in [(12.0, 0.0, 0.0), (7.0, -2.0, 0.0), (7.1, 0.0, 33.0), (-5.3, 1.0, 119.0)] {
        let place = |x: f64, y: f64| Turn::degrees(rotate).apply(DVec2::new(x, y));
        let run = scene(&thin_lens(37.0, rotate, DVec2::ZERO), place(-37.0, foot), place(-37.0, height));
        assert_eq!((found(&run), run.trace.tree.rays.len()), (Vec::new(), 3));
    }
}

#[test]
fn a_round_mirror_images_by_its_equation() {
    for (radius, s) in [(80.0, 60.0), (80.0, 20.0), (80.0, 200.0), (80.0, 80.0), (-80.0, 60.0), (-80.0, 15.0)] {
        let behind = 1.0 / (2.0 / radius - 1.0 / s);
        let (m, h) = (-behind / s, 1e-2);
        let run = scene(&mirror(radius), DVec2::new(-s, 0.0), DVec2::new(-s, h));
        let all = found(&run);
        let [image] = all.as_slice() else { panic!("R = {radius}, s = {s}: {all:?}") };
        assert_point(image.tip, DVec2::new(-behind, m * h), 1e-4);
        assert_point(DVec2::new(0.0, image.tip.y), DVec2::new(0.0, m * h), 1e-7);
        assert_point(image.foot, DVec2::new(image.tip.x, 0.0), 1e-9);
        assert_eq!(image.is_real, behind > 0.0, "R = {radius}, s = {s}");
    }
}

#[test]
fn rays_of_a_mirror_are_those_of_a_textbook() {
    for radius in [80.0, -80.0] {
        let run = scene(&mirror(radius), DVec2::new(-90.0, 0.0), DVec2::new(-90.0, 1.0));
        let rays = &run.trace.tree.rays;
        let slopes = rays.iter().map(|ray| ray.segments[0].direction.y / ray.segments[0].direction.x);
        let expected = [0.0, -1.0 / (90.0 - radius), -1.0 / (90.0 - 0.5 * radius)];
        for (slope, expected) in slopes.zip(expected) {
            assert!((slope - expected).abs() < 1e-15, "{slope} is not {expected}");
        }
        let aside = |segment: &Segment, x: f64| segment.direction.perp_dot(DVec2::new(x, 0.0) - segment.from).abs();
        assert!(aside(last(&rays[0]), -0.5 * radius) < 1e-3, "parallel, then through F");
        assert!(last(&rays[1]).direction.distance(-rays[1].segments[0].direction) < 1e-13, "by C, then back");
        assert!(last(&rays[2]).direction.y.abs() < 1e-4, "by F, then parallel");
    }
}

#[test]
fn rays_that_would_miss_their_element_are_replaced() {
    let rim = 0.95 * 60.0;
    for s in [20.0, 39.5, 40.0, 42.0, 60.0] {
        for height in [0.0, 1.0, 8.0, 40.0, 59.0, 130.0] {
            let run = scene(&thin_lens(40.0, 0.0, DVec2::ZERO), DVec2::new(-s, -7.0), DVec2::new(-s, height));
            let heights = heights(&run);
            assert_eq!(heights.len(), 3, "{s} {height}");
            assert!(heights.iter().all(|y| y.abs() <= rim + 1e-9), "{s} {height}: {heights:?}");
            for k in 0..3 {
                assert!((heights[k] - heights[(k + 1) % 3]).abs() > 1e-5, "{s} {height}: {heights:?}");
            }
        }
    }
    let run = scene(&thin_lens(40.0, 0.0, DVec2::ZERO), DVec2::new(-20.0, -5.0), DVec2::new(-20.0, 0.0));
    for (height, expected) in heights(&run).into_iter().zip([0.0, 30.0, -30.0]) {
        assert!((height - expected).abs() < 1e-12, "the tip on the axis: {height}");
    }
}

#[test]
fn a_flat_mirror_mirrors_foot_and_tip() {
    for (rotate, from, to) in
        [(0.0, (-40.0, -4.0), (-40.0, 14.0)), (0.0, (-50.0, 3.0), (-30.0, 14.0)), (35.0, (-40.0, 6.0), (-44.0, 15.0))]
    {
        let mirror = format!("(shape: Flat(from: (0, -32), to: (0, 26)), rotate: {rotate:?}, surface: Mirror)");
        let [from, to] = [from, to].map(|(x, y)| DVec2::new(x, y));
        let normal = Turn::degrees(rotate).direction();
        let mirrored = |p: DVec2| p - 2.0 * normal * p.dot(normal);
        let run = scene(&mirror, from, to);
        let all = found(&run);
        let [image] = all.as_slice() else { panic!("{all:?}") };
        assert_point(image.tip, mirrored(to), 1e-12);
        assert_point(image.foot, mirrored(from), 1e-8);
        assert!(!image.is_real);
    }
}

/// Coordinates of a turned scene are written with a few digits: the object leans by what was rounded off.
#[test]
fn a_rounded_object_has_the_image_of_the_exact_one() {
    let image = |from: &str, to: &str| {
        let run = run_text(&format!(
            "(bodies: [(shape: Lens(radii: (60, -60), thickness: 8, diameter: 40), rotate: 20, medium: Index(1.5))],
            sources: [(light: Object(from: {from}, to: {to}))], trace: (secondary_rays: TransmittedOnly))"
        ));
        let images = object_images(&run.system, &run.trace.tree);
        let image = images.last().unwrap();
        image.tip - image.foot
    };
    let exact = image("(-75.17540966287267, -27.361611466053496)", "(-81.33177224273471, -10.447144291907144)");
    let rounded = image("(-75.18, -27.36)", "(-81.33, -10.45)");
    assert!(exact.normalize().perp_dot(rounded.normalize()).abs() < 0.01, "{exact} {rounded}");
}

#[test]
fn foot_and_tip_of_an_oblique_object_each_have_their_own_distance() {
    let image_of = |p: DVec2| {
        let behind = 1.0 / (1.0 / 40.0 + 1.0 / p.x);
        DVec2::new(behind, p.y * behind / p.x)
    };
    let (from, to) = (DVec2::new(-70.0, -2.0), DVec2::new(-60.0, 12.0));
    let all = found(&scene(&thin_lens(40.0, 0.0, DVec2::ZERO), from, to));
    assert_point(all[0].tip, image_of(to), 1e-10);
    assert_point(all[0].foot, image_of(from), 1e-6);
}

#[test]
fn a_thick_lens_images_from_its_principal_planes() {
    let power = 0.5 * (2.0 / 40.0 - 0.5 * 16.0 / (1.5 * 1600.0));
    let f = 1.0 / power;
    let plane = -8.0 + f * 0.5 * 16.0 / (1.5 * 40.0);
    let s = 75.0 + plane;
    let behind = 1.0 / (power - 1.0 / s);
    let near = found(&scene(THICK, DVec2::new(-75.0, 0.0), DVec2::new(-75.0, 0.01)));
    assert_point(near[0].tip, DVec2::new(-plane + behind, -0.01 * behind / s), 1e-4);
    // Farther out the rays miss that point, and yet each other by little.
    let far = found(&scene(THICK, DVec2::new(-75.0, 0.0), DVec2::new(-75.0, 4.0)));
    assert!(far[0].tip.distance(DVec2::new(-plane + behind, -4.0 * behind / s)) < 0.05 * behind);
    assert!((far[0].foot - DVec2::new(far[0].tip.x, 0.0)).length() < 1e-12, "across the axis");
}

#[test]
fn reflections_at_glass_do_not_count() {
    let [from, to] = [DVec2::new(-75.0, 0.0), DVec2::new(-75.0, 7.0)];
    let tip =
        |settings: &str| found(&scene_with(THICK, from, to, "", settings)).iter().map(|i| i.tip).collect::<Vec<_>>();
    assert_eq!(tip("trace: (secondary_rays: Fresnel)"), tip("trace: (secondary_rays: TransmittedOnly)"));
    assert_eq!(tip("").len(), 1);
}

#[test]
fn the_middle_line_tells_where_the_image_is() {
    let glass = THICK.replace("Index(1.5)", "Catalog(\"N-SF11\")");
    let [from, to] = [DVec2::new(-75.0, 0.0), DVec2::new(-75.0, 3.0)];
    let tip = |spectrum: &str| found(&scene_with(&glass, from, to, &format!("spectrum: {spectrum}"), ""))[0].tip;
    assert_eq!(tip("Lines([486.1327, 587.5618, 656.2725])"), tip("Line(587.5618)"));
    assert!(tip("Line(486.1327)").distance(tip("Line(656.2725)")) > 1.0, "the glass disperses");
}

#[test]
fn an_image_needs_light_that_gets_there_and_meets() {
    let lens = thin_lens(40.0, 0.0, DVec2::ZERO);
    let [from, to] = [DVec2::new(-60.0, 0.0), DVec2::new(-60.0, 12.0)];
    let screen = |x: f64| format!("{lens}, (shape: Flat(from: ({x:?}, -90), to: ({x:?}, 90)), surface: Screen)");
    assert_eq!(found(&scene(&screen(119.0), from, to)), [], "the screen stands in front of it");
    let on_screen = found(&scene(&screen(120.0), from, to));
    assert!(on_screen[0].is_real && !on_screen[0].is_intermediate);
    let virtual_image = found(&scene(&screen(50.0), DVec2::new(-20.0, 0.0), DVec2::new(-20.0, 5.0)));
    assert!(!virtual_image[0].is_real, "a screen behind the lens does not matter for it");
    let hemisphere = "(shape: Lens(radii: (15, -15), thickness: 30, diameter: 30), medium: Index(1.5))";
    assert_eq!(
        found(&scene(hemisphere, DVec2::new(-60.0, 0.0), DVec2::new(-60.0, 11.0))),
        [],
        "rays far from the axis do not meet"
    );
}

#[test]
fn a_second_lens_makes_an_image_of_the_image() {
    let second = |x: f64| {
        format!("{}, {}", thin_lens(30.0, 0.0, DVec2::new(50.0, 0.0)), thin_lens(30.0, 0.0, DVec2::new(x, 0.0)))
    };
    let images = |x: f64| found(&scene(&second(x), DVec2::ZERO, DVec2::new(0.0, 6.0)));
    let all = images(185.0);
    assert_eq!(
        all.iter().map(|image| (image.is_real, image.is_intermediate)).collect::<Vec<_>>(),
        [(true, true), (true, false)]
    );
    for (image, x, y) in [(&all[0], 125.0, -9.0), (&all[1], 245.0, 9.0)] {
        assert_point(image.tip, DVec2::new(x, y), 1e-10);
        assert_point(image.foot, DVec2::new(x, 0.0), 1e-10);
    }
    // The second lens as a magnifier: 20 mm behind the image.
    let all = images(145.0);
    assert_eq!((all.len(), all[1].is_real), (2, false));
    assert_point(all[1].tip, DVec2::new(145.0 - 60.0, -27.0), 1e-10);
    // It catches the light before it has met.
    let all = images(110.0);
    assert_eq!((all.len(), all[0].is_intermediate), (1, false));
    assert_point(all[0].tip, DVec2::new(120.0, -6.0), 1e-10);
}

#[test]
fn a_mirror_on_the_way_turns_the_image_with_the_axis() {
    // The axis is turned from +x to −y 60 mm behind the lens.
    let mirror = "(shape: Flat(from: (30, 30), to: (90, -30)), surface: Mirror)";
    let run = scene(
        &format!("{}, {mirror}", thin_lens(40.0, 0.0, DVec2::ZERO)),
        DVec2::new(-60.0, -3.0),
        DVec2::new(-60.0, 6.0),
    );
    let all = found(&run);
    let [image] = all.as_slice() else { panic!("{all:?}") };
    assert_point(image.tip, DVec2::new(60.0 + 12.0, -60.0), 1e-10);
    assert_point(image.foot, DVec2::new(60.0 - 6.0, -60.0), 1e-10);
}

#[test]
fn a_lens_in_water_has_the_focal_points_of_water() {
    let water = "(shape: Rectangle(800, 200), medium: Index(1.333)), ";
    let run = scene(&format!("{water}{THICK}"), DVec2::new(-300.0, 0.0), DVec2::new(-300.0, 5.0));
    let n = 1.5 / 1.333;
    let f = 1.0 / ((n - 1.0) * (2.0 / 40.0 - (n - 1.0) * 16.0 / (n * 1600.0)));
    let plane = -8.0 + f * (n - 1.0) * 16.0 / (n * 40.0);
    let through_focus = &run.trace.tree.rays[2].segments[0];
    let at = through_focus.from.x - through_focus.from.y * through_focus.direction.x / through_focus.direction.y;
    assert!((at - (plane - f)).abs() < 1e-10, "{at} is not {}", plane - f);
}
