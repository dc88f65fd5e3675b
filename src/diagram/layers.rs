//! The layers of a figure from back to front, and the order in which words take their places.

use crate::diagram::generations::{Aged, by_generation, together};
use crate::diagram::key::Entry;
use crate::diagram::room::Room;
use crate::diagram::{
    Figure, angles, arrows, axes, bodies, cardinal, deviations, extensions, grid, hits, labels, legend, normals, notes,
    objects, protractors, rays, scale_bar, sources, surfaces, wavefronts,
};
use crate::drawing::{Group, Item, Text};

/// Marks between the bodies and the rays or on top of them, by layer.
#[derive(Default)]
struct Marks {
    grid: Vec<Item>,
    axes: Vec<Item>,
    planes: Vec<Item>,
    normals: Vec<Aged>,
    extensions: Vec<Aged>,
    objects: Vec<Aged>,
    angles: Vec<Aged>,
    deviations: Vec<Aged>,
    protractors: Vec<Aged>,
    labels: Vec<Item>,
    object_labels: Vec<Aged>,
    /// Bodies whose labels are left out.
    unlabeled: usize,
    below: Vec<Text>,
}

/// The layers, and what stands below the scene; `spared` branches are below the faintest that is drawn.
pub(super) fn layers(figure: &mut Figure<'_>, spared: usize) -> (Vec<Item>, Vec<Entry>) {
    let crowd = std::mem::take(&mut figure.crowd);
    // Very many branches are not told apart, and so have no generations.
    let mut stack = Stack { figure, has_generations: crowd.is_empty(), layers: Vec::new() };
    let settings = &figure.scene.diagram;
    let mut marks = marks(figure, stack.has_generations);
    stack.put("bodies", bodies::bodies(figure));
    stack.put("grid", marks.grid);
    stack.put("surfaces", surfaces::surfaces(figure));
    stack.put("axes", marks.axes);
    stack.put("principal-planes", marks.planes);
    stack.put_aged("normals", marks.normals);
    stack.put_aged("extensions", marks.extensions);
    stack.put_aged("protractors", marks.protractors);
    stack.put_aged("wavefronts", wavefronts::wavefronts(figure));
    stack.put_aged("deviations", marks.deviations);
    if stack.has_generations {
        stack.put_aged("rays", rays::rays(figure));
    } else {
        stack.put("rays", crowd);
    }
    stack.put_aged("arrows", if settings.arrows { arrows::arrows(figure) } else { Vec::new() });
    stack.put_aged("angles", marks.angles);
    stack.put_aged("objects", marks.objects);
    stack.put("focal-points", cardinal::points(figure));
    stack.put("sources", sources::sources(figure));
    marks.labels.extend(stack.sorted("labels", marks.object_labels));
    stack.put("labels", marks.labels);
    stack.put_whole("notes", notes::notes(figure));
    stack.put_whole("scale-bar", if settings.scale_bar { scale_bar::scale_bar(figure) } else { Vec::new() });
    let mut below: Vec<_> = marks.below.into_iter().map(|text| Entry { sample: None, text }).collect();
    if settings.legend {
        below.extend(legend::legend(figure, spared));
        below.extend(legend::unlabeled(figure, marks.unlabeled));
    }
    (stack.layers, below)
}

/// All marks; those come first whose words need a certain place most.
fn marks(figure: &Figure<'_>, is_uncrowded: bool) -> Marks {
    let settings = &figure.scene.diagram;
    let mut marks = Marks {
        grid: if settings.grid { grid::grid(figure) } else { Vec::new() },
        axes: if settings.optical_axis { axes::axes(figure) } else { Vec::new() },
        planes: cardinal::planes(figure),
        normals: if settings.normals { normals::normals(figure) } else { Vec::new() },
        extensions: extensions::extensions(figure),
        objects: objects::arrows(figure),
        ..Marks::default()
    };
    marks.extensions.extend(objects::lines_back(figure));
    let shapes = labels::shapes(figure);
    let mut room = Room::new(figure, labels::chords(&shapes));
    let aged = [&marks.normals, &marks.extensions, &marks.objects].into_iter().flatten().map(|(_, item)| item);
    aged.chain(&marks.axes).chain(&marks.planes).for_each(|item| room.keep_off_item(item));
    for item in &marks.grid {
        room.take_words(item);
    }
    let found = deviations::found(figure, &mut room);
    let hits = if is_uncrowded { hits::marked(figure) } else { Vec::new() };
    let protractors = if settings.protractor { protractors::chosen(figure, &hits) } else { Vec::new() };
    protractors.iter().for_each(|protractor| protractor.keep_off(&mut room));
    room.anchors = hits.iter().map(|hit| hit.at).collect();
    if settings.angles {
        (marks.angles, marks.below) = angles::angles(figure, &hits, &mut room);
    }
    let (deviations, unplaced) = deviations::deviations(figure, &found, &mut room);
    marks.deviations = deviations;
    marks.below.extend(unplaced);
    marks.labels = cardinal::letters(figure, &mut room);
    marks.object_labels = objects::words(figure, &mut room);
    marks.protractors = protractors.iter().flat_map(|protractor| protractor.items(figure, &mut room)).collect();
    let (labels, unlabeled) = labels::labels(figure, &shapes, &mut room);
    marks.labels.extend(labels);
    marks.unlabeled = unlabeled;
    marks
}

/// Layers that are put on top of each other; empty ones are left out.
struct Stack<'f> {
    figure: &'f Figure<'f>,
    has_generations: bool,
    layers: Vec<Item>,
}

impl Stack<'_> {
    /// A layer that ends where the frame does.
    fn put(&mut self, class: &str, items: Vec<Item>) {
        if !items.is_empty() {
            let frame = self.figure.frame.area.grown(2.0);
            self.layers.push(Group::layer(class, items).clipped(frame).into());
        }
    }

    /// The same, by the generation of the light that its items belong to.
    fn put_aged(&mut self, class: &str, items: Vec<Aged>) {
        self.put(class, self.sorted(class, items));
    }

    /// A layer that may stand out beyond the frame.
    fn put_whole(&mut self, class: &str, items: Vec<Item>) {
        if !items.is_empty() {
            self.layers.push(Group::layer(class, items).into());
        }
    }

    fn sorted(&self, layer: &str, items: Vec<Aged>) -> Vec<Item> {
        if self.has_generations { by_generation(layer, items) } else { together(items) }
    }
}
