//! The compiled arrangement in exact arithmetic: in random scenes of bodies that overlap, nest, touch and are cemented, every
//! segment runs in the medium of the last body that holds its midpoint.

use glam::DVec2;
use snellius::Scene;
use snellius::compile::compile;
use snellius::scene::{Body, Direction, Light, Medium, SecondaryRays, Shape, Substance};
use snellius::trace::{Ending, Segment};

use crate::oracle::clearance;
use crate::scenes::{body, source, towards};
use crate::support::figures::{at_least, at_most, size};
use crate::support::random::Random;
use crate::support::wide::{Wide2, power_of_two, wide};
use crate::support::{Run, run_scene};

/// A body's inside, without rounding: its coordinates are short binary fractions.
enum Inside {
    Polygon(Vec<Wide2>),
    Disk {
        center: Wide2,
        radius: f64,
    },
    /// The half of the disk that lies towards `axis`.
    HalfDisk {
        center: Wide2,
        radius: f64,
        axis: Wide2,
    },
}

impl Inside {
    /// Of a body turned by quarters.
    fn of(body: &Body) -> Self {
        let quarters = (0..4).find(|k| 90.0 * f64::from(*k) == body.rotate).unwrap();
        let turned = |p: DVec2| (0..quarters).fold(p, |p, _| p.perp());
        let center = Wide2::from(body.at);
        match &body.shape {
            Shape::Polygon(points) => Self::Polygon(points.iter().map(|p| Wide2::from(turned(*p)) + center).collect()),
            Shape::Disk { radius } => Self::Disk { center, radius: *radius },
            Shape::HalfDisk { radius } => Self::HalfDisk { center, radius: *radius, axis: turned(DVec2::X).into() },
            other => panic!("{other:?} has no exact inside"),
        }
    }

    fn holds(&self, p: Wide2) -> bool {
        match self {
            Self::Polygon(points) => {
                let edges = points.iter().zip(points.iter().cycle().skip(1));
                edges.filter(|(a, b)| is_crossed(**a, **b, p)).count() % 2 == 1
            }
            Self::Disk { center, radius } => in_disk(*center, *radius, p),
            Self::HalfDisk { center, radius, axis } => {
                in_disk(*center, *radius, p) && (p - *center).dot(*axis) > wide(0.0)
            }
        }
    }
}

/// Whether the ray from `p` towards +x crosses an edge.
fn is_crossed(a: Wide2, b: Wide2, p: Wide2) -> bool {
    let left = (b - a).cross(p - a) > wide(0.0);
    (a.y > p.y) != (b.y > p.y) && left == (b.y > a.y)
}

fn in_disk(center: Wide2, radius: f64, p: Wide2) -> bool {
    (p - center).dot(p - center) < wide(radius) * wide(radius)
}

/// Index of the last body that holds a point.
fn index_at(scene: &Scene, insides: &[Inside], p: Wide2) -> f64 {
    let last = scene.bodies.iter().zip(insides).rev().find(|(_, inside)| inside.holds(p));
    let Medium::Index(n) = last.map_or(&scene.surroundings, |(body, _)| match &body.substance {
        Substance::Medium(medium) => medium,
        other => panic!("{other:?} is no medium"),
    }) else {
        panic!("a medium by its index")
    };
    *n
}

fn lattice(random: &mut Random, reach: usize) -> DVec2 {
    let whole = |random: &mut Random| f64::from(u32::try_from(random.below(2 * reach + 1)).unwrap());
    DVec2::new(whole(random), whole(random)) - DVec2::splat(f64::from(u32::try_from(reach).unwrap()))
}

/// A polygon of whole coordinates about its origin, convex or not.
fn polygon(random: &mut Random) -> Shape {
    if random.below(3) == 0 {
        let corner = lattice(random, 3).abs() + DVec2::ONE;
        return Shape::Polygon(vec![-corner, DVec2::new(corner.x, -corner.y), corner, DVec2::new(-corner.x, corner.y)]);
    }
    let mut points: Vec<_> = (0..3 + random.below(5)).map(|_| lattice(random, 4)).collect();
    let angle = |p: &DVec2| snellius::numerics::atan2_degrees(p.y, p.x);
    points.sort_by(|p, q| angle(p).total_cmp(&angle(q)));
    points.dedup_by(|p, q| angle(p) == angle(q));
    Shape::Polygon(points)
}

fn random_body(random: &mut Random) -> Body {
    let radius = [1.0, 2.0, 3.0, 4.0, 5.0][random.below(5)];
    let shape = match random.below(5) {
        0 | 1 => polygon(random),
        2 => Shape::HalfDisk { radius },
        _ => Shape::Disk { radius },
    };
    let medium = Medium::Index([1.0, 1.33, 1.5, 1.5, 2.0][random.below(5)]);
    let rotate = [0.0, 90.0, 180.0, 270.0][random.below(4)];
    body(shape, Substance::Medium(medium)).placed(lattice(random, 5), rotate)
}

/// Up to six bodies that compile, and rays between points of the lattice, at all angles and between any points.
fn random_scene(random: &mut Random) -> Scene {
    let mut scene = Scene::default();
    scene.surroundings = Medium::Index([1.0, 1.0, 1.33][random.below(3)]);
    scene.trace.secondary_rays = SecondaryRays::Fixed { kr: 0.5, kt: 0.5 };
    (scene.trace.max_depth, scene.trace.min_power) = (5, 0.0);
    for _ in 0..1 + random.below(6) {
        let next = random_body(random);
        // A polygon that touches itself is refused.
        if compile(&Scene::new(vec![next.clone()], Vec::new())).is_ok() {
            scene.bodies.push(next);
        }
    }
    for k in 0..6 {
        let (from, to) = (lattice(random, 8), lattice(random, 8));
        let apart = DVec2::new(random.unit(), random.unit());
        scene.sources.push(match k {
            0 if from != to => towards(from, to),
            1 => source(Light::Ray { from, direction: Direction::Angle(360.0 * random.unit()) }),
            _ => towards(from + apart, to + 20.0 * apart.perp()),
        });
    }
    scene
}

/// Midpoint of a segment that ends, or points ahead of one that escapes.
fn probes(segment: &Segment) -> Vec<Wide2> {
    let Segment { from, to, direction, .. } = *segment;
    match (to, segment.ending) {
        (Some(to), _) => vec![power_of_two(-1) * (Wide2::from(from) + Wide2::from(to))],
        (None, Ending::Escaped) => [0.1, 1.0, 3.0, 9.0, 27.0].map(|t| Wide2::from(from + t * direction)).into(),
        _ => Vec::new(),
    }
}

/// Counts of probes, of those too close to an outline, and of those in a wrong medium.
fn tally(run: &Run, counts: &mut [f64; 3]) {
    let insides: Vec<_> = run.scene.bodies.iter().map(Inside::of).collect();
    for segment in run.trace.tree.rays.iter().flat_map(|ray| &ray.segments) {
        for p in probes(segment) {
            counts[0] += 1.0;
            if clearance(&run.system, p.narrow()) <= 1e-9 * 10.0 {
                counts[1] += 1.0;
            } else if index_at(&run.scene, &insides, p) != segment.medium_index {
                counts[2] += 1.0;
                println!("{:?} {segment:?}", crate::scenes::Random(run.scene.clone()));
            }
        }
    }
}

#[test]
fn every_segment_runs_in_the_medium_of_the_last_body_that_holds_it() {
    let mut random = Random(7);
    let mut counts = [0.0; 3];
    let scenes = size(1_000, 100_000);
    for _ in 0..scenes {
        tally(&run_scene(random_scene(&mut random)), &mut counts);
    }
    let [probes, aside, wrong] = counts;
    at_least("midpoints held against exact containment, per scene", probes / f64::from(scenes), 20.0);
    at_most("share of midpoints on an outline, set aside", aside / probes, 0.01);
    at_most("segments in a wrong medium, exact containment", wrong, 0.0);
}
