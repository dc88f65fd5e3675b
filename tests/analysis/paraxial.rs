//! Cardinal points.

use snellius::OpticalSystem;
use snellius::analysis::{Axis, Paraxial, paraxial, paraxial_of};
use snellius::glam::DVec2;
use snellius::light::Wavelength;
use snellius::numerics::Turn;

use crate::support::{run_text, tables::close};

fn system(bodies: &str) -> OpticalSystem {
    run_text(&format!("(bodies: [{bodies}])")).system
}

const AXIS: Axis = Axis { from: DVec2::new(-200.0, 0.0), direction: DVec2::X };

fn on_axis(bodies: &str) -> Option<Paraxial> {
    paraxial(&system(bodies), AXIS, Wavelength::D)
}

/// Where the last branch of a ray crosses the x axis, and its slope.
fn crossing(scene: &str) -> (f64, f64) {
    let trace = run_text(scene).trace;
    let last = *trace.tree.rays[0].segments.last().unwrap();
    let slope = last.direction.y / last.direction.x;
    (last.from.x - last.from.y / slope, slope)
}

/// Hecht, "Optics", 4th ed., problem 6.7: f = nR/2(n − 1), with both principal points in the center.
#[test]
fn ball_lenses_have_their_principal_points_in_the_center() {
    for (n, radius) in [(1.5, 10.0), (1.33, 3.0), (1.9, 40.0)] {
        let ball = on_axis(&format!("(shape: Disk({radius}), medium: Index({n}))")).unwrap();
        let f = n * radius / (2.0 * (n - 1.0));
        close(ball.back_focal_length, f, 1e-12 * f, "f'");
        close(ball.front_focal_length, f, 1e-12 * f, "f");
        let [front, back] = ball.focal_points;
        assert!(back.distance(DVec2::new(f, 0.0)) < 1e-12 * f && front.distance(DVec2::new(-f, 0.0)) < 1e-12 * f);
        let in_center = [ball.principal_points, ball.nodal_points].concat();
        assert!(in_center.iter().all(|p| p.length() < 1e-12 * f), "{ball:?}");
    }
}

/// Rays at ever smaller heights meet in F′, and the aberration falls with the square of the height.
#[test]
fn rays_near_the_axis_meet_in_the_focal_point() {
    let meniscus = r#"(shape: Lens(radii: (30, 70), thickness: 8, diameter: 20), medium: Catalog("N-BK7"))"#;
    let water = "surroundings: Index(1.33),";
    let ball = "(shape: Disk(10), medium: Index(1.6))";
    let half = "(shape: HalfDisk(10), medium: Index(1.6))";
    let between = "(shape: Rectangle(50, 30), at: (25, 0), medium: Index(1.4)), (shape: Disk(10), medium: Index(1.8))";
    let lenses = "(shape: Flat(from: (0, -9), to: (0, 9)), surface: ThinLens(focal_length: 40)),
        (shape: Flat(from: (15, 9), to: (15, -9)), surface: ThinLens(focal_length: -60)),
        (shape: Rectangle(10, 30), at: (20, 0), medium: Index(1.5))";
    for (settings, bodies) in
        [("", meniscus), (water, meniscus), (water, ball), ("", half), ("", between), ("", lenses)]
    {
        let scene = |height: f64| {
            format!(
                "({settings} bodies: [{bodies}], trace: (secondary_rays: TransmittedOnly),
                sources: [(light: Ray(from: (-50, {height}), direction: Angle(0)), spectrum: Line(587.5618))])"
            )
        };
        let points = paraxial(&run_text(&scene(1.0)).system, AXIS, Wavelength::D).unwrap();
        let focus = points.focal_points[1].x;
        let off = |height: f64| (crossing(&scene(height)).0 - focus).abs();
        assert!(off(1e-5) < 1e-9, "{bodies}: {}", off(1e-5));
        let (far, near) = (off(0.2), off(0.1));
        assert!(far < 1e-9 || (far / near - 4.0).abs() < 0.1, "{bodies}: {far} and {near}");
        let (_, slope) = crossing(&scene(1e-5));
        close(-1e-5 / slope, points.back_focal_length, 1e-8, bodies);
    }
}

/// A ray from F leaves parallel, and one aimed at N leaves from N′ in its own direction.
#[test]
fn front_focal_point_and_nodal_points_do_what_they_are_for() {
    let bodies = "(shape: Rectangle(80, 60), at: (45, 0), medium: Index(1.33)),
        (shape: Lens(radii: (30, -45), thickness: 12, diameter: 30), medium: Index(1.6)),
        (shape: Flat(from: (60, -9), to: (60, 9)), surface: Screen)";
    let points = on_axis(bodies).unwrap();
    let through = |aim: DVec2, from: f64| {
        let angle = 1e-4;
        let start = aim + from * Turn::degrees(angle).direction();
        run_text(&format!(
            "(bodies: [{bodies}],
            sources: [(light: Ray(from: ({}, {}), direction: Angle({angle})))],
            trace: (secondary_rays: TransmittedOnly))",
            start.x, start.y
        ))
        .trace
        .tree
        .rays[0]
            .segments[2]
    };
    let parallel = through(points.focal_points[0], 1e-3).direction;
    assert!(parallel.y.abs() < 1e-14, "{parallel}");
    let nodal = through(points.nodal_points[0], -60.0);
    assert!((nodal.direction.y - Turn::degrees(1e-4).sin).abs() < 1e-14, "{}", nodal.direction);
    let crosses = nodal.from.x - nodal.from.y * nodal.direction.x / nodal.direction.y;
    close(crosses, points.nodal_points[1].x, 1e-8, "N'");
    assert_eq!(points.indices, [1.0, 1.33]);
    close(points.back_focal_length, 1.33 * points.front_focal_length, 1e-12, "f'/f = n'/n");
}

/// The same group wherever it stands and however it is turned, far from the origin too, and its light the other way.
#[test]
fn placement_carries_the_points_along() {
    let group = |place: &str| {
        format!(
            "(shape: LensGroup(diameter: 16, surfaces: [(radius: 40, thickness: 5, medium: Index(1.52)),
            (radius: -35, thickness: 2, medium: Index(1.7)), (radius: -120)]) {place})"
        )
    };
    let home = on_axis(&group("")).unwrap();
    let turn = Turn::degrees(37.0);
    for at in [DVec2::new(3.0, 4.0), DVec2::new(1e6, -2e6)] {
        let placed = system(&group(&format!(", rotate: 37, at: ({}, {})", at.x, at.y)));
        let axis = |from: f64, sense: f64| Axis {
            from: at + turn.apply(DVec2::new(from, 0.0)),
            direction: 2.0 * sense * turn.direction(),
        };
        let points = paraxial(&placed, axis(-100.0, 1.0), Wavelength::D).unwrap();
        let near = 1e-12 * (100.0 + at.length());
        for (p, q) in points.focal_points.iter().zip(home.focal_points) {
            assert!(p.distance(at + turn.apply(q)) < near, "{p}");
        }
        let back = paraxial(&placed, axis(100.0, -1.0), Wavelength::D).unwrap();
        assert!(back.focal_points[0].distance(points.focal_points[1]) < near);
        assert!(back.principal_points[1].distance(points.principal_points[0]) < near);
    }
}

#[test]
fn some_bodies_as_if_the_rest_were_not_there() {
    let bodies = "(shape: Disk(10), medium: Index(1.5)),
        (shape: Lens(radii: (60, -60), thickness: 4, diameter: 20), at: (40, 0), medium: Index(1.6)),
        (shape: Rectangle(4, 30), at: (60, 0), medium: Index(1.4))";
    let all = system(bodies);
    let only = |listed: &[usize]| paraxial_of(&all, listed, AXIS, Wavelength::D);
    close(only(&[0]).unwrap().back_focal_length, 15.0, 1e-12, "the ball alone");
    assert_eq!(only(&[0, 1, 2]), paraxial(&all, AXIS, Wavelength::D));
    assert_ne!(only(&[0, 1, 2]).unwrap().focal_points, only(&[0]).unwrap().focal_points);
    assert_eq!(only(&[2]), None, "a slab has no power");
    assert_eq!(only(&[7]), None);
    let in_water = system(
        "(shape: Disk(10), medium: Index(1.5)), (shape: Rectangle(60, 30), at: (60, 0), medium: Index(1.33)),
        (shape: Disk(5), at: (60, 0), medium: Index(1.5))",
    );
    assert_eq!(paraxial_of(&in_water, &[2], AXIS, Wavelength::D).unwrap().indices, [1.33, 1.33]);
    assert_eq!(
        paraxial_of(&in_water, &[0, 2], AXIS, Wavelength::D),
        None,
        "air behind the one, water before the other"
    );
    let behind_ball = Axis { from: DVec2::new(20.0, 0.0), ..AXIS };
    let lens = only(&[1]).unwrap();
    assert_eq!(paraxial_of(&all, &[0, 1], behind_ball, Wavelength::D), Some(lens), "the light starts behind the ball");
}

#[test]
fn mirrors_send_the_light_back_along_the_axis() {
    let mirror = "(shape: Arc(from: (-5, -25), through: (0, 0), to: (-5, 25)), surface: Mirror)";
    let alone = on_axis(mirror).unwrap();
    let half_radius = DVec2::new(-32.5, 0.0);
    assert!(alone.focal_points.iter().all(|focus| focus.distance(half_radius) < 1e-12), "{alone:?}");
    let settings = "trace: (secondary_rays: TransmittedOnly)";
    // A silvered face: light passes the lens, and again on its way back.
    let silvered = "(shape: Lens(radii: (80, -65), thickness: 6, diameter: 20), at: (-3, 0), medium: Index(1.5)),
        (shape: Arc(from: (-5, -25), through: (0, 0), to: (-5, 25)), surface: Mirror)";
    let scene =
        format!("(bodies: [{silvered}], sources: [(light: Ray(from: (-99, 1e-5), direction: Angle(0)))], {settings})");
    let (focus, slope) = crossing(&scene);
    let points = on_axis(silvered).unwrap();
    close(points.focal_points[1].x, focus, 1e-8, "F'");
    close(points.back_focal_length, 1e-5 / slope, 1e-8, "f'");
    let resonator =
        format!("{mirror}, (shape: Arc(from: (-95, -5), through: (-99, 0), to: (-95, 5)), surface: Mirror)");
    assert!(on_axis(&resonator).is_some(), "the light starts behind the other mirror");
    let between = Axis { from: DVec2::new(-50.0, 0.0), ..AXIS };
    assert_eq!(paraxial(&system(&resonator), between, Wavelength::D), None, "light between two mirrors never leaves");
}

#[test]
fn screens_and_absorbers_end_the_system() {
    let ball = "(shape: Disk(10), medium: Index(1.5))";
    let lens = "(shape: Flat(from: (40, -9), to: (40, 9)), surface: ThinLens(focal_length: 40))";
    for wall in ["Screen", "Absorber"] {
        let wall = format!("(shape: Flat(from: (30, -9), to: (30, 9)), surface: {wall})");
        assert_eq!(on_axis(&format!("{ball}, {wall}, {lens}")), on_axis(ball), "{wall}");
    }
    assert_ne!(on_axis(&format!("{ball}, {lens}")), on_axis(ball));
}

#[test]
fn bodies_that_touch_on_the_axis_count_in_the_order_of_their_media() {
    let (ball, slab) =
        ("(shape: Disk(10), medium: Index(1.5))", "(shape: Rectangle(20, 30), at: (20, 0), medium: Index(1.7))");
    let (ball_first, slab_first) = (on_axis(&format!("{ball}, {slab}")), on_axis(&format!("{slab}, {ball}")));
    let apart =
        on_axis(&format!("{ball}, (shape: Rectangle(20, 30), at: (20.000001, 0), medium: Index(1.7))")).unwrap();
    for points in [ball_first.unwrap(), slab_first.unwrap()] {
        close(points.back_focal_length, 15.0, 1e-12, "a slab changes no focal length");
        close(points.focal_points[1].x, apart.focal_points[1].x, 1e-5, "F'");
    }
}

#[test]
fn without_upright_boundaries_or_power_there_are_no_points() {
    let lens =
        |more: &str| format!("(shape: Lens(radii: (50, -50), thickness: 6, diameter: 22 {more}, medium: Index(1.5))");
    assert!(on_axis(&lens(")")).is_some());
    for (what, bodies) in [
        ("tilted", lens("), rotate: 1")),
        ("off the axis", lens("), at: (0, 1)")),
        ("missed", lens("), at: (0, 30)")),
        ("behind the light", lens("), at: (-300, 0)")),
        ("a flat facet", lens(", facets: 5)")),
        ("a corner between facets", lens(", facets: 4)")),
        ("a slab", "(shape: Rectangle(5, 20), medium: Index(1.5))".into()),
        (
            "a thin lens beside its center",
            "(shape: Flat(from: (0, -8), to: (0, 9)), surface: ThinLens(focal_length: 40))".into(),
        ),
        (
            "a telescope",
            "(shape: Flat(from: (0, -9), to: (0, 9)), surface: ThinLens(focal_length: 100)),
            (shape: Flat(from: (125, -9), to: (125, 9)), surface: ThinLens(focal_length: 25))"
                .into(),
        ),
        ("nothing", String::new()),
    ] {
        assert_eq!(on_axis(&bodies), None, "{what}");
    }
    let direction = DVec2::ZERO;
    assert_eq!(paraxial(&system(&lens(")")), Axis { direction, ..AXIS }, Wavelength::D), None);
}
