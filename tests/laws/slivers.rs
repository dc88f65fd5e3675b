//! Bodies whose corners nearly coincide: what lies on the two sides of every outline is what the outlines alone say, in
//! painter's order.

use glam::DVec2;
use snellius::geometry::Curve;
use snellius::numerics::{atan2_degrees, pow};
use snellius::scene::{Medium, PathStep, Shape, Substance};
use snellius::system::MediumId;
use snellius::{OpticalSystem, Scene, compile};

use crate::scenes::{Random as Shown, body};
use crate::support::figures::{at_least, at_most, size};
use crate::support::random::Random;
use crate::support::run_text;

/// Points farther from all outlines are surely on one side of each: boundaries are one within 16 u of the largest coordinate, and
/// corners that are one move each other by a few times that.
const CLEAR: f64 = 1e-11;

/// Of what is nearer to a curve than this it is the same curve.
const ROUNDING: f64 = 4e-14;

/// Largest coordinate.
const REACH: f64 = 100.0;

/// The medium that the outlines give a point: that of the last one that holds it.
fn medium_at(system: &OpticalSystem, p: DVec2) -> MediumId {
    let outlines = system.bodies().iter().flat_map(|body| &body.outlines);
    let last = outlines.rev().find(|outline| outline.medium.is_some() && holds(&outline.curves, p));
    last.and_then(|outline| outline.medium).unwrap_or(system.surroundings())
}

/// Even or odd: edges that a ray towards +x crosses, and caps between chord and arc that hold the point.
fn holds(curves: &[Curve], p: DVec2) -> bool {
    curves.iter().filter(|curve| is_crossed(curve, p) != in_cap(curve, p)).count() % 2 == 1
}

fn is_crossed(curve: &Curve, p: DVec2) -> bool {
    let left = (curve.b - curve.a).perp_dot(p - curve.a) > 0.0;
    (curve.a.y > p.y) != (curve.b.y > p.y) && left == (curve.b.y > curve.a.y)
}

fn in_cap(curve: &Curve, p: DVec2) -> bool {
    curve.curvature != 0.0 && curve.segment_holds(p)
}

/// Distance from a point to a curve of at most half a circle, to rounding however flat it is.
fn distance(curve: &Curve, p: DVec2) -> f64 {
    let is_beside = (0.0..=curve.along(curve.b)).contains(&curve.along(curve.project(p)));
    if is_beside { curve.offset(p).abs() } else { p.distance(curve.a).min(p.distance(curve.b)) }
}

/// Both sides of a point of an outline at half the distance to what else is near; `None` where too much is.
fn beside(system: &OpticalSystem, outline: &[Curve], curve: &Curve, p: DVec2) -> Option<[DVec2; 2]> {
    let curves = || system.bodies().iter().flat_map(|body| &body.outlines).flat_map(|outline| &outline.curves);
    let apart = |p: DVec2| curves().map(move |other| distance(other, p));
    let ends = p.distance(curve.a).min(p.distance(curve.b));
    let free = apart(p).filter(|distance| *distance > ROUNDING).fold(ends.min(1e-3 * REACH), f64::min);
    // No round share, by which a point would come to lie on another outline's line.
    let aside = 0.43 * free * curve.normal_at(p);
    let sides = [p + aside, p - aside];
    // Off the circles beyond the ends of arcs, too, where rounding decides whether a cap holds a point.
    let is_off = |p: DVec2| {
        curves().all(|other| other.offset(p).abs() > 1e-12) && apart(p).all(|distance| distance > 0.35 * free)
    };
    // In the tip of a spike both of its edges are one.
    let is_spike = outline.iter().filter(|other| distance(other, p) <= CLEAR).count() > 1;
    // Two sides of which one is an arc may cross beside the corner that they share, up to 1e-9 of their size.
    let is_corner = ends < 3e-9 * REACH && outline.iter().any(|other| other.curvature != 0.0);
    let is_clear = !is_spike && !is_corner && 0.4 * free > CLEAR && sides.into_iter().all(is_off);
    is_clear.then_some(sides)
}

/// The media that the compiled interfaces give the two sides of a point of an outline; the same on both where there is none, and
/// `None` where several run within rounding of each other.
fn compiled(system: &OpticalSystem, curve: &Curve, p: DVec2, around: MediumId) -> Option<[MediumId; 2]> {
    let mut here = system.interfaces().iter().filter(|one| distance(&one.curve, p - system.origin()) <= CLEAR);
    let Some(one) = here.next() else { return Some([around; 2]) };
    let forward = one.curve.normal_at(p - system.origin()).dot(curve.normal_at(p)) > 0.0;
    here.next().is_none().then_some(if forward { [one.left, one.right] } else { [one.right, one.left] })
}

/// Counts of places on outlines looked at, and of those whose sides are wrong.
#[derive(Default)]
struct Counts {
    places: f64,
    /// Set aside.
    aside: f64,
    wrong: f64,
    /// The last wrong one.
    last: String,
}

fn tally(scene: &Scene, random: &mut Random) -> Counts {
    let mut counts = Counts::default();
    let system = compile(scene).unwrap().system;
    let outlines = system.bodies().iter().flat_map(|body| &body.outlines);
    for (outline, curve) in outlines.flat_map(|outline| outline.curves.iter().map(move |curve| (outline, curve))) {
        for _ in 0..4 {
            // Near the ends, too, where others cross.
            let part = pow(10.0, -10.0 * pow(random.unit(), 3.0));
            let part = if random.below(2) == 0 { part } else { 1.0 - part };
            let p = curve.project(curve.a.lerp(curve.b, part));
            let Some(sides) = beside(&system, &outline.curves, curve, p) else { continue };
            let expected = sides.map(|side| medium_at(&system, side));
            // Where nothing changes, nothing need be there.
            let Some(found) = compiled(&system, curve, p, expected[0]) else {
                counts.aside += 1.0;
                continue;
            };
            counts.places += 1.0;
            if found != expected {
                counts.wrong += 1.0;
                counts.last = format!("{p:?} of {curve:?}: {found:?} is not {expected:?}\n{:?}", Shown(scene.clone()));
            }
        }
    }
    counts
}

/// A length log-uniform between 1e-13 and 1e-3 of the largest coordinate.
fn tiny(random: &mut Random) -> f64 {
    REACH * pow(10.0, -13.0 + 10.0 * random.unit())
}

/// A corner of the coarse grid that all bodies share, or a point beside it.
fn corner(random: &mut Random) -> DVec2 {
    let whole = |random: &mut Random| 20.0 * f64::from(i32::try_from(random.below(9)).unwrap() - 4);
    let p = DVec2::new(whole(random), whole(random));
    if random.below(3) == 0 { p } else { p + beside_zero(random) }
}

fn beside_zero(random: &mut Random) -> DVec2 {
    let turn = DVec2::new(random.unit() - 0.5, random.unit() - 0.5);
    // Along an axis as a rule: slivers and T-junctions.
    let turn = [turn, DVec2::new(turn.x, 0.0), DVec2::new(0.0, turn.y)][random.below(3)];
    tiny(random) * turn
}

/// An outline whose corners lie on the grid or beside it: straight and one of them twice, or some of its sides bent.
fn outline(random: &mut Random) -> Shape {
    let mut points: Vec<_> = (0..3 + random.below(4)).map(|_| corner(random)).collect();
    let middle = points.iter().sum::<DVec2>() / f64::from(u32::try_from(points.len()).unwrap());
    let angle = |p: &DVec2| atan2_degrees(p.y - middle.y, p.x - middle.x);
    points.sort_by(|p, q| angle(p).total_cmp(&angle(q)));
    if random.below(2) == 0 {
        let k = random.below(points.len());
        points.insert(k + 1, points[k] + beside_zero(random));
        return Shape::Polygon(points);
    }
    let mut path = Vec::new();
    for (k, from) in points.iter().enumerate() {
        let to = points[(k + 1) % points.len()];
        let bulge = (to - *from).perp() * pow(10.0, -9.0 * random.unit()) * (random.unit() - 0.5);
        let through = 0.5 * (*from + to) + bulge;
        path.push(if random.below(2) == 0 { PathStep::LineTo(to) } else { PathStep::ArcTo { through, to } });
    }
    Shape::Outline { start: points[0], path }
}

fn random_scene(random: &mut Random) -> Scene {
    let mut scene = Scene::default();
    while scene.bodies.len() < 2 + random.below(3) {
        let medium = Medium::Index([1.0, 1.5, 1.5, 2.0][random.below(4)]);
        let next = body(outline(random), Substance::Medium(medium));
        if compile(&Scene::new(vec![next.clone()], vec![])).is_ok() {
            scene.bodies.push(next);
        }
    }
    scene
}

#[test]
fn both_sides_of_outlines_with_nearly_coincident_corners_are_what_the_outlines_say() {
    let mut random = Random(11);
    let scenes = size(2_000, 200_000);
    let mut all = Counts::default();
    for _ in 0..scenes {
        let counts = tally(&random_scene(&mut random), &mut random);
        all.places += counts.places;
        all.aside += counts.aside;
        all.wrong += counts.wrong;
        if counts.wrong > 0.0 {
            println!("{}", counts.last);
        }
    }
    at_least("places on nearly coincident outlines, per scene", all.places / f64::from(scenes), 20.0);
    at_most("share of them beside several boundaries within rounding, set aside", all.aside / all.places, 0.01);
    at_most("places on nearly coincident outlines with wrong sides", all.wrong, 0.0);
}

/// Looks at many places of one scene, which must all be right.
fn is_right(bodies: &str) {
    let scene = Scene::from_ron(&format!("(bodies: [{bodies}])")).unwrap();
    let mut random = Random(5);
    for _ in 0..200 {
        let counts = tally(&scene, &mut random);
        assert!(counts.places > 0.0 && counts.wrong == 0.0, "{}", counts.last);
    }
}

#[test]
fn a_long_edge_crosses_a_short_one() {
    // An edge of 1e-6, crossed 8e-11 from its end.
    is_right(
        "(shape: Polygon([(20, -40.00000000000561), (20.000000860312284, -40.000000712441306), (40, 0),
            (59.9877972724177, 79.9834980116803), (-20, 59.99999972518214)]), medium: Index(1.5)),
        (shape: Polygon([(40, -60), (40.00000028947101, -59.99999976897605), (39.999544842314414, -39.998918161387756),
            (-40, 20.000000000021217)]), medium: Index(1.5))",
    );
}

#[test]
fn an_edge_crosses_a_flat_arc_along_it() {
    // A radius of 2e9, at 2e-8 rad.
    is_right(
        "(shape: Polygon([(-60, 0), (-20, -80), (20, -60), (40, 60), (20, 60)]), medium: Index(1.5)),
        (shape: Outline(start: (-60.00000591024569, -20), path: [ArcTo(through: (-60.00002571031538, -50), to: (-60.00000000000157, -80)),
            LineTo((79.99999999997921, 60)), LineTo((-80, 40))]), medium: Index(2)),
        (shape: Outline(start: (-80, -80), path: [LineTo((-60, -79.99999999997927)),
            ArcTo(through: (-30.000000285510463, -49.99999964592013), to: (1.371180863897158e-7, -20)),
            ArcTo(through: (39.99579824654138, 10.005602429347281), to: (80, 40)), LineTo((40, 20)), LineTo((-20, 20))]),
            medium: Index(1))",
    );
}

#[test]
fn an_arc_crosses_a_much_flatter_one_twice() {
    // Radii of 200 and 1e9, 5 apart in places and 3e-6 from an end.
    is_right(
        "(shape: Outline(start: (-20, -60), path: [LineTo((60, -60)), LineTo((80, -40)),
            ArcTo(through: (49.99999857611589, 9.999999145669955), to: (19.999999999998593, 60)), LineTo((-20, -60))]),
            medium: Index(1.5)),
        (shape: Outline(start: (79.9999999394713, -40), path: [LineTo((59.99999701150103, -20)),
            ArcTo(through: (-19.288142735354086, 3.7458043238727257), to: (-80.00006739877142, 60)),
            ArcTo(through: (12.34579255019549, 29.753330361215355), to: (79.9999999394713, -40))]), medium: Index(2))",
    );
}

#[test]
fn flat_arcs_beside_each_other_do_not_cross() {
    // Radii of 2e10 and 4e9, 5e-8 apart.
    is_right(
        "(shape: Outline(start: (-20, -40), path: [LineTo((40, -80)), ArcTo(through: (40.000000059204005, -30), to: (40, 20)),
            ArcTo(through: (9.99956153782597, -9.99956153782597), to: (-20, -40))]), medium: Index(1.5)),
        (shape: Outline(start: (39.999999999979174, -20), path: [ArcTo(through: (40.00000001421627, -30), to: (40, -40)),
            LineTo((60, -80)), LineTo((60, 0)), LineTo((20, 40))]), medium: Index(2))",
    );
}

#[test]
fn a_flat_arc_is_cut_close_to_its_end() {
    // An edge passes below the outline's corners by 1.3e-10 and 1.4e-11, through arcs that are as flat.
    let run = run_text(
        "(bodies: [
            (shape: Polygon([(-70.71067811865474, 5.55e-15), (-70.71067797723339, -1.4141465776162931e-10),
                (70.71067811865474, -5.55e-15), (44.04405498380264, 26.66662299343075), (5.55e-15, 70.71067811865474)]),
                medium: Index(1.5)),
            (shape: Outline(start: (-5.55e-15, -56.568542494923804), path: [
                ArcTo(through: (28.284214678919405, -28.284214678919405), to: (56.568542494923804, -5.55e-15)),
                LineTo((5.55e-15, 56.568542494923804)),
                ArcTo(through: (-28.284214678919405, 28.284214678919405), to: (-56.568542494923804, 5.55e-15)),
                LineTo((-5.55e-15, -56.568542494923804))]), medium: Index(1.5)),
        ], sources: [(light: Ray(from: (65, 3), direction: Angle(-90)))], trace: (secondary_rays: TransmittedOnly))",
    );
    let segments = &run.trace.tree.rays[0].segments;
    let indices: Vec<_> = segments.iter().map(|segment| segment.medium_index).collect();
    assert_eq!(indices, [1.5, 1.0], "out through the lower edge");
}
