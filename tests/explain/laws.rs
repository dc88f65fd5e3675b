//! What a printed line should say, from the lines before it.

use crate::formula::{Known, value};
use crate::interval::{Interval, Value};
use crate::page::{PrintedHit, PrintedLine, Solution, share};

/// Everything that is wrong with a solution, and how many results were worked out anew.
pub(crate) fn faults(solution: &Solution) -> (Vec<String>, usize) {
    let mut check = Check { faults: Vec::new(), checked: 0, known: solution.start.clone() };
    let mut from = solution.start["P0"];
    let mut direction = solution.start["V0"];
    let mut power = Value::Number(Interval::exactly(1.0));
    for hit in &solution.hits {
        check.arrival(hit, from, direction, power);
        for line in &hit.lines {
            check.line(hit, line);
        }
        from = hit.given["P"];
        let goes_on = hit.lines.iter().find(|line| line.letter == "δ");
        if let Some(line) = goes_on {
            let transmitted = line.formula.as_deref() == Some("∠(V0, T)");
            direction = check.known[if transmitted { "T" } else { "R" }];
            power = hit.arriving.unwrap() * check.known[if transmitted { "k_t" } else { "k_r" }];
        } else {
            power = hit.arriving.unwrap();
        }
    }
    check.end(&solution.end, direction, power);
    (check.faults, check.checked)
}

struct Check {
    faults: Vec<String>,
    checked: usize,
    known: Known,
}

impl Check {
    fn demand(&mut self, holds: bool, fault: impl FnOnce() -> String) {
        self.checked += 1;
        if !holds {
            self.faults.push(fault());
        }
    }

    /// The ray arrives from where it set out, in its direction, with its power.
    fn arrival(&mut self, hit: &PrintedHit, from: Value, direction: Value, power: Value) {
        let heading = &hit.heading;
        self.demand(hit.given["V"].middle() == direction.middle(), || {
            format!("{heading}: V is not the last direction")
        });
        self.demand(hit.arriving.unwrap().meets(power), || format!("{heading}: the power is not what was sent"));
        let (way, v) = (hit.given["P"] - from, hit.given["V"]);
        let beside = way.cross(v).number();
        self.demand(beside.low <= 0.0, || format!("{heading}: P is not on the ray, {beside:?}"));
        self.demand((way * v).number().high >= 0.0, || format!("{heading}: P lies behind"));
        let (v0, p0) = (self.known["V0"], self.known["P0"]);
        self.known = hit.given.clone();
        self.known.extend([("V0".into(), v0), ("P0".into(), p0)]);
        let along = (self.known["N"] * v).number();
        self.demand(along.low <= 0.0, || format!("{heading}: N is not against V"));
    }

    fn line(&mut self, hit: &PrintedHit, line: &PrintedLine) {
        let place = format!("{}, {}", hit.heading, line.letter);
        match line.result {
            Some(result) => {
                self.result(&place, line, result);
                self.law(&place, hit, line, result);
                self.known.insert(line.letter.clone(), result);
            }
            None => self.none(&place, line),
        }
    }

    /// Where there is no result, there must be none.
    fn none(&mut self, place: &str, line: &PrintedLine) {
        let number = |letter: &str| self.known[letter].number();
        let right = match line.letter.as_str() {
            "C2" | "S2" | "θ2" => number("C2²").low < 0.0,
            "T" => number("C2²").low <= 0.0,
            "θc" => number("n1").low <= number("n2").high,
            _ => false,
        };
        self.demand(right, || format!("{place}: there is a result"));
    }

    /// The printed formula leads to the result, and the numbers in it are those of its letters.
    fn result(&mut self, place: &str, line: &PrintedLine, result: Value) {
        let Some(formula) = &line.formula else { return };
        if line.numbers.is_none() && formula.contains(char::is_alphabetic) && line.remark.contains("total") {
            return;
        }
        // Toward the critical angle, C2 follows from its square alone.
        let formula = if line.letter == "C2" { "√C2²" } else { formula };
        let mut known = self.known.clone();
        if let (Some(square), "C2") = (known.get("C2²").copied(), line.letter.as_str()) {
            known.insert("C2".into(), square);
        }
        let formula = formula.replace("√C2²", "√C2");
        let expected = value(&formula, &known);
        // Turned back, to either side.
        let expected = if expected.meets(result) { expected } else { turned(&line.letter, expected) };
        self.demand(expected.meets(result), || format!("{place}: {formula} is {expected:?}, not {result:?}"));
        let Some(numbers) = &line.numbers else { return };
        let middles: Known = known.iter().map(|(letter, value)| (letter.clone(), value.middle())).collect();
        let [in_letters, in_numbers] = [value(&formula, &middles), value(numbers, &Known::new())];
        self.demand(in_letters.meets(in_numbers), || format!("{place}: {numbers} is not {formula}"));
    }

    /// The law itself leads to the result, whatever formula is printed.
    fn law(&mut self, place: &str, hit: &PrintedHit, line: &PrintedLine, result: Value) {
        if let Some(expected) = self.expected(hit, line) {
            self.demand(expected.meets(result), || format!("{place}: the law gives {expected:?}, not {result:?}"));
        }
    }

    fn expected(&self, hit: &PrintedHit, line: &PrintedLine) -> Option<Value> {
        let known = |letter: &str| self.known[letter];
        let one = Value::Number(Interval::exactly(1.0));
        let square = |value: Value| Value::Number(value.number().square());
        let degrees = |letter: &str, f: fn(f64) -> f64| {
            Value::Number(known(letter).number().map((-1.0, 1.0), |x| f(x).to_degrees()))
        };
        let is_total = || known("C2²").number().middle() <= 0.0;
        Some(match line.letter.as_str() {
            "C1" => -(known("N") * known("V")),
            // Both ways: the sine that the cross product gives is that of the cosine.
            "S1" => known("N").cross(known("V")),
            "η" => known("n2") / known("n1"),
            "C2²" => one - square(known("n1") * known("S1") / known("n2")),
            "C2" => Value::Number(known("C2²").number().map((0.0, 1.0), f64::sqrt)),
            "S2" => known("n1") * known("S1") / known("n2"),
            "T" if hit.given.contains_key("f") => self.behind_lens(),
            "T" => self.transmitted(),
            "R" => known("V") - (known("N") * known("V")) * known("N") - (known("N") * known("V")) * known("N"),
            "θ1" => degrees("C1", f64::acos),
            "θ2" if hit.given.contains_key("f") => {
                Value::Number((-(known("N") * known("T"))).number().map((-1.0, 1.0), |x| x.acos().to_degrees()))
            }
            "θ2" => degrees("C2", f64::acos),
            "θc" => Value::Number((known("n2") / known("n1")).number().map((-1.0, 1.0), |x| x.asin().to_degrees())),
            "R_s" | "R_p" if is_total() => one,
            "R_s" => self.reflectance("n1", "n2"),
            "R_p" => self.reflectance("n2", "n1"),
            "k_r" if hit.given.contains_key("w_s") => known("w_s") * known("R_s") + known("w_p") * known("R_p"),
            "c_local" => one - known("k_r") - known("k_t"),
            _ => return None,
        })
    }

    /// By components: what runs along the boundary is n1 S1/n2 of it, the rest goes into the medium.
    fn transmitted(&self) -> Value {
        let known = |letter: &str| self.known[letter];
        let along = known("V") - known("N") * (known("N") * known("V"));
        along * known("n1") / known("n2") - known("C2") * known("N")
    }

    /// Behind an ideal lens, the light crosses that through its center in the focal plane.
    fn behind_lens(&self) -> Value {
        let known = |letter: &str| self.known[letter];
        let [half, one] = [0.5, 1.0].map(|x| Value::Number(Interval::exactly(x)));
        let slope = known("V") * known("τ") / -(known("N") * known("V"));
        let bend = (known("P") - known("M")) * known("τ") / known("f");
        let mean = half * (known("n1") + known("n2"));
        let behind = (known("n1") * slope - mean * bend) / known("n2");
        let length =
            Value::Number((one + Value::Number(behind.number().square())).number().map((1.0, 1e300), f64::sqrt));
        (behind * known("τ") - known("N")) / length
    }

    /// Fresnel: s as it stands, p with the indices exchanged.
    fn reflectance(&self, a: &str, b: &str) -> Value {
        let (a, b) = (self.known[a] * self.known["C1"], self.known[b] * self.known["C2"]);
        Value::Number(((a - b) / (a + b)).number().square())
    }

    fn end(&mut self, end: &str, direction: Value, power: Value) {
        let told = share(end);
        self.demand(told.meets(power), || format!("at the end {told:?} of the power, not {power:?}"));
        let along = crate::page::printed(crate::page::between(end, "Its direction is ", ", a deviation"), None);
        self.demand(along.middle() == direction.middle(), || format!("at the end along {along:?}, not {direction:?}"));
        let deviation =
            crate::page::printed(crate::page::between(end, "a deviation of ", "° from that"), None).number();
        let expected = self.known["V0"].angle_to(direction).number();
        let turned = [-360.0, 0.0, 360.0].map(|turn| Interval::around(deviation.middle() + turn, deviation.width()));
        self.demand(turned.iter().any(|turned| turned.meets(expected)), || {
            format!("deviated by {deviation:?}, not {expected:?}")
        });
    }
}

/// A deviation, counted the other way round.
fn turned(letter: &str, angle: Value) -> Value {
    if letter == "δ" {
        angle - Value::Number(Interval::exactly(360.0_f64.copysign(angle.number().low)))
    } else {
        angle
    }
}
