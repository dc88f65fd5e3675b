//! Angles at the hits: their arcs, their values, and that none is lost and none stands on another.

#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

mod support;

use snellius::diagram;
use snellius::drawing::{Drawing, Group, Item, Rect, Text};
use snellius::glam;
use snellius::numerics::tan_degrees;
use snellius::scene::{Light, Substance, Surface};
use snellius::trace::{Segment, TracedRay};
use support::{Run, run_scene, run_text};

fn figure(run: &Run) -> Drawing {
    diagram::draw(&run.scene, &run.system, &run.trace.tree)
}

/// A ray onto the flat face of glass, at an angle from its normal, from above.
fn onto_glass(angle: f64, settings: &str) -> String {
    let body = "(shape: Rectangle(200, 60), at: (0, -30), medium: Index(1.5))";
    let source = format!("(light: Ray(from: {}, direction: Towards((0, 0))))", away(angle, 50.0));
    format!("(bodies: [{body}], sources: [{source}], trace: (max_depth: 1), {settings})")
}

/// A ray inside of glass onto its upper face.
fn out_of_glass(angle: f64) -> String {
    let body = "(shape: Rectangle(200, 100), at: (0, -50), medium: Index(1.5))";
    let [x, y] = [-40.0 * tan_degrees(angle), -40.0];
    format!(
        "(bodies: [{body}], sources: [(light: Ray(from: ({x}, {y}), direction: Angle({})))], trace: (max_depth: 1))",
        90.0 - angle
    )
}

/// A point from which light comes down to the origin at an angle from the vertical.
fn away(angle: f64, height: f64) -> String {
    format!("({}, {height})", -height * tan_degrees(angle))
}

fn groups<'a>(items: &'a [Item], class: &str) -> Vec<&'a Group> {
    let group = |item: &'a Item| if let Item::Group(group) = item { Some(group) } else { None };
    items.iter().filter_map(group).filter(|group| group.class == class).collect()
}

/// The marks of hits: of each those that come with the light that arrives and those that come with the light that leaves.
fn angles(drawing: &Drawing) -> Vec<Group> {
    let generations = groups(&drawing.items, "angles").into_iter().flat_map(|layer| groups(&layer.items, "generation"));
    let mut hits: Vec<Group> = Vec::new();
    for part in generations.flat_map(|generation| groups(&generation.items, "angle")) {
        match hits.iter_mut().find(|hit| hit.data == part.data) {
            Some(hit) => hit.items = [&hit.items[..], &part.items].concat().into(),
            None => hits.push(part.clone()),
        }
    }
    hits
}

fn texts(items: &[Item]) -> Vec<&Text> {
    items.iter().flat_map(texts_of).collect()
}

fn texts_of(item: &Item) -> Vec<&Text> {
    match item {
        Item::Text(text) => vec![text],
        Item::Group(group) => texts(&group.items),
        _ => Vec::new(),
    }
}

fn words(text: &Text) -> String {
    text.spans.iter().map(|span| span.text.as_str()).collect::<String>().replace(['\u{a0}', '\u{202f}'], " ")
}

/// What stands at the hits of a scene, and below the figure.
fn values(scene: &str) -> Vec<String> {
    let drawing = figure(&run_text(scene));
    let hits = angles(&drawing);
    let marks = hits.iter().flat_map(|group| texts(&group.items)).map(words);
    let below = groups(&drawing.items, "key").into_iter().flat_map(|key| texts(&key.items));
    marks.chain(below.filter(|text| text.class != "legend").map(words)).collect()
}

#[test]
fn a_hit_shows_both_angles() {
    assert_eq!(values(&onto_glass(45.0, "")), ["θ1 = 45.0°", "θ2 = 28.1°", "5.0 %", "95.0 %"]);
    assert_eq!(values(&onto_glass(30.0, ""))[..2], ["θ1 = 30.0°", "θ2 = 19.5°"]);
    assert_eq!(values(&out_of_glass(30.0))[..2], ["θ1 = 30.0°", "θ2 = 48.6°"]);
    assert!(values(&onto_glass(45.0, "diagram: (angles: false)")).is_empty());
    assert!(values(&onto_glass(0.0, "")).is_empty(), "nothing to see at perpendicular incidence");
}

#[test]
fn shares_are_those_of_the_light_that_arrives() {
    let slab = |faintest: &str| {
        let source = "(light: Ray(from: (-60, 60), direction: Angle(-45)))";
        let body = "(shape: Rectangle(400, 40), medium: Index(1.5))";
        values(&format!("(bodies: [{body}], sources: [{source}], diagram: (faintest: {faintest}))"))
    };
    let shares = |values: Vec<String>| values.into_iter().filter(|value| value.ends_with('%')).collect::<Vec<_>>();
    assert_eq!(shares(slab("0.5")), ["95.0 %", "95.2 %"], "of light that has more p than at first");
    assert!(shares(slab("0.00001")).is_empty(), "only where few hits are marked");
    assert_eq!(shares(values(&out_of_glass(50.0))), [""; 0], "all of it is reflected");
}

#[test]
fn total_reflection_has_a_badge() {
    let drawing = figure(&run_text(&out_of_glass(50.0)));
    let badges = |items: &[Item]| {
        let is_badge =
            |item: &&Item| matches!(item, Item::Shape(shape) if shape.class == "badge" && shape.fill.is_some());
        items.iter().filter(is_badge).count()
    };
    assert_eq!(angles(&drawing).iter().map(|mark| badges(&mark.items)).sum::<usize>(), 1);
    let drawing = figure(&run_text(&out_of_glass(30.0)));
    assert_eq!(angles(&drawing).iter().map(|mark| badges(&mark.items)).sum::<usize>(), 0);
}

#[test]
fn remarkable_angles_are_told() {
    assert_eq!(values(&out_of_glass(50.0)), ["TIR", "θ1 = 50.0° > θc = 41.8°"]);
    assert_eq!(values(&out_of_glass(41.79))[..2], ["θ1 = θc = 41.8°", "θ2 = 88.4°"]);
    assert_eq!(values(&out_of_glass(41.83)), ["θ1 = θc = 41.8°"]);
    assert_eq!(values(&onto_glass(56.31, ""))[..2], ["θ1 = θB = 56.3°", "θ2 = 33.7°"]);
    assert_eq!(values(&onto_glass(56.2, ""))[..2], ["θ1 = 56.2°", "θ2 = 33.6°"]);
}

#[test]
fn mirrors_show_the_angle_and_thin_lenses_none() {
    let flat = |surface: &str| {
        let source = format!("(light: Ray(from: {}, direction: Towards((0, 0))))", away(35.0, 50.0));
        format!("(bodies: [(shape: Flat(from: (-50, 0), to: (50, 0)), surface: {surface})], sources: [{source}])")
    };
    assert_eq!(values(&flat("Mirror")), ["θ1 = 35.0°"]);
    assert!(values(&flat("ThinLens(focal_length: 40)")).is_empty());
    assert!(values(&flat("Screen")).is_empty());
    let arcs = figure(&run_text(&flat("Mirror")));
    assert_eq!(angles(&arcs)[0].items.len(), 3, "arcs of both rays and a value");
}

#[test]
fn one_of_many_parallel_rays_is_marked() {
    let scene = |light: &str| {
        let body = "(shape: Rectangle(200, 60), at: (0, -30), medium: Index(1.5))";
        format!("(bodies: [{body}], sources: [(light: {light})], trace: (max_depth: 1))")
    };
    let beam = "Beam(center: (-40, 40), direction: Angle(-45), width: 30, rays: 7)";
    assert_eq!(
        values(&scene(beam)),
        ["1", "1: θ1 = 45.0°, θ2 = 28.1°"],
        "below, since between the rays there is no room"
    );
    assert!(values(&scene("Point(at: (0, 40), rays: 90)")).is_empty());
    assert_eq!(
        values(&scene("Fan(from: (0, 40), direction: Angle(-80), spread: 20, rays: 2)"))
            .iter()
            .filter(|value| value.contains('θ'))
            .count(),
        2
    );
}

/// Every rectangle of words in the figure.
fn boxes(drawing: &Drawing) -> Vec<(String, Rect)> {
    texts(&drawing.items).into_iter().map(|text| (words(text), text.bounds())).collect()
}

#[test]
fn no_words_overlap_or_leave_the_frame_and_no_hit_is_lost() {
    let mut marked = 0;
    for name in support::scene_names() {
        for (size, all) in [([960, 540], false), ([640, 400], false), ([1600, 900], false), ([960, 540], true)] {
            let mut scene = support::run(&name).scene;
            let diagram = &mut scene.diagram;
            diagram.size = size;
            if all {
                (diagram.grid, diagram.scale_bar, diagram.protractor) = (true, true, true);
                (diagram.focal_points, diagram.principal_planes) = (true, true);
            }
            let run = run_scene(scene);
            let drawing = figure(&run);
            let boxes = boxes(&drawing);
            let frame = Rect { min: glam::DVec2::ZERO, max: glam::DVec2::new(f64::from(size[0]), f64::from(size[1])) };
            for (k, (text, rect)) in boxes.iter().enumerate() {
                assert!(
                    frame.contains(rect.min) && frame.contains(rect.max),
                    "{name} {size:?}: {text} leaves the frame"
                );
                let other = boxes[..k].iter().find(|(_, other)| other.overlaps(&rect.grown(-0.5)));
                assert!(other.is_none(), "{name} {size:?}: {text} overlaps {other:?}");
            }
            marked += lost_hits(&name, &run, &drawing);
        }
    }
    assert!(marked > 120, "{marked} hits");
}

/// Checks that every hit that matters has its values, in its place or below the figure; returns how many have.
fn lost_hits(name: &str, run: &Run, drawing: &Drawing) -> usize {
    let marks = angles(drawing);
    let below: Vec<_> =
        groups(&drawing.items, "key").into_iter().flat_map(|key| texts(&key.items)).map(words).collect();
    for mark in &marks {
        let values: Vec<_> = texts(&mark.items).into_iter().map(words).collect();
        let first = values.first().unwrap_or_else(|| panic!("{name}: {:?} has no value", mark.data));
        let is_below = first
            .parse::<u32>()
            .is_ok_and(|n| below.iter().any(|line| line.starts_with(&format!("{n}: ")) && line.contains("θ1 ")));
        let is_in_place = values.iter().any(|value| value.contains("θ1"));
        assert!(is_in_place || is_below, "{name}: {values:?} of {:?}, below {below:?}", mark.data);
    }
    let addresses: Vec<_> = marks.iter().map(|mark| mark.data[0].1.clone()).collect();
    let places: Vec<_> = hits(run).filter(|(ray, segment)| addresses.contains(&ray.address(segment.id))).collect();
    assert_eq!(places.len(), marks.len(), "{name}: {addresses:?}");
    if run.scene.diagram.angles && marks.len() < 12 && run.scene.diagram.view == snellius::scene::View::Auto {
        for (ray, segment) in hits(run).filter(|(_, segment)| matters(run, segment)) {
            let at = segment.to.unwrap();
            let near = |(_, other): &&(&TracedRay, &Segment)| other.to.unwrap().distance(at) < 0.05 * extent(run);
            assert!(places.iter().any(|place| near(&place)), "{name}: {} is not marked", ray.address(segment.id));
        }
    }
    marks.len()
}

/// Hits of single rays at one line.
fn hits(run: &Run) -> impl Iterator<Item = (&TracedRay, &Segment)> {
    let segments = run.trace.tree.rays.iter().flat_map(|ray| ray.segments.iter().map(move |segment| (ray, segment)));
    segments.filter(|(_, segment)| segment.hit.is_some())
}

/// Whether the angles of a hit are told, for a source of one ray at one line and a refracting face.
fn matters(run: &Run, segment: &Segment) -> bool {
    let hit = segment.hit.unwrap();
    let is_single = run.scene.sources.iter().all(|source| matches!(source.light, Light::Ray { .. }))
        && run.trace.tree.rays.iter().all(|ray| !ray.one_of_several_lines);
    let is_medium =
        matches!(run.scene.bodies[hit.body].substance, Substance::Medium(_) | Substance::Surface(Surface::Mirror));
    let share = segment.power.total() / run.trace.tree.rays[0].power;
    is_single
        && is_medium
        && share >= run.scene.diagram.faintest
        && hit.theta_i_degrees() > 2.0
        && hit.n_t != Some(hit.n_i)
}

/// About the size of what is seen.
fn extent(run: &Run) -> f64 {
    let ends = run.trace.tree.rays.iter().flat_map(|ray| ray.segments.iter().map(|segment| segment.from));
    let (min, max) = ends.fold((glam::DVec2::MAX, glam::DVec2::MIN), |(min, max), p| (min.min(p), max.max(p)));
    (max - min).max_element()
}

/// The entries of the legend.
fn legend(scene: &str) -> Vec<String> {
    let drawing = figure(&run_text(scene));
    let below = groups(&drawing.items, "key").into_iter().flat_map(|key| texts(&key.items));
    below.filter(|text| text.class == "legend").map(words).collect()
}

#[test]
fn the_legend_tells_what_the_figure_needs() {
    let scene = |spectrum: &str, settings: &str| {
        let body = "(shape: Rectangle(200, 60), at: (0, -30), medium: Catalog(\"N-BK7\"))";
        let source = format!("(light: Ray(from: (-40, 40), direction: Angle(-45)), spectrum: {spectrum})");
        format!("(bodies: [{body}], sources: [{source}], {settings})")
    };
    let quiet = "trace: (secondary_rays: TransmittedOnly)";
    assert!(legend(&scene("Line(589.3)", quiet)).is_empty());
    assert_eq!(legend(&scene("Lines([486.1327, 656.2725])", quiet)), ["486.1 nm", "656.3 nm"]);
    let shares = ["100 %", "10 % of a source's ray", "3 branches below 1 % are not drawn"];
    assert_eq!(legend(&scene("Line(589.3)", "")), shares);
    assert!(legend(&scene("Line(589.3)", "diagram: (legend: false)")).is_empty());
    let ways = ["source", "transmission", "reflection", "100 %", "10 % of a source's ray"];
    assert_eq!(legend(&scene("Line(589.3)", "trace: (max_depth: 1), diagram: (color: Via)")), ways);
}

#[test]
fn in_a_small_figure_the_legend_gives_way() {
    let scene = |size: &str| {
        let bodies: String =
            (0..4).map(|k| format!("(shape: Rectangle(3, 60), at: ({}, 0), medium: Index(1.5)),", 5 * k)).collect();
        format!(
            "(bodies: [{bodies}], sources: [(light: Ray(from: (-30, 12), direction: Angle(-30)))],
            diagram: (size: {size}, faintest: 0.02))"
        )
    };
    let lines = |size: &str| {
        let drawing = figure(&run_text(&scene(size)));
        let key =
            groups(&drawing.items, "key").into_iter().flat_map(|key| texts(&key.items)).cloned().collect::<Vec<_>>();
        (key.iter().filter(|text| text.class == "legend").count(), key.len())
    };
    assert!(lines("(960, 540)").0 > 1);
    let (legend, all) = lines("(400, 260)");
    assert!(legend == 0 && all > 3, "{legend} of {all}");
}
