//! What a figure shows and where: bodies, rays, normals, words and the frame they stand in.
//!
//! One file a kind of mark; each turns what it needs of scene, system and tree into items of the display list.

mod angles;
mod arc;
mod arrows;
mod axes;
mod blend;
mod bodies;
mod branches;
mod cardinal;
mod coincidence;
mod crowd;
mod deviations;
mod extensions;
mod frame;
mod grid;
mod header;
mod hits;
mod irradiance;
mod key;
mod labels;
mod legend;
mod nice;
mod normals;
mod notes;
mod objects;
mod optics;
mod outline;
mod palette;
mod paths;
mod protractors;
mod rays;
mod room;
mod scale_bar;
mod sources;
mod statistics;
mod styles;
mod surfaces;
mod view;
mod wavefronts;
mod wrap;

use glam::DVec2;

use crate::drawing::{Drawing, Group, Item, Rect};
use crate::scene::Scene;
use crate::system::OpticalSystem;
use crate::trace::RayTree;

use branches::{Branch, Sight};
use crowd::Crowd;
use frame::Frame;
use key::Entry;
use optics::Optics;
use palette::Palette;
use room::Room;
use styles::Styles;

pub use deviations::problems;
pub use statistics::Statistics;

/// Everything that the marks look at.
struct Figure<'a> {
    scene: &'a Scene,
    system: &'a OpticalSystem,
    tree: &'a RayTree,
    optics: &'a Optics,
    frame: Frame,
    palette: Palette,
    styles: Styles<'a>,
    /// The branches that are drawn, weakest first; only the strongest of very many.
    branches: Vec<Branch<'a>>,
    /// Very many branches as they are drawn, empty where each is drawn by itself.
    crowd: Vec<Item>,
}

/// Lays out the figure of a traced scene; [`Scene`] shows one beside its file.
///
/// `system` and `tree` must come from `scene`; parts that do not fit together are left out.
#[must_use]
pub fn draw(scene: &Scene, system: &OpticalSystem, tree: &RayTree) -> Drawing {
    draw_counted(scene, system, tree).0
}

/// The same as [`draw`], and what it shows and spares.
#[must_use]
pub fn draw_counted(scene: &Scene, system: &OpticalSystem, tree: &RayTree) -> (Drawing, Statistics) {
    laid_out(scene, system, tree, false)
}

/// `everywhere` draws segments outside the view too, to see that they make no difference.
pub(crate) fn laid_out(
    scene: &Scene,
    system: &OpticalSystem,
    tree: &RayTree,
    everywhere: bool,
) -> (Drawing, Statistics) {
    let palette = Palette::of(scene.diagram.theme);
    let optics = Optics::new(scene, system, tree);
    let (header, top) = header::header(scene, &palette);
    let screens = irradiance::screens(scene, system, tree);
    let strip = irradiance::width(scene, &screens);
    // What stands below the scene takes room from it, so that more of it may have to stand there.
    // A legend of one line is expected where it will be needed, so that most figures are laid out once.
    let is_expected = scene.diagram.legend && legend::has_weak_branches(scene, tree);
    let (mut foot, mut is_guess) = (if is_expected { key::LINE } else { 0.0 }, is_expected);
    let (mut items, mut statistics) = loop {
        let (mut figure, statistics) = seen((scene, system, tree), &optics, area(scene, top, foot, strip), everywhere);
        let (layers, below) = figure.layers(statistics.segments_below_faintest);
        let taken = key::height(&below, figure.frame.area.size().x);
        if taken <= foot && !(is_guess && taken < foot) {
            let mut items = figure.with_key(layers, &below);
            items.extend(irradiance::curves(&figure, &screens));
            break (items, statistics);
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
    (drawing, statistics)
}

/// What is seen of the scene in an area, before it is drawn.
fn seen<'a>(
    (scene, system, tree): (&'a Scene, &'a OpticalSystem, &'a RayTree),
    optics: &'a Optics,
    area: Rect,
    everywhere: bool,
) -> (Figure<'a>, Statistics) {
    let palette = Palette::of(scene.diagram.theme);
    let frame = Frame::new(area, &view::extent(scene, system, tree, optics, &area));
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
    (Figure { scene, system, tree, optics, frame, palette, styles, branches, crowd }, statistics)
}

impl Figure<'_> {
    /// The layers from back to front, and what stands below the scene.
    fn layers(&mut self, spared: usize) -> (Vec<Item>, Vec<Entry>) {
        let crowd = std::mem::take(&mut self.crowd);
        let crowd_is_empty = crowd.is_empty();
        let rays = if crowd_is_empty { rays::rays(self) } else { crowd };
        let settings = &self.scene.diagram;
        let normals = if settings.normals { normals::normals(self) } else { Vec::new() };
        let mut layers = vec![self.layer("bodies", bodies::bodies(self))];
        if settings.grid {
            layers.push(self.layer("grid", grid::grid(self)));
        }
        layers.push(self.layer("surfaces", surfaces::surfaces(self)));
        let axes = if settings.optical_axis { axes::axes(self) } else { Vec::new() };
        let planes = cardinal::planes(self);
        let mut extensions = extensions::extensions(self);
        extensions.extend(objects::lines_back(self));
        let objects = objects::arrows(self);
        let shapes = labels::shapes(self);
        let mut room = Room::new(self, labels::chords(&shapes), &[&normals, &extensions, &axes, &planes, &objects]);
        let hits = if crowd_is_empty { hits::marked(self) } else { Vec::new() };
        let (angles, mut below) =
            if settings.angles { angles::angles(self, &hits, &mut room) } else { Default::default() };
        let (deviations, unplaced) = deviations::deviations(self, &mut room);
        below.extend(unplaced);
        let mut words = cardinal::letters(self, &mut room);
        words.extend(objects::words(self, &mut room));
        let protractors =
            if settings.protractor { protractors::protractors(self, &hits, &mut room) } else { Vec::new() };
        words.extend(labels::labels(self, &shapes, &mut room));
        layers.push(self.layer("axes", axes));
        layers.push(self.layer("principal-planes", planes));
        layers.push(self.layer("normals", normals));
        layers.push(self.layer("extensions", extensions));
        layers.push(self.layer("protractors", protractors));
        layers.push(self.layer("wavefronts", wavefronts::wavefronts(self)));
        layers.push(self.layer("deviations", deviations));
        layers.push(self.layer("rays", rays));
        if settings.arrows {
            layers.push(self.layer("arrows", arrows::arrows(self)));
        }
        layers.push(self.layer("angles", angles));
        layers.push(self.layer("objects", objects));
        layers.push(self.layer("focal-points", cardinal::points(self)));
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

/// The part of the figure that is left for the scene, beside a strip of some width at the right.
fn area(scene: &Scene, below_header: f64, foot: f64, strip: f64) -> Rect {
    let [width, height] = scene.diagram.size.map(f64::from);
    let side = header::margin(scene);
    let foot = foot + if scene.diagram.scale_bar { scale_bar::HEIGHT } else { 0.0 };
    let below_header = if strip > 0.0 { below_header + irradiance::TITLE } else { below_header };
    let top = below_header.min(0.7 * height);
    let bottom = (height - side - foot).max(top + 0.2 * height);
    Rect { min: DVec2::new(side, top), max: DVec2::new((width - side - strip).max(side), bottom) }
}
