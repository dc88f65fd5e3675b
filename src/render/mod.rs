//! Display list to file formats. Nothing here knows what a ray is.

mod arcs;
mod decimal;
mod encode;
mod fingerprint;
mod mix;
#[cfg(feature = "pdf")]
mod pdf;
mod png;
mod samples;
mod skia;
mod svg;

#[cfg(feature = "pdf")]
pub use pdf::pdf;
pub use png::{RenderError, png, png_within};
pub use svg::{svg, svg_outlined};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagram::{Margins, laid_out};
    use crate::scene::Scene;

    /// Scenes whose view cuts rays off, drawn singly and by style.
    const CUT_OFF: [&str; 3] = [
        r#"(
            bodies: [(shape: Prism(apex_angle: 60, side: 40), medium: Catalog("F2"))],
            sources: [(light: Ray(from: (-50, -18), direction: Towards((-12, 0))), spectrum: White(samples: 9))],
            diagram: (view: Box((10, -30), (60, 10)), faintest: 0, arrows: false, legend: false),
        )"#,
        r"(
            bodies: [(shape: Rectangle(4, 400), medium: Index(1.5)), (shape: Rectangle(4, 400), at: (10, 0), medium: Index(1.8))],
            sources: [(light: Fan(from: (-20, 0), direction: Angle(40), spread: 20, rays: 400))],
            trace: (min_power: 1e-3),
            diagram: (view: Box((-4, 10), (14, 30)), faintest: 0, arrows: false, legend: false),
        )",
        r"(
            bodies: [(shape: Disk(10), medium: Index(1.5))],
            sources: [(light: Beam(center: (-40, 0), direction: Angle(0), width: 19, rays: 90))],
            diagram: (view: Box((8, 2), (30, -12)), theme: Dark, arrows: false, legend: false),
        )",
    ];

    #[test]
    fn what_is_culled_would_not_be_seen() {
        let mut by_style = 0;
        for text in CUT_OFF {
            let scene = Scene::from_ron(text).unwrap();
            let system = crate::compile(&scene).unwrap().system;
            let tree = crate::trace(&system).tree;
            let [(culled, spared, _), (whole, all, _)] =
                [false, true].map(|all| laid_out(&scene, &system, &tree, Margins::default(), all));
            assert!(spared.segments_outside_view > 20 && all.segments_outside_view == 0, "{spared:?}");
            assert_eq!(spared.segments_drawn + spared.segments_outside_view, all.segments_drawn);
            assert_eq!(
                spared.segments_drawn > 2000,
                all.segments_drawn > 2000,
                "both singly or both by style: {spared:?}"
            );
            by_style += u32::from(all.segments_drawn > 2000);
            let [a, b] =
                [culled, whole].map(|drawing| tiny_skia::Pixmap::decode_png(&png(&drawing, 1.0).unwrap()).unwrap());
            let mut lit = 0;
            // A line just outside reaches into the border by half its width.
            for (x, y) in (36..924).flat_map(|x| (38..504).map(move |y| (x, y))) {
                let [a, b] = [&a, &b].map(|picture| picture.pixel(x, y).unwrap());
                let channels = [(a.red(), b.red()), (a.green(), b.green()), (a.blue(), b.blue())];
                assert!(channels.iter().all(|(a, b)| a.abs_diff(*b) <= 1), "{x}, {y}: {a:?} {b:?}");
                lit += u32::from(a.red() != a.green());
            }
            assert!(lit > 1000, "{lit}");
        }
        assert_eq!(by_style, 1);
    }
}
