//! How the time per segment grows with edges, rays and depth.

use std::time::Instant;

use snellius::Scene;

use crate::contest::{Contest, OURS, PARRY, SCALAR};
use crate::figures::Bound;
use crate::optics::{by_power, compile, scattered, to_depth};
use crate::plot::{Curve, Panel};
use crate::race::{Times, race};
use crate::scenes::slabs;
use crate::study::Study;
use crate::table::{Table, digits};

/// A scene of ten times the edges is left out where this one took longer to compile and trace, in seconds.
const PATIENCE: f64 = 12.0;
/// The scalar loop takes part up to this many edges.
const SCALAR_EDGES: usize = 10_000;
const COMPETITORS: [&str; 3] = [OURS, SCALAR, PARRY];

/// Times at one place of a sweep.
struct Measured {
    x: f64,
    times: Times,
}

/// The growth with edges; whether the largest size but one was reached.
pub(crate) fn edges(study: &mut Study) -> bool {
    let mut table = Table::new("edges", &["edges", "segments followed", "compile (s)", OURS, SCALAR, PARRY]);
    let last = study.size(4, 6);
    let (mut results, mut spent) = (Vec::new(), 0.0);
    for edges in (1..=last).map(|power| 10_usize.pow(power)) {
        if spent > PATIENCE {
            println!("left out: {edges} edges, since a tenth of them took {spent:.0} s");
            break;
        }
        let scene = by_power(scattered(edges / 10, 10, study.size(4, 64)));
        let compiling = seconds(|| drop(compile(&scene)));
        let contest = Contest::new(&scene);
        spent = compiling.max(seconds(|| drop(snellius::summarize(&contest.system))));
        let times = timed(study, &contest, edges <= SCALAR_EDGES);
        let [ours, scalar, parry] = COMPETITORS.map(|name| times.get(name).map_or(String::new(), digits));
        table.row([edges.to_string(), contest.followed.to_string(), digits(compiling), ours, scalar, parry]);
        results.push(Measured { x: edges as f64, times });
    }
    study.save(&table);
    study.draw("edges", &[panel("Scattered polygons", "edges", &results)]);
    growth_figure(study, last, &results);
    results.len() + 1 >= last as usize
}

fn seconds(run: impl FnOnce()) -> f64 {
    let start = Instant::now();
    run();
    start.elapsed().as_secs_f64()
}

fn growth_figure(study: &mut Study, last: u32, results: &[Measured]) {
    let name = format!("growth_1e1_to_1e{last}");
    let bound = Bound::AtMost { bound: 15.0, goal: 8.0 };
    match results {
        [first, .., largest] if results.len() == last as usize => {
            study.figures.ratio(&name, largest.times.of(OURS) / first.times.of(OURS), bound);
        }
        _ => study.figures.unmeasured(&name, "compiling or tracing takes too long", bound),
    }
}

/// The growth with rays and depth.
pub(crate) fn rays_and_depth(study: &mut Study) {
    let mut table = Table::new("sweeps", &["scene", "sweep", "value", "segments followed", OURS, SCALAR, PARRY]);
    let many = |rays: u32| rays as usize;
    let scenes: [(&str, &dyn Fn(u32) -> Scene); 2] =
        [("10 slab surfaces", &slabs), ("500 polygons", &|rays| scattered(500, 5, many(rays)))];
    let rays = study.size(vec![1, 4], vec![1, 2, 4, 8, 16, 32, 64]);
    let depths = study.size(vec![2, 8], vec![1, 2, 4, 8, 16, 32, 64]);
    let (mut by_rays, mut by_depth) = (Vec::new(), Vec::new());
    for (name, scene) in scenes {
        let swept = rays.iter().map(|rays| (*rays, by_power(scene(*rays))));
        let results = sweep(study, &mut table, [name, "rays"], swept.collect());
        by_rays.push(panel(name, "rays", &results));
        let swept = depths.iter().map(|depth| (*depth, to_depth(scene(study.size(2, 16)), *depth)));
        let results = sweep(study, &mut table, [name, "max_depth"], swept.collect());
        by_depth.push(panel(name, "max_depth", &results));
    }
    study.save(&table);
    study.draw("rays", &by_rays);
    study.draw("depth", &by_depth);
}

fn sweep(study: &Study, table: &mut Table, words: [&str; 2], scenes: Vec<(u32, Scene)>) -> Vec<Measured> {
    let mut results = Vec::new();
    for (value, scene) in scenes {
        let contest = Contest::new(&scene);
        let times = timed(study, &contest, true);
        let [scene, sweep] = words.map(str::to_owned);
        let [ours, scalar, parry] = COMPETITORS.map(|name| digits(times.of(name)));
        table.row([scene, sweep, value.to_string(), contest.followed.to_string(), ours, scalar, parry]);
        results.push(Measured { x: f64::from(value), times });
    }
    results
}

fn timed(study: &Study, contest: &Contest, with_scalar: bool) -> Times {
    let mut tasks = contest.tasks();
    if with_scalar {
        tasks.push(contest.scalar());
    }
    race(study, tasks)
}

fn panel(title: &str, axis: &'static str, results: &[Measured]) -> Panel {
    let curve = |name: &'static str| {
        let points = results.iter().filter_map(|result| Some((result.x, result.times.get(name)?))).collect();
        Curve { name: name.into(), points, is_joined: true }
    };
    Panel { title: title.into(), axes: [axis, "ns per segment"], curves: COMPETITORS.map(curve).into() }
}
