//! What an explanation says, before it is written as text, Markdown or LaTeX.

use super::lines::{Letters, Line, direction_at_source, start};
use super::math::{Letter, Notation, Reading, Value};
use super::step::{Explanation, Step};
use crate::characters::one_line;
use crate::report::significant;
use crate::scene::SecondaryRays;
use crate::system::Action;
use crate::trace::{Ending, Segment, Via};

/// What of an explanation is written. The numbers of its questions are the same in each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Part {
    /// What is given, the laws, the numbers put in, and the results.
    #[default]
    Worked,
    /// A worksheet: what is given, and the laws with blanks for the results.
    Worksheet,
    /// The results alone.
    Key,
}

/// A piece of a document.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Block {
    Title(String),
    Ray(String),
    Hit(String),
    Say(Vec<Piece>),
    /// Numbered results.
    Items(Vec<Item>),
}

/// Words, or letters with their values.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Piece {
    Words(String),
    Given(Letter),
}

/// A numbered result.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Item {
    pub(super) number: String,
    line: Line,
    part: Part,
}

impl Item {
    /// What equals what.
    pub(super) fn math(&self, notation: Notation) -> String {
        let Self { line: Line { letter, formula, unit, .. }, part, .. } = self;
        let value = letter.value.as_ref().map(|value| value.write(notation) + written_unit(unit, notation));
        let written = |reading| formula.as_ref().map(|formula| formula.write(reading, notation));
        let numbers = formula.as_ref().filter(|formula| value.is_some() && formula.has_numbers());
        let numbers = numbers.map(|formula| formula.write(Reading::Numbers, notation));
        let name = Some(letter.write(notation).to_owned());
        let mut sides: Vec<_> = match part {
            Part::Worked => [name, written(Reading::Letters), numbers, value].into_iter().flatten().collect(),
            Part::Worksheet => [name, written(Reading::Letters), Some(blank(notation))].into_iter().flatten().collect(),
            Part::Key => [name, value].into_iter().flatten().collect(),
        };
        sides.dedup();
        sides.join(" = ")
    }

    /// What is said about the result, in words.
    pub(super) fn remark(&self) -> String {
        match (self.part, &self.line) {
            (Part::Worksheet, _) => String::new(),
            (_, Line { letter: Letter { value: None, .. }, remark, .. }) => format!("none: {remark}"),
            (_, line) => line.remark.into(),
        }
    }
}

fn written_unit(unit: &'static str, notation: Notation) -> &'static str {
    match (unit, notation) {
        ("°", Notation::Latex) => r"^\circ",
        _ => unit,
    }
}

fn blank(notation: Notation) -> String {
    if notation == Notation::Latex { r"\underline{\hspace{4em}}" } else { "________" }.into()
}

/// What explanations of rays of one scene say, piece by piece as it is asked for: a path may have a million hits.
pub(super) fn document(explanations: &[Explanation], part: Part) -> impl Iterator<Item = Block> {
    let title = explanations.first().map_or("", |explanation| &explanation.title);
    let title = (!title.is_empty()).then(|| Block::Title(one_line(title)));
    title.into_iter().chain(explanations.iter().flat_map(move |explanation| Writer { explanation, part }.blocks()))
}

/// Longer addresses are not written out at every hit.
const LONGEST: usize = 80;

fn words(words: impl Into<String>) -> Piece {
    Piece::Words(words.into())
}

#[derive(Clone, Copy)]
struct Writer<'a> {
    explanation: &'a Explanation,
    part: Part,
}

impl<'a> Writer<'a> {
    fn blocks(self) -> impl Iterator<Item = Block> + use<'a> {
        let steps = self.explanation.steps.iter().enumerate();
        let hits = steps.flat_map(move |(k, step)| self.hit(k + 1, step));
        self.header().into_iter().chain(hits).chain(self.end())
    }

    fn is_worksheet(self) -> bool {
        self.part == Part::Worksheet
    }

    fn header(self) -> Vec<Block> {
        let Explanation { ray, address, source, source_name, wavelength, power, length_decimals, .. } =
            self.explanation;
        // The letters of the path tell what becomes of the light.
        let heading = format!("Ray {}", if self.is_worksheet() { ray } else { address });
        let name = source_name.as_ref().map_or(String::new(), |name| format!(", {}", one_line(name)));
        let (nm, power) = (wavelength.nanometers(), significant(*power));
        let source = format!("Source {source}{name}; vacuum wavelength {nm} nm; power {power}.");
        let mut blocks = vec![Block::Ray(heading), Block::Say(vec![words(source)])];
        if self.part != Part::Key {
            let rounding = format!("Lengths are rounded to {length_decimals} decimals, other numbers to 6 digits.");
            let index = format!(", in index {}.", significant(self.explanation.start.medium_index));
            let (from, along) = (start(self.explanation), direction_at_source(self.explanation));
            blocks.push(Block::Say(vec![words(rounding)]));
            let (from, along) = (Piece::Given(from), Piece::Given(along));
            blocks.push(Block::Say(vec![words("The ray starts at "), from, words(" along "), along, words(index)]));
        }
        blocks
    }

    fn hit(self, number: usize, step: &Step) -> Vec<Block> {
        let letters = Letters::new(self.explanation, step);
        let mut blocks = vec![Block::Hit(format!("Hit {number}: {}, {}", one_line(&step.body), kind(step.action)))];
        if self.part == Part::Worked {
            let arrives = format!("Light arrives: {}.", self.carrying(number - 1, &step.segment));
            blocks.push(Block::Say(vec![words(arrives)]));
        }
        if self.part != Part::Key {
            blocks.push(Block::Say(self.given(number, &letters, step)));
        }
        let lines = letters.lines().into_iter().enumerate();
        let item = |(k, line)| Item { number: format!("{number}.{}", k + 1), line, part: self.part };
        blocks.push(Block::Items(lines.map(item).collect()));
        blocks.extend(step.next.filter(|_| self.part != Part::Key).map(|next| self.goes_on(number, &next)));
        blocks
    }

    fn goes_on(self, number: usize, next: &Segment) -> Block {
        let which = if next.via == Via::Transmission { "transmitted" } else { "reflected" };
        let how = if self.is_worksheet() { String::new() } else { format!(": {}", self.carrying(number, next)) };
        Block::Say(vec![words(format!("The {which} light goes on{how}."))])
    }

    /// What is known where the light arrives.
    fn given(self, number: usize, letters: &Letters, step: &Step) -> Vec<Piece> {
        let mut given = Vec::new();
        for (letter, name) in letters.given() {
            // What the last hit led to is no gift of the next.
            if matches!(letter.plain, "V" | "w_s" | "w_p") && self.is_worksheet() && number > 1 {
                continue;
            }
            given.push(words(if given.is_empty() { "Given: " } else { ", " }));
            given.push(Piece::Given(letter));
            given.extend(name.map(|name| words(format!(" ({name})"))));
        }
        given.push(words(self.given_in_words(number, step)));
        given
    }

    /// What else is given at a hit.
    fn given_in_words(self, number: usize, step: &Step) -> String {
        let before = number.checked_sub(1).filter(|k| *k > 0 && self.is_worksheet());
        let direction = before
            .map_or(String::new(), |k| format!(" V is the direction found at hit {k}, w_s and w_p are as found last."));
        let shares = match (step.action, self.explanation.secondary_rays) {
            (Action::Split { reflect, transmit }, _) => {
                format!(" The beam splitter reflects {reflect} and transmits {transmit}.")
            }
            (Action::Refract, SecondaryRays::Fixed { kr, kt }) => {
                format!(" The scene sets k_r to {kr} and k_t to {kt} where light is transmitted.")
            }
            (Action::Refract, SecondaryRays::TransmittedOnly) => {
                " The transmitted ray carries everything, where there is one.".into()
            }
            _ => String::new(),
        };
        format!(".{direction}{shares}")
    }

    /// A branch of the path by its address, and what it carries.
    fn carrying(self, hits: usize, segment: &Segment) -> String {
        let address = shortened(self.explanation.address_behind(hits));
        match significant(segment.power.total() / self.explanation.power).as_str() {
            "1" => format!("{address}, with all of the ray's power"),
            share => format!("{address}, with {share} of the ray's power"),
        }
    }

    fn end(self) -> [Block; 2] {
        let blank = blank(Notation::Plain);
        let how = if self.is_worksheet() {
            format!(
                "How does the path end? {blank} By how much is the light deviated from its first direction? {blank}"
            )
        } else {
            self.ending()
        };
        [Block::Hit("End".into()), Block::Say(vec![words(how)])]
    }

    fn ending(self) -> String {
        let Explanation { end, children, steps, .. } = self.explanation;
        let how = match end.ending {
            Ending::Interface => format!(
                "ends at the last hit, where {} {}",
                children.join(" and "),
                if children.len() == 1 { "begins" } else { "begin" }
            ),
            Ending::Absorbed => "is absorbed at the last hit".into(),
            Ending::Detected => "lands on the screen".into(),
            Ending::Escaped => "leaves the scene".into(),
            Ending::CutMinPower => "is not followed, since it carries less than the scene's min_power".into(),
            Ending::CutMaxDepth => "is not followed, since as many hits as the scene's max_depth lie behind it".into(),
            Ending::CutMaxSegments => "is not followed, since the scene's max_segments are spent".into(),
        };
        let direction = Value::vector(end.direction).write(Notation::Plain);
        let deviation = Value::number(self.explanation.deviation_degrees(end.direction)).write(Notation::Plain);
        let carrying = self.carrying(steps.len(), end);
        format!("{carrying}, {how}. Its direction is {direction}, a deviation of {deviation}° from that at the source.")
    }
}

/// An address of many hits with its middle left out.
fn shortened(address: &str) -> String {
    match (address.get(..LONGEST / 2), address.get(address.len().saturating_sub(LONGEST / 2)..)) {
        (Some(first), Some(last)) if address.len() > LONGEST => format!("{first}…{last}"),
        _ => address.into(),
    }
}

/// What a boundary is.
fn kind(action: Action) -> &'static str {
    match action {
        Action::Refract => "face between two media",
        Action::Mirror => "mirror",
        Action::Absorb => "absorber",
        Action::Detect { .. } => "screen",
        Action::Split { .. } => "beam splitter",
        Action::ThinLens { .. } => "ideal thin lens",
    }
}
