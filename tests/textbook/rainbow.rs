//! The rainbow's Descartes rays in a drop.

use snellius::numerics::{Turn, atan2_degrees};

use crate::truth::{Row, TOLERANCE, branch, close, number, table, traced};

fn rows() -> Vec<Row> {
    let mut rows = table("angles_critical_brewster_rainbow.csv", 18);
    rows.retain(|row| row.text("material").starts_with("rainbow"));
    assert_eq!(rows.len(), 6);
    rows
}

/// A cell such as `incidence=59.39`, under the column that other rows use.
fn named(row: &Row, column: &str, name: &str) -> f64 {
    let (found, value) = row.text(column).split_once('=').unwrap();
    assert_eq!(found, name, "{}", row.what);
    number(value)
}

fn incidence(row: &Row) -> f64 {
    named(row, "critical_deg(to air)", "incidence")
}

fn internal_reflections(row: &Row) -> usize {
    row.text("material").split(['=', ' ']).nth(2).unwrap().parse().unwrap()
}

/// Clockwise deviation, 0 to 360 degrees, of a ray that meets the upper half of a drop.
fn deviation(row: &Row, incidence: f64) -> f64 {
    let height = 10.0 * Turn::degrees(incidence).sin;
    let trace = traced(&format!(
        "(
            title: \"A drop\",
            bodies: [(shape: Disk(10), medium: Index({}))],
            sources: [(light: Ray(from: (-20, {height}), direction: Angle(0)))],
            trace: (max_depth: 4, min_power: 0),
        )",
        row.text("n")
    ));
    let ray = &trace.tree.rays[0];
    close(ray.segments[0].hit.unwrap().theta_i_degrees(), incidence, TOLERANCE, &row.what);
    let path = format!("t{}t", "r".repeat(internal_reflections(row)));
    let out = branch(ray, &path).unwrap().direction;
    atan2_degrees(-out.y, out.x).rem_euclid(360.0)
}

#[test]
fn deviation_of_the_descartes_ray() {
    for row in rows() {
        let deviation = deviation(&row, incidence(&row));
        close(deviation, named(&row, "brewster_deg(from air)", "deviation"), TOLERANCE, &row.what);
        let radius = named(&row, "brewster_deg(from inside)", "bow radius");
        close((deviation - 180.0).abs(), radius, TOLERANCE, &row.what);
    }
}

#[test]
fn no_ray_deviates_less() {
    for row in rows() {
        let least = deviation(&row, incidence(&row));
        for step in [-1.0, -1e-3, 1e-3, 1.0] {
            assert!(deviation(&row, incidence(&row) + step) > least, "{} at {step:+}°", row.what);
        }
    }
}
