//! What a figure shows and where: bodies, rays, normals, words and the frame they stand in.
//!
//! One file a kind of mark; each turns what it needs of scene, system and tree into items of the display list.

mod angles;
mod arrows;
mod blend;
mod bodies;
mod branches;
mod coincidence;
mod crowd;
mod extensions;
mod frame;
mod generations;
mod grid;
mod header;
mod hits;
mod key;
mod labels;
mod legend;
mod margins;
mod nice;
mod normals;
mod notes;
mod outline;
mod palette;
mod paths;
mod rays;
mod room;
mod scale_bar;
mod sources;
mod statistics;
mod styles;
mod surfaces;
mod view;
mod wrap;

use glam::DVec2;

use crate::drawing::{Drawing, Group, Item, Rect};
use crate::scene::Scene;
use crate::system::OpticalSystem;
use crate::trace::RayTree;

use branches::{Branch, Sight};
use crowd::Crowd;
use frame::Frame;
use generations::{Aged, by_generation, together};
use key::Entry;
use palette::Palette;
use room::Room;
use styles::Styles;

pub use margins::Margins;
pub use statistics::Statistics;

/// Everything that the marks look at.
struct Figure<'a> {
    scene: &'a Scene,
    system: &'a OpticalSystem,
    tree: &'a RayTree,
    frame: Frame,
    palette: Palette,
    styles: Styles<'a>,
    /// The branches that are drawn, weakest first; only the strongest of very many.
    branches: Vec<Branch<'a>>,
    /// Very many branches as they are drawn, empty where each is drawn by itself.
    crowd: Vec<Item>,
}

/// Lays out the figure of a traced scene.
///
/// `system` and `tree` must come from `scene`; parts that do not fit together are left out.
#[must_use]
pub fn draw(scene: &Scene, system: &OpticalSystem, tree: &RayTree) -> Drawing {
    draw_counted(scene, system, tree).0
}

/// The same as [`draw`], and what it shows and spares.
#[must_use]
pub fn draw_counted(scene: &Scene, system: &OpticalSystem, tree: &RayTree) -> (Drawing, Statistics) {
    draw_within(scene, system, tree, Margins::default())
}

/// The same with as much room for the words above and below the scene as these margins have, where it takes less: figures of one
/// size and the same margins have their scenes at one height, and with one view at one scale.
#[must_use]
pub fn draw_within(scene: &Scene, system: &OpticalSystem, tree: &RayTree, margins: Margins) -> (Drawing, Statistics) {
    let (drawing, statistics, _) = laid_out(scene, system, tree, margins, false);
    (drawing, statistics)
}

/// The room that a scene's figure takes for words.
#[must_use]
pub fn margins(scene: &Scene, system: &OpticalSystem, tree: &RayTree) -> Margins {
    laid_out(scene, system, tree, Margins::default(), false).2
}

/// `everywhere` draws segments outside the view too, to see that they make no difference.
pub(crate) fn laid_out(
    scene: &Scene,
    system: &OpticalSystem,
    tree: &RayTree,
    least: Margins,
    everywhere: bool,
) -> (Drawing, Statistics, Margins) {
    let palette = Palette::of(scene.diagram.theme);
    let (header, top) = header::header(scene, &palette);
    let top = top.max(least.top);
    // What stands below the scene takes room from it, so that more of it may have to stand there.
    // A legend of one line is expected where it will be needed, so that most figures are laid out once.
    let is_expected = scene.diagram.legend && legend::has_weak_branches(scene, tree);
    let (mut foot, mut is_guess) = (if is_expected { key::LINE } else { 0.0 }.max(least.foot), is_expected);
    let (mut items, mut statistics) = loop {
        let (mut figure, statistics) = seen(scene, system, tree, area(scene, top, foot), everywhere);
        let (layers, below) = figure.layers(statistics.segments_below_faintest);
        let taken = key::height(&below, figure.frame.area.size().x).max(least.foot);
        if taken <= foot && !(is_guess && taken < foot) {
            break (figure.with_key(layers, &below), statistics);
        }
        (foot, is_guess) = (taken, false);
    };
    items.push(Group::layer("header", header).into());
    statistics.count(&items);
    let drawing = Drawing {
        size: scene.diagram.size,
        background: Some(palette.ground),
        title: scene.title.clone(),
        description: scene.caption.clone(),
        items,
    };
    (drawing, statistics, Margins { top, foot })
}

/// What is seen of the scene in an area, before it is drawn.
fn seen<'a>(
    scene: &'a Scene,
    system: &'a OpticalSystem,
    tree: &'a RayTree,
    area: Rect,
    everywhere: bool,
) -> (Figure<'a>, Statistics) {
    let palette = Palette::of(scene.diagram.theme);
    let frame = Frame::new(area, &view::extent(scene, system, tree, &area));
    let mut crowd = Crowd::new(Styles::new(scene, palette, tree));
    let mut statistics = Statistics::default();
    let sight = Sight { frame: &frame, faintest: scene.diagram.faintest, everywhere };
    let spared = sight.visit(tree, &mut |branch| {
        statistics.segments_drawn += branch.members;
        crowd.push(branch);
    });
    statistics.segments_outside_view = spared.outside_view;
    statistics.segments_below_faintest = spared.below_faintest;
    let (branches, styles, crowd) = crowd.finish();
    (Figure { scene, system, tree, frame, palette, styles, branches, crowd }, statistics)
}

impl Figure<'_> {
    /// The layers from back to front, and what stands below the scene.
    fn layers(&mut self, spared: usize) -> (Vec<Item>, Vec<Entry>) {
        let crowd = std::mem::take(&mut self.crowd);
        let crowd_is_empty = crowd.is_empty();
        // Very many branches are not told apart, and so have no generations.
        let sorted = |layer: &str, items: Vec<Aged>| {
            if crowd_is_empty { by_generation(layer, items) } else { together(items) }
        };
        let rays = if crowd_is_empty { sorted("rays", rays::rays(self)) } else { crowd };
        let settings = &self.scene.diagram;
        let normals = if settings.normals { normals::normals(self) } else { Vec::new() };
        let mut layers = vec![self.layer("bodies", bodies::bodies(self))];
        if settings.grid {
            layers.push(self.layer("grid", grid::grid(self)));
        }
        layers.push(self.layer("surfaces", surfaces::surfaces(self)));
        let extensions = extensions::extensions(self);
        let shapes = labels::shapes(self);
        let mut room = Room::new(self, labels::chords(&shapes), &[&normals, &extensions]);
        let has_angles = settings.angles && crowd_is_empty;
        let (angles, below) = if has_angles { angles::angles(self, &mut room) } else { Default::default() };
        let words = labels::labels(self, &shapes, &mut room);
        layers.push(self.layer("normals", sorted("normals", normals)));
        layers.push(self.layer("extensions", sorted("extensions", extensions)));
        layers.push(self.layer("rays", rays));
        if settings.arrows {
            layers.push(self.layer("arrows", sorted("arrows", arrows::arrows(self))));
        }
        layers.push(Group::layer("angles", sorted("angles", angles)).into());
        layers.push(self.layer("sources", sources::sources(self)));
        layers.push(self.layer("labels", words));
        layers.push(Group::layer("notes", notes::notes(self)).into());
        if settings.scale_bar {
            layers.push(Group::layer("scale-bar", scale_bar::scale_bar(self)).into());
        }
        layers.retain(|layer| !matches!(layer, Item::Group(group) if group.items.is_empty()));
        let mut below: Vec<_> = below.into_iter().map(|text| Entry { sample: None, text }).collect();
        if settings.legend {
            below.extend(legend::legend(self, spared));
        }
        (layers, below)
    }

    /// The layers with what stands below the scene.
    fn with_key(&self, mut layers: Vec<Item>, below: &[Entry]) -> Vec<Item> {
        let Rect { min, max } = self.frame.area;
        let items = key::items(below, DVec2::new(min.x, max.y), max.x - min.x);
        if !items.is_empty() {
            layers.push(Group::layer("key", items).into());
        }
        layers
    }

    /// A layer that ends where the frame does.
    fn layer(&self, class: &str, items: Vec<Item>) -> Item {
        Group::layer(class, items).clipped(self.frame.area.grown(2.0)).into()
    }
}

/// The part of the figure that is left for the scene.
fn area(scene: &Scene, below_header: f64, foot: f64) -> Rect {
    let [width, height] = scene.diagram.size.map(f64::from);
    let side = header::margin(scene);
    let foot = foot + if scene.diagram.scale_bar { scale_bar::HEIGHT } else { 0.0 };
    let top = below_header.min(0.7 * height);
    let bottom = (height - side - foot).max(top + 0.2 * height);
    Rect { min: DVec2::new(side, top), max: DVec2::new((width - side).max(side), bottom) }
}
