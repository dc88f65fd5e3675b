//! A figure that is built up, as on slides that follow each other.

use std::collections::BTreeSet;

use crate::drawing::{Drawing, Group, Item};

impl Drawing {
    /// The steps of its build-up, those that its groups name.
    #[must_use]
    pub fn steps(&self) -> BTreeSet<u32> {
        let mut found = BTreeSet::new();
        collect(&self.items, &mut found);
        found
    }

    /// The figure as it stands after a step of its build-up: without the groups of later steps, the rest in its place.
    #[must_use]
    pub fn up_to(&self, step: u32) -> Self {
        Self { items: kept(&self.items, step), ..self.clone() }
    }
}

fn collect(items: &[Item], found: &mut BTreeSet<u32>) {
    for item in items {
        if let Item::Group(group) = item {
            found.extend(group.step);
            collect(&group.items, found);
        }
    }
}

fn kept(items: &[Item], step: u32) -> Vec<Item> {
    let keep = |item: &Item| match item {
        Item::Group(group) if group.step.is_some_and(|own| own > step) => None,
        Item::Group(group) => {
            let items = kept(&group.items, step);
            // What held nothing but later steps goes with them.
            let stays = !items.is_empty() || group.items.is_empty();
            stays.then(|| Group { items: items.into(), ..group.clone() }.into())
        }
        other => Some(other.clone()),
    };
    items.iter().filter_map(keep).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_figure_grows_and_ends_whole() {
        let group = |step, items: Vec<Item>| Item::from(Group { step, items: items.into(), ..Group::default() });
        let late = group(None, vec![group(Some(7), Vec::new())]);
        let items = vec![group(Some(2), vec![group(Some(4), Vec::new()), group(None, Vec::new())]), late];
        let whole = Drawing { items, ..Drawing::default() };
        assert_eq!(whole.steps().into_iter().collect::<Vec<_>>(), [2, 4, 7]);
        assert_eq!(whole.up_to(1).items, []);
        assert_eq!(whole.up_to(3).items, [group(Some(2), vec![group(None, Vec::new())])]);
        assert_eq!(whole.up_to(6).items, whole.items[..1]);
        assert_eq!(whole.up_to(7), whole);
    }
}
