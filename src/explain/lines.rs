//! What there is to work out at a hit: each law in letters, and its result.

use super::math::{Formula, Letter, Value};
use super::step::{Explanation, Step};
use crate::scene::SecondaryRays;
use crate::system::Action;

/// One result, and the formula that leads to it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Line {
    pub(super) letter: Letter,
    /// `None` where the result is read off.
    pub(super) formula: Option<Formula>,
    pub(super) unit: &'static str,
    /// What the result means, or why there is none.
    pub(super) remark: &'static str,
}

const TOTAL: &str = "total internal reflection";
const CRITICAL: &str =
    "at the critical angle T would run along the boundary and carry nothing: total internal reflection";

impl Line {
    fn new(letter: &Letter, formula: Formula) -> Self {
        Self { letter: letter.clone(), formula: Some(formula), unit: "", remark: "" }
    }

    /// A result that no formula gives.
    fn told(letter: &Letter, remark: &'static str) -> Self {
        Self { letter: letter.clone(), formula: None, unit: "", remark }
    }

    fn remark(self, remark: &'static str) -> Self {
        Self { remark, ..self }
    }

    fn degrees(self) -> Self {
        Self { unit: "°", ..self }
    }
}

/// A smaller share of light is not divided by: few of its printed digits may be left.
const LEAST_SHARE: f64 = 1e-5;

/// The letters of a hit with their values.
pub(super) struct Letters<'a> {
    explanation: &'a Explanation,
    step: &'a Step,
    p: Letter,
    v: Letter,
    n: Letter,
    n1: Letter,
    n2: Letter,
    w_s: Letter,
    w_p: Letter,
    c1: Letter,
    s1: Letter,
    eta: Letter,
    discriminant: Letter,
    c2: Letter,
    s2: Letter,
    t: Letter,
    r: Letter,
}

/// The direction of a ray at its source.
pub(super) fn direction_at_source(explanation: &Explanation) -> Letter {
    Letter::new("V0", r"\vec V_0", Some(Value::vector(explanation.start.direction)))
}

/// The point at which a ray starts.
pub(super) fn start(explanation: &Explanation) -> Letter {
    let value = Value::point(explanation.start.from, explanation.length_decimals);
    Letter::new("P0", "P_0", Some(value))
}

fn number(plain: &'static str, latex: &'static str, x: impl Into<Option<f64>>) -> Letter {
    Letter::new(plain, latex, x.into().map(Value::number))
}

fn constant(digits: &'static str) -> Formula {
    Formula::Constant(digits)
}

impl<'a> Letters<'a> {
    pub(super) fn new(explanation: &'a Explanation, step: &'a Step) -> Self {
        let (hit, [w_s, w_p]) = (&step.hit, step.polarization());
        Self {
            explanation,
            step,
            p: Letter::new("P", "P", Some(Value::point(step.at, explanation.length_decimals))),
            v: Letter::new("V", r"\vec V", Some(Value::vector(step.segment.direction))),
            n: Letter::new("N", r"\vec N", Some(Value::vector(hit.normal))),
            n1: number("n1", "n_1", hit.n_i),
            n2: number("n2", "n_2", hit.n_t),
            w_s: number("w_s", "w_s", w_s),
            w_p: number("w_p", "w_p", w_p),
            c1: number("C1", "C_1", hit.cos_i),
            s1: number("S1", "S_1", hit.sin_i.abs()),
            eta: number("η", r"\eta", step.eta()),
            discriminant: Letter::new("C2²", "C_2^2", step.discriminant().map(Value::exact)),
            c2: Letter::new("C2", "C_2", hit.cos_t.map(Value::exact)),
            s2: number("S2", "S_2", hit.sin_t.map(f64::abs)),
            t: Letter::new("T", r"\vec T", step.hit.transmitted().map(Value::vector)),
            r: Letter::new("R", r"\vec R", Some(Value::vector(step.hit.reflected()))),
        }
    }

    /// What is known where the light arrives; media with their catalog names.
    pub(super) fn given(&self) -> Vec<(Letter, Option<&'static str>)> {
        let [before, behind] = self.step.media;
        let mut given =
            vec![(self.p.clone(), None), (self.v.clone(), None), (self.n.clone(), None), (self.n1.clone(), before)];
        if self.n2.value.is_some() {
            given.push((self.n2.clone(), behind));
        }
        if let Action::ThinLens { focal_length, .. } = self.step.action {
            let ThinLensLetters { m, f, tau } = self.lens_letters(focal_length);
            given.extend([m, f, tau].map(|letter| (letter, None)));
        }
        if self.by_fresnel() {
            given.extend([&self.w_s, &self.w_p].map(|letter| (letter.clone(), None)));
        }
        given
    }

    /// Everything to work out, in order.
    pub(super) fn lines(&self) -> Vec<Line> {
        let mut lines = vec![self.line_c1(), self.line_s1()];
        match self.step.action {
            Action::Refract | Action::Split { .. } => self.face(&mut lines),
            Action::Mirror => lines.extend([self.line_r(), self.theta_1()]),
            Action::Absorb => lines.push(self.theta_1()),
            Action::Detect { .. } => lines.extend([self.theta_1(), self.position()]),
            Action::ThinLens { focal_length, .. } => self.thin_lens(&mut lines, focal_length),
        }
        self.shares(&mut lines);
        lines.extend(self.deviation());
        lines
    }

    fn f(letter: &Letter) -> Formula {
        letter.into()
    }

    fn line_c1(&self) -> Line {
        Line::new(&self.c1, Self::f(&self.n).dot(&self.v).minus())
    }

    fn line_s1(&self) -> Line {
        let sine = if self.step.hit.sin_i.abs() < 0.1 {
            // Toward the normal 1 − C1² would cancel.
            Formula::Cross(Box::new(Self::f(&self.n)), Box::new(Self::f(&self.v)))
        } else {
            constant("1").less(Self::f(&self.c1).square()).root()
        };
        Line::new(&self.s1, sine)
    }

    fn line_r(&self) -> Line {
        Line::new(&self.r, Self::f(&self.v).plus(constant("2").times(&self.c1).times(&self.n)))
    }

    /// The angle whose sine and cosine are known, from the one that tells it better.
    fn angle(
        letter: (&'static str, &'static str),
        degrees: Option<f64>,
        sine: (&Letter, f64),
        cosine: (&Letter, f64),
    ) -> Line {
        let formula = if sine.1 < cosine.1 {
            Formula::Arc("arcsin", Box::new(sine.0.into()))
        } else {
            Formula::Arc("arccos", Box::new(cosine.0.into()))
        };
        Line::new(&number(letter.0, letter.1, degrees), formula).degrees()
    }

    fn theta_1(&self) -> Line {
        let hit = &self.step.hit;
        Self::angle(
            ("θ1", r"\theta_1"),
            Some(hit.theta_i_degrees()),
            (&self.s1, hit.sin_i.abs()),
            (&self.c1, hit.cos_i),
        )
    }

    /// A face between two media.
    fn face(&self, lines: &mut Vec<Line>) {
        lines.push(Line::new(&self.eta, Self::f(&self.n2).over(&self.n1)));
        self.transmission(lines);
        lines.extend([self.line_r(), self.theta_1()]);
        self.angles_behind(lines);
        if self.by_fresnel() {
            self.fresnel(lines);
        }
    }

    fn by_fresnel(&self) -> bool {
        self.step.action == Action::Refract && self.explanation.secondary_rays == SecondaryRays::Fresnel
    }

    fn total(&self) -> Option<&'static str> {
        let is_total = self.step.hit.total_internal_reflection;
        is_total.then_some(if self.step.is_critical() { CRITICAL } else { TOTAL })
    }

    fn transmission(&self, lines: &mut Vec<Line>) {
        let radicand =
            constant("1").plus(Self::f(&self.c1).square().less(constant("1")).over(Self::f(&self.eta).square()));
        let sign = match (self.total(), self.step.is_critical()) {
            (None, _) => "",
            (Some(_), true) => "zero: the critical angle itself",
            (Some(_), false) => "negative: total internal reflection",
        };
        lines.push(Line::new(&self.discriminant, radicand.clone()).remark(sign));
        let root = match self.discriminant.value.clone() {
            Some(value) if self.c2.value.is_some() => Formula::Known(Box::new(radicand), value).root(),
            _ => radicand.root(),
        };
        let total = self.total().unwrap_or_default();
        lines.push(Line::new(&self.c2, root).remark(if self.c2.value.is_none() { TOTAL } else { "" }));
        let s2 = Line::new(&self.s2, Self::f(&self.s1).over(&self.eta));
        lines.push(s2.remark(if self.s2.value.is_none() { TOTAL } else { "" }));
        let along_normal = Self::f(&self.c1).over(&self.eta).less(&self.c2);
        let t = Self::f(&self.v).over(&self.eta).plus(along_normal.times(&self.n));
        lines.push(Line::new(&self.t, t).remark(total));
    }

    fn angles_behind(&self, lines: &mut Vec<Line>) {
        let hit = &self.step.hit;
        let sine = (&self.s2, hit.sin_t.map_or(f64::INFINITY, f64::abs));
        let cosine = (&self.c2, hit.cos_t.unwrap_or(0.0));
        let theta_2 = Self::angle(("θ2", r"\theta_2"), hit.theta_t_degrees(), sine, cosine);
        lines.push(theta_2.remark(if hit.theta_t_degrees().is_none() { TOTAL } else { "" }));
        let critical = Formula::Arc("arcsin", Box::new(Self::f(&self.eta)));
        let theta_c = Line::new(&number("θc", r"\theta_c", hit.critical_degrees()), critical).degrees();
        lines.push(theta_c.remark(if hit.critical_degrees().is_none() { "n1 is not above n2" } else { "" }));
    }

    /// Reflectances by Fresnel's equations.
    fn fresnel(&self, lines: &mut Vec<Line>) {
        let reflectance = self.step.hit.reflectance;
        let amplitude = |a: &Letter, b: &Letter| {
            let (a, b) = (Self::f(a).times(&self.c1), Self::f(b).times(&self.c2));
            a.clone().less(b.clone()).over(a.plus(b)).square()
        };
        let remark = self.total().map_or("", |_| TOTAL);
        let line = |letter: Letter, formula| Line::new(&letter, formula).remark(remark);
        lines.push(line(number("R_s", "R_s", reflectance.s), amplitude(&self.n1, &self.n2)));
        lines.push(line(number("R_p", "R_p", reflectance.p), amplitude(&self.n2, &self.n1)));
    }

    /// How the power that arrives is shared.
    fn shares(&self, lines: &mut Vec<Line>) {
        let [k_r, k_t, c_local] = self.step.shares();
        let (k_r, k_t) = (number("k_r", "k_r", k_r), number("k_t", "k_t", k_t));
        if self.by_fresnel() {
            let reflectance = self.step.hit.reflectance;
            let (r_s, r_p) = (number("R_s", "R_s", reflectance.s), number("R_p", "R_p", reflectance.p));
            let mean = Self::f(&self.w_s).times(&r_s).plus(Self::f(&self.w_p).times(&r_p));
            lines.push(Line::new(&k_r, mean));
            lines.push(Line::new(&k_t, constant("1").less(&k_r)));
        } else {
            let why = self.why_shares();
            lines.push(Line::told(&k_r, why));
            lines.push(Line::told(&k_t, why));
        }
        let local = constant("1").less(&k_r).less(&k_t);
        lines.push(Line::new(&number("c_local", r"c_{\text{local}}", c_local), local));
        lines.extend(self.polarization_behind().into_iter().flatten());
    }

    /// The shares of the polarizations in the light that goes on, where they change and its own share is no rounding.
    fn polarization_behind(&self) -> Option<[Line; 2]> {
        let next = self.step.next.filter(|_| self.by_fresnel() && self.total().is_none())?;
        let (reflectance, [k_r, k_t, _]) = (self.step.hit.reflectance, self.step.shares());
        let is_transmitted = self.step.next_is_transmitted();
        let (share, share_letter) =
            if is_transmitted { (k_t, number("k_t", "k_t", k_t)) } else { (k_r, number("k_r", "k_r", k_r)) };
        let line = |new: Letter, w: &Letter, r: Letter| {
            let part = if is_transmitted { Self::f(w).times(constant("1").less(&r)) } else { Self::f(w).times(&r) };
            Line::new(&new, part.over(&share_letter))
        };
        let [s, p] = [next.power.s, next.power.p].map(|part| part / next.power.total());
        (share > LEAST_SHARE).then(|| {
            [
                line(number("w_s′", "w_s'", s), &self.w_s, number("R_s", "R_s", reflectance.s)),
                line(number("w_p′", "w_p'", p), &self.w_p, number("R_p", "R_p", reflectance.p)),
            ]
        })
    }

    fn why_shares(&self) -> &'static str {
        match (self.step.action, self.total()) {
            (Action::Split { .. }, Some(_)) => {
                "at total internal reflection what would be transmitted is reflected too"
            }
            (Action::Split { .. }, None) => "by the beam splitter's own numbers",
            (Action::Mirror, _) => "a mirror reflects everything",
            (Action::Absorb, _) => "an absorber takes everything",
            (Action::Detect { .. }, _) => "a screen takes everything",
            (Action::ThinLens { .. }, _) => "an ideal lens transmits everything",
            (Action::Refract, Some(_)) => TOTAL,
            (Action::Refract, None) => "set by the scene",
        }
    }

    /// Where the light lands on a screen.
    fn position(&self) -> Line {
        let value = self.step.hit.position.map(|s| Value::length(s, self.explanation.length_decimals));
        Line::told(&Letter::new("s", "s", value), "from the screen's first point, along it")
    }

    fn thin_lens(&self, lines: &mut Vec<Line>, focal_length: f64) {
        let ThinLensLetters { m, f, tau } = self.lens_letters(focal_length);
        let (step, hit) = (self.step, &self.step.hit);
        let height = match step.action {
            Action::ThinLens { center, .. } => (step.at - center).dot(step.hit.tangent()),
            _ => 0.0,
        };
        let h = Letter::new("h", "h", Some(Value::length(height, self.explanation.length_decimals)));
        let slope = |sin: f64, cos: f64| (cos > 0.0).then(|| sin / cos);
        let m1 = number("m1", "m_1", slope(hit.sin_i, hit.cos_i));
        let behind = hit.sin_t.zip(hit.cos_t).and_then(|(sin, cos)| slope(sin, cos));
        let m2 = number("m2", "m_2", m1.value.as_ref().and(behind));
        let edge_on = if m2.value.is_none() { "light along the lens goes on along it" } else { "" };
        lines.push(Line::new(&h, Self::f(&self.p).less(&m).dot(&tau)));
        lines.push(Line::new(&m1, Self::f(&self.v).dot(&tau).over(&self.c1)).remark(edge_on));
        lines.push(Line::new(&m2, self.bent_slope(&m1, &h, &f)).remark(edge_on));
        let length = constant("1").plus(Self::f(&m2).square()).root();
        let t = Self::f(&m2).times(&tau).less(&self.n).over(length);
        lines.push(Line::new(&self.t, t).remark(edge_on));
        lines.push(self.theta_1());
        let theta_2 = number("θ2", r"\theta_2", hit.theta_t_degrees());
        let arc = Formula::Arc("arctan", Box::new(Formula::Size(Box::new(Self::f(&m2)))));
        lines.push(Line::new(&theta_2, arc).degrees());
    }

    /// The slope behind an ideal lens: m1 − h/f, and with the mean index between two media.
    fn bent_slope(&self, m1: &Letter, h: &Letter, f: &Letter) -> Formula {
        let hit = &self.step.hit;
        let bend = Self::f(h).over(f);
        if hit.n_t.is_none_or(|n_t| n_t.to_bits() == hit.n_i.to_bits()) {
            return Self::f(m1).less(bend);
        }
        let mean = Self::f(&self.n1).plus(&self.n2).over(constant("2"));
        Self::f(&self.n1).times(m1).less(mean.times(bend)).over(&self.n2)
    }

    fn lens_letters(&self, focal_length: f64) -> ThinLensLetters {
        let decimals = self.explanation.length_decimals;
        let center = match self.step.action {
            Action::ThinLens { center, .. } => center,
            _ => self.step.at,
        };
        ThinLensLetters {
            m: Letter::new("M", "M", Some(Value::point(center, decimals))),
            f: number("f", "f", focal_length),
            tau: Letter::new("τ", r"\vec\tau", Some(Value::vector(self.step.hit.tangent()))),
        }
    }

    /// The deviation of the light that goes on.
    fn deviation(&self) -> Option<Line> {
        let next = self.step.next?;
        let taken = if self.step.next_is_transmitted() { &self.t } else { &self.r };
        let from = direction_at_source(self.explanation);
        let delta = number("δ", r"\delta", self.explanation.deviation_degrees(next.direction));
        Some(Line::new(&delta, Formula::Angle(Box::new(Self::f(&from)), Box::new(Self::f(taken)))).degrees())
    }
}

/// The letters of an ideal thin lens.
struct ThinLensLetters {
    /// Center.
    m: Letter,
    f: Letter,
    /// Unit vector along the lens.
    tau: Letter,
}
