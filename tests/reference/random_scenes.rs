//! Random scenes against the reference.

use std::collections::{BTreeMap, HashSet};
use std::mem::discriminant;

use glam::DVec2;
use snellius::compile;

use crate::bench::Bench;
use crate::compare::compare;
use crate::generator::Generator;
use crate::support::figures::{at_most, counted, size};

#[test]
fn random_scenes_agree() {
    let mut generator = Generator::new(1);
    // What crosses itself is refused.
    let mut scene = || {
        let mut scene = generator.scene();
        let walls = Bench::new(&scene, DVec2::ZERO).walls;
        scene.sources.push(generator.aimed(&walls));
        scene
    };
    let scenes = std::iter::repeat_with(&mut scene).filter(|scene| compile(scene).is_ok());
    let (mut in_sizes, mut in_conditions, mut compared, mut set_aside) = (0.0_f64, 0.0_f64, 0, 0);
    let (mut shapes, mut doubts, mut worst) = (HashSet::new(), BTreeMap::new(), String::new());
    for (number, scene) in scenes.take(size(100, 1000) as usize).enumerate() {
        let findings = compare(&scene);
        assert!(findings.faults.is_empty(), "scene {number}: {:#?}\n{scene:#?}", findings.faults);
        if findings.in_conditions > in_conditions {
            worst = format!("scene {number}, {}", findings.worst);
        }
        in_sizes = in_sizes.max(findings.in_sizes);
        in_conditions = in_conditions.max(findings.in_conditions);
        compared += findings.compared;
        set_aside += findings.set_aside;
        findings.doubts.into_iter().for_each(|(doubt, count)| *doubts.entry(doubt).or_insert(0) += count);
        shapes.extend(scene.bodies.iter().map(|body| discriminant(&body.shape)));
    }
    println!("worst: {worst}; branches set aside: {doubts:?}");
    assert_eq!(shapes.len(), 13, "every shape takes part");
    counted("random scenes against the reference: segments compared", compared as f64);
    let share = set_aside as f64 / (compared + set_aside) as f64;
    at_most("random scenes against the reference: segments set aside", share, 0.04);
    at_most("random scenes against the reference: largest error of a position, sizes", in_sizes, 1e-9);
    at_most("random scenes against the reference: largest error, u × condition", in_conditions, 10.0);
}
