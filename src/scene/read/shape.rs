use glam::DVec2;

use super::medium::medium;
use super::node::Node;
use super::reader::{Form, Reader, Variant};
use crate::scene::{Element, PathStep, Shape};

const SHAPES: [Form; 13] = [
    ("Polygon", "Polygon([(0, 0), (40, 0), (0, 40)])"),
    ("Rectangle", "Rectangle(30, 20)"),
    ("RegularPolygon", "RegularPolygon(6, 20)"),
    ("Prism", "Prism(apex_angle: 60, side: 30)"),
    ("RightAnglePrism", "RightAnglePrism(40)"),
    ("Disk", "Disk(20)"),
    ("HalfDisk", "HalfDisk(20)"),
    ("Lens", "Lens(radii: (50, -50), thickness: 6, diameter: 30)"),
    (
        "Outline",
        "Outline(start: (0, 0), path: [LineTo((40, 0)), ArcTo(through: (50, 20), to: (40, 40)), LineTo((0, 40))])",
    ),
    (
        "LensGroup",
        "LensGroup(diameter: 25, surfaces: [(radius: 60, thickness: 6, medium: Catalog(\"N-BK7\")), (radius: -60)])",
    ),
    ("Flat", "Flat(from: (0, -20), to: (0, 20))"),
    ("Arc", "Arc(from: (0, -20), through: (5, 0), to: (0, 20))"),
    ("Stop", "Stop(opening: 10, height: 40)"),
];

const STEPS: [Form; 2] = [("LineTo", "LineTo((40, 0))"), ("ArcTo", "ArcTo(through: (50, 20), to: (40, 40))")];

/// A shape in one of its forms.
pub(super) fn shape(r: &mut Reader, node: &Node<'_>) -> Option<Shape> {
    let variant = r.variant(node, "a shape", &SHAPES)?;
    match variant.name {
        "Polygon" => Some(Shape::Polygon(variant.value(r, "points").and_then(|list| r.points(&list))?)),
        "Rectangle" => {
            let [width, height] = variant.values(r, ["width", "height"])?.map(|node| r.number(&node));
            Some(Shape::Rectangle { width: width?, height: height? })
        }
        "RegularPolygon" => {
            let [sides, radius] = variant.values(r, ["sides", "radius"])?;
            let (sides, radius) = (r.count32(&sides), r.number(&radius));
            Some(Shape::RegularPolygon { sides: sides?, radius: radius? })
        }
        "RightAnglePrism" => Some(Shape::RightAnglePrism { leg: length(r, &variant, "leg")? }),
        "Disk" => Some(Shape::Disk { radius: length(r, &variant, "radius")? }),
        "HalfDisk" => Some(Shape::HalfDisk { radius: length(r, &variant, "radius")? }),
        _ => named_shape(r, &variant),
    }
}

fn length(r: &mut Reader, variant: &Variant<'_>, name: &str) -> Option<f64> {
    let node = variant.value(r, name)?;
    r.number(&node)
}

fn named_shape(r: &mut Reader, variant: &Variant<'_>) -> Option<Shape> {
    match variant.name {
        "Prism" => {
            let f = variant.fields(r, &["apex_angle", "side"])?;
            let (apex_angle, side) =
                (f.required(r, "apex_angle", Reader::number), f.required(r, "side", Reader::number));
            Some(Shape::Prism { apex_angle: apex_angle?, side: side? })
        }
        "Stop" => {
            let f = variant.fields(r, &["opening", "height"])?;
            let (opening, height) = (f.required(r, "opening", Reader::number), f.required(r, "height", Reader::number));
            Some(Shape::Stop { opening: opening?, height: height? })
        }
        "Flat" => {
            let f = variant.fields(r, &["from", "to"])?;
            let (from, to) = (f.required(r, "from", Reader::point), f.required(r, "to", Reader::point));
            Some(Shape::Flat { from: from?, to: to? })
        }
        "Arc" => {
            let f = variant.fields(r, &["from", "through", "to"])?;
            let [from, through, to] = ["from", "through", "to"].map(|name| f.required(r, name, Reader::point));
            Some(Shape::Arc { from: from?, through: through?, to: to? })
        }
        "Lens" => lens(r, variant),
        "Outline" => outline(r, variant),
        _ => lens_group(r, variant),
    }
}

fn lens(r: &mut Reader, variant: &Variant<'_>) -> Option<Shape> {
    let f = variant.fields(r, &["radii", "thickness", "diameter", "facets"])?;
    let radii = f.required(r, "radii", radii);
    let thickness = f.required(r, "thickness", Reader::number);
    let diameter = f.required(r, "diameter", Reader::number);
    let facets = f.optional(r, "facets", Reader::count32);
    Some(Shape::Lens { radii: radii?, thickness: thickness?, diameter: diameter?, facets })
}

fn radii(r: &mut Reader, node: &Node<'_>) -> Option<[f64; 2]> {
    let help = "write the radii of the left and the right face: `(50, -50)`; `inf` is a plane face";
    let [left, right] = r.pair(node, "two radii `(r1, r2)`", help)?;
    let (left, right) = (r.number_or_inf(&left), r.number_or_inf(&right));
    Some([left?, right?])
}

fn outline(r: &mut Reader, variant: &Variant<'_>) -> Option<Shape> {
    let f = variant.fields(r, &["start", "path"])?;
    let start: Option<DVec2> = f.required(r, "start", Reader::point);
    let path = f.required(r, "path", |r, node| r.each(node, "steps", step));
    Some(Shape::Outline { start: start?, path: path? })
}

fn step(r: &mut Reader, node: &Node<'_>) -> Option<PathStep> {
    let variant = r.variant(node, "a step", &STEPS)?;
    if variant.name == "LineTo" {
        let to = variant.value(r, "to")?;
        return r.point(&to).map(PathStep::LineTo);
    }
    let f = variant.fields(r, &["through", "to"])?;
    let (through, to) = (f.required(r, "through", Reader::point), f.required(r, "to", Reader::point));
    Some(PathStep::ArcTo { through: through?, to: to? })
}

fn lens_group(r: &mut Reader, variant: &Variant<'_>) -> Option<Shape> {
    let f = variant.fields(r, &["diameter", "surfaces"])?;
    let diameter = f.required(r, "diameter", Reader::number);
    let surfaces = f.required(r, "surfaces", |r, node| r.each(node, "surfaces", element));
    Some(Shape::LensGroup { diameter: diameter?, surfaces: surfaces? })
}

fn element(r: &mut Reader, node: &Node<'_>) -> Option<Element> {
    let example = "(radius: 60, thickness: 6, medium: Catalog(\"N-BK7\"))";
    let f = r.fields(node, "a surface of a lens group", &["radius", "thickness", "medium"], example)?;
    let radius = f.required(r, "radius", Reader::number_or_inf);
    // A refused value must not look like one that was left out.
    let thickness = f.or(r, "thickness", None, |r, node| Some(r.number(node).or(Some(1.0))));
    let medium = f.or(r, "medium", None, |r, node| Some(medium(r, node).or(Some(crate::scene::Medium::Index(1.0)))));
    Some(Element { radius: radius?, thickness, medium })
}
