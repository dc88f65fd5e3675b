//! Rays and boundaries to refract, by regime.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec2;

use crate::random::Random;

/// A direction, a normal against it, and the two indices.
#[derive(Clone, Copy)]
pub(crate) struct Incident {
    pub(crate) v: DVec2,
    pub(crate) n: DVec2,
    pub(crate) n_i: f64,
    pub(crate) n_t: f64,
}

pub(crate) const REGIMES: [&str; 5] = ["generic", "near normal", "near grazing", "near critical", "small contrast"];

/// Distances from the critical angle, as exponents of ten.
pub(crate) const DISTANCES: std::ops::RangeInclusive<i32> = -15..=-3;

pub(crate) fn incidents(regime: &str, count: usize, random: &mut Random) -> Vec<Incident> {
    (0..count)
        .map(|_| match regime {
            "generic" => generic(random),
            "near normal" => near_normal(random),
            "near grazing" => near_grazing(random),
            "near critical" => {
                let exponent = between(random, -15.0, -3.0);
                near_critical(libm::exp10(exponent), random)
            }
            _ => small_contrast(random),
        })
        .collect()
}

/// Any angle and any two indices; some are totally reflected.
fn generic(random: &mut Random) -> Incident {
    let angle = between(random, -0.5 * PI, 0.5 * PI);
    let indices = [between(random, 1.0, 4.0), between(random, 1.0, 4.0)];
    incident(libm::sincos(angle), indices, random)
}

/// 0.1 to 1e-12 rad from the normal.
fn near_normal(random: &mut Random) -> Incident {
    let angle = libm::exp10(between(random, -12.0, -1.0)) * sign(random);
    let indices = [between(random, 1.0, 4.0), between(random, 1.0, 4.0)];
    incident(libm::sincos(angle), indices, random)
}

/// 0.1 to 1e-12 rad from the boundary, into the denser medium.
fn near_grazing(random: &mut Random) -> Incident {
    let (sin, cos) = libm::sincos(libm::exp10(between(random, -12.0, -1.0)));
    let n_i = between(random, 1.0, 2.0);
    let indices = [n_i, n_i + between(random, 0.1, 2.0)];
    incident((cos * sign(random), sin), indices, random)
}

/// So far (rad) from the critical angle, on either side of it.
pub(crate) fn near_critical(distance: f64, random: &mut Random) -> Incident {
    let n_t = between(random, 1.0, 2.0);
    let n_i = n_t + between(random, 0.1, 2.0);
    let angle = libm::asin(n_t / n_i) + distance * sign(random);
    let (sin, cos) = libm::sincos(angle.min(FRAC_PI_2));
    incident((sin * sign(random), cos), [n_i, n_t], random)
}

/// Indices 1e-7 apart; the angle to the boundary differs from the critical one by a share of 1e-3 to 1e-15.
fn small_contrast(random: &mut Random) -> Incident {
    let n_t = between(random, 1.0, 2.0);
    let n_i = n_t * (1.0 + 1e-7);
    let share = 1.0 + sign(random) * libm::exp10(between(random, -15.0, -3.0));
    let cos = share * ((n_i - n_t) * (n_i + n_t)).sqrt() / n_i;
    let sin = ((1.0 - cos) * (1.0 + cos)).sqrt();
    incident((sin * sign(random), cos), [n_i, n_t], random)
}

/// The ray with this sine and cosine of the angle of incidence, at a boundary that runs anyhow.
fn incident((sin, cos): (f64, f64), [n_i, n_t]: [f64; 2], random: &mut Random) -> Incident {
    let (y, x) = libm::sincos(between(random, -PI, PI));
    let n = DVec2::new(x, y);
    Incident { v: (-sin * n.perp() - cos * n).normalize(), n, n_i, n_t }
}

fn between(random: &mut Random, low: f64, high: f64) -> f64 {
    low + (high - low) * random.unit()
}

fn sign(random: &mut Random) -> f64 {
    if random.below(2) == 0 { 1.0 } else { -1.0 }
}
