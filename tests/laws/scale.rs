//! Scenes of very many bodies: they compile right, and eight times the bodies do not take much more than eight times the
//! time.

use std::fmt::Write as _;
use std::time::Instant;

use glam::DVec2;
use snellius::Scene;
use snellius::compile::compile;
use snellius::scene::{Medium, SecondaryRays, Shape, Substance};
use snellius::trace::Ending;

use crate::scenes::{body, towards};
use crate::support::figures::size;
use crate::support::random::Random;
use crate::support::run_scene;

/// Squares of width 6, 10 apart in rows and columns, written in a random order; a ray through all of every third row.
fn squares(side: u32) -> Scene {
    let mut places: Vec<DVec2> =
        (0..side * side).map(|k| 10.0 * DVec2::new(f64::from(k % side), f64::from(k / side))).collect();
    let mut random = Random(3);
    for k in (1..places.len()).rev() {
        places.swap(k, random.below(k + 1));
    }
    // No two of one medium.
    let glass = |k: usize| Substance::Medium(Medium::Index(1.5 + 1e-6 * k as f64));
    let square = |(k, at)| body(Shape::Rectangle { width: 6.0, height: 6.0 }, glass(k)).placed(at, 0.0);
    let row = |k: u32| 30.0 * f64::from(k) + 0.5;
    let mut scene = Scene::new(
        places.into_iter().enumerate().map(square).collect(),
        (0..side.div_ceil(3)).map(|k| towards(DVec2::new(-20.0, row(k)), DVec2::new(0.0, row(k)))).collect(),
    );
    (scene.trace.secondary_rays, scene.trace.max_depth) = (SecondaryRays::TransmittedOnly, 4 * side);
    scene
}

/// The same squares as the text of a file.
fn text(scene: &Scene) -> String {
    let mut text = String::from("(bodies: [\n");
    for (k, body) in scene.bodies.iter().enumerate() {
        let (Shape::Rectangle { width, height }, DVec2 { x, y }) = (&body.shape, body.at) else { unreachable!() };
        writeln!(text, "(name: \"s{k}\", shape: Rectangle({width}, {height}), at: ({x}, {y}), medium: Index(1.5)),")
            .unwrap();
    }
    text + "])"
}

#[test]
fn every_body_of_a_hundred_thousand_is_hit_where_it_stands() {
    let side = size(100, 317);
    let run = run_scene(squares(side));
    assert_eq!(run.system.interfaces().len(), 4 * run.scene.bodies.len());
    assert_eq!(run.trace.tree.rays.len(), side.div_ceil(3) as usize);
    for (k, ray) in run.trace.tree.rays.iter().enumerate() {
        let (last, met) = ray.segments.split_last().unwrap();
        assert_eq!((last.ending, met.len()), (Ending::Escaped, 2 * side as usize));
        for (number, segment) in met.iter().enumerate() {
            let center = DVec2::new(10.0 * (number / 2) as f64, 30.0 * k as f64);
            let face = if number % 2 == 0 { -3.0 } else { 3.0 };
            assert!(segment.to.unwrap().distance(center + DVec2::new(face, 0.5)) < 1e-9, "{segment:?}");
            assert_eq!(run.scene.bodies[segment.hit.unwrap().body].at, center);
        }
    }
}

/// A pass that compares all with all takes 64 times as long for 8 times the bodies. Times vary where other work goes on, so
/// that the least of several ratios counts.
#[track_caller]
fn grows_in_proportion(what: &str, job: impl Fn(u32)) {
    let seconds = |side: u32| {
        let begun = Instant::now();
        job(side);
        begun.elapsed().as_secs_f64()
    };
    let ratios = (0..7).map(|_| seconds(91) / seconds(32));
    let least = ratios.fold(f64::INFINITY, f64::min);
    assert!(least < 4.0 * 8.0, "{what}: {least} times as long for 8 times as many");
}

#[test]
fn compiling_takes_time_in_proportion() {
    let scenes: Vec<_> = [32, 91].map(squares).into();
    grows_in_proportion("compile", |side| {
        let scene = scenes.iter().find(|scene| scene.bodies.len() == (side * side) as usize).unwrap();
        assert!(compile(scene).is_ok());
    });
}

#[test]
fn reading_takes_time_in_proportion() {
    let texts: Vec<_> = [32, 91].map(|side| (side, text(&squares(side)))).into();
    grows_in_proportion("load", |side| {
        let (_, text) = texts.iter().find(|(of, _)| *of == side).unwrap();
        assert!(Scene::from_ron(text).is_ok());
    });
}
