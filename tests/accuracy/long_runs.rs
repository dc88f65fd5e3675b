//! What many hits add up to: lengths of directions, powers, paths sent back, a light guide.

use f256::f256;
use glam::DVec2;
use snellius::Scene;
use snellius::compile::{compile, compile_within};
use snellius::scene::{Body, Direction, Light, Limit, Limits, Medium, Shape, Substance, Surface};
use snellius::trace::{Segment, Summary, TracedRay, Via, Visitor, visit};

use crate::scenes::{body, source, towards};
use crate::support::figures::{U, at_least, at_most, counted, size};
use crate::support::random::Random;
use crate::support::wide::{Wide2, narrow};
use crate::support::{run_scene, run_text};

/// The largest deviation of a direction's length from 1.
#[derive(Default)]
struct Lengths {
    hits: u32,
    worst: f64,
}

impl Visitor for Lengths {
    fn segment(&mut self, _: &TracedRay, segment: Segment) {
        self.hits += u32::from(segment.hit.is_some());
        self.worst = self.worst.max(narrow(Wide2::from(segment.direction).length() - f256::ONE).abs());
    }
}

#[test]
fn a_hundred_thousand_mirror_bounces_keep_the_direction_a_unit_vector() {
    let mut lengths = Lengths::default();
    for shape in ["Polygon([(0, 0), (7, 1), (9, 6), (4, 9), (-2, 5)])", "Disk(5)", "HalfDisk(4)"] {
        let scene = Scene::from_ron(&format!(
            "(bodies: [(shape: {shape}, surface: Mirror)], sources: [(light: Ray(from: (2, 2.5), direction: Angle(17.3)))], \
             trace: (max_depth: 100000))"
        ));
        visit(&compile(&scene.unwrap()).unwrap().system, &mut lengths);
    }
    at_least("mirror bounces", f64::from(lengths.hits), 3e5);
    at_most("mirror bounces: length of a direction off 1", lengths.worst, 4e-16);
}

/// Counts, balance, and how many segments have no children.
struct Leaves {
    summary: Summary,
    leaves: u64,
}

impl Visitor for Leaves {
    fn segment(&mut self, ray: &TracedRay, segment: Segment) {
        self.leaves += u64::from(segment.ending != snellius::Ending::Interface);
        self.summary.segment(ray, segment);
    }
}

#[test]
fn the_power_balance_closes_over_millions_of_leaves() {
    let segments = u64::from(size(300_000, 17_000_000));
    let scene = Scene::from_ron(
        "(bodies: [(shape: Rectangle(20, 14), surface: Mirror), (shape: Disk(3), at: (-4, 1), medium: Index(1.7)), \
         (shape: Prism(apex_angle: 50, side: 7), at: (4, -1), rotate: 11, medium: Index(1.5))], \
         sources: [(power: 0.7, light: Fan(from: (-9, -4), direction: Angle(20), spread: 50, rays: 7))], \
         trace: (min_power: 1e-9, max_depth: 1000))",
    );
    let mut scene = scene.unwrap();
    scene.trace.max_segments = segments;
    let limits = Limits::default().with(Limit::Segments, segments);
    let system = compile_within(&scene, &limits).unwrap().system;
    let mut leaves = Leaves { summary: Summary::new(&system), leaves: 0 };
    visit(&system, &mut leaves);
    #[expect(clippy::cast_precision_loss, reason = "a count far below 2^53")]
    at_least("power balance: leaves", leaves.leaves as f64, f64::from(size(100_000, 8_000_000)));
    let off = leaves.summary.balance.residual().abs() / leaves.summary.balance.emitted.value();
    at_most("power balance: residual in u of what was emitted", off / U, 4.0);
}

#[test]
fn a_light_guide_keeps_ten_thousand_total_reflections() {
    let run = run_text(
        "(bodies: [(shape: Rectangle(40000, 1), medium: Index(1.49))], trace: (max_depth: 10001), \
         sources: [(light: Ray(from: (-19000, 0.125), direction: Towards((-18996, 3.125))))])",
    );
    let segments = &run.trace.tree.rays[0].segments;
    let kept = segments.iter().filter(|s| s.via == Via::TotalInternalReflection && s.power.total() == 1.0).count();
    at_least("light guide: total reflections without loss", f64::from(u32::try_from(kept).unwrap()), 1e4);
    // Unfolded, the way is straight: x grows by 4/3 from one side to the other.
    let last = &segments[10_000];
    let exact = -19_000.0 + 0.375 * 4.0 / 3.0 + 9_999.0 * 4.0 / 3.0;
    let off = (last.from.x - exact).abs() / 20_000.0 / U;
    at_most("light guide: place after 1e4 reflections in u of the length and hit", off / 1e4, 1.0);
}

/// A mirrored heptagon with glass triangles in it, which no light leaves.
fn labyrinth(random: &mut Random) -> Vec<Body> {
    let corners = [(0.0, 0.0), (9.0, -2.0), (15.0, 3.0), (16.0, 9.0), (10.0, 15.0), (3.0, 14.0), (-3.0, 6.0)];
    let walls = body(Shape::Polygon(corners.map(DVec2::from).to_vec()), Substance::Surface(Surface::Mirror));
    let places = [(3.0, 3.5), (10.0, 2.5), (7.0, 7.5), (4.0, 11.0), (12.0, 9.0)];
    let triangles = places.into_iter().map(|place| {
        let side = 1.0 + 1.5 * random.unit();
        let glass = Substance::Medium(Medium::Index(1.2 + 0.6 * random.unit()));
        let shape = Shape::Prism { apex_angle: 30.0 + 60.0 * random.unit(), side };
        body(shape, glass).placed(DVec2::from(place), 360.0 * random.unit())
    });
    std::iter::once(walls).chain(triangles).collect()
}

fn children<'a>(ray: &'a TracedRay, of: &Segment) -> impl Iterator<Item = &'a Segment> + use<'a> {
    let parent = Some(of.id);
    ray.segments.iter().filter(move |child| child.parent == parent)
}

/// The path of the brighter branch at every hit.
fn brightest(ray: &TracedRay) -> Vec<&Segment> {
    let next = |last: &&Segment| children(ray, last).max_by(|a, b| a.power.total().total_cmp(&b.power.total()));
    std::iter::successors(ray.segments.first(), next).collect()
}

/// How far beside its start the light comes back, in sizes of the scene, that is sent back on the brightest path after so
/// many hits; infinite where it finds another way.
fn missed(scene: &Scene, hits: usize) -> f64 {
    let there = run_scene(scene.clone());
    let way = brightest(&there.trace.tree.rays[0]);
    let Some(Segment { from, to: Some(to), direction, .. }) = way.get(hits) else { return f64::INFINITY };
    // Aimed at a point far behind: a near one, rounded, would turn the ray.
    let turned = from.midpoint(*to);
    let mut scene = scene.clone();
    scene.sources = vec![towards(turned, turned - 64.0 * *direction)];
    let back = run_scene(scene);
    let ray = &back.trace.tree.rays[0];
    let home = way[1..=hits]
        .iter()
        .rev()
        .try_fold(&ray.segments[0], |last, turned| children(ray, last).find(|child| child.via == turned.via));
    home.map_or(f64::INFINITY, |home| (way[0].from - home.from).perp_dot(home.direction).abs() / 16.0)
}

#[test]
fn a_path_sent_back_returns() {
    let mut random = Random(14);
    for (hits, bound) in [(20_u32, 1e-13), (100, 2e-12)] {
        let mut off: Vec<f64> = Vec::new();
        for _ in 0..size(200, 1_000) {
            let bodies = labyrinth(&mut random);
            let light = Light::Ray { from: DVec2::new(7.0, 4.5), direction: Direction::Angle(360.0 * random.unit()) };
            let mut scene = Scene::new(bodies, vec![source(light)]);
            (scene.trace.max_depth, scene.trace.min_power) = (hits + 1, 1e-4);
            off.push(missed(&scene, usize::try_from(hits).unwrap()));
        }
        off.sort_by(f64::total_cmp);
        counted(&format!("time reversal: paths of {hits} hits"), f64::from(u32::try_from(off.len()).unwrap()));
        counted(&format!("time reversal: median after {hits} hits"), off[off.len() / 2]);
        at_most(&format!("time reversal: 99th percentile after {hits} hits"), off[off.len() * 99 / 100], bound);
    }
}
