//! Any bytes as a scene file: refused with reasons, or through the whole way.
#![no_main]

#[path = "../../tests/any_scene/mod.rs"]
mod any_scene;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    any_scene::properties::hold_bytes(bytes);
});
