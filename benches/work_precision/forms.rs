//! Forms of Snell's law: the error of the transmitted direction, wrong verdicts of total reflection, and the time.

use std::hint::black_box;

use f256::f256;
use glam::DVec2;
use snellius::laws;

use crate::clock::medians;
use crate::double_double::Double;
use crate::incidences::{DISTANCES, Incident, REGIMES, incidents, near_critical};
use crate::plot::{Curve, Panel};
use crate::random::Random;
use crate::study::Study;
use crate::table::{Table, digits};
use crate::truth;
use crate::wide::{Wide2, narrow, wide};

/// Half an ulp of 1.
const U: f64 = 0.5 * f64::EPSILON;
const OURS: &str = "ours";

/// A form of the law: the unit direction of the transmitted ray, or `None` at total internal reflection.
struct Form {
    name: &'static str,
    refract: fn(&Incident) -> Option<DVec2>,
    /// Refracts batches of a list.
    task: fn(&[Incident]) -> Box<dyn FnMut()>,
}

const FORMS: [Form; 5] = [
    Form {
        name: "vector form, f32",
        refract: |incident| vector_form_f32(&Incident32::from(incident)),
        task: |incidents| task(incidents.iter().map(Incident32::from).collect(), vector_form_f32),
    },
    Form { name: "vector form, f64", refract: vector_form, task: |incidents| task(incidents.into(), vector_form) },
    Form { name: "by angles, f64", refract: by_angles, task: |incidents| task(incidents.into(), by_angles) },
    Form { name: OURS, refract: ours, task: |incidents| task(incidents.into(), ours) },
    Form { name: "double-double", refract: double_double, task: |incidents| task(incidents.into(), double_double) },
];

/// So many refractions are timed at once: too few for the system to interrupt often.
const BATCH: usize = 500;

/// Refracts the next batch at every call, so that the processor cannot learn the branches by heart.
fn task<I: 'static>(incidents: Vec<I>, refract: impl Fn(&I) -> Option<DVec2> + 'static) -> Box<dyn FnMut()> {
    let mut batches = (0..incidents.len() / BATCH).cycle();
    Box::new(move || {
        let first = BATCH * batches.next().unwrap_or(0);
        for incident in &incidents[first..first + BATCH] {
            black_box(refract(black_box(incident)));
        }
    })
}

pub(crate) fn run(study: &mut Study) {
    let (rays, rounds) = (study.size(1000, 20_000), study.size(9, 1001));
    let mut random = Random(1);
    let mut results = Vec::new();
    for regime in REGIMES {
        let incidents = incidents(regime, rays, &mut random);
        let mut tasks: Vec<_> = FORMS.iter().map(|form| (form.task)(&incidents)).collect();
        let times = medians(rounds, &mut tasks);
        for (form, time) in FORMS.iter().zip(times) {
            let ns = 1e9 * time / BATCH as f64;
            results.push(Measured { form: form.name, regime, ns, errors: errors(form, &incidents) });
        }
    }
    let by_distance = by_distance(study.size(50, 2000), &mut random);
    study.save(&table(&results));
    study.save(&distance_table(&by_distance));
    study.draw("forms", &[time_panel(&results), distance_panel(&by_distance)]);
    figures(study, &results);
}

struct Measured {
    form: &'static str,
    regime: &'static str,
    ns: f64,
    errors: Errors,
}

/// The errors of a form over a list of rays.
#[derive(Default)]
struct Errors {
    /// Largest error of the direction, rad.
    worst: f64,
    /// Largest error over u κ, κ = max(1, tan θ_t) being the condition of the transmitted direction.
    conditioned: f64,
    /// Total reflection where there is none, or none where there is.
    wrong_verdicts: u32,
}

fn errors(form: &Form, incidents: &[Incident]) -> Errors {
    let mut errors = Errors::default();
    for incident in incidents {
        let Incident { v, n, n_i, n_t } = *incident;
        match (truth::refract(v.into(), n.into(), wide(n_i), wide(n_t)), (form.refract)(incident)) {
            (Some(exact), Some(direction)) => {
                let error = angle_between(exact, direction.into());
                let n = Wide2::from(n).unit();
                let condition = narrow(exact.cross(n) / exact.dot(n)).abs().max(1.0);
                errors.worst = errors.worst.max(error);
                errors.conditioned = errors.conditioned.max(error / (U * condition));
            }
            (None, None) => {}
            _ => errors.wrong_verdicts += 1,
        }
    }
    errors
}

/// The angle between two directions, rad.
fn angle_between(a: Wide2, b: Wide2) -> f64 {
    let (sin, cos): (f256, f256) = (a.cross(b), a.dot(b));
    libm::atan2(narrow(sin).abs(), narrow(cos))
}

/// The worst error of every form at each distance from the critical angle.
fn by_distance(rays: usize, random: &mut Random) -> Vec<(f64, Vec<f64>)> {
    let row = |exponent: i32| {
        let distance = libm::exp10(f64::from(exponent));
        let incidents: Vec<_> = (0..rays).map(|_| near_critical(distance, random)).collect();
        (distance, FORMS.iter().map(|form| errors(form, &incidents).worst).collect())
    };
    DISTANCES.map(row).collect()
}

fn table(results: &[Measured]) -> Table {
    let columns = [
        "form",
        "regime",
        "time (ns)",
        "worst error (rad)",
        "worst error / (u κ)",
        "wrong verdicts of total reflection",
    ];
    let mut table = Table::new("forms", &columns);
    for Measured { form, regime, ns, errors } in results {
        let cells = [digits(*ns), digits(errors.worst), digits(errors.conditioned), errors.wrong_verdicts.to_string()];
        let [time, worst, conditioned, wrong] = cells;
        table.row([(*form).into(), (*regime).into(), time, worst, conditioned, wrong]);
    }
    table
}

fn distance_table(rows: &[(f64, Vec<f64>)]) -> Table {
    let names = FORMS.map(|form| form.name);
    let mut table =
        Table::new("forms_critical", &["from critical (rad)", names[0], names[1], names[2], names[3], names[4]]);
    for (distance, errors) in rows {
        let error = |k: usize| digits(errors[k]);
        table.row([format!("{distance:.0e}"), error(0), error(1), error(2), error(3), error(4)]);
    }
    table
}

fn time_panel(results: &[Measured]) -> Panel {
    let curve = |form: &Form| {
        let points = results.iter().filter(|result| result.form == form.name);
        let points = points.map(|result| (result.ns, result.errors.worst)).collect();
        Curve { name: form.name.into(), points, is_joined: false }
    };
    let title = "Time and error, a marker per regime".into();
    let axes = ["time per refraction (ns)", "worst error of the direction (rad)"];
    Panel { title, axes, curves: FORMS.iter().map(curve).collect() }
}

fn distance_panel(rows: &[(f64, Vec<f64>)]) -> Panel {
    let points =
        |k: usize| rows.iter().map(|(distance, errors)| (*distance, errors[k])).filter(|p| p.1 > 0.0).collect();
    let curve = |(k, form): (usize, &Form)| Curve { name: form.name.into(), points: points(k), is_joined: true };
    let title = "Toward the critical angle".into();
    let axes = ["distance from the critical angle (rad)", "worst error of the direction (rad)"];
    Panel { title, axes, curves: FORMS.iter().enumerate().map(curve).collect() }
}

fn figures(study: &mut Study, results: &[Measured]) {
    let ours = || results.iter().filter(|result| result.form == OURS);
    let conditioned = ours().map(|result| result.errors.conditioned).fold(0.0, f64::max);
    let wrong_verdicts = ours().map(|result| result.errors.wrong_verdicts).sum::<u32>();
    let is_critical = |result: &&Measured| ["near critical", "small contrast"].contains(&result.regime);
    let critical = ours().filter(is_critical).map(|result| result.errors.worst / U).fold(0.0, f64::max);
    let figures = &mut study.figures;
    figures.at_most("refraction: worst error / (u κ)", conditioned, 4.0);
    figures.at_most("refraction near critical: worst error / u", critical, 2.0);
    figures.at_most("refraction: wrong verdicts", f64::from(wrong_verdicts), 0.0);
}

/// The transmitted direction of the vector form in single precision.
#[derive(Clone, Copy)]
struct Incident32 {
    v: [f32; 2],
    n: [f32; 2],
    n_i: f32,
    n_t: f32,
}

impl From<&Incident> for Incident32 {
    #[expect(clippy::cast_possible_truncation, reason = "single precision is the point")]
    fn from(incident: &Incident) -> Self {
        let narrow = |p: DVec2| [p.x as f32, p.y as f32];
        Self { v: narrow(incident.v), n: narrow(incident.n), n_i: incident.n_i as f32, n_t: incident.n_t as f32 }
    }
}

/// T = V/η + (C1/η − C2) N.
fn vector_form_f32(&Incident32 { v, n, n_i, n_t }: &Incident32) -> Option<DVec2> {
    let eta = n_t / n_i;
    let c1 = -(n[0] * v[0] + n[1] * v[1]);
    let radicand = 1.0 + (c1 * c1 - 1.0) / (eta * eta);
    let along_n = c1 / eta - radicand.sqrt();
    let component = |k: usize| f64::from(v[k] / eta + along_n * n[k]);
    (radicand > 0.0).then(|| DVec2::new(component(0), component(1)))
}

fn vector_form(&Incident { v, n, n_i, n_t }: &Incident) -> Option<DVec2> {
    laws::refract_vector_form(v, n, n_i, n_t)
}

fn ours(&Incident { v, n, n_i, n_t }: &Incident) -> Option<DVec2> {
    laws::refract(v, n, n_i, n_t).direction()
}

fn by_angles(&Incident { v, n, n_i, n_t }: &Incident) -> Option<DVec2> {
    let theta_i = libm::asin(v.perp_dot(n).clamp(-1.0, 1.0));
    let sin_t = n_i * libm::sin(theta_i) / n_t;
    let theta_t = libm::asin(sin_t);
    (sin_t.abs() < 1.0).then(|| -libm::sin(theta_t) * n.perp() - libm::cos(theta_t) * n)
}

/// The law by components, of lengths that need not be 1: (n_t C2)² |V|²|N|² = (n_t |V||N|)² − (n_i V×N)².
fn double_double(&Incident { v, n, n_i, n_t }: &Incident) -> Option<DVec2> {
    let [vx, vy, nx, ny, n_i, n_t] = [v.x, v.y, n.x, n.y, n_i, n_t].map(Double::from);
    let along = n_i * (vx * ny - vy * nx);
    let n_squared = nx * nx + ny * ny;
    let whole = n_t * ((vx * vx + vy * vy) * n_squared).sqrt();
    let radicand = (whole - along) * (whole + along);
    if radicand.high <= 0.0 {
        return None;
    }
    let across = radicand.sqrt();
    let scale = whole * n_squared.sqrt();
    Some(DVec2::new(((along * ny - across * nx) / scale).high, ((-along * nx - across * ny) / scale).high))
}
