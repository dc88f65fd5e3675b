//! Scenes made from random bytes, and every scene that once went wrong, through the whole way: read, compiled, traced, shown.
//!
//! The fuzzer in `fuzz/` holds scenes to the same properties for as long as one likes.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test fails by panicking")]

mod support;

#[path = "any_scene/mod.rs"]
mod any_scene;
#[path = "any_scene/finds.rs"]
mod finds;

use std::collections::BTreeMap;
use std::panic::catch_unwind;

use any_scene::generator;
use any_scene::properties::{Verdict, hold_scene};
use any_scene::ron::ron;
use support::figures::size;
use support::random::Random;

/// Scenes from seeded bytes, with their texts.
fn scenes(count: u32) -> impl Iterator<Item = (snellius::Scene, String)> {
    let mut random = Random(1637);
    (0..count).map(move |_| {
        let bytes: Vec<u8> = (0..1 + random.below(150)).flat_map(|_| random.next().to_le_bytes()).collect();
        let scene = generator::scene(&bytes);
        let text = ron(&scene);
        (scene, text)
    })
}

#[test]
fn the_properties_hold_in_generated_scenes() {
    let mut verdicts = BTreeMap::new();
    for (scene, text) in scenes(size(400, 20_000)) {
        let verdict =
            catch_unwind(|| hold_scene(&scene, &text)).unwrap_or_else(|_| panic!("this scene fails:\n{text}"));
        *verdicts.entry(format!("{verdict:?}")).or_insert(0) += 1;
    }
    println!("{verdicts:?}");
    let of = |verdict: Verdict| verdicts.get(&format!("{verdict:?}")).copied().unwrap_or(0);
    assert!(of(Verdict::Drawn) > of(Verdict::Refused) && of(Verdict::Refused) > 0, "{verdicts:?}");
}

#[test]
fn the_generator_knows_the_whole_format() {
    let words = "Polygon Rectangle RegularPolygon Prism RightAnglePrism Disk HalfDisk Lens facets Outline LineTo ArcTo LensGroup Flat \
        Arc Stop Mirror Absorber Screen BeamSplitter ThinLens Index Speed Cauchy Sellmeier Catalog Ray Beam Fan Point Object Angle \
        Towards Line Lines White Unpolarized S P Fresnel Fixed TransmittedOnly Auto Box Light Dark Print Wavelength Power Via \
        wavefronts";
    let valid: Vec<String> =
        scenes(2000).filter(|(scene, _)| snellius::compile(scene).is_ok()).map(|(_, text)| text).collect();
    for word in words.split_whitespace() {
        let is_word = |text: &String| text.split(|c: char| !c.is_alphanumeric() && c != '_').any(|part| part == word);
        assert!(valid.iter().filter(|text| is_word(text)).count() >= 10, "{word} in {} scenes", valid.len());
    }
    for switch in "normals angles labels arrows legend extensions protractor optical_axis focal_points principal_planes grid scale_bar \
        irradiance"
        .split_whitespace()
    {
        let with = |on: bool| valid.iter().filter(|text| text.contains(&format!("{switch}: {on}"))).count();
        assert!(with(true) > 100 && with(false) > 100, "{switch}");
    }
}
