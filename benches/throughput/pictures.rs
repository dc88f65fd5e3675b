//! What a drawing costs beside the trace that it shows, and what keeping the tree costs.

use snellius::drawing::{Cap, Color, Drawing, Item, PathStep, Shape, Stroke};
use snellius::{Scene, diagram, render, retrace, summarize, trace};
use tiny_skia::{LineCap, LineJoin, Paint, PathBuilder, Pixmap, Transform};

use crate::contest::followed;
use crate::figures::Bound;
use crate::optics::{by_power, compile};
use crate::race::{Task, race};
use crate::scenes::slabs;
use crate::study::Study;
use crate::table::{Table, digits};

pub(crate) fn run(study: &mut Study) {
    let (scene, segments) = stack(study.size(5_000, 100_000));
    let system = compile(&scene).unwrap().system;
    let tree = trace(&system).tree;
    let drawing = diagram::draw(&scene, &system, &tree);
    let mut kept = trace(&system);
    let tasks = vec![
        Task::new("summarize", segments, || summarize(&system)),
        Task::new("trace", segments, || trace(&system)),
        Task::new("trace again", segments, || retrace(&system, &mut kept)),
        Task::new("draw", segments, || diagram::draw(&scene, &system, &tree)),
        Task::new("svg", segments, || render::svg(&drawing)),
        Task::new("png", segments, || render::png(&drawing, 1.0).unwrap()),
        Task::new("a stroke a segment", segments, || strokes(&drawing)),
    ];
    let times = race(study, tasks);
    let mut table = Table::new("pictures", &["step", "ns per segment"]);
    for step in ["summarize", "trace", "trace again", "draw", "svg", "png", "a stroke a segment"] {
        table.row([step.into(), digits(times.of(step))]);
    }
    study.save(&table);
    let svg = (times.of("draw") + times.of("svg")) / times.of("trace");
    study.figures.ratio("svg_vs_trace", svg, Bound::AtMost { bound: 6.0, goal: 3.0 });
    let tree = times.of("trace") / times.of("summarize");
    study.figures.ratio("tree_vs_stream", tree, Bound::AtMost { bound: 1.25, goal: 1.1 });
    let png = times.of("a stroke a segment") / times.of("png");
    study.figures.ratio("png_vs_strokes", png, Bound::AtLeast { bound: 3.0, goal: 10.0 });
}

/// The slabs with as many rays as give some number of segments, all of them drawn.
fn stack(segments: u64) -> (Scene, u64) {
    let of = |rays| by_power(slabs(rays));
    let count = |rays| followed(&compile(&of(rays)).unwrap().system);
    let rays = u32::try_from(segments.div_ceil(count(1))).unwrap();
    let mut scene = of(rays);
    scene.diagram.faintest = 0.0;
    (scene, count(rays))
}

/// The rays of a drawing as a picture, each by a stroke of its own.
fn strokes(drawing: &Drawing) -> Vec<u8> {
    let [width, height] = drawing.size;
    let mut pixels = Pixmap::new(width, height).unwrap();
    if let Some(color) = drawing.background {
        let Color([r, g, b]) = color;
        pixels.fill(tiny_skia::Color::from_rgba8(r, g, b, 255));
    }
    stroke_items(&mut pixels, &drawing.items);
    pixels.encode_png().unwrap()
}

fn stroke_items(pixels: &mut Pixmap, items: &[Item]) {
    for item in items {
        match item {
            Item::Group(group) => stroke_items(pixels, &group.items),
            Item::Lines(lines) => {
                let ends = lines.ends.iter().map(|ends| ends.map(|hundredths| hundredths as f32 / 100.0));
                stroke_lines(pixels, ends, &lines.stroke);
            }
            Item::Shape(Shape { path, stroke: Some(stroke), class, .. }) if class.starts_with("ray") => {
                stroke_lines(pixels, ends(path.steps()).into_iter(), stroke);
            }
            _ => {}
        }
    }
}

/// The straight lines of a path.
#[expect(clippy::cast_possible_truncation, reason = "pixels")]
fn ends(steps: &[PathStep]) -> Vec<[f32; 4]> {
    let mut from = None;
    let mut line = |step: &PathStep| match *step {
        PathStep::MoveTo(p) => {
            from = Some(p);
            None
        }
        PathStep::LineTo(to) => from.replace(to).map(|from| [from.x, from.y, to.x, to.y].map(|x| x as f32)),
        _ => None,
    };
    steps.iter().filter_map(&mut line).collect()
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "pixels, and a byte")]
fn stroke_lines(pixels: &mut Pixmap, lines: impl Iterator<Item = [f32; 4]>, stroke: &Stroke) {
    let Color([r, g, b]) = stroke.color;
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color_rgba8(r, g, b, (stroke.opacity.clamp(0.0, 1.0) * 255.0).round() as u8);
    let line_cap = if stroke.cap == Cap::Round { LineCap::Round } else { LineCap::Butt };
    let width = stroke.width as f32;
    let look = tiny_skia::Stroke { width, line_cap, line_join: LineJoin::Round, ..tiny_skia::Stroke::default() };
    for [x, y, to_x, to_y] in lines {
        let mut pen = PathBuilder::new();
        pen.move_to(x, y);
        pen.line_to(to_x, to_y);
        let Some(path) = pen.finish() else { continue };
        pixels.stroke_path(&path, &paint, &look, Transform::identity(), None);
    }
}
