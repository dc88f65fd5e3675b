//! Every scene file against the reference: the power of ten that its largest error is below may not grow.

use std::collections::BTreeSet;
use std::path::PathBuf;

use snellius::Scene;

use crate::compare::{Findings, compare};
use crate::support::figures::{at_most, counted};
use crate::support::{root, scene_names};

const COLUMNS: [&str; 6] = ["scene", "rays", "compared", "set_aside", "below_10^_sizes", "below_10^_u_conditions"];

/// Largest error of any number, in u × condition.
pub(crate) const MOST: f64 = 3.16;

#[test]
fn every_scene_stays_below_its_ceiling() {
    let all: Vec<_> = scene_names().into_iter().map(|name| (compare(&scene(&name)), name)).collect();
    let rows: Vec<_> = all.iter().map(|(findings, name)| row(name, findings)).collect();
    for (findings, name) in &all {
        assert!(findings.faults.is_empty(), "{name}: {:#?}", findings.faults);
    }
    if std::env::var_os("SNELLIUS_UPDATE").is_some_and(|value| value == "1") {
        write(&rows);
    }
    let recorded = read();
    let names = |rows: &[Vec<String>]| rows.iter().map(|row| row[0].clone()).collect::<BTreeSet<_>>();
    let (found, expected) = (names(&rows), names(&recorded));
    let wrong: Vec<_> = found.symmetric_difference(&expected).collect();
    assert!(wrong.is_empty(), "without a row, or without a scene: {wrong:?}");
    for ((row, ceiling), (findings, _)) in rows.iter().zip(&recorded).zip(&all) {
        assert_eq!(row[..4], ceiling[..4], "{COLUMNS:?}");
        let is_below = (4..6).all(|k| exponent_of(&row[k]) <= exponent_of(&ceiling[k]));
        assert!(is_below, "{row:?} is above its ceiling {ceiling:?}: {}", findings.worst);
    }
    print(&all);
}

fn print(all: &[(Findings, String)]) {
    let sum = |count: fn(&Findings) -> usize| all.iter().map(|(findings, _)| count(findings)).sum::<usize>() as f64;
    let worst = |error: fn(&Findings) -> f64| all.iter().map(|(findings, _)| error(findings)).fold(0.0, f64::max);
    let (compared, aside) = (sum(|findings| findings.compared), sum(|findings| findings.set_aside));
    counted("scene files against the reference: segments compared", compared);
    at_most("scene files against the reference: segments set aside", aside / (compared + aside), 0.01);
    at_most("scene files against the reference: largest error of a position, sizes", worst(|f| f.in_sizes), 1e-13);
    at_most("scene files against the reference: largest error, u × condition", worst(|f| f.in_conditions), MOST);
}

fn scene(name: &str) -> Scene {
    let text = std::fs::read_to_string(root().join("scenes").join(format!("{name}.ron"))).unwrap();
    Scene::from_ron(&text).unwrap_or_else(|problems| panic!("{problems}"))
}

fn row(name: &str, findings: &Findings) -> Vec<String> {
    let Findings { rays, compared, set_aside, in_sizes, in_conditions, .. } = findings;
    let counts = [rays, compared, set_aside].map(|count| count.to_string());
    // A tenth of u is as good as nothing.
    let exponents =
        [(in_sizes, -17.0), (in_conditions, -1.0)].map(|(error, least)| exponent(*error, least).to_string());
    [name.to_owned()].into_iter().chain(counts).chain(exponents).collect()
}

/// The smallest power of ten that an error is not above.
fn exponent(error: f64, least: f64) -> f64 {
    // Adding 0 turns −0 into 0.
    if error > 0.0 { libm::log10(error).ceil().max(least) + 0.0 } else { least }
}

fn exponent_of(cell: &str) -> i32 {
    cell.parse().unwrap()
}

fn path() -> PathBuf {
    root().join("tests/reference/ceilings.csv")
}

fn read() -> Vec<Vec<String>> {
    let mut reader = csv::Reader::from_path(path()).unwrap();
    assert_eq!(reader.headers().unwrap(), &COLUMNS[..]);
    reader.records().map(|record| record.unwrap().iter().map(str::to_owned).collect()).collect()
}

fn write(rows: &[Vec<String>]) {
    let mut writer = csv::Writer::from_path(path()).unwrap();
    writer.write_record(COLUMNS).unwrap();
    rows.iter().for_each(|row| writer.write_record(row).unwrap());
    writer.flush().unwrap();
}
