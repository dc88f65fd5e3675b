//! Random scenes.

use std::fmt;

use glam::DVec2;
use proptest::collection::vec;
use proptest::prelude::*;
use snellius::Scene;
use snellius::numerics::Turn;
use snellius::scene::{
    Body, Direction, Element, Light, Medium, PathStep, SecondaryRays, Shape, Source, Substance, Surface, TraceSettings,
};

pub(crate) fn body(shape: Shape, substance: Substance) -> Body {
    Body::new(shape, substance)
}

pub(crate) fn source(light: Light) -> Source {
    Source::new(light)
}

pub(crate) fn towards(from: DVec2, to: DVec2) -> Source {
    source(Light::Ray { from, direction: Direction::Towards(to) })
}

pub(crate) fn settings(max_depth: u32) -> TraceSettings {
    let mut settings = TraceSettings::default();
    settings.max_depth = max_depth;
    settings
}

/// A random scene, shown in few lines.
#[derive(Clone)]
pub(crate) struct Random(pub Scene);

impl fmt::Debug for Random {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Scene { surroundings, bodies, sources, trace, .. } = &self.0;
        writeln!(f, "{surroundings:?} {trace:?}")?;
        for Body { shape, at, rotate, substance, .. } in bodies {
            writeln!(f, "{shape:?} at {at:?} rotate {rotate:?} {substance:?}")?;
        }
        sources.iter().try_for_each(|source| writeln!(f, "{:?}", source.light))
    }
}

/// Bodies anywhere.
pub(crate) fn free_scenes() -> impl Strategy<Value = Random> {
    scenes(point(10.0), -180.0..180.0, vec(point(25.0), 3))
}

/// Bodies with whole sizes on a lattice, turned by quarters: their faces and corners often coincide. Rays start on the
/// lattice and head for it, through corners and along edges.
pub(crate) fn lattice_scenes() -> impl Strategy<Value = Random> {
    scenes(lattice(3), prop_oneof![Just(0.0), Just(90.0), Just(180.0), Just(-90.0)], vec(lattice(6), 3))
}

/// A lattice scene turned as a whole, and moved: what coincided does so up to rounding.
pub(crate) fn turned_scenes() -> impl Strategy<Value = Random> {
    let angle = prop_oneof![-180.0..180.0, Just(30.0), Just(45.0)];
    let shift = prop_oneof![Just(0.0), -1000.0..1000.0, -1e6..1e6];
    (lattice_scenes(), angle, shift.clone(), shift)
        .prop_map(|(Random(scene), angle, x, y)| Random(turned(scene, angle, DVec2::new(x, y))))
}

/// The whole scene turned about the coordinate origin, then moved.
pub(crate) fn turned(mut scene: Scene, angle: f64, shift: DVec2) -> Scene {
    let turn = |p: DVec2| Turn::degrees(angle).apply(p) + shift;
    for body in &mut scene.bodies {
        (body.at, body.rotate) = (turn(body.at), body.rotate + angle);
    }
    let heading = |direction| match direction {
        Direction::Angle(degrees) => Direction::Angle(degrees + angle),
        Direction::Towards(p) => Direction::Towards(turn(p)),
        other => panic!("how does {other:?} turn?"),
    };
    let light = |light| match light {
        Light::Ray { from, direction } => Light::Ray { from: turn(from), direction: heading(direction) },
        Light::Beam { center, direction, width, rays } => {
            Light::Beam { center: turn(center), direction: heading(direction), width, rays }
        }
        Light::Fan { from, direction, spread, rays } => {
            Light::Fan { from: turn(from), direction: heading(direction), spread, rays }
        }
        Light::Point { at, rays } => Light::Point { at: turn(at), rays },
        Light::Object { from, to } => Light::Object { from: turn(from), to: turn(to) },
        other => panic!("how does {other:?} turn?"),
    };
    for source in &mut scene.sources {
        source.light = light(source.light.clone());
    }
    scene
}

fn scenes(
    at: impl Strategy<Value = DVec2>,
    rotate: impl Strategy<Value = f64>,
    targets: impl Strategy<Value = Vec<DVec2>>,
) -> impl Strategy<Value = Random> {
    let bodies = vec((shapes(), substances(), at, rotate).prop_map(placed), 1..6);
    let rays = (targets, point(20.0), vec(-180.0..180.0, 4));
    (bodies, rays, medium(), tracing()).prop_map(|(bodies, (targets, free, angles), surroundings, trace)| {
        let aimed = [0, 1].map(|k| (targets[k], targets[k + 1]));
        let rays = aimed.into_iter().filter(|(from, to)| from != to).map(|(from, to)| towards(from, to));
        let angled = angles.iter().enumerate().map(|(k, angle)| {
            let from = if k % 2 == 0 { free } else { targets[0] };
            source(Light::Ray { from, direction: Direction::Angle(*angle) })
        });
        let mut scene = Scene::new(bodies, rays.chain(angled).collect());
        scene.surroundings = surroundings;
        scene.trace = trace;
        Random(scene)
    })
}

fn placed((shape, substance, at, rotate): (Shape, Substance, DVec2, f64)) -> Body {
    let substance = match shape {
        Shape::LensGroup { .. } => Substance::Elements,
        Shape::Flat { .. } | Shape::Arc { .. } | Shape::Stop { .. } => match substance {
            Substance::Surface(_) => substance,
            _ => Substance::Surface(Surface::Mirror),
        },
        _ => substance,
    };
    body(shape, substance).placed(at, rotate)
}

fn point(reach: f64) -> impl Strategy<Value = DVec2> {
    (-reach..reach, -reach..reach).prop_map(DVec2::from)
}

fn lattice(reach: i32) -> impl Strategy<Value = DVec2> {
    (-reach..=reach, -reach..=reach).prop_map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)))
}

fn size() -> impl Strategy<Value = f64> {
    prop_oneof![(1..5_i32).prop_map(f64::from), 0.5..6.0]
}

fn index() -> impl Strategy<Value = f64> {
    prop_oneof![Just(1.0), Just(1.33), Just(1.5), Just(1.5), 1.0..2.5]
}

fn medium() -> impl Strategy<Value = Medium> {
    prop_oneof![9 => index().prop_map(Medium::Index), 1 => Just(Medium::Catalog("N-BK7".into()))]
}

fn tracing() -> impl Strategy<Value = TraceSettings> {
    let secondary_rays = prop_oneof![
        4 => Just(SecondaryRays::Fresnel),
        1 => Just(SecondaryRays::TransmittedOnly),
        1 => (0.0..0.5, 0.0..0.5).prop_map(|(kr, kt)| SecondaryRays::Fixed { kr, kt }),
    ];
    (secondary_rays, 1..8_u32, prop_oneof![Just(0.0), Just(1e-3)]).prop_map(|(secondary_rays, max_depth, min_power)| {
        let mut settings = TraceSettings::default();
        settings.secondary_rays = secondary_rays;
        settings.max_depth = max_depth;
        settings.min_power = min_power;
        settings
    })
}

fn substances() -> impl Strategy<Value = Substance> {
    let surface = prop_oneof![
        2 => Just(Surface::Mirror),
        1 => Just(Surface::Absorber),
        1 => Just(Surface::Screen),
        2 => (0.0..0.5, 0.0..0.5).prop_map(|(reflect, transmit)| Surface::BeamSplitter { reflect, transmit }),
    ];
    prop_oneof![
        4 => medium().prop_map(Substance::Medium),
        1 => surface.prop_map(Substance::Surface),
    ]
}

fn shapes() -> impl Strategy<Value = Shape> {
    prop_oneof![
        2 => polygon(),
        2 => lattice_triangle(),
        2 => (size(), size()).prop_map(|(width, height)| Shape::Rectangle { width, height }),
        1 => (3..8_u32, size()).prop_map(|(sides, radius)| Shape::RegularPolygon { sides, radius }),
        1 => (20.0..120.0, size()).prop_map(|(apex_angle, side)| Shape::Prism { apex_angle, side }),
        1 => size().prop_map(|leg| Shape::RightAnglePrism { leg }),
        2 => size().prop_map(|radius| Shape::Disk { radius }),
        2 => size().prop_map(|radius| Shape::HalfDisk { radius }),
        2 => lens(),
        2 => outline(),
        1 => lens_group(),
        1 => (point(5.0), point(5.0)).prop_map(|(from, to)| Shape::Flat { from, to }),
        1 => (point(5.0), point(5.0), point(5.0)).prop_map(|(from, through, to)| Shape::Arc { from, through, to }),
        1 => (0.5..2.0, 2.5..8.0).prop_map(|(opening, height)| Shape::Stop { opening, height }),
    ]
}

/// Convex where all distances are the same, else star-shaped; either orientation.
fn polygon() -> impl Strategy<Value = Shape> {
    let star = vec((0.3..1.0, 1.0..5.0), 3..9);
    (star, any::<bool>(), any::<bool>()).prop_map(|(corners, convex, clockwise)| {
        let whole: f64 = corners.iter().map(|(step, _)| step).sum();
        let mut angle = 0.0;
        let corner = |&(step, distance): &(f64, f64)| {
            angle += 360.0 * step / whole;
            (if convex { corners[0].1 } else { distance }) * Turn::degrees(angle).direction()
        };
        let mut points: Vec<_> = corners.iter().map(corner).collect();
        if clockwise {
            points.reverse();
        }
        Shape::Polygon(points)
    })
}

fn lattice_triangle() -> impl Strategy<Value = Shape> {
    (lattice(3), lattice(3), lattice(3))
        .prop_filter("three points on a line", |(a, b, c)| (*b - *a).perp_dot(*c - *a) != 0.0)
        .prop_map(|(a, b, c)| Shape::Polygon(vec![a, b, c]))
}

/// Radius of a face that reaches up to half the diameter 4, or a plane one.
fn face() -> impl Strategy<Value = f64> {
    prop_oneof![Just(f64::INFINITY), Just(3.0), Just(-3.0), 2.5..30.0, -30.0..-2.5]
}

fn lens() -> impl Strategy<Value = Shape> {
    (face(), face(), 0.0..2.0, prop_oneof![4 => Just(None), 1 => (1..9_u32).prop_map(Some)]).prop_map(
        |(left, right, extra, facets)| {
            let thickness = extra + least_thickness(left, right);
            Shape::Lens { radii: [left, right], thickness, diameter: 4.0, facets }
        },
    )
}

/// The thickness at which the faces of a lens of diameter 4 meet, somewhat above it, or above 0.
fn least_thickness(left: f64, right: f64) -> f64 {
    let sag =
        |radius: f64| if radius.is_finite() { radius - radius.signum() * (radius * radius - 4.0).sqrt() } else { 0.0 };
    (sag(left) - sag(right)).max(0.0) + 0.05
}

fn lens_group() -> impl Strategy<Value = Shape> {
    (face(), face(), face(), index(), index()).prop_map(|(first, second, third, n, m)| {
        let element = |radius, thickness, index: Option<f64>| Element::new(radius, thickness, index.map(Medium::Index));
        let (t1, t2) = (0.5 + least_thickness(first, second), 0.5 + least_thickness(second, third));
        let surfaces =
            vec![element(first, Some(t1), Some(n)), element(second, Some(t2), Some(m)), element(third, None, None)];
        Shape::LensGroup { diameter: 4.0, surfaces }
    })
}

/// A rectangle of which some sides bulge or cave in, by up to half a circle.
fn outline() -> impl Strategy<Value = Shape> {
    let bulge = prop_oneof![Just(0.0), Just(0.5), 0.01..0.5, -0.2..-0.01];
    (vec(bulge, 4), 2.0..5.0, 2.0..5.0).prop_map(|(bulges, width, height): (Vec<f64>, f64, f64)| {
        let corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height), (0.0, 0.0)].map(DVec2::from);
        let step = |k: usize| {
            let (from, to) = (corners[k], corners[k + 1]);
            let through = 0.5 * (from + to) - bulges[k] * (to - from).perp();
            if bulges[k] == 0.0 { PathStep::LineTo(to) } else { PathStep::ArcTo { through, to } }
        };
        Shape::Outline { start: corners[0], path: (0..4).map(step).collect() }
    })
}
