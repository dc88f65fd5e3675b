//! Every scene file against the reference, its errors held as ceilings.
use crate::compare::compare;
use crate::support::{self, figures::U};

#[test]
fn every_scene() {
    for name in support::scene_names() {
        let path = support::root().join("scenes").join(format!("{name}.ron"));
        let scene = snellius::Scene::from_ron(&std::fs::read_to_string(path).unwrap()).unwrap();
        let start = std::time::Instant::now();
        let f = compare(&scene);
        println!("{name} {} {} {} {:.1e} ({:.1} u) {:.2} {:?} {:?} {:?} {:?}", f.rays, f.compared, f.set_aside, f.in_sizes, f.in_sizes/U, f.in_conditions, f.worst, f.doubts, &f.faults[..f.faults.len().min(3)], start.elapsed());
    }
}
