//! What a figure shows and where: bodies, rays, normals, words and the frame they stand in.
//!
//! One file a kind of mark; each turns what it needs of scene, system and tree into items of the display list.

mod arrows;
mod blend;
mod bodies;
mod branches;
mod coincidence;
mod extensions;
mod frame;
mod grid;
mod header;
mod labels;
mod nice;
mod normals;
mod notes;
mod outline;
mod palette;
mod rays;
mod scale_bar;
mod sources;
mod surfaces;
mod view;
mod wrap;

use crate::drawing::{Drawing, Group, Item, Rect};
use crate::scene::Scene;
use crate::system::OpticalSystem;
use crate::trace::RayTree;

use branches::Branch;
use frame::Frame;
use palette::Palette;

/// Everything that the marks look at.
struct Figure<'a> {
    scene: &'a Scene,
    system: &'a OpticalSystem,
    tree: &'a RayTree,
    frame: Frame,
    palette: Palette,
    /// The branches that are drawn, weakest first.
    branches: Vec<Branch<'a>>,
}

/// Lays out the figure of a traced scene.
///
/// `system` and `tree` must come from `scene`; parts that do not fit together are left out.
#[must_use]
pub fn draw(scene: &Scene, system: &OpticalSystem, tree: &RayTree) -> Drawing {
    let settings = &scene.diagram;
    let palette = Palette::of(settings.theme);
    let (header, below) = header::header(scene, &palette);
    let area = area(scene, below);
    let frame = Frame::new(area, &view::extent(scene, system, tree, &area));
    let branches = branches::visible(tree, &frame, settings.faintest);
    let figure = Figure { scene, system, tree, frame, palette, branches };
    let mut items = figure.layers();
    items.push(Group::layer("header", header).into());
    Drawing {
        size: settings.size,
        background: Some(palette.ground),
        title: scene.title.clone(),
        description: scene.caption.clone(),
        items,
    }
}

impl Figure<'_> {
    /// The layers from back to front.
    fn layers(&self) -> Vec<Item> {
        let settings = &self.scene.diagram;
        let normals = if settings.normals { normals::normals(self) } else { Vec::new() };
        let mut layers = vec![self.layer("bodies", bodies::bodies(self))];
        if settings.grid {
            layers.push(self.layer("grid", grid::grid(self)));
        }
        layers.push(self.layer("surfaces", surfaces::surfaces(self)));
        let extensions = extensions::extensions(self);
        let words = labels::labels(self, &[&normals, &extensions]);
        layers.push(self.layer("normals", normals));
        layers.push(self.layer("extensions", extensions));
        layers.push(self.layer("rays", rays::rays(self)));
        if settings.arrows {
            layers.push(self.layer("arrows", arrows::arrows(self)));
        }
        layers.push(self.layer("sources", sources::sources(self)));
        layers.push(self.layer("labels", words));
        layers.push(Group::layer("notes", notes::notes(self)).into());
        if settings.scale_bar {
            layers.push(Group::layer("scale-bar", scale_bar::scale_bar(self)).into());
        }
        layers.retain(|layer| !matches!(layer, Item::Group(group) if group.items.is_empty()));
        layers
    }

    /// A layer that ends where the frame does.
    fn layer(&self, class: &str, items: Vec<Item>) -> Item {
        Group::layer(class, items).clipped(self.frame.area.grown(2.0)).into()
    }
}

/// The part of the figure that is left for the scene.
fn area(scene: &Scene, below_header: f64) -> Rect {
    let [width, height] = scene.diagram.size.map(f64::from);
    let side = header::margin(scene);
    let foot = if scene.diagram.scale_bar { scale_bar::HEIGHT } else { 0.0 };
    let top = below_header.min(0.7 * height);
    let bottom = (height - side - foot).max(top + 0.2 * height);
    Rect { min: glam::DVec2::new(side, top), max: glam::DVec2::new((width - side).max(side), bottom) }
}
