//! Deviation, by drops and prisms.

use snellius::analysis::{least_deviation, turning_degrees};
use snellius::laws::minimum_deviation;
use snellius::light::Wavelength;
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

#[test]
fn the_ray_of_least_deviation_is_found_between_the_traced_ones() {
    // A fan from beside a prism: wherever it stands, the least deviation is the closed form's.
    for (n, apex) in [(1.5168, 60.0), (1.7, 40.0), (1.5, 50.0)] {
        let run = run_text(&format!(
            "(bodies: [(shape: Prism(apex_angle: {apex}, side: 40), medium: Index({n}))],
            sources: [(light: Fan(from: (-57, -19.6), direction: Towards((0, 0)), spread: 12, rays: 12))],
            trace: (min_power: 0, max_depth: 3))"
        ));
        let least = least_deviation(&run.system, 0, "tt", Wavelength::D).unwrap();
        close(least.degrees, -minimum_deviation(n, apex).unwrap(), 1e-12, "toward the base");
        let coarse = run.trace.tree.rays.iter().filter_map(|ray| {
            let end = ray.segments.iter().find(|end| ray.address(end.id).ends_with(":tt"))?;
            turning_degrees(ray, end.id)
        });
        let coarse = coarse.map(f64::abs).fold(f64::INFINITY, f64::min);
        assert!(coarse > least.degrees.abs() + 1e-6, "{coarse}: no ray of the fan is as good");
    }
}

#[test]
fn the_rainbows_ray_is_found_in_a_beam() {
    let n: f64 = 1.333;
    let run = run_text(
        "(bodies: [(shape: Disk(10), at: (500, 0), medium: Index(1.333))],
        sources: [(light: Beam(center: (450, 6), direction: Angle(0), width: 7.7, rays: 9))], trace: (min_power: 0, max_depth: 4))",
    );
    let least = least_deviation(&run.system, 0, "trt", Wavelength::D).unwrap();
    // Descartes: cos² θ_i = (n² − 1)/3, and 180° + 2 θ_i − 4 θ_t.
    let sine = (1.0 - (n * n - 1.0) / 3.0).sqrt();
    let asin = snellius::numerics::asin_degrees;
    close(least.degrees, -(180.0 + 2.0 * asin(sine) - 4.0 * asin(sine / n)), 1e-12, "degrees");
    close(least.from.y, 10.0 * sine, 1e-6, "height");
    assert_eq!(least_deviation(&run.system, 0, "trx", Wavelength::D), None);
    assert_eq!(least_deviation(&run.system, 1, "trt", Wavelength::D), None);
}
