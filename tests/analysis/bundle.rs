//! Where rays meet.

use snellius::analysis::{Axis, Bundle, Confusion, ImageKind, images, paraxial};
use snellius::glam::DVec2;
use snellius::light::Wavelength;
use snellius::trace::{RayTree, trace};
use snellius::{Scene, compile};

use crate::support::tables::close;

fn tree(fields: &str) -> RayTree {
    let settings = "trace: (secondary_rays: TransmittedOnly)";
    trace(&compile(&Scene::from_ron(&format!("({fields}, {settings})")).unwrap()).unwrap().system).tree
}

/// A beam along +x onto a body.
fn beam(body: &str, width: f64, rays: usize) -> RayTree {
    let light = format!("Beam(center: (-100, 0), direction: Angle(0), width: {width}, rays: {rays})");
    tree(&format!("bodies: [({body})], sources: [(light: {light}, spectrum: Line(587.5618))]"))
}

const THIN_LENS: &str = "shape: Flat(from: (0, -20), to: (0, 20)), surface: ThinLens(focal_length: 40)";
const DIVERGING: &str = "shape: Flat(from: (0, -20), to: (0, 20)), surface: ThinLens(focal_length: -40)";
const HOLLOW: &str = "shape: Arc(from: (0, -100), through: (100, 0), to: (0, 100)), surface: Mirror";

#[test]
fn an_ideal_lens_gathers_parallel_light_in_a_point() {
    for width in [30.0, 1e-3] {
        let bundle = Bundle::of(&beam(THIN_LENS, width, 7), 0, "t");
        assert_eq!(bundle.rays().len(), 7);
        let focus = bundle.focus().unwrap();
        assert!(focus.at.distance(DVec2::new(40.0, 0.0)) < 1e-9 && focus.spread < 1e-13, "{focus:?}");
        assert_eq!(focus.kind, ImageKind::Real);
        let waist = bundle.least_confusion().unwrap();
        assert!(waist.at.distance(DVec2::new(40.0, 0.0)) < 1e-9 && waist.diameter < 1e-13, "{waist:?}");
    }
    let focus = Bundle::of(&beam(DIVERGING, 30.0, 7), 0, "t").focus().unwrap();
    assert!(focus.at.distance(DVec2::new(-40.0, 0.0)) < 1e-12, "{focus:?}");
    assert_eq!(focus.kind, ImageKind::Virtual);
}

#[test]
fn parallel_rays_and_single_ones_have_no_focus() {
    let slab = beam("shape: Rectangle(5, 60), rotate: 20, medium: Index(1.5)", 20.0, 9);
    for bundle in [Bundle::of(&slab, 0, ""), Bundle::of(&slab, 0, "tt"), Bundle::of(&beam(THIN_LENS, 9.0, 1), 0, "t")] {
        assert!(!bundle.rays().is_empty());
        assert_eq!((bundle.focus(), bundle.least_confusion()), (None, None));
    }
    for path in ["r", "tttt", "x"] {
        let none = Bundle::of(&slab, 0, path);
        assert!(none.rays().is_empty() && none.focus().is_none() && none.least_confusion().is_none());
    }
    assert_eq!(Bundle::of(&slab, 1, "t").direction(), None);
}

/// The least width of a bundle found by trying.
fn tried(bundle: &Bundle, best: &Confusion) -> f64 {
    let width = |x: f64| {
        let heights = bundle.rays().iter().map(|ray| {
            let along = best.at + x * best.direction - ray.from;
            let cos = ray.direction.dot(best.direction);
            let met = ray.from + along.dot(best.direction) / cos * ray.direction;
            (met - best.at).dot(best.direction.perp())
        });
        let heights: Vec<f64> = heights.collect();
        let highest = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        highest - heights.iter().copied().fold(f64::INFINITY, f64::min)
    };
    (-20_000..=20_000).map(|k| width(1e-3 * f64::from(k))).fold(f64::INFINITY, f64::min)
}

#[test]
fn least_confusion_is_the_narrowest_place() {
    let lens = "shape: Lens(radii: (40, -70), thickness: 9, diameter: 34), rotate: 6, medium: Index(1.6)";
    for (body, path) in [(lens, "tt"), (HOLLOW, "r"), ("shape: Disk(20), medium: Index(1.4)", "tt")] {
        let bundle = Bundle::of(&beam(body, 28.0, 23), 0, path);
        assert_eq!(bundle.rays().len(), 23);
        let best = bundle.least_confusion().unwrap();
        let tried = tried(&bundle, &best);
        assert!(
            best.diameter > 0.0 && best.diameter <= tried + 1e-12 && best.diameter > tried - 1e-3,
            "{best:?}, {tried}"
        );
        let focus = bundle.focus().unwrap();
        assert!(focus.spread < best.diameter && focus.at.distance(best.at) < 20.0);
    }
}

/// Two rays on each side: the marginal pair crosses the next pair's lines at the least width.
#[test]
fn least_confusion_of_four_rays_in_closed_form() {
    let tree = beam(HOLLOW, 60.0, 4);
    let [outer, inner] = [0, 1].map(|ray| tree.rays[ray].segments[1]);
    // By symmetry the width is twice the larger height; heights of opposite signs meet where their sum is 0.
    let slope = |segment: &snellius::trace::Segment| segment.direction.y / segment.direction.x;
    let height = |segment: &snellius::trace::Segment| segment.from.y - slope(segment) * segment.from.x;
    let x = -(height(&outer) + height(&inner)) / (slope(&outer) + slope(&inner));
    let best = Bundle::of(&tree, 0, "r").least_confusion().unwrap();
    close(best.at.x, x, 1e-11, "x");
    close(best.at.y, 0.0, 1e-12, "y");
    close(best.diameter, 2.0 * (height(&outer) + slope(&outer) * x).abs(), 1e-12, "diameter");
}

/// A ray at height h onto a hollow mirror of radius R crosses the axis R/(2 cos α) from the center, sin α = h/R, since the
/// triangle of center, hit and crossing has two angles α. Caustic: Born & Wolf, section 3.2; Hecht, section 5.4.3.
#[test]
fn marginal_rays_of_a_hollow_mirror() {
    for half_width in [0.1_f64, 10.0, 60.0, 90.0] {
        let bundle = Bundle::of(&beam(HOLLOW, 2.0 * half_width, 21), 0, "r");
        let cos = (1.0 - half_width * half_width / 1e4).sqrt();
        let focus = bundle.marginal().focus().unwrap();
        assert!(focus.at.distance(DVec2::new(50.0 / cos, 0.0)) < 1e-9, "{half_width}: {focus:?}");
        assert!(focus.spread < 1e-12);
    }
}

/// The aberration grows as the square of the height. For n = 1.5 and light from infinity a thin plano-convex lens has 7/6 h²/f with
/// its curved side to the light and 9/2 h²/f turned round: Hecht, "Optics", 4th ed., section 6.3.1 and figure 6.18; Born &
/// Wolf, section 5.5.
#[test]
fn spherical_aberration_grows_with_the_square_of_the_height() {
    let aberration = |radii: &str, width: f64| {
        let body = format!("shape: Lens(radii: {radii}, thickness: 0.5, diameter: 8), medium: Index(1.5)");
        let scene = format!("(bodies: [({body})])");
        let system = compile(&Scene::from_ron(&scene).unwrap()).unwrap().system;
        let axis = Axis { from: DVec2::new(-9.0, 0.0), direction: DVec2::X };
        let focus = paraxial(&system, axis, Wavelength::D).unwrap().focal_points[1];
        focus.x - Bundle::of(&beam(&body, width, 5), 0, "tt").marginal().focus().unwrap().at.x
    };
    for radii in ["(200, -200)", "(100, inf)", "(inf, -100)"] {
        let [narrow, wide] = [2.0, 4.0].map(|width| aberration(radii, width));
        assert!(narrow > 0.0 && (wide / narrow - 4.0).abs() < 0.01, "{radii}: {narrow} and {wide}");
    }
    let (convex_first, plane_first) = (aberration("(100, inf)", 2.0), aberration("(inf, -100)", 2.0));
    close(convex_first * 200.0, 7.0 / 6.0, 0.02, "convex side to the light");
    close(plane_first * 200.0, 4.5, 0.02, "plane side to the light");
}

/// 1/f = 1/s + 1/s′, element by element.
#[test]
fn images_of_a_point_lens_by_lens() {
    let lens = |x: f64, f: f64| {
        format!("(shape: Flat(from: ({x}, -30), to: ({x}, 30)), surface: ThinLens(focal_length: {f}))")
    };
    let fields = |s: f64| {
        format!(
            "bodies: [{}, {}], sources: [(light: Fan(from: (-{s}, 4), direction: Angle(0), spread: 10, rays: 5),
            spectrum: Lines([500, 600]))]",
            lens(0.0, 40.0),
            lens(200.0, -25.0)
        )
    };
    let found = images(&tree(&fields(60.0)), 0);
    assert_eq!(found.iter().map(|image| image.path.as_str()).collect::<Vec<_>>(), ["t", "tt", "t", "tt"]);
    assert_eq!(found[2].wavelength.nanometers(), 600.0);
    let (first, second) = (found[0].focus, found[1].focus);
    // 1/40 − 1/60 = 1/120, magnified −2 times.
    assert!(first.at.distance(DVec2::new(120.0, -8.0)) < 1e-10 && first.spread < 1e-13, "{first:?}");
    // 80 before the second lens: 1/s′ = −1/25 − 1/80, virtual.
    let s = -1.0 / (1.0 / 25.0 + 1.0 / 80.0);
    assert!(second.at.distance(DVec2::new(200.0 + s, -8.0 * -s / 80.0)) < 1e-10, "{second:?}");
    assert_eq!([first.kind, second.kind], [ImageKind::Real, ImageKind::Virtual]);
    let at_focus = images(&tree(&fields(40.0)), 0);
    assert_eq!(
        at_focus.iter().map(|image| image.path.as_str()).collect::<Vec<_>>(),
        ["tt", "tt"],
        "parallel behind the first"
    );
}

#[test]
fn a_path_that_some_rays_do_not_share_has_no_image() {
    let scene =
        |width: f64| beam("shape: Flat(from: (0, -10), to: (0, 10)), surface: ThinLens(focal_length: 40)", width, 5);
    assert_eq!(images(&scene(19.0), 0).len(), 1);
    assert!(images(&scene(30.0), 0).is_empty());
    assert!(images(&RayTree::default(), 0).is_empty());
}

#[test]
fn images_go_on_behind_a_total_reflection() {
    let tree = tree(
        "bodies: [(shape: RightAnglePrism(40), medium: Index(1.5))],
        sources: [(light: Fan(from: (-30, 10), direction: Angle(0), spread: 0.002, rays: 3))]",
    );
    let found = images(&tree, 0);
    let paths: Vec<&str> = found.iter().map(|image| image.path.as_str()).collect();
    assert_eq!(paths, ["t", "ti", "tit"]);
    // 30 mm of air look like 45 in the glass, mirrored at the face x + y = 40; the way out of 10 mm of glass gives a third back.
    let [inside, mirrored, out] = [0, 1, 2].map(|place| found[place].focus.at);
    for (point, expected) in [(inside, (-45.0, 10.0)), (mirrored, (30.0, 85.0)), (out, (30.0, 85.0 / 1.5))] {
        assert!((point - DVec2::from(expected)).length() < 1e-3, "{point} is not {expected:?}");
    }
    assert!(found.iter().all(|image| image.focus.kind == ImageKind::Virtual));
}

#[test]
fn a_bundle_all_round_has_its_first_rays_direction() {
    let tree = tree("sources: [(light: Point(at: (3, 4), rays: 8))]");
    let bundle = Bundle::of(&tree, 0, "");
    assert_eq!(bundle.direction(), Some(DVec2::X));
    assert!((bundle.focus().unwrap().at - DVec2::new(3.0, 4.0)).length() < 1e-12);
}
