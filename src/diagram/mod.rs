//! What a figure shows and where: bodies, rays, normals, words and the frame they stand in.
//!
//! One file a kind of mark; each turns what it needs of scene, system and tree into items of the display list.

mod angles;
mod arc;
mod arrows;
mod axes;
mod badge;
mod blend;
mod bodies;
mod branches;
mod cardinal;
mod coincidence;
mod crowd;
mod deviations;
mod extensions;
mod frame;
mod generations;
mod grid;
mod header;
mod hits;
mod irradiance;
mod key;
mod labels;
mod layers;
mod legend;
mod margins;
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
use styles::Styles;

pub use deviations::problems;
pub use margins::Margins;
pub use statistics::Statistics;

/// Where the lines below take more than this share of the figure's height, the legend gives way.
const MOST_BELOW: f64 = 0.25;

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
    let (mut items, mut statistics, foot) = fitted((scene, system, tree), top, least.foot, everywhere);
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

/// All below the header, and the height that the lines below the scene take: it takes room from the scene, so that more of
/// it may have to stand there.
fn fitted(
    (scene, system, tree): (&Scene, &OpticalSystem, &RayTree),
    top: f64,
    least_foot: f64,
    everywhere: bool,
) -> (Vec<Item>, Statistics, f64) {
    let optics = Optics::new(scene, system, tree);
    let screens = irradiance::screens(scene, system, tree);
    let strip = irradiance::width(scene, &screens);
    // A legend of one line is expected where it will be needed, so that most figures are laid out once.
    let is_expected = scene.diagram.legend && legend::has_weak_branches(scene, tree);
    let (mut foot, mut is_guess) = (if is_expected { key::LINE } else { 0.0 }.max(least_foot), is_expected);
    loop {
        let (mut figure, statistics) = seen((scene, system, tree), &optics, area(scene, top, foot, strip), everywhere);
        let (layers, mut below) = layers::layers(&mut figure, statistics.segments_below_faintest);
        let width = figure.frame.area.size().x;
        if key::height(&below, width) > MOST_BELOW * f64::from(scene.diagram.size[1]) {
            below.retain(|entry| !entry.is_legend());
        }
        let taken = key::height(&below, width).max(least_foot);
        if taken <= foot && !(is_guess && taken < foot) {
            let mut items = figure.with_key(layers, &below);
            items.extend(irradiance::curves(&figure, &screens));
            return (items, statistics, foot);
        }
        (foot, is_guess) = (taken, false);
    }
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
    /// The layers with what stands below the scene.
    fn with_key(&self, mut layers: Vec<Item>, below: &[Entry]) -> Vec<Item> {
        let Rect { min, max } = self.frame.area;
        let bar = if self.scene.diagram.scale_bar { scale_bar::HEIGHT } else { 0.0 };
        let items = key::items(below, DVec2::new(min.x, max.y + bar), max.x - min.x);
        if !items.is_empty() {
            layers.push(Group::layer("key", items).into());
        }
        layers
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
