//! The laws held against tables computed in 60-digit arithmetic, and against what must hold for every ray.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod support;

use glam::DVec2;
use proptest::prelude::*;
use snellius::laws::{
    Refraction, brewster_angle, critical_angle, fresnel, reflect, refract, refract_vector_form, relative_index,
};
use snellius::light::FRAUNHOFER;
use snellius::media::catalog;
use snellius::numerics::{Turn, asin_degrees, cross};

use support::tables::{close, table};

/// Unit roundoff of f64.
const U: f64 = f64::EPSILON / 2.0;
const N: DVec2 = DVec2::NEG_X;

#[test]
fn fresnel_equations() {
    let mut transmitted = 0;
    for row in table("fresnel.csv", 195) {
        let (n_i, n_t, what) = (row.number("n1"), row.number("n2"), &row.what);
        match refract(Turn::degrees(row.number("theta_i_deg")).direction(), N, n_i, n_t) {
            Refraction::TotalInternalReflection { .. } => assert_eq!(row.text("flag"), "TIR", "{what}"),
            Refraction::Refracted { cos_i, sin_i, cos_t, sin_t, .. } => {
                transmitted += 1;
                close(asin_degrees(sin_t), row.number("theta_t_deg"), 1e-12 / cos_t, what);
                let f = fresnel(n_i, n_t, cos_i, sin_i, cos_t, sin_t);
                // An angle of incidence rounded by 2 U moves r_p by 4 U (n_i/n_t)²/C2 near the critical angle, and R by twice that.
                let tolerance = 1e-14_f64.max(16.0 * U * (n_i / n_t) * (n_i / n_t) / cos_t);
                let actual = [f.r_s, f.r_p, f.reflectance.s, f.reflectance.p, f.transmittance.s, f.transmittance.p];
                for (actual, column) in actual.into_iter().zip(["r_s", "r_p", "R_s", "R_p", "T_s", "T_p"]) {
                    close(actual, row.number(column), tolerance, &format!("{column} in {what}"));
                }
                close(0.5 * f.reflectance.total(), row.number("R_unpol"), tolerance, what);
            }
        }
    }
    assert_eq!(transmitted, 160);
}

#[test]
fn critical_and_brewster_angles() {
    let mut rows = table("angles_critical_brewster_rainbow.csv", 18);
    rows.retain(|row| !row.text("material").starts_with("rainbow"));
    assert_eq!(rows.len(), 12);
    for row in rows {
        let n = row.number("n");
        close(critical_angle(n, 1.0).unwrap(), row.number("critical_deg(to air)"), 1e-12, &row.what);
        close(brewster_angle(1.0, n), row.number("brewster_deg(from air)"), 1e-12, &row.what);
        close(brewster_angle(n, 1.0), row.number("brewster_deg(from inside)"), 1e-12, &row.what);
        let normal = fresnel(1.0, n, 1.0, 0.0, 1.0, 0.0);
        close(normal.reflectance.s, row.number("R_normal"), 1e-14, &row.what);
    }
}

#[test]
fn catalog_indices() {
    for row in table("materials_lines.csv", 20) {
        let medium = catalog::find(row.text("material")).unwrap().dispersion();
        for line in FRAUNHOFER {
            let what = format!("{} in {}", line.letter, row.what);
            close(medium.index(line.wavelength), row.number(line.letter), 1e-9, &what);
        }
    }
}

/// A ray at a boundary: its direction, the normal against it, and the indices.
#[derive(Clone, Copy, Debug)]
struct Arrival {
    v: DVec2,
    n: DVec2,
    n_i: f64,
    n_t: f64,
}

impl Arrival {
    fn refract(self) -> Refraction {
        refract(self.v, self.n, self.n_i, self.n_t)
    }
}

/// Angles of incidence even and near both ends, normals in every direction, indices far apart and nearly equal.
fn arrivals() -> impl Strategy<Value = Arrival> {
    let angle = prop_oneof![
        -90.0..90.0,
        (-14.0..1.0, any::<bool>()).prop_map(|(e, left)| power_of_ten(e).copysign(if left { 1.0 } else { -1.0 })),
        (-10.0..1.0, any::<bool>())
            .prop_map(|(e, left)| { (90.0 - power_of_ten(e)).copysign(if left { 1.0 } else { -1.0 }) }),
    ];
    let indices = prop_oneof![
        (1.0..4.0, 1.0..4.0),
        (1.0..4.0, -12.0..-1.0, any::<bool>()).prop_map(|(n, e, denser)| {
            let other = n * (1.0 + power_of_ten(e));
            if denser { (n, other) } else { (other, n) }
        }),
    ];
    (angle, 0.0..360.0, indices).prop_map(|(angle, normal, (n_i, n_t)): (f64, f64, (f64, f64))| Arrival {
        v: -Turn::degrees(normal + angle).direction(),
        n: Turn::degrees(normal).direction(),
        n_i,
        n_t,
    })
}

fn power_of_ten(exponent: f64) -> f64 {
    snellius::numerics::pow(10.0, exponent)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_not_reflected_is_transmitted(a in arrivals()) {
        if let Refraction::Refracted { cos_i, sin_i, cos_t, sin_t, .. } = a.refract() {
            let f = fresnel(a.n_i, a.n_t, cos_i, sin_i, cos_t, sin_t);
            for (r, t) in [(f.reflectance.s, f.transmittance.s), (f.reflectance.p, f.transmittance.p)] {
                prop_assert!((0.0..=1.0).contains(&r) && (0.0..=1.0).contains(&t));
                prop_assert!((r + t - 1.0).abs() <= 2.0 * U);
            }
        }
    }

    #[test]
    fn the_textbook_amplitudes_agree(a in arrivals()) {
        if let Refraction::Refracted { cos_i, sin_i, cos_t, sin_t, .. } = a.refract() {
            let f = fresnel(a.n_i, a.n_t, cos_i, sin_i, cos_t, sin_t);
            let (s_i, s_t, p_i, p_t) = (a.n_i * cos_i, a.n_t * cos_t, a.n_t * cos_i, a.n_i * cos_t);
            let (s, p) = (s_i + s_t, p_i + p_t);
            // The forms differ by how well the rounded cosines and sines obey C² + S² = 1, over the squared sum.
            let n = a.n_i.max(a.n_t);
            prop_assert!((f.r_s - (s_i - s_t) / s).abs() <= 4.0 * U + 32.0 * U * n * n / (s * s));
            prop_assert!((f.r_p - (p_i - p_t) / p).abs() <= 4.0 * U + 32.0 * U * n * n / (p * p));
            // Transmitted power from the transmitted amplitude: T = (n_t C2/n_i C1) t² with t_s = 2 n_i C1/(n_i C1 + n_t C2).
            let t_s = 2.0 * s_i / s;
            if cos_i > 0.0 {
                prop_assert!((f.transmittance.s - s_t / s_i * t_s * t_s).abs() <= 8.0 * U + 64.0 * U * n * n / (s * s));
            }
        }
    }

    #[test]
    fn directions_are_unit_vectors(a in arrivals()) {
        prop_assert!((reflect(a.v, a.n).length() - 1.0).abs() <= 2.0 * U);
        if let Some(t) = a.refract().direction() {
            prop_assert!((t.length() - 1.0).abs() <= 2.0 * U);
        }
    }

    #[test]
    fn the_angle_of_reflection_is_the_angle_of_incidence(a in arrivals()) {
        let r = reflect(a.v, a.n);
        prop_assert!((cross(r, a.n) - cross(a.v, a.n)).abs() <= 8.0 * U);
        prop_assert!((r.dot(a.n) + a.v.dot(a.n)).abs() <= 8.0 * U);
    }

    #[test]
    fn snells_law_holds_for_the_directions(a in arrivals()) {
        if let Some(t) = a.refract().direction() {
            let residual = a.n_i * cross(a.v, a.n) - a.n_t * cross(t, a.n);
            prop_assert!(residual.abs() <= 8.0 * U * a.n_i.max(a.n_t), "{residual}");
        }
    }

    #[test]
    fn the_way_back_is_the_way_there(a in arrivals()) {
        let Refraction::Refracted { direction: t, cos_i, .. } = a.refract() else { return Ok(()) };
        // Rounding shifts the component along the boundary by a few U n; that moves the angle by so much over n_i C1.
        let shift = 16.0 * U * a.n_i.max(a.n_t) / a.n_i;
        if cos_i * cos_i <= 4.0 * shift {
            return Ok(());
        }
        let back = Arrival { v: -t, n: -a.n, n_i: a.n_t, n_t: a.n_i }.refract().direction();
        prop_assert!(back.is_some(), "the way back is totally reflected");
        prop_assert!((back.unwrap() + a.v).length() <= shift / cos_i);
    }

    #[test]
    fn the_vector_form_agrees(a in arrivals()) {
        let Refraction::Refracted { direction, cos_t, .. } = a.refract() else { return Ok(()) };
        let eta = relative_index(a.n_i, a.n_t);
        // Five roundings of 1 and four of 1/η² enter C2², and half of that over C2 leaves it.
        let square = U * (5.0 + 8.0 / (eta * eta));
        if cos_t * cos_t <= 4.0 * square {
            return Ok(());
        }
        let by_vectors = refract_vector_form(a.v, a.n, a.n_i, a.n_t);
        prop_assert!(by_vectors.is_some(), "the vector form reflects totally");
        let bound = square / cos_t + 8.0 * U * (1.0 + 1.0 / eta);
        prop_assert!((by_vectors.unwrap() - direction).length() <= bound);
    }

    #[test]
    fn total_internal_reflection_is_for_thinner_media_past_the_critical_angle(a in arrivals()) {
        let refraction = a.refract();
        match critical_angle(a.n_i, a.n_t) {
            None => prop_assert!(refraction.direction().is_some()),
            Some(critical) => {
                let angle = asin_degrees(refraction.sin_i().abs());
                // Away from the critical angle by more than an arc sine can lose at 90°.
                if (angle - critical).abs() > 2e-6 {
                    prop_assert_eq!(refraction.direction().is_none(), angle > critical);
                }
            }
        }
    }

    #[test]
    fn bends_toward_the_normal_into_the_denser_medium_and_away_into_the_thinner(a in arrivals()) {
        if let Refraction::Refracted { direction, sin_i, sin_t, cos_i, cos_t } = a.refract() {
            prop_assert!(sin_i * sin_t >= 0.0, "the ray crosses over to the other side of the normal");
            prop_assert!(direction.dot(a.n) <= 0.0);
            // Indices an ulp apart bend by less than the cosines and sines are rounded.
            let toward = |sin_in: f64, cos_in: f64, sin_out: f64, cos_out: f64| {
                sin_out.abs() <= sin_in.abs() * (1.0 + 4.0 * U) && cos_out >= cos_in - 8.0 * U
            };
            if a.n_t > a.n_i {
                prop_assert!(toward(sin_i, cos_i, sin_t, cos_t));
            } else if a.n_t < a.n_i {
                prop_assert!(toward(sin_t, cos_t, sin_i, cos_i));
            }
        }
    }
}
