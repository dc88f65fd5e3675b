//! One flat boundary: Fresnel's equations, the critical angle, Brewster's angle.

use snellius::light::Power;
use snellius::numerics::Turn;
use snellius::trace::{Segment, Trace, TracedRay};

use crate::truth::{Row, TOLERANCE, branch, close, number, table, traced};

/// Three rays into a flat face at this angle of incidence: S, P and unpolarized.
fn boundary(n_i: f64, n_t: f64, theta_i: f64) -> Trace {
    let from = -10.0 * Turn::degrees(theta_i).direction();
    let ray = format!("light: Ray(from: ({}, {}), direction: Angle({theta_i}))", from.x, from.y);
    traced(&format!(
        "(
            title: \"A flat boundary\",
            surroundings: Index({n_i}),
            bodies: [(shape: Rectangle(20, 40), at: (10, 0), medium: Index({n_t}))],
            sources: [({ray}, polarization: S), ({ray}, polarization: P), ({ray})],
            trace: (max_depth: 1),
        )"
    ))
}

/// The three rays' own segments, with their hits.
fn arriving(trace: &Trace) -> [&Segment; 3] {
    [0, 1, 2].map(|source| &trace.tree.rays[source].segments[0])
}

/// Power of a branch, 0 where it was not spawned.
fn power(ray: &TracedRay, path: &str) -> f64 {
    branch(ray, path).map_or(0.0, |segment| segment.power.total())
}

#[test]
fn reflectance_and_transmittance_by_polarization() {
    for row in table("fresnel.csv", 195) {
        let trace = boundary(row.number("n1"), row.number("n2"), row.number("theta_i_deg"));
        let reflected = if row.text("flag") == "TIR" { "i" } else { "r" };
        for (source, reflectance, transmittance) in [(0, "R_s", "T_s"), (1, "R_p", "T_p")] {
            let (r, t) = (row.number(reflectance), row.number(transmittance));
            let ray = &trace.tree.rays[source];
            close(power(ray, reflected), r, TOLERANCE, &row.what);
            close(power(ray, "t"), t, TOLERANCE, &row.what);
            let hit = ray.segments[0].hit.unwrap();
            close(hit.reflected_share(ray.segments[0].power), r, TOLERANCE, &row.what);
            close(hit.transmitted_share(ray.segments[0].power), t, TOLERANCE, &row.what);
        }
        close(power(&trace.tree.rays[2], reflected), row.number("R_unpol"), TOLERANCE, &row.what);
    }
}

#[test]
fn each_polarization_stays_what_it_is() {
    let trace = boundary(1.0, 1.5, 40.0);
    let [s, p] = [0, 1].map(|source| branch(&trace.tree.rays[source], "r").unwrap().power);
    assert_eq!(s, Power { s: s.total(), p: 0.0 });
    assert_eq!(p, Power { s: 0.0, p: p.total() });
    assert!(s.total() > p.total() && p.total() > 0.0);
}

#[test]
fn angle_of_transmission() {
    for row in table("fresnel.csv", 195) {
        let trace = boundary(row.number("n1"), row.number("n2"), row.number("theta_i_deg"));
        let hit = arriving(&trace)[0].hit.unwrap();
        close(hit.theta_i_degrees(), row.number("theta_i_deg"), TOLERANCE, &row.what);
        if row.text("flag") == "TIR" {
            assert!(hit.total_internal_reflection && hit.theta_t_degrees().is_none(), "{}", row.what);
            continue;
        }
        // Near the critical angle, the last digit of the angle of incidence moves that of transmission by dθ_t/dθ_i as much.
        let spread = row.number("n1") * hit.cos_i / (row.number("n2") * hit.cos_t.unwrap());
        let tolerance = TOLERANCE * spread.max(1.0);
        close(hit.theta_t_degrees().unwrap(), row.number("theta_t_deg"), tolerance, &row.what);
    }
}

/// The rows of media, without those of the rainbow.
fn media() -> Vec<Row> {
    let mut rows = table("angles_critical_brewster_rainbow.csv", 18);
    rows.retain(|row| !row.text("material").starts_with("rainbow"));
    assert_eq!(rows.len(), 12);
    rows
}

#[test]
fn critical_angle_parts_transmission_from_total_reflection() {
    for row in media() {
        let (n, critical) = (row.number("n"), row.number("critical_deg(to air)"));
        let below = boundary(n, 1.0, critical - 1e-9);
        let hit = arriving(&below)[0].hit.unwrap();
        close(hit.critical_degrees().unwrap(), critical, TOLERANCE, &row.what);
        let beyond = boundary(n, 1.0, critical + 1e-9);
        for source in 0..3 {
            let [below, beyond] = [&below, &beyond].map(|trace| &trace.tree.rays[source]);
            assert!(power(below, "t") > 0.0 && branch(below, "i").is_none(), "{}", row.what);
            assert!(branch(beyond, "t").is_none(), "{}", row.what);
            close(power(beyond, "i"), 1.0, TOLERANCE, &row.what);
        }
    }
}

#[test]
fn no_critical_angle_into_the_denser_medium() {
    for row in media() {
        let trace = boundary(1.0, row.number("n"), 89.9);
        let hit = arriving(&trace)[0].hit.unwrap();
        assert!(hit.critical_degrees().is_none() && !hit.total_internal_reflection, "{}", row.what);
    }
}

#[test]
fn brewsters_angle_reflects_no_p_from_either_side() {
    for row in media() {
        let n = row.number("n");
        for (n_i, n_t, column) in [(1.0, n, "brewster_deg(from air)"), (n, 1.0, "brewster_deg(from inside)")] {
            let trace = boundary(n_i, n_t, row.number(column));
            let [s, p, unpolarized] = [0, 1, 2].map(|source| &trace.tree.rays[source]);
            assert!(power(p, "r") < 1e-30, "{}", row.what);
            close(power(p, "t"), 1.0, TOLERANCE, &row.what);
            // All that is reflected is s, at right angles to what is transmitted.
            assert!(power(s, "r") > 0.01, "{}", row.what);
            close(power(unpolarized, "r"), 0.5 * power(s, "r"), TOLERANCE, &row.what);
            let [r, t] = ["r", "t"].map(|path| branch(s, path).unwrap().direction);
            close(r.dot(t), 0.0, TOLERANCE, &row.what);
        }
    }
}

#[test]
fn reflectance_at_normal_incidence() {
    for row in media() {
        let n = number(row.text("n"));
        for trace in [boundary(1.0, n, 0.0), boundary(n, 1.0, 0.0)] {
            for ray in &trace.tree.rays {
                close(power(ray, "r"), row.number("R_normal"), TOLERANCE, &row.what);
            }
        }
    }
}
