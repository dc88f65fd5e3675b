//! Several figures in one.

use glam::DVec2;

use crate::drawing::{Color, Drawing, Fill, Group, Item, Lines, Path, Rect, Shape, Text, hundredths, pixel};

impl Drawing {
    /// Figures from left to right with `gap` pixels between them, their upper edges at one height. A ground that all have
    /// is the whole's; else each has its own, and between them is none.
    #[must_use]
    pub fn side_by_side(panels: &[Self], gap: u32) -> Self {
        let grounds = || panels.iter().map(|panel| panel.background);
        let background = grounds().next().flatten().filter(|first| grounds().all(|ground| ground == Some(*first)));
        let height = panels.iter().map(|panel| panel.size[1]).max().unwrap_or(0);
        let (mut items, mut width) = (Vec::new(), 0_u32);
        for (number, panel) in (1..).zip(panels) {
            if number > 1 {
                width = width.saturating_add(gap);
            }
            let ground = panel.background.filter(|_| background.is_none());
            items.push(as_panel(panel, &format!("panel-{number}"), ground, width));
            width = width.saturating_add(panel.size[0]);
        }
        let joined = |words: fn(&Self) -> &str| {
            let words: Vec<&str> = panels.iter().map(words).filter(|words| !words.is_empty()).collect();
            words.join(" | ")
        };
        let (title, description) = (joined(|panel| &panel.title), joined(|panel| &panel.description));
        Self { size: [width, height], background, title, description, items }
    }
}

fn as_panel(panel: &Drawing, name: &str, ground: Option<Color>, left: u32) -> Item {
    let by = DVec2::new(f64::from(left), 0.0);
    let [width, height] = panel.size.map(f64::from);
    let frame = Rect { min: DVec2::ZERO, max: DVec2::new(width, height) }.moved(by);
    let ground = ground.map(|color| Shape::filled(Path::rect(frame), Fill::solid(color), "ground").into());
    let items = panel.items.iter().map(|item| placed(item, by, name));
    Group { name: name.into(), ..Group::layer("panel", ground.into_iter().chain(items).collect()) }.into()
}

/// An item elsewhere, its names under the panel's.
fn placed(item: &Item, by: DVec2, panel: &str) -> Item {
    match item {
        Item::Shape(shape) => Shape { path: shape.path.moved(by), ..shape.clone() }.into(),
        Item::Lines(lines) => {
            let move_by = by.to_array().map(hundredths);
            let ends = lines.ends.iter().map(|ends| std::array::from_fn(|k| ends[k].saturating_add(move_by[k % 2])));
            Lines { ends: ends.collect(), ..lines.clone() }.into()
        }
        Item::Text(text) => {
            let at = text.at + by;
            Text { at: DVec2::new(pixel(at.x), pixel(at.y)), ..text.clone() }.into()
        }
        Item::Group(group) => {
            let name = if group.name.is_empty() { String::new() } else { format!("{panel}-{}", group.name) };
            let clip = group.clip.map(|clip| clip.moved(by));
            let items: Vec<Item> = group.items.iter().map(|item| placed(item, by, panel)).collect();
            Group { name, clip, items: items.into(), ..group.clone() }.into()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Stroke;

    fn panel(ground: u32) -> Drawing {
        let stroke = || Stroke::solid(Color::hex(0), 1.0);
        let mut lines = Lines::new(stroke(), "");
        lines.push(DVec2::new(1.0, 2.0), DVec2::new(3.5, 4.0));
        let mut arc = Path::line(DVec2::ZERO, DVec2::new(5.0, 6.0));
        arc.arc_to(3.0, false, true, DVec2::new(7.0, 8.0));
        let clip = Rect { min: DVec2::ZERO, max: DVec2::new(9.0, 9.0) };
        let text = Text::new("word", DVec2::new(2.5, 9.0), 10.0, Color::hex(0));
        let items = vec![lines.into(), Shape::stroked(arc, stroke(), "").into(), text.into()];
        let group = Group { name: "rays-0".into(), ..Group::layer("", items) };
        let items = vec![group.clipped(clip).into()];
        Drawing { size: [20, 30], background: Some(Color::hex(ground)), title: "a".into(), items, ..Drawing::default() }
    }

    #[test]
    fn everything_of_a_panel_moves() {
        let both = Drawing::side_by_side(&[panel(1), panel(1)], 4);
        assert_eq!((both.size, both.background, both.title.as_str()), ([44, 30], Some(Color::hex(1)), "a | a"));
        let [Item::Group(first), Item::Group(second)] = both.items.as_slice() else { panic!("{both:?}") };
        let [Item::Group(layer)] = &second.items[..] else { panic!("{second:?}") };
        assert_eq!((second.name.as_str(), layer.name.as_str()), ("panel-2", "panel-2-rays-0"));
        assert_eq!(layer.clip.unwrap().min, DVec2::new(24.0, 0.0));
        let [Item::Lines(lines), Item::Shape(shape), Item::Text(text)] = &layer.items[..] else { panic!() };
        assert_eq!(lines.ends, [[2500, 200, 2750, 400]]);
        let mut arc = Path::line(DVec2::new(24.0, 0.0), DVec2::new(29.0, 6.0));
        arc.arc_to(3.0, false, true, DVec2::new(31.0, 8.0));
        assert_eq!((&shape.path, text.at), (&arc, DVec2::new(26.5, 9.0)));
        let Item::Group(still) = &first.items[0] else { panic!() };
        let Item::Group(before) = &panel(1).items[0] else { panic!() };
        assert_eq!(still.items, before.items, "the first stands where it stood");
    }

    #[test]
    fn grounds_that_differ_stay_with_their_panels() {
        let both = Drawing::side_by_side(&[panel(1), panel(2)], 4);
        assert_eq!(both.background, None);
        let Item::Group(second) = &both.items[1] else { panic!() };
        let Item::Shape(ground) = &second.items[0] else { panic!() };
        let rect = Rect { min: DVec2::new(24.0, 0.0), max: DVec2::new(44.0, 30.0) };
        assert_eq!((&ground.path, ground.fill), (&Path::rect(rect), Some(Fill::solid(Color::hex(2)))));
    }
}
