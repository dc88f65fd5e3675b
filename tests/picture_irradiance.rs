//! How the light on screens is spread along them, beside the scene.

#![allow(clippy::unwrap_used, clippy::float_cmp, reason = "a test stops at the first surprise")]

mod support;

use snellius::diagram;
use snellius::drawing::{Color, Drawing, Group, Item, PathStep, Rect, Shape, Text};
use snellius::glam::DVec2;
use snellius::scene::Theme;
use support::{Run, run, run_scene, run_text};

fn drawn(run: &Run) -> Drawing {
    diagram::draw(&run.scene, &run.system, &run.trace.tree)
}

fn figure(scene: &str) -> Drawing {
    drawn(&run_text(scene))
}

/// A beam along +x onto an upright screen.
fn beam(rays: usize, settings: &str) -> String {
    format!(
        "(bodies: [(name: \"wall\", shape: Flat(from: (40, -10), to: (40, 10)), surface: Screen)],
        sources: [(light: Beam(center: (-40, 5), direction: Angle(0), width: 4, rays: {rays}))],
        diagram: (view: Box((-40, -12), (42, 12)), {settings}))"
    )
}

fn plots(drawing: &Drawing) -> Vec<&Group> {
    let groups = drawing.items.iter().filter_map(|item| if let Item::Group(group) = item { Some(group) } else { None });
    groups.filter(|group| group.class == "irradiance").collect()
}

fn texts(items: &[Item]) -> Vec<&Text> {
    let of = items.iter().map(|item| match item {
        Item::Text(text) => vec![text],
        Item::Group(group) => texts(&group.items),
        _ => Vec::new(),
    });
    of.flatten().collect()
}

fn words(group: &Group) -> Vec<String> {
    texts(&group.items).into_iter().map(|text| text.spans[0].text.clone()).collect()
}

/// The shapes of a class among some items.
fn shapes<'a>(items: &'a [Item], class: &str) -> Vec<&'a Shape> {
    let of = |item: &'a Item| match item {
        Item::Shape(shape) if shape.class == class => vec![shape],
        Item::Group(group) => shapes(&group.items, class),
        _ => Vec::new(),
    };
    items.iter().flat_map(of).collect()
}

fn points(shape: &Shape) -> Vec<DVec2> {
    let point = |step: &PathStep| match *step {
        PathStep::MoveTo(p) | PathStep::LineTo(p) => Some(p),
        _ => None,
    };
    shape.path.steps().iter().filter_map(point).collect()
}

fn bounds(points: &[DVec2]) -> Rect {
    let first = Rect { min: points[0], max: points[0] };
    points.iter().fold(first, |rect, p| Rect { min: rect.min.min(*p), max: rect.max.max(*p) })
}

#[test]
fn sixteen_branches_make_a_curve() {
    let count = |scene: &str| plots(&figure(scene)).len();
    assert_eq!(count(&beam(16, "")), 1);
    assert_eq!(count(&beam(15, "")), 0);
    assert_eq!(count(&beam(16, "irradiance: false")), 0);
    assert_eq!(count(&beam(16, "size: (400, 240)")), 1);
    assert_eq!(count(&beam(16, "size: (399, 240)")), 0, "too narrow");
    assert_eq!(count(&beam(16, "size: (400, 239)")), 0, "too low");
}

#[test]
fn the_scene_makes_room() {
    let [without, with] = [beam(15, ""), beam(16, "")].map(|scene| figure(&scene));
    let screen = |drawing: &Drawing| bounds(&points(shapes(&drawing.items, "surface screen")[0]));
    assert!(screen(&with).max.x < screen(&without).max.x - 150.0);
    let plot = plots(&with)[0];
    assert!(texts(&plot.items).iter().all(|text| text.bounds().min.x > screen(&with).max.x));
    assert!(texts(&plot.items).iter().all(|text| text.bounds().max.x < 960.0));
}

/// The axis is as high as the screen, and the curve stands where the light landed.
#[test]
fn a_curve_stands_at_the_heights_of_its_upright_screen() {
    for screen in ["from: (40, -10), to: (40, 10)", "from: (40, 10), to: (40, -10)"] {
        let drawing = figure(&beam(16, "").replace("from: (40, -10), to: (40, 10)", screen));
        let screen = bounds(&points(shapes(&drawing.items, "surface screen")[0]));
        let axis = points(shapes(&plots(&drawing)[0].items, "axis")[0]);
        let mut ends = [axis[0].y, axis[1].y];
        ends.sort_by(f64::total_cmp);
        assert!((ends[0] - screen.min.y).abs() < 0.1 && (ends[1] - screen.max.y).abs() < 0.1, "{ends:?} {screen:?}");
        let curve = bounds(&points(shapes(&plots(&drawing)[0].items, "curve")[0]));
        let per_mm = screen.size().y / 20.0;
        // The beam is 4 mm wide about y = 5, and half a step more on each side.
        let step = 4.0 / 15.0;
        let center = screen.max.y - 15.0 * per_mm;
        assert!((curve.center().y - center).abs() < 0.6, "{curve:?}");
        assert!((curve.size().y - (4.0 + step) * per_mm).abs() < 20.0 / 240.0 * per_mm + 0.2, "{curve:?}");
    }
}

/// The value's line stands at its share of the largest value, which reaches the end.
#[test]
fn values_and_positions_are_told() {
    let drawing = figure(&beam(16, ""));
    let plot = plots(&drawing)[0];
    assert_eq!(words(plot), ["wall", "0.2/mm", "0 mm", "5", "10", "15", "20"]);
    let curve = bounds(&points(shapes(&plot.items, "curve")[0]));
    let line = bounds(&points(shapes(&plot.items, "")[0])).min.x;
    let most = 1.0 / (4.0 + 4.0 / 15.0);
    assert!(((line - curve.min.x) / curve.size().x - 0.2 / most).abs() < 0.01);
    let unnamed = beam(16, "").replace("name: \"wall\", ", "");
    assert_eq!(words(plots(&figure(&unnamed))[0])[0], "screen");
    let long = beam(16, "").replace("wall", "a wall with a name of many words");
    assert!(words(plots(&figure(&long))[0])[0].ends_with('…'));
}

#[test]
fn each_line_has_its_color_and_in_print_its_dashes() {
    let scene = |theme: &str| {
        beam(6, &format!("theme: {theme}")).replace("rays: 6)", "rays: 6), spectrum: Lines([450, 550, 650])")
    };
    for (theme, dashes) in [("Light", 1), ("Dark", 1), ("Print", 3)] {
        let drawing = figure(&scene(theme));
        let strokes: Vec<_> =
            shapes(&plots(&drawing)[0].items, "curve").into_iter().map(|shape| shape.stroke.clone().unwrap()).collect();
        let mut colors: Vec<Color> = strokes.iter().map(|stroke| stroke.color).collect();
        colors.dedup();
        assert_eq!(colors.len(), 3, "{theme}");
        let mut found: Vec<_> = strokes.iter().map(|stroke| format!("{:?}", stroke.dash)).collect();
        found.sort();
        found.dedup();
        assert_eq!(found.len(), dashes, "{theme}");
    }
}

const MIXED: &str = "(
    title: \"Mixed screens\",
    bodies: [
        (name: \"floor under all of it\", shape: Flat(from: (30, -30), to: (-40, -30)), surface: Screen),
        (shape: Lens(radii: (40, -40), thickness: 8, diameter: 30), at: (0, 10), medium: Catalog(\"N-SF11\")),
        (name: \"wall\", shape: Flat(from: (50, 30), to: (40, -20)), surface: Screen),
        (name: \"ring\", shape: Disk(6), at: (-40, 20), surface: Screen),
    ],
    sources: [
        (light: Fan(from: (-30, 10), direction: Angle(0), spread: 50, rays: 30), spectrum: White(samples: 12)),
        (light: Point(at: (-20, -10), rays: 300), spectrum: Line(589.3)),
    ],
    trace: (secondary_rays: TransmittedOnly),
)";

/// A floor's positions run to the left, as it was written, and a screen beside another gets the next place.
#[test]
fn screens_that_do_not_stand_upright_come_one_below_the_other() {
    let drawing = figure(MIXED);
    let plots = plots(&drawing);
    let titles: Vec<_> = plots.iter().map(|plot| words(plot)[0].clone()).collect();
    assert_eq!(titles, ["floor under all of it", "wall", "ring"]);
    let tops: Vec<_> = plots.iter().map(|plot| texts(&plot.items)[0].at.y).collect();
    assert!(tops.windows(2).all(|pair| pair[1] > pair[0] + 80.0));
    let floor = points(shapes(&plots[0].items, "axis")[0]);
    assert!(floor[0].x > floor[1].x && floor[0].y == floor[1].y);
    let wall = points(shapes(&plots[1].items, "axis")[0]);
    assert!(wall[0].y < wall[1].y && wall[0].x == wall[1].x);
}

/// Two upright screens, the second partly at the heights of the first.
const SIDE_BY_SIDE: &str = "(
    bodies: [
        (name: \"near\", shape: Flat(from: (20, -10), to: (20, 2)), surface: Screen),
        (name: \"far\", shape: Flat(from: (40, -1), to: (40, 12)), surface: Screen),
    ],
    sources: [(light: Beam(center: (-40, 0), direction: Angle(0), width: 20, rays: 60))],
)";

#[test]
fn curves_of_screens_at_the_same_heights_stand_apart() {
    let drawing = figure(SIDE_BY_SIDE);
    let axes: Vec<_> = plots(&drawing).iter().map(|plot| bounds(&points(shapes(&plot.items, "axis")[0]))).collect();
    assert_eq!(axes.len(), 2);
    assert!(axes[0].max.y + 20.0 < axes[1].min.y, "{axes:?}");
}

#[test]
fn no_words_overlap_or_leave_the_figure() {
    let dim = beam(40, "").replace("rays: 40)", "rays: 40), power: 0.002");
    let scenes = [
        run_text(SIDE_BY_SIDE).scene,
        run_text(&dim).scene,
        run_text(MIXED).scene,
        run_text(&beam(40, "grid: true, scale_bar: true")).scene,
        run("prisms/hydrogen-lines").scene,
        run("lenses/caustic-on-screen").scene,
        run("lenses/facets").scene,
    ];
    let mut curves = 0;
    for scene in scenes {
        for size in [[320, 240], [400, 240], [480, 300], [640, 400], [960, 540], [1920, 1080], [400, 1200]] {
            for theme in [Theme::Light, Theme::Dark, Theme::Print] {
                let mut scene = scene.clone();
                (scene.diagram.size, scene.diagram.theme) = (size, theme);
                let drawing = drawn(&run_scene(scene.clone()));
                let plots = plots(&drawing);
                let own: Vec<&Text> = plots.iter().flat_map(|plot| texts(&plot.items)).collect();
                let whole = Rect { min: DVec2::ZERO, max: DVec2::new(f64::from(size[0]), f64::from(size[1])) };
                for text in &own {
                    let bounds = text.bounds();
                    let what = format!("{} {size:?}: {text:?}", scene.title);
                    assert!(whole.contains(bounds.min) && whole.contains(bounds.max), "{what} leaves");
                    let others = texts(&drawing.items).into_iter().filter(|other| !std::ptr::eq(*other, *text));
                    let hit = others.into_iter().find(|other| other.bounds().overlaps(&bounds.grown(-0.5)));
                    assert!(hit.is_none(), "{what} overlaps {hit:?}");
                }
                curves += plots.len();
            }
        }
    }
    assert!(curves > 80, "{curves} curves");
}

#[test]
fn no_scale_or_place_breaks_a_curve() {
    for (scale, at) in [(1e-12, 0.0), (1.0, 1e9), (1e12, 1.0), (1e-3, -1e6)] {
        let [x, y, width] = [at - 40.0 * scale, at, 4.0 * scale];
        for screen in [[40.0, -10.0, 40.0, 10.0], [40.0, -3.0, 40.0, 3.0], [50.0, -10.0, 40.0, 5.0]] {
            let [a, b, c, d] = screen.map(|value| at + scale * value);
            let drawing = figure(&format!(
                "(bodies: [(shape: Flat(from: ({a:?}, {b:?}), to: ({c:?}, {d:?})), surface: Screen)],
                sources: [(light: Beam(center: ({x:?}, {y:?}), direction: Angle(0), width: {width:?}, rays: 20))])"
            ));
            let curve = points(shapes(&plots(&drawing)[0].items, "curve")[0]);
            assert!(curve.len() > 3 && curve.iter().all(|p| p.is_finite()));
            let inside = Rect { min: DVec2::ZERO, max: DVec2::new(960.0, 540.0) };
            assert!(curve.iter().all(|p| inside.contains(*p)), "{scale:e} {at:e}");
        }
    }
}
