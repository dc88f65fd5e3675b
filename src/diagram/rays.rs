use std::collections::BTreeMap;

use crate::diagram::Figure;
use crate::diagram::branches::{Branch, closed_stretch};
use crate::diagram::generations::Aged;
use crate::diagram::styles::{Styles, strength, together};
use crate::drawing::{Group, Item, Path, Shape, Stroke, Whole, shortest};

/// Branches that are few enough, each with its address and power.
pub(super) fn rays(figure: &Figure<'_>) -> Vec<Aged> {
    let styles = &figure.styles;
    let mut fans: BTreeMap<usize, Vec<&Branch<'_>>> = BTreeMap::new();
    for branch in &figure.branches {
        if let Some(fan) = branch.fan.filter(|_| styles.spectral(branch)) {
            fans.entry(fan.id).or_default().push(branch);
        }
    }
    let items = figure.branches.iter().filter_map(|branch| {
        let item = match branch.fan.and_then(|fan| fans.get(&fan.id)) {
            None => Some(single(branch, styles.stroke(branch, strength(branch.share))).into()),
            // A fan stands where its strongest line would.
            Some(fan) => fan.last().is_some_and(|last| std::ptr::eq(*last, branch)).then(|| spectrum(styles, fan)),
        };
        item.map(|item| (branch.generation(), item))
    });
    items.collect()
}

fn single(branch: &Branch<'_>, stroke: Stroke) -> Shape {
    let path = Path::line(branch.ends[0], branch.ends[1]);
    Shape::stroked(path, stroke, &class(branch))
        .with("data-address", branch.address())
        .with("data-power", shortest(branch.power))
}

/// The lines of one ray as a whole of the strongest line's opacity, so that many weak lines over each other stay weak.
fn spectrum(styles: &Styles<'_>, fan: &[&Branch<'_>]) -> Item {
    let strongest = fan.iter().map(|branch| strength(branch.share)).fold(0.0, f64::max);
    let mut items: Vec<Item> = Vec::new();
    for branch in fan {
        let own = strength(branch.share);
        items.push(
            single(branch, styles.stroke(branch, own).faded(styles.opacity(own) / styles.opacity(strongest))).into(),
        );
    }
    let whole = Whole { opacity: styles.opacity(strongest), adds_up: styles.add_up() };
    if !whole.adds_up
        && let Some((first, ends)) = fan.first().zip(closed_stretch(fan))
    {
        let stroke = styles.stroke(&together(first), strongest).faded(1.0);
        items.push(Shape::stroked(Path::line(ends[0], ends[1]), stroke, "together").into());
    }
    Group::layer("spectrum", items).as_whole(whole).into()
}

fn class(branch: &Branch<'_>) -> String {
    format!("ray {}", branch.segment.via.word())
}
