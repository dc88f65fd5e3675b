use std::path::Path;

use super::picture::{Picture, warn_of_missing_glyphs};
use super::{Render, Traced};
use crate::cli::console::{Fault, Mistake, Status, summarize};
use crate::cli::scene;
use crate::cli::stats::Stopwatch;
use crate::diagram::{self, Margins};
use crate::drawing::Drawing;
use crate::scene::{MAX_PIXELS, MIN_PIXELS};

/// Free space between panels, pixels.
const GAP: u32 = 16;

impl Render {
    /// Draws all scenes into one picture, or nothing: a comparison that lacks a scene looks like another. Every scene is looked
    /// at, so that all that is wrong is shown at once.
    pub(super) fn draw_panels(&self, pictures: &[Picture]) -> Result<Status, Mistake> {
        let mut failed: Vec<&Path> = Vec::new();
        let mut panels: Vec<(&Path, Traced, Stopwatch)> = Vec::new();
        for scene in &self.scenes {
            let mut watch = Stopwatch::start();
            match Traced::of(scene, &self.look, &mut watch) {
                Ok(traced) => panels.push((scene, traced, watch)),
                Err(fault) => {
                    Status::of(Err(fault));
                    failed.push(scene);
                }
            }
        }
        if !failed.is_empty() {
            return Ok(summarize(&failed, self.scenes.len(), ", so nothing is drawn"));
        }
        let own: Vec<[u32; 2]> = panels.iter().map(|(_, traced, _)| traced.ready.scene.diagram.size).collect();
        let sizes = sizes(&own, self.look.size)?;
        for ((_, traced, _), size) in panels.iter_mut().zip(sizes) {
            traced.ready.scene.diagram.size = size;
        }
        Ok(Status::of(self.write_panels(panels, pictures)))
    }

    fn write_panels(&self, panels: Vec<(&Path, Traced, Stopwatch)>, pictures: &[Picture]) -> Result<(), Fault> {
        let margins = panels
            .iter()
            .map(|(_, Traced { ready, trace }, _)| diagram::margins(&ready.scene, &ready.system, &trace.tree));
        let margins = margins.fold(Margins::default(), Margins::max);
        let mut drawings = Vec::new();
        for (scene, traced, mut watch) in panels {
            watch.begin("drawing");
            let (drawing, figure) = self.figure(&traced, margins);
            warn_of_missing_glyphs(&drawing, &scene::name(scene));
            drawings.push(drawing);
            self.show_stats(scene, &traced, figure, &watch);
        }
        let whole = Drawing::side_by_side(&drawings, GAP);
        let mut watch = Stopwatch::start();
        pictures.iter().try_for_each(|picture| picture.write(&whole, &self.look, "panels", &mut watch))
    }
}

/// Sizes of panels whose figures would have sizes of their own by themselves. The widths are in the proportion of those, the
/// height is one; by default half of the widths and the greatest height.
fn sizes(own: &[[u32; 2]], whole: Option<[u32; 2]>) -> Result<Vec<[u32; 2]>, Mistake> {
    let gaps = own.iter().skip(1).fold(0_u32, |gaps, _| gaps.saturating_add(GAP));
    let widths: u64 = own.iter().map(|[width, _]| u64::from(*width)).sum();
    let [width, height] = whole.unwrap_or_else(|| {
        let width = u32::try_from(widths / 2).unwrap_or(MAX_PIXELS).saturating_add(gaps);
        [width.min(MAX_PIXELS), own.iter().map(|[_, height]| *height).max().unwrap_or(MIN_PIXELS)]
    });
    let room = u64::from(width.saturating_sub(gaps));
    let (mut before, mut sizes) = (0, Vec::new());
    for [own, _] in own {
        // From edge to edge, so that the widths sum up.
        let edge = |at: u64| at * room / widths.max(1);
        let after = before + u64::from(*own);
        let width = u32::try_from(edge(after) - edge(before)).unwrap_or(0);
        if width < MIN_PIXELS {
            return Err(Mistake(format!("so many panels do not fit into {room} pixels: widen them with --size")));
        }
        sizes.push([width, height]);
        before = after;
    }
    Ok(sizes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panels_have_half_of_their_widths_and_one_height() {
        let of = |own: &[[u32; 2]], whole| sizes(own, whole).map_err(|Mistake(why)| why);
        assert_eq!(of(&[[960, 540], [400, 800]], None).unwrap(), [[480, 800], [200, 800]]);
        let third = of(&[[960, 540]; 3], Some([1000, 300])).unwrap();
        assert_eq!(third, [[322, 300], [323, 300], [323, 300]], "968 pixels are left");
        assert!(of(&[[960, 540]; 3], Some([60, 300])).unwrap_err().contains("--size"));
        let many = of(&[[960, 540]; 40], None).unwrap();
        assert_eq!(many.iter().map(|[width, _]| width).sum::<u32>() + 39 * GAP, MAX_PIXELS);
        assert!(of(&vec![[960, 540]; 2000], None).is_err());
    }
}
