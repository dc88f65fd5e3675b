//! Scenes of every kind, most of them valid, through the whole way.
//!
//! `cargo +nightly fuzz fmt --sanitizer none scene FILE` prints the scene that a file of bytes stands for.
#![no_main]

use std::fmt;

use arbitrary::{Arbitrary, Result, Unstructured};
use snellius::Scene;

#[path = "../../tests/any_scene/mod.rs"]
mod any_scene;

use any_scene::{generator, properties, ron};

struct AnyScene(Scene);

impl<'a> Arbitrary<'a> for AnyScene {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        Ok(Self(generator::scene(bytes.bytes(bytes.len())?)))
    }
}

impl fmt::Debug for AnyScene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&ron::ron(&self.0))
    }
}

libfuzzer_sys::fuzz_target!(|scene: AnyScene| {
    properties::hold_scene(&scene.0, &ron::ron(&scene.0));
});
