//! Scenes of every kind, most of them valid, through the whole way.
#![no_main]

#[path = "../../tests/any_scene/mod.rs"]
mod any_scene;

use any_scene::{generator, properties, ron};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let scene = generator::scene(bytes);
    properties::hold_scene(&scene, &ron::ron(&scene));
});
