//! Refraction, reflection and Fresnel's equations against the same laws in 237 bits. The f64 arguments are taken as exact;
//! V and N as directions, whose lengths are 1 up to rounding.

use f256::f256;
use glam::DVec2;
use snellius::laws::{Refraction, fresnel, reflect, refract};

use crate::support::figures::{U, at_most, counted, size};
use crate::support::random::Random;
use crate::support::wide::{Wide2, narrow, wide};

/// A ray's arrival at a boundary.
#[derive(Clone, Copy, Debug)]
struct Arrival {
    v: DVec2,
    n: DVec2,
    n_i: f64,
    n_t: f64,
}

/// What is true of it.
struct Truth {
    sin_i: f256,
    cos_i: f256,
    sin_t: f256,
    /// `None` at total internal reflection.
    transmitted: Option<(Wide2, f256)>,
    reflected: Wide2,
}

impl Arrival {
    /// With the angle of incidence near `theta` radians: V and N are rounded from 237 bits.
    fn new(random: &mut Random, theta: f256, n_i: f64, n_t: f64) -> Self {
        let (sin, cos) = wide(std::f64::consts::TAU * random.unit()).sin_cos();
        let normal = Wide2 { x: cos, y: sin };
        let (sin, cos) = theta.sin_cos();
        let v = sin * (-normal).perp() - cos * normal;
        Self { v: v.narrow(), n: normal.narrow(), n_i, n_t }
    }

    fn truth(&self) -> Truth {
        let (v, n) = (Wide2::from(self.v).unit(), Wide2::from(self.n).unit());
        let tangent = -n.perp();
        let (sin_i, cos_i) = (v.cross(n), -v.dot(n));
        let sin_t = wide(self.n_i) * sin_i / wide(self.n_t);
        let square = (f256::ONE - sin_t) * (f256::ONE + sin_t);
        let transmitted = (square > f256::ZERO).then(|| {
            let cos_t = square.sqrt();
            (sin_t * tangent - cos_t * n, cos_t)
        });
        Truth { sin_i, cos_i, sin_t, transmitted, reflected: sin_i * tangent + cos_i * n }
    }
}

/// Sine of the angle between a computed direction and the true one, in units of u; infinite where the length is off.
fn off(computed: DVec2, truth: Wide2) -> f64 {
    let computed = Wide2::from(computed);
    let length = narrow(computed.length() - f256::ONE).abs();
    if length <= 3.0 * U { narrow(computed.cross(truth)).abs() / U } else { f64::INFINITY }
}

/// Two indices from 1 to 4, or that differ by a contrast from 1e-7 on.
fn indices(random: &mut Random) -> (f64, f64) {
    let n = 1.0 + random.unit();
    let other =
        if random.below(2) == 0 { 1.0 + 3.0 * random.unit() } else { n * (1.0 + libm::exp10(-7.0 * random.unit())) };
    if random.below(2) == 0 { (n, other) } else { (other, n) }
}

/// A random angle of incidence: anywhere, nearly normal, nearly grazing.
fn angle(random: &mut Random) -> f256 {
    let small = wide(libm::exp10(-15.0 * random.unit()));
    match random.below(3) {
        0 => wide(std::f64::consts::FRAC_PI_2 * random.unit()),
        1 => small,
        _ => f256::ONE.atan() + f256::ONE.atan() - small,
    }
}

/// An arrival within 1e-15 to 1e-3 of the critical angle, on either side.
fn near_critical(random: &mut Random, contrast: f64) -> Arrival {
    let n_t = 1.0 + random.unit();
    let n_i = n_t * (1.0 + contrast);
    let critical = (wide(n_t) / wide(n_i)).asin();
    let beside = wide(libm::exp10(-3.0 - 12.0 * random.unit()));
    let sign = if random.below(2) == 0 { f256::ONE } else { -f256::ONE };
    Arrival::new(random, critical + sign * beside, n_i, n_t)
}

#[test]
fn a_refracted_direction_is_within_4_units_times_the_condition() {
    let mut random = Random(11);
    let (mut worst, mut worst_reflected): (f64, f64) = (0.0, 0.0);
    for _ in 0..size(20_000, 1_000_000) {
        let (theta, (n_i, n_t)) = (angle(&mut random), indices(&mut random));
        let arrival = Arrival::new(&mut random, theta, n_i, n_t);
        let truth = arrival.truth();
        worst_reflected = worst_reflected.max(off(reflect(arrival.v, arrival.n), truth.reflected));
        let (Some(direction), Some((t, cos_t))) =
            (refract(arrival.v, arrival.n, n_i, n_t).direction(), truth.transmitted)
        else {
            continue;
        };
        let condition = narrow(truth.sin_t / cos_t).abs().max(1.0);
        worst = worst.max(off(direction, t) / condition);
    }
    at_most("refraction: error of T in u times max(1 and tan θ_t)", worst, 4.0);
    at_most("reflection: error of R in u", worst_reflected, 4.0);
}

#[test]
fn near_the_critical_angle_nothing_is_lost() {
    let mut random = Random(12);
    let (mut worst, mut wrong): (f64, u32) = (0.0, 0);
    let cases = size(20_000, 1_000_000);
    let mut transmitted = 0;
    for _ in 0..cases {
        let contrast = libm::exp10(-7.0 * random.unit());
        let arrival = near_critical(&mut random, contrast);
        let truth = arrival.truth();
        match (refract(arrival.v, arrival.n, arrival.n_i, arrival.n_t).direction(), truth.transmitted) {
            (Some(direction), Some((t, _))) => {
                worst = worst.max(off(direction, t));
                transmitted += 1;
            }
            (None, None) => {}
            _ => wrong += 1,
        }
    }
    counted("near critical: cases", f64::from(cases));
    assert!(transmitted > cases / 4 && transmitted < cases * 3 / 4, "{transmitted} of {cases} transmitted");
    at_most("near critical: wrong verdicts on total internal reflection", f64::from(wrong), 0.0);
    at_most("near critical: error of T in u", worst, 2.0);
}

/// Along the diagonal both squares of a direction may be below 1/2; a trace's directions are some units longer or shorter
/// than 1.
#[test]
fn near_the_critical_angle_lengths_of_diagonal_directions_count() {
    let mut random = Random(15);
    let (mut worst, mut wrong): (f64, u32) = (0.0, 0);
    for _ in 0..size(20_000, 1_000_000) {
        let units = |random: &mut Random| U * (8.0 * random.unit() - 4.0);
        let v = DVec2::splat(std::f64::consts::FRAC_1_SQRT_2) + DVec2::new(units(&mut random), units(&mut random));
        let n_t = 1.0 + random.unit();
        let n_i = n_t * std::f64::consts::SQRT_2 * (1.0 + units(&mut random));
        let arrival = Arrival { v, n: [DVec2::NEG_X, DVec2::NEG_Y][random.below(2)], n_i, n_t };
        match (refract(v, arrival.n, n_i, n_t).direction(), arrival.truth().transmitted) {
            (Some(direction), Some((t, _))) => worst = worst.max(narrow(Wide2::from(direction).cross(t)).abs() / U),
            (None, None) => {}
            _ => wrong += 1,
        }
    }
    at_most("near critical along the diagonal: wrong verdicts", f64::from(wrong), 0.0);
    at_most("near critical along the diagonal: error of T in u", worst, 2.0);
}

/// The powers' fractions by the textbook's formulas.
struct Powers {
    transmitted: [f64; 2],
    reflected: [f64; 2],
}

#[test]
fn reflectance_and_transmittance_do_not_cancel() {
    let mut random = Random(13);
    let (mut of_t, mut of_r, mut of_r_s): (f64, f64, f64) = (0.0, 0.0, 0.0);
    for k in 0..size(20_000, 1_000_000) {
        let arrival = if k % 2 == 0 {
            let contrast = libm::exp10(-7.0 * random.unit());
            near_critical(&mut random, contrast)
        } else {
            let (theta, (n_i, n_t)) = (angle(&mut random), indices(&mut random));
            Arrival::new(&mut random, theta, n_i, n_t)
        };
        let Refraction::Refracted { cos_i, sin_i, cos_t, sin_t, .. } =
            refract(arrival.v, arrival.n, arrival.n_i, arrival.n_t)
        else {
            continue;
        };
        let truth = arrival.truth();
        // At grazing incidence rounding may turn N away from the ray.
        let Some((_, true_cos_t)) = truth.transmitted.filter(|_| truth.cos_i > f256::ZERO) else { continue };
        let f = fresnel(arrival.n_i, arrival.n_t, cos_i, sin_i, cos_t, sin_t);
        let (r, t) = (f.reflectance, f.transmittance);
        let Powers { transmitted, reflected } = powers(&arrival, &truth, true_cos_t);
        // C2 is the root of a discriminant that is good to 2^-102.
        let unit = U + libm::exp2(-102.0) / (cos_t * cos_t);
        of_t = of_t.max((t.s / transmitted[0] - 1.0).abs() / unit).max((t.p / transmitted[1] - 1.0).abs() / unit);
        of_r = of_r.max((r.s - reflected[0]).abs() / U).max((r.p - reflected[1]).abs() / U);
        of_r_s = of_r_s.max((r.s / reflected[0] - 1.0).abs() / U);
    }
    at_most("Fresnel: relative error of T_s and T_p in u + 2^-102/C2²", of_t, 32.0);
    at_most("Fresnel: relative error of R_s in u", of_r_s, 32.0);
    at_most("Fresnel: error of R_s and R_p in u", of_r, 16.0);
}

fn powers(arrival: &Arrival, truth: &Truth, cos_t: f256) -> Powers {
    let (n_i, n_t) = (wide(arrival.n_i), wide(arrival.n_t));
    let amplitude = |a: f256, b: f256| (narrow(wide(4.0) * a * b / ((a + b) * (a + b))), (a - b) / (a + b));
    let (t_s, r_s) = amplitude(n_i * truth.cos_i, n_t * cos_t);
    let (t_p, r_p) = amplitude(n_t * truth.cos_i, n_i * cos_t);
    assert!(truth.sin_i.abs() <= f256::ONE);
    Powers { transmitted: [t_s, t_p], reflected: [narrow(r_s * r_s), narrow(r_p * r_p)] }
}
