//! The traces whose instructions `benches/instructions.sh` counts: `instructions SCENE WAY REPETITIONS`. Without
//! arguments it does nothing.

#![allow(missing_docs, reason = "a program")]
#![allow(unreachable_pub, dead_code, clippy::unwrap_used, reason = "a program without users")]

#[path = "support/scenes.rs"]
mod scenes;

use std::hint::black_box;

use snellius::{OpticalSystem, compile, summarize, trace};

fn main() {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    let [scene, way, repetitions] = &arguments[..] else {
        return println!("nothing counted: `benches/instructions.sh` does");
    };
    let system = system(scene);
    let repetitions: u32 = repetitions.parse().unwrap();
    let one_thread = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    one_thread.install(|| match way.as_str() {
        "stream" => (0..repetitions).for_each(|_| drop(black_box(summarize(black_box(&system))))),
        "tree" => (0..repetitions).for_each(|_| drop(black_box(trace(black_box(&system))))),
        other => panic!("no way {other}: stream or tree"),
    });
}

fn system(scene: &str) -> OpticalSystem {
    let scene = match scene {
        "prism" => scenes::prism(64),
        "slabs" => scenes::slabs(1),
        other => panic!("no scene {other}: prism or slabs"),
    };
    let mut scene = scene;
    (scene.trace.min_power, scene.trace.max_depth) = (1e-4, scenes::NO_DEPTH);
    compile(&scene).unwrap().system
}
