//! Every formula of docs/derivation.md holds, and so do the numbers of its examples.
//!
//! An indented line is a chain of equal things: `C2 = √(1 + (C1² − 1)/η²) = √0.84 = 0.916515`. Sides in letters must be equal,
//! at the example and at random directions and indices, with letters as snellius's laws give them. Sides in numbers must be
//! equal to these at the example, the last result to its 6 digits.

use std::collections::BTreeMap;
use std::fs;

use glam::DVec2;
use snellius::glam;
use snellius::laws::{self, Refraction};
use snellius::light::Wavelength;
use snellius::media::catalog;

use crate::formula::{Known, value};
use crate::interval::{Interval, Value};
use crate::page::printed;
use crate::support::random::Random;
use crate::support::root;

/// Directions and indices at a hit: V, N, n1, n2.
type Hit = (DVec2, DVec2, f64, f64);

const INTO_GLASS: Hit = (DVec2::new(0.6, -0.8), DVec2::new(0.0, 1.0), 1.0, 1.5);
const OUT_OF_GLASS: Hit = (DVec2::new(0.8, 0.6), DVec2::new(0.0, -1.0), 1.5, 1.0);
/// Sections whose numbers are those of the second example.
const SECTIONS_OUT_OF_GLASS: [&str; 2] = ["6. Total internal reflection", "7. The vector R"];

#[test]
fn every_formula_of_the_derivation_holds() {
    let page = fs::read_to_string(root().join("docs/derivation.md")).unwrap();
    let (mut formulas, mut numbers) = (0, 0);
    for section in page.split("\n## ").skip(1) {
        let heading = section.lines().next().unwrap();
        let is_total = SECTIONS_OUT_OF_GLASS.contains(&heading);
        let example = letters(if is_total { OUT_OF_GLASS } else { INTO_GLASS });
        let outside_blocks = section.split("\n```").step_by(2).flat_map(str::lines);
        for line in outside_blocks.filter(|line| line.starts_with("    ") && line.contains(" = ")) {
            formulas += 1;
            numbers += holds_at(line, &example, true).unwrap_or_else(|fault| panic!("{heading}: {fault}"));
            let mut random = Random(7);
            for _ in 0..100 {
                let hit = random_hit(&mut random, is_total);
                holds_at(line, &letters(hit), false).unwrap_or_else(|fault| panic!("{heading}: {hit:?}: {fault}"));
            }
        }
    }
    assert!(formulas > 50 && numbers > 50, "{formulas} formulas, {numbers} sides in numbers");
}

#[test]
fn a_wrong_formula_and_a_wrong_digit_are_found() {
    let known = letters(INTO_GLASS);
    let fault = |line: &str| holds_at(line, &known, true).unwrap_err();
    assert!(fault("S1 η = S2").contains("S2"));
    assert!(fault("T = V/η + (C1/η + C2) N").contains("T"));
    assert!(fault("C2 = √0.84 = 0.916516").contains("0.916516"));
    assert!(fault("C2 = √0.85 = 0.916515").contains("0.85"));
    assert!(fault("0.9 = 0.6·1.6").contains("1.6"));
    assert!(fault("T = 0.4·(1, 0) − 0.916516·(0, 1)").contains("0.916516"));
    assert!(fault("S2 ≠ 0.4").contains("0.4"));
    assert_eq!(holds_at("C2 = √0.84 = 0.916515", &known, true), Ok(2));
    assert_eq!(holds_at("C2 = √0.84 = 0.916515", &letters(OUT_OF_GLASS), false), Ok(0), "no sides to compare");
}

#[test]
fn what_it_says_of_the_two_forms_was_measured() {
    let mut reader = csv::Reader::from_path(root().join("docs/accuracy/forms.csv")).unwrap();
    let rows: Vec<_> = reader.records().map(Result::unwrap).collect();
    let measured = |form: &str, regime: &str, column: usize| -> f64 {
        rows.iter().find(|row| &row[0] == form && &row[1] == regime).unwrap()[column].parse().unwrap()
    };
    let (error, wrong_verdicts) = (3, 5);
    let vector_form = measured("vector form, f64", "near critical", error);
    assert!((5e-9..2e-8).contains(&vector_form), "some 10⁻⁸ rad: {vector_form}");
    assert!(measured("ours", "near critical", error) < 2e-16);
    assert!(measured("vector form, f64", "small contrast", wrong_verdicts) > 2000.0, "thousands");
    assert!(measured("ours", "small contrast", wrong_verdicts) == 0.0);
}

/// Compares the sides of a line with its first one, those in numbers only at the example, and tells how many these were.
fn holds_at(line: &str, known: &Known, is_example: bool) -> Result<usize, String> {
    let signs = [(" − ", " - "), ("−", "-"), ("|V′|", "length_V"), ("|N′|", "length_N"), ("C2²", "square_C2")];
    let line = signs.iter().fold(line.trim().to_owned(), |line, (sign, plain)| line.replace(sign, plain));
    let line = line.replace("V′", "V_prime").replace("N′", "N_prime").replace('°', "");
    let (line, unequal) = line.split_once(" ≠ ").map_or((line.as_str(), None), |(line, side)| (line, Some(side)));
    let sides: Vec<_> = line.split(" = ").collect();
    let (in_numbers, in_letters): (Vec<_>, Vec<_>) = sides.iter().partition(|side| is_in_numbers(side));
    let mut in_letters = in_letters.into_iter();
    let first = match in_letters.next() {
        Some(letter) if is_example || in_letters.len() > 0 => value(letter, known),
        Some(_) => return Ok(0),
        None => numbers(sides[0]),
    };
    for side in in_letters {
        if !is_close(value(side, known), first, 1e-9) {
            return Err(format!("{side} is not what {line} says"));
        }
    }
    if !is_example {
        return Ok(0);
    }
    for side in &in_numbers {
        if !numbers(side).meets(first) {
            return Err(format!("{side} is not what {line} says"));
        }
    }
    match unequal {
        Some(side) if is_close(value(side, known), first, 1e-3) => Err(format!("{side} is equal in {line}")),
        _ => Ok(in_numbers.len()),
    }
}

/// What a side in numbers may stand for: a result to its last digit, and all that comes of the rounded numbers in a formula.
fn numbers(side: &str) -> Value {
    let is_result = side.parse::<f64>().is_ok() || (side.rfind('(') == Some(0) && side.ends_with(')'));
    if is_result {
        return printed(side, None);
    }
    let words = side.split(|c: char| !(c.is_ascii_digit() || c == '.'));
    let is_rounded = |word: &&str| word.trim_start_matches(['0', '.']).replace('.', "").len() >= 6;
    let known = words.filter(is_rounded).map(|word| (word.to_owned(), printed(word, None))).collect();
    value(side, &known)
}

/// Whether no letter stands in it.
fn is_in_numbers(side: &str) -> bool {
    !side.replace("arcsin", "").replace("arctan", "").contains(char::is_alphabetic)
}

fn is_close(a: Value, b: Value, tolerance: f64) -> bool {
    let close = |a: Interval, b: Interval| {
        let (a, b) = (a.middle(), b.middle());
        (a - b).abs() <= tolerance * a.abs().max(1.0)
    };
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => close(a, b),
        (Value::Vector(a, b), Value::Vector(c, d)) => close(a, c) && close(b, d),
        _ => false,
    }
}

/// What the letters stand for at a hit; those of the transmitted light only if there is any.
fn letters((v, n, n1, n2): Hit) -> Known {
    let refraction = laws::refract(v, n, n1, n2);
    let (c1, s1, eta) = (refraction.cos_i(), refraction.sin_i().abs(), laws::relative_index(n1, n2));
    // The one to which V leans.
    let tangent = refraction.sin_i().signum() * laws::Incidence::new(v, n).tangent;
    let mut vectors = BTreeMap::from([("V", v), ("N", n), ("R", laws::reflect(v, n)), ("τ", tangent)]);
    let mut numbers = BTreeMap::from([
        ("n1", n1),
        ("n2", n2),
        ("η", eta),
        ("C1", c1),
        ("S1", s1),
        ("square_C2", 1.0 - (s1 / eta) * (s1 / eta)),
        ("c", laws::SPEED_OF_LIGHT),
        ("v1", laws::SPEED_OF_LIGHT / n1),
        ("v2", laws::SPEED_OF_LIGHT / n2),
        ("θ1", s1.atan2(c1).to_degrees()),
        ("θB", laws::brewster_angle(n1, n2)),
        ("w_s", 0.5),
        ("w_p", 0.5),
    ]);
    let glass = catalog::find("N-BK7").unwrap().dispersion();
    let lines = [("n_F", Wavelength::HYDROGEN_F), ("n_d", Wavelength::D), ("n_C", Wavelength::HYDROGEN_C)];
    numbers.extend(lines.map(|(letter, line)| (letter, glass.index(line))));
    numbers.extend(laws::critical_angle(n1, n2).map(|angle| ("θc", angle)));
    if let Refraction::Refracted { direction, cos_i, sin_i, cos_t, sin_t } = refraction {
        vectors.extend([("T", direction), ("N_prime", cos_t * n), ("V_prime", cos_t / cos_i * v)]);
        let shares = laws::Shares::fresnel(laws::fresnel(n1, n2, cos_i, sin_i, cos_t, sin_t));
        let reflected = shares.reflectance;
        let k_r = 0.5 * (reflected.s + reflected.p);
        numbers.extend([("C2", cos_t), ("S2", sin_t.abs()), ("θ2", sin_t.abs().atan2(cos_t).to_degrees())]);
        numbers.extend([("length_N", cos_t), ("length_V", cos_t / cos_i)]);
        // The share of the way from the tip of −N′ to that of V′ at which T ends, along the boundary.
        let along = |d: DVec2| d.dot(tangent);
        numbers.insert("k", along(direction) / along(cos_t / cos_i * v));
        numbers.extend([("R_s", reflected.s), ("R_p", reflected.p), ("k_r", k_r), ("k_t", 1.0 - k_r)]);
    }
    let exactly = Interval::exactly;
    let vectors = vectors.into_iter().map(|(letter, d)| (letter.to_owned(), Value::Vector(exactly(d.x), exactly(d.y))));
    vectors.chain(numbers.into_iter().map(|(letter, x)| (letter.to_owned(), Value::Number(exactly(x))))).collect()
}

/// A hit at which light is transmitted, or one past the critical angle; V leans to the left of −N.
fn random_hit(random: &mut Random, is_total: bool) -> Hit {
    let n = DVec2::from_angle(std::f64::consts::TAU * random.unit());
    let (n1, n2) = (1.0 + random.unit(), 1.0 + random.unit());
    let (thin, dense) = (n1.min(n2), 1.1 * n1.max(n2));
    let (n1, n2) = if is_total { (dense, thin) } else { (n1, n2) };
    let critical = (n2 / n1).min(1.0);
    let (low, high) = if is_total { (1.01 * critical, 0.999) } else { (0.05, 0.95 * critical) };
    let sin = low + (high - low) * random.unit();
    (sin * -n.perp() - (1.0 - sin * sin).sqrt() * n, n, n1, n2)
}
