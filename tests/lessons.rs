//! What each scene teaches, as an assertion of its own: a golden file alone can pin wrong physics.
#![allow(clippy::unwrap_used, clippy::float_cmp, reason = "a lesson may fail, and may ask for equal bits")]

mod support;

#[path = "lessons/lenses.rs"]
mod lenses;
#[path = "lessons/measure.rs"]
mod measure;
#[path = "lessons/mirrors.rs"]
mod mirrors;
#[path = "lessons/nature.rs"]
mod nature;
#[path = "lessons/prisms.rs"]
mod prisms;
#[path = "lessons/rays.rs"]
mod rays;
#[path = "lessons/refraction.rs"]
mod refraction;
#[path = "lessons/total_reflection.rs"]
mod total_reflection;

use support::Run;

/// A scene's name and what must hold of its trace.
pub type Lesson = (&'static str, fn(&Run));

fn lessons() -> Vec<Lesson> {
    [
        refraction::LESSONS,
        total_reflection::LESSONS,
        prisms::LESSONS,
        lenses::LESSONS,
        mirrors::LESSONS,
        nature::LESSONS,
    ]
    .concat()
}

#[test]
fn every_scene_teaches_what_it_says() {
    for (name, holds) in lessons() {
        println!("{name}");
        holds(&support::run(name));
    }
}

#[test]
fn every_scene_has_a_lesson() {
    let mut taught: Vec<_> = lessons().iter().map(|(name, _)| (*name).to_owned()).collect();
    taught.sort();
    assert_eq!(taught, support::scene_names());
}
