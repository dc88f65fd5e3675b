//! Random scenes against the reference.

use std::collections::BTreeMap;

use snellius::compile;

use crate::compare::compare;
use crate::generator::Generator;
use crate::support::figures::{at_most, counted, size};

#[test]
fn random_scenes_agree() {
    let wanted = size(100, 1000);
    let mut generator = Generator::new(1);
    let (mut in_sizes, mut in_conditions, mut compared, mut set_aside) = (0.0_f64, 0.0_f64, 0, 0);
    let (mut scenes, mut doubts, mut worst) = (0, BTreeMap::new(), String::new());
    while scenes < wanted {
        let scene = generator.scene();
        // What crosses itself is refused.
        if compile(&scene).is_err() {
            continue;
        }
        scenes += 1;
        let findings = compare(&scene);
        if !findings.faults.is_empty() { println!("{scenes}: {:?} {:?}", &findings.faults[..findings.faults.len().min(3)], findings.worst); 
            if std::env::var_os("SHOW").is_some() {
            println!("{:?}\n{:?}", scene.surroundings, scene.trace);
            for b in &scene.bodies { println!("{:?} {:?} {:?} {:?}", b.shape, b.at, b.rotate, b.substance) }
            for b in &scene.sources { println!("{:?} {:?}", b.light, b.spectrum) }
            }
        }
        if findings.in_conditions > in_conditions {
            worst = format!("scene {scenes}, {}", findings.worst);
        }
        in_sizes = in_sizes.max(findings.in_sizes);
        in_conditions = in_conditions.max(findings.in_conditions);
        compared += findings.compared;
        set_aside += findings.set_aside;
        findings.doubts.into_iter().for_each(|(doubt, count)| *doubts.entry(doubt).or_insert(0) += count);
    }
    println!("worst: {worst}; branches set aside: {doubts:?}");
    counted("random scenes against the reference: segments compared", f64::from(u32::try_from(compared).unwrap()));
    let share = set_aside as f64 / (compared + set_aside) as f64;
    at_most("random scenes against the reference: segments set aside", share, 0.03);
    at_most("random scenes against the reference: largest error of a position, sizes", in_sizes, 1e-9);
    at_most("random scenes against the reference: largest error, u × condition", in_conditions, 100.0);
}
