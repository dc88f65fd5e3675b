//! Deviation by a prism.

use glam::DVec2;
use snellius::numerics::{Turn, atan2_degrees, cross};
use snellius::trace::Trace;

use crate::truth::{Row, TOLERANCE, branch, close, table, traced};

/// What a prism does to a ray.
#[derive(Debug, PartialEq)]
enum Passage {
    /// Deviation toward the base and angle of emergence, degrees.
    Through {
        deviation: f64,
        emergence: f64,
    },
    TotallyReflected,
}

/// A ray onto the middle of the left face. The prism is turned so that this face is upright, its base to the right.
fn trace_prism(n: &str, apex_angle: f64, incidence: f64) -> Trace {
    let half = Turn::degrees(0.5 * apex_angle);
    let side = 30.0;
    let middle = half.apply(DVec2::new(-0.5 * side * half.sin, side * half.cos / 6.0));
    let from = middle - 20.0 * Turn::degrees(incidence).direction();
    traced(&format!(
        "(
            title: \"A prism\",
            bodies: [(shape: Prism(apex_angle: {apex_angle}, side: {side}), rotate: {}, medium: Index({n}))],
            sources: [(light: Ray(from: ({}, {}), direction: Angle({incidence})))],
            trace: (secondary_rays: TransmittedOnly),
        )",
        0.5 * apex_angle,
        from.x,
        from.y
    ))
}

fn passage(row: &Row, incidence: f64) -> Passage {
    let trace = trace_prism(row.text("n"), row.number("apex_deg"), incidence);
    let ray = &trace.tree.rays[0];
    let incoming = &ray.segments[0];
    close(incoming.hit.unwrap().theta_i_degrees(), incidence.abs(), TOLERANCE, &row.what);
    let at_second_face = branch(ray, "t").unwrap().hit.unwrap();
    if at_second_face.total_internal_reflection {
        assert!(branch(ray, "ti").is_some() && branch(ray, "tt").is_none(), "{}", row.what);
        return Passage::TotallyReflected;
    }
    let out = branch(ray, "tt").unwrap().direction;
    Passage::Through {
        deviation: atan2_degrees(cross(out, incoming.direction), out.dot(incoming.direction)),
        emergence: at_second_face.theta_t_degrees().unwrap(),
    }
}

fn deviation(row: &Row, incidence: f64) -> f64 {
    match passage(row, incidence) {
        Passage::Through { deviation, .. } => deviation,
        Passage::TotallyReflected => panic!("{} at {incidence}° is totally reflected", row.what),
    }
}

#[test]
fn deviation_against_incidence() {
    for row in table("prism_deviation_vs_incidence.csv", 42) {
        let passage = passage(&row, row.number("incidence_deg"));
        if row.text("deviation_deg") == "TIR" {
            assert_eq!(passage, Passage::TotallyReflected, "{}", row.what);
            continue;
        }
        let Passage::Through { deviation, emergence } = passage else { panic!("{} is totally reflected", row.what) };
        close(deviation, row.number("deviation_deg"), TOLERANCE, &row.what);
        close(emergence, row.number("emergence_deg"), TOLERANCE, &row.what);
    }
}

#[test]
fn minimum_deviation_is_symmetric() {
    for row in table("prism_min_deviation.csv", 66) {
        let incidence = row.number("incidence_at_min_dev_deg");
        let Passage::Through { deviation, emergence } = passage(&row, incidence) else {
            panic!("{} is totally reflected", row.what)
        };
        close(deviation, row.number("min_deviation_deg"), TOLERANCE, &row.what);
        close(emergence, incidence, TOLERANCE, &row.what);
    }
}

#[test]
fn no_ray_deviates_less() {
    for row in table("prism_min_deviation.csv", 66) {
        let incidence = row.number("incidence_at_min_dev_deg");
        let least = deviation(&row, incidence);
        for step in [-1.0, -1e-3, 1e-3, 1.0] {
            assert!(deviation(&row, incidence + step) > least, "{} at {step:+}°", row.what);
        }
    }
}

#[test]
fn minimum_deviation_as_published() {
    let mut rows = table("prism_min_deviation.csv", 66);
    rows.retain(|row| !row.text("published_value").is_empty());
    assert_eq!(rows.len(), 1);
    for row in rows {
        let deviation = deviation(&row, row.number("incidence_at_min_dev_deg"));
        // Published with eight decimals, of which the last is off.
        close(deviation, row.number("published_value"), 0.5e-7, &row.what);
    }
}

#[test]
fn second_face_reflects_totally_below_the_limiting_incidence() {
    for row in table("prism_min_deviation.csv", 66) {
        let limit = row.number("min_incidence_without_TIR_deg");
        assert_eq!(passage(&row, limit - 1e-9), Passage::TotallyReflected, "{}", row.what);
        assert_ne!(passage(&row, limit + 1e-9), Passage::TotallyReflected, "{}", row.what);
    }
}
