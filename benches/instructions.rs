//! The traces whose instructions `benches/instructions.sh` counts: `instructions SCENE REPETITIONS`. Without arguments it does
//! nothing.

#![allow(missing_docs, reason = "a program")]
#![allow(unreachable_pub, dead_code, clippy::unwrap_used, reason = "a program without users")]

#[path = "support/scenes.rs"]
mod scenes;

use std::hint::black_box;

use snellius::scene::TraceSettings;
use snellius::{Scene, compile, summarize, trace};

fn main() {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    let [scene, repetitions] = &arguments[..] else {
        return println!("nothing counted: `benches/instructions.sh` does");
    };
    let scene = match scene.as_str() {
        "prism" => scenes::prism(64),
        "slabs" => scenes::slabs(1),
        other => panic!("no scene {other}: prism or slabs"),
    };
    let settings = TraceSettings { min_power: 1e-4, max_depth: scenes::NO_DEPTH, ..TraceSettings::default() };
    let system = compile(&Scene { trace: settings, ..scene }).unwrap().system;
    let one_thread = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    one_thread.install(|| {
        for _ in 0..repetitions.parse::<u32>().unwrap() {
            black_box(summarize(black_box(&system)));
            black_box(trace(black_box(&system)));
        }
    });
}
