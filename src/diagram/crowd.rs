use std::collections::BTreeMap;

use crate::diagram::branches::Branch;
use crate::diagram::styles::{Styles, strength};
use crate::drawing::{Color, Group, Item, Lines, Whole};
use crate::trace::Via;

/// With more branches than this, those of one style share a path.
const MOST_SINGLE: usize = 2000;
/// So many of the strongest are kept for the marks that look at single branches.
const STRONGEST: usize = 4000;
/// Steps of power that are told apart where branches share paths.
const LEVELS: f64 = 24.0;

/// The branches of a figure as they come: each by itself while they are few, by style as well when they are many.
pub(super) struct Crowd<'a> {
    styles: Styles<'a>,
    count: usize,
    /// The strongest, each with the number of branches before it, in no order.
    strongest: Vec<(Branch<'a>, usize)>,
    /// Weaker ones are not among the strongest, share of the source ray.
    weakest: f64,
    by_style: BTreeMap<Style, Lines>,
}

/// What branches must have in common to share a path; in this order they are drawn.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Style {
    level: u8,
    adds_up: bool,
    via: Alphabetic,
    color: Color,
    dash: usize,
}

/// Ways that a branch came about, in the order of their words.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Alphabetic {
    Reflection,
    Source,
    TotalInternalReflection,
    Transmission,
}

impl<'a> Crowd<'a> {
    pub(super) fn new(styles: Styles<'a>) -> Self {
        Self { styles, count: 0, strongest: Vec::new(), weakest: 0.0, by_style: BTreeMap::new() }
    }

    pub(super) fn push(&mut self, branch: &Branch<'a>) {
        self.count += 1;
        if self.count > MOST_SINGLE {
            if self.by_style.is_empty() {
                let earlier = self.strongest.iter().map(|(branch, _)| branch);
                earlier.for_each(|branch| add(&mut self.by_style, &self.styles, branch));
            }
            add(&mut self.by_style, &self.styles, branch);
        }
        if branch.share >= self.weakest {
            self.strongest.push((*branch, self.count));
            if self.strongest.len() > 2 * STRONGEST {
                self.keep_strongest();
            }
        }
    }

    fn keep_strongest(&mut self) {
        if self.strongest.len() > STRONGEST {
            let after = |a: &(Branch<'a>, usize), b: &(Branch<'a>, usize)| order(b, a);
            let (_, last, _) = self.strongest.select_nth_unstable_by(STRONGEST - 1, after);
            self.weakest = last.0.share;
            self.strongest.truncate(STRONGEST);
        }
    }

    /// The strongest branches, weakest first, which are all where they are few; and how many are drawn: the weak ones first,
    /// a path a style, none where each is drawn by itself.
    pub(super) fn finish(mut self) -> (Vec<Branch<'a>>, Styles<'a>, Vec<Item>) {
        self.keep_strongest();
        self.strongest.sort_unstable_by(order);
        (self.strongest.into_iter().map(|(branch, _)| branch).collect(), self.styles, items(self.by_style))
    }
}

fn items(by_style: BTreeMap<Style, Lines>) -> Vec<Item> {
    let mut items: Vec<Item> = Vec::new();
    let mut paths = by_style.into_iter().peekable();
    while let Some((style, lines)) = paths.next() {
        if !style.adds_up {
            items.push(lines.into());
            continue;
        }
        let whole = Whole { opacity: lines.stroke.opacity, adds_up: true };
        let mut lights = vec![lines];
        while let Some((_, next)) = paths.next_if(|(next, _)| next.adds_up && next.level == style.level) {
            lights.push(next);
        }
        lights.iter_mut().for_each(|light| light.stroke.opacity = 1.0);
        let lights = lights.into_iter().map(Item::from).collect();
        items.push(Group::layer("spectrum", lights).as_whole(whole).into());
    }
    items
}

/// By power, the later of equal ones behind.
fn order(a: &(Branch<'_>, usize), b: &(Branch<'_>, usize)) -> std::cmp::Ordering {
    a.0.share.total_cmp(&b.0.share).then(a.1.cmp(&b.1))
}

fn add<'a>(by_style: &mut BTreeMap<Style, Lines>, styles: &Styles<'a>, branch: &Branch<'a>) {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 24")]
    let level = (strength(branch.share) * LEVELS + 0.5) as u8;
    let style = Style {
        level,
        adds_up: styles.add_up() && styles.spectral(branch),
        via: Alphabetic::of(branch.segment.via),
        color: styles.color(branch),
        dash: styles.dash(branch),
    };
    let lines = by_style.entry(style).or_insert_with(|| {
        let stroke = styles.stroke(branch, f64::from(level) / LEVELS);
        Lines::new(stroke, &format!("ray {}", branch.segment.via.word()))
    });
    lines.push(branch.ends[0], branch.ends[1]);
}

impl Alphabetic {
    fn of(via: Via) -> Self {
        match via {
            Via::Reflection => Self::Reflection,
            Via::Source => Self::Source,
            Via::TotalInternalReflection => Self::TotalInternalReflection,
            Via::Transmission => Self::Transmission,
        }
    }
}
