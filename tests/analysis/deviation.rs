//! Deviation, by drops and prisms.

use snellius::analysis::turning_degrees;
use snellius::laws::minimum_deviation;
use snellius::numerics::Turn;
use snellius::trace::SegmentId;

use crate::support::tables::{close, number, table};
use crate::support::{run_text, segment};

/// Descartes rays of the first and second rainbow: the second turns by more than half a turn.
#[test]
fn light_turns_on_in_a_drop() {
    let mut largest: f64 = 0.0;
    for row in table("angles_critical_brewster_rainbow.csv", 18) {
        let Some(rainbow) = row.text("material").strip_prefix("rainbow") else { continue };
        let reflections: usize = rainbow.split(['=', ' ']).nth(2).unwrap().parse().unwrap();
        let named = |column: &str| number(row.text(column).split_once('=').unwrap().1);
        let incidence = Turn::degrees(named("critical_deg(to air)"));
        for side in [1.0, -1.0] {
            let trace = run_text(&format!(
                "(bodies: [(shape: Disk(10), medium: Index({}))],
                sources: [(light: Ray(from: (-20, {}), direction: Angle(0)))], trace: (max_depth: 4, min_power: 0))",
                row.text("n"),
                side * 10.0 * incidence.sin
            ))
            .trace;
            let ray = &trace.tree.rays[0];
            let end = segment(ray, &format!("t{}t", "r".repeat(reflections)));
            let expected = named("brewster_deg(from air)");
            close(turning_degrees(ray, end.id).unwrap(), -side * expected, 1e-11, &row.what);
            largest = largest.max(expected);
        }
    }
    assert!(largest > 230.0);
}

#[test]
fn light_turns_round_more_than_once() {
    // Grazing light in a disk creeps along the rim: by 2 (90° − θ_t) at every inner reflection.
    let trace = run_text(
        "(bodies: [(shape: Disk(10), medium: Index(1.5))],
        sources: [(light: Ray(from: (-20, 9.99), direction: Angle(0)))], trace: (max_depth: 9, min_power: 0))",
    )
    .trace;
    let ray = &trace.tree.rays[0];
    let end = segment(ray, "trrrrrr");
    let hit = ray.segments[0].hit.unwrap();
    let (theta_i, theta_t) = (hit.theta_i_degrees(), hit.theta_t_degrees().unwrap());
    let expected = theta_i - theta_t + 6.0 * (180.0 - 2.0 * theta_t);
    assert!(expected > 540.0);
    close(turning_degrees(ray, end.id).unwrap(), -expected, 1e-11, "six reflections");
    assert_eq!(turning_degrees(ray, SegmentId(0)), Some(0.0));
    assert_eq!(turning_degrees(ray, SegmentId(9999)), None);
}

#[test]
fn minimum_deviation_of_prisms() {
    for row in table("prism_min_deviation.csv", 66) {
        let deviation = minimum_deviation(row.number("n"), row.number("apex_deg")).unwrap();
        close(deviation, row.number("min_deviation_deg"), 1e-12, &row.what);
    }
}
