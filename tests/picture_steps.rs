//! Figures hit by hit: what belongs to which generation of the light, and what stays in its place.

#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

mod support;

use std::collections::BTreeSet;

use roxmltree::{Document, Node};
use snellius::diagram::draw;
use snellius::drawing::Drawing;
use snellius::render;
use support::{run, run_text, scene_names};

/// In through one face at 40°, out through the other and back inside.
const SLAB: &str = r#"(
    bodies: [(name: "slab", shape: Rectangle(60, 20), medium: Index(1.5))],
    sources: [(light: Ray(from: (-40, 40), direction: Towards((-15, 10))))],
)"#;

fn figure(text: &str) -> Drawing {
    let run = run_text(text);
    draw(&run.scene, &run.system, &run.trace.tree)
}

fn of_class<'a, 'b>(document: &'a Document<'b>, class: &str) -> Vec<Node<'a, 'b>> {
    let has = |node: &Node<'_, '_>| node.attribute("class").is_some_and(|all| all.split(' ').any(|one| one == class));
    document.descendants().filter(has).collect()
}

/// The generation that a mark stands in.
fn generation(node: &Node<'_, '_>) -> Option<usize> {
    node.ancestors().find_map(|group| group.attribute("data-generation")).map(|number| number.parse().unwrap())
}

fn words(node: &Node<'_, '_>) -> String {
    node.descendants().filter_map(|node| node.text().filter(|_| node.is_text())).collect()
}

/// How many hits lie behind a branch with this address.
fn hits(address: &str) -> usize {
    address.rsplit(':').next().unwrap().len()
}

#[test]
fn every_branch_stands_in_the_group_of_its_generation() {
    for name in ["refraction/slab-reflections", "prisms/white-light", "mirrors/optical-square"] {
        let run = run(name);
        let text = render::svg(&draw(&run.scene, &run.system, &run.trace.tree));
        let document = Document::parse(&text).unwrap();
        let rays = of_class(&document, "ray");
        assert!(rays.len() > 5, "{name}");
        for ray in &rays {
            assert_eq!(generation(ray), Some(hits(ray.attribute("data-address").unwrap())), "{name}");
        }
        let layer = of_class(&document, "rays")[0];
        let order: Vec<_> =
            layer.children().filter(Node::is_element).map(|group| generation(&group).unwrap()).collect();
        assert!(order[0] == 0 && order.is_sorted_by(|a, b| a < b), "{name}: {order:?}");
    }
}

#[test]
fn marks_come_with_the_light_that_they_belong_to() {
    let text = render::svg(&figure(SLAB));
    let document = Document::parse(&text).unwrap();
    let at = |class: &str| of_class(&document, class).iter().map(|node| generation(node).unwrap()).collect::<Vec<_>>();
    // A hit of the source's ray, one of the light inside, and so on.
    assert_eq!(at("normal")[..2], [0, 1], "a normal comes with the light that arrives");
    assert_eq!(at("arrow")[..2], [0, 1]);
    let mut values: Vec<_> =
        of_class(&document, "angle-value").iter().map(|value| (generation(value).unwrap(), words(value))).collect();
    values.sort();
    let first: Vec<_> = values.iter().take(5).map(|(generation, value)| (*generation, &value[..3])).collect();
    assert_eq!(first, [(0, "θ1"), (1, "θ1"), (1, "θ2"), (2, "θ1"), (2, "θ2")], "{values:?}");
    for mark in of_class(&document, "angle") {
        let [own, arriving] = [generation(&mark).unwrap(), hits(mark.attribute("data-address").unwrap())];
        let leaves = words(&mark).contains("θ2");
        assert_eq!(own, arriving + usize::from(leaves || !words(&mark).contains('θ')), "{}", words(&mark));
    }
}

#[test]
fn the_extensions_of_a_turned_ray_come_when_it_is_turned() {
    let turned = "bodies: [(shape: Prism(apex_angle: 60, side: 40), medium: Index(1.5))],
        sources: [(light: Ray(from: (-50, -18), direction: Towards((-12, 0))))], diagram: (extensions: true)";
    let fan = "bodies: [(shape: Flat(from: (0, -18), to: (0, 18)), surface: Mirror)],
        sources: [(light: Fan(from: (-30, 4), direction: Angle(0), spread: 20, rays: 3))], diagram: (extensions: true)";
    for (scene, generations) in [(turned, vec![2, 2]), (fan, vec![1, 1, 1])] {
        let text = render::svg(&figure(&format!("({scene})")));
        let document = Document::parse(&text).unwrap();
        let found: Vec<_> = of_class(&document, "extension").iter().filter_map(generation).collect();
        assert_eq!(found, generations, "{scene}");
    }
}

#[test]
fn a_build_up_moves_nothing_and_ends_whole() {
    for name in ["refraction/slab-reflections", "prisms/penta", "total-reflection/half-disk-below", "lenses/achromat"] {
        let run = run(name);
        let whole = draw(&run.scene, &run.system, &run.trace.tree);
        let steps = whole.steps();
        let pictures: Vec<String> = steps.iter().map(|step| render::svg(&whole.up_to(*step))).collect();
        assert!(steps.len() > 1 && steps.first() == Some(&0), "{name}: {steps:?}");
        assert_eq!(pictures.last(), Some(&render::svg(&whole)), "{name}");
        // All but the ids, which are another figure's: every line of a picture is in the next.
        let lines = |picture: &str| -> Vec<String> {
            picture.lines().map(|line| line.split(" id=").next().unwrap().to_owned()).collect()
        };
        for pair in pictures.windows(2) {
            let mut next = lines(&pair[1]).into_iter();
            assert!(lines(&pair[0]).iter().all(|line| next.any(|other| other == *line)), "{name}");
            assert!(pair[0].len() < pair[1].len(), "{name}: a step adds something");
        }
    }
}

#[test]
fn no_two_groups_have_one_id() {
    let ids = |text: &str| -> Vec<String> {
        let document = Document::parse(text).unwrap();
        of_class(&document, "generation").iter().map(|group| group.attribute("id").unwrap().to_owned()).collect()
    };
    let whole = figure(SLAB);
    let panels = Drawing::side_by_side(&[whole.clone(), whole.clone()], 10);
    // Three figures on one page.
    let all: Vec<String> =
        [&whole, &whole.up_to(1), &panels].iter().flat_map(|figure| ids(&render::svg(figure))).collect();
    let different: BTreeSet<&String> = all.iter().collect();
    assert!(all.len() > 20 && different.len() == all.len(), "{all:?}");
    assert!(all.iter().any(|id| id.starts_with("panel-2-rays-1-")), "{all:?}");
}

#[test]
fn very_many_branches_have_no_generations() {
    let crowd = r"(
        bodies: [(shape: Disk(10), medium: Index(1.5))],
        sources: [(light: Beam(center: (-40, 0), direction: Angle(0), width: 19, rays: 900))],
    )";
    let crowd = figure(crowd);
    assert!(crowd.steps().is_empty());
    assert!(render::svg(&crowd).contains("class=\"normal\""), "though it has marks");
}

#[test]
fn panels_of_all_scenes_are_whole() {
    let drawings: Vec<Drawing> = scene_names()
        .iter()
        .take(6)
        .map(|name| {
            let run = run(name);
            draw(&run.scene, &run.system, &run.trace.tree)
        })
        .collect();
    let text = render::svg(&Drawing::side_by_side(&drawings, 16));
    let document = Document::parse(&text).unwrap();
    let count = |of: &str| document.descendants().filter(|node| node.has_tag_name(of)).count();
    let each = |of: &str| drawings.iter().map(|one| render::svg(one).matches(of).count()).sum::<usize>();
    assert_eq!((count("text"), of_class(&document, "ray").len()), (each("<text"), each("class=\"ray ")));
    let clips: BTreeSet<_> =
        document.descendants().filter(|node| node.has_tag_name("clipPath")).map(|clip| clip.attribute("id")).collect();
    assert_eq!(clips.len(), 6, "each panel clips at its own frame");
}
