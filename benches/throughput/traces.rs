//! Whole traces against the scalar loop, parry2d and the floor.

use snellius::numerics::Sum;
use snellius::{Ending, OpticalSystem, Segment, TracedRay, Visitor, visit};

use crate::contest::{BOXES, Contest, OURS, PARRY, SCALAR};
use crate::figures::Bound;
use crate::floor::Replay;
use crate::optics::{BOUNCES, by_power, guide, scattered, spectrum, to_depth, triplet};
use crate::race::{Task, Times, race};
use crate::scenes::{prism, slabs};
use crate::study::Study;
use crate::table::{Table, digits};

const FLOOR: &str = "floor";
const COLUMNS: [&str; 10] = [
    "scene",
    "edges",
    "segments followed",
    "ns per segment",
    "million segments per second",
    "scalar loop (ns)",
    "parry2d (ns)",
    "its boxes (ns)",
    "floor (ns)",
    "floor / ours",
];

/// Scenes with all competitors; the largest one only where it can be compiled in reasonable time.
pub(crate) fn run(study: &mut Study, with_largest: bool) {
    let mut table = Table::new("traces", &COLUMNS);
    let small = [
        ("prism", prism(study.size(1000, 4000)), "floor_over_trace_prism", 0.5),
        ("10 slab surfaces", slabs(study.size(2, 16)), "floor_over_trace_slabs", 0.4),
        ("Cooke triplet", triplet(study.size(8, 64)), "floor_over_trace_triplet", 0.4),
    ];
    for (name, scene, figure, bound) in small {
        let contest = Contest::new(&by_power(scene));
        let times = timed(study, &contest, true, true);
        row(&mut table, name, &contest, &times);
        study.figures.ratio(figure, times.of(FLOOR) / times.of(OURS), Bound::AtLeast { bound, goal: 0.8 });
        if name == "prism" {
            let bound = Bound::AtLeast { bound: 1.0, goal: 1.5 };
            study.figures.ratio("trace_vs_scalar_prism", times.of(SCALAR) / times.of(OURS), bound);
        }
    }
    polygons(study, &mut table, with_largest);
    others(study, &mut table);
    study.save(&table);
}

fn polygons(study: &mut Study, table: &mut Table, with_largest: bool) {
    let contest = Contest::new(&by_power(scattered(500, 5, study.size(2, 16))));
    let times = timed(study, &contest, true, true);
    row(table, "500 polygons", &contest, &times);
    let over = |name| times.of(name) / times.of(OURS);
    let (scalar, parry) = (Bound::AtLeast { bound: 20.0, goal: 60.0 }, Bound::AtLeast { bound: 3.0, goal: 6.0 });
    study.figures.ratio("trace_vs_scalar_scatter500", over(SCALAR), scalar);
    study.figures.ratio("trace_vs_parry2d_scatter500", over(PARRY), parry);
    if with_largest {
        let contest = Contest::new(&by_power(scattered(study.size(1000, 50_000), 5, study.size(2, 32))));
        let times = timed(study, &contest, false, false);
        row(table, study.size("1000 polygons", "50 000 polygons"), &contest, &times);
    }
}

/// Scenes without a figure.
fn others(study: &Study, table: &mut Table) {
    let contest = Contest::new(&to_depth(guide(study.size(2, 16)), BOUNCES));
    let times = timed(study, &contest, true, true);
    row(table, "light guide, 1000 bounces", &contest, &times);
    // One index an edge: the others know no wavelengths.
    let contest = Contest::new(&by_power(spectrum(study.size(4, 64))));
    let times = race(study, vec![contest.ours()]);
    row(table, "prism of N-BK7, 64 lines", &contest, &times);
}

fn timed(study: &Study, contest: &Contest, with_scalar: bool, with_floor: bool) -> Times {
    let replay = with_floor.then(|| checked(&contest.system, contest.cuts()));
    let mut tasks = contest.tasks();
    if with_scalar {
        tasks.push(contest.scalar());
    }
    if let Some(replay) = &replay {
        tasks.push(Task::new(FLOOR, contest.followed, || balance(replay)));
    }
    race(study, tasks)
}

/// A replay that was seen to give the segments of the trace.
fn checked(system: &OpticalSystem, (min_power, max_depth): (f64, u32)) -> Replay<'_> {
    let replay = Replay::new(system, min_power, max_depth);
    let (mut trace, mut again) = (List(Vec::new()), List(Vec::new()));
    visit(system, &mut trace);
    replay.visit(&mut again);
    assert_eq!(trace.0.len(), again.0.len(), "the replay lists as many segments");
    for (one, other) in trace.0.iter().zip(&again.0) {
        assert!(is_close(one, other), "the replay differs:\n{one:?}\n{other:?}");
    }
    replay
}

/// The same segment up to rounding.
fn is_close(one: &Segment, other: &Segment) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * (1.0 + a.abs());
    let ends = |segment: &Segment| segment.to.unwrap_or(segment.from + segment.direction);
    (one.id, one.parent, one.via, one.ending) == (other.id, other.parent, other.via, other.ending)
        && near(ends(one).distance(ends(other)), 0.0)
        && near(one.power.total(), other.power.total())
        && near(one.optical_path, other.optical_path)
        && near(one.medium_index, other.medium_index)
}

struct List(Vec<Segment>);

impl Visitor for List {
    fn segment(&mut self, _: &TracedRay, segment: Segment) {
        self.0.push(segment);
    }
}

/// The power of a replay, summed up by how its branches end, as a trace without a tree sums it.
fn balance(replay: &Replay) -> Balance {
    let mut balance = Balance::default();
    replay.visit(&mut balance);
    balance
}

#[derive(Default)]
struct Balance {
    segments: u64,
    escaped: Sum,
    cut: Sum,
}

impl Visitor for Balance {
    #[inline]
    fn segment(&mut self, _: &TracedRay, segment: Segment) {
        self.segments += 1;
        match segment.ending {
            Ending::Interface => {}
            Ending::Escaped => self.escaped.add(segment.power.total()),
            _ => self.cut.add(segment.power.total()),
        }
    }
}

fn row(table: &mut Table, name: &str, contest: &Contest, times: &Times) {
    let ours = times.of(OURS);
    let time = |name| times.get(name).map_or(String::new(), digits);
    let floor = times.get(FLOOR).map_or(String::new(), |floor| digits(floor / ours));
    let edges = contest.system.interfaces().len().to_string();
    let [speed, ours] = [1e3 / ours, ours].map(digits);
    let followed = contest.followed.to_string();
    let [scalar, parry, boxes, least] = [SCALAR, PARRY, BOXES, FLOOR].map(time);
    table.row([name.into(), edges, followed, ours, speed, scalar, parry, boxes, least, floor]);
}
