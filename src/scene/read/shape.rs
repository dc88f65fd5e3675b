use glam::DVec2;

use super::node::Node;
use super::plain::{MaybeInfinite, Within};
use super::reader::{Read, Reader};
use super::variant::{Form, Variant};
use crate::scene::{Element, Limit, PathStep, Shape};

const SHAPES: [Form; 13] = [
    ("Polygon", "Polygon([(0, 0), (40, 0), (0, 40)])"),
    ("Rectangle", "Rectangle(30, 20)"),
    ("RegularPolygon", "RegularPolygon(6, 20)"),
    ("Prism", "Prism(apex_angle: 60, side: 30)"),
    ("RightAnglePrism", "RightAnglePrism(40)"),
    ("Disk", "Disk(20)"),
    ("HalfDisk", "HalfDisk(20)"),
    ("Lens", "Lens(radii: (50, -50), thickness: 6, diameter: 30)"),
    ("Outline", "Outline(start: (0, 0), path: [LineTo((40, 0)), ArcTo(through: (50, 20), to: (40, 40))])"),
    ("LensGroup", "LensGroup(diameter: 25, surfaces: [(radius: 60, thickness: 6, medium: Index(1.5)), (radius: -60)])"),
    ("Flat", "Flat(from: (0, -20), to: (0, 20))"),
    ("Arc", "Arc(from: (0, -20), through: (5, 0), to: (0, 20))"),
    ("Stop", "Stop(opening: 10, height: 40)"),
];

const SIDES: usize = Limit::Sides as usize;

const STEPS: [Form; 2] = [("LineTo", "LineTo((40, 0))"), ("ArcTo", "ArcTo(through: (50, 20), to: (40, 40))")];

impl Read for Shape {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let variant = r.variant(node, "a shape", &SHAPES)?;
        match variant.name {
            "Polygon" => Some(Self::Polygon(variant.value(r, "points")?)),
            "Rectangle" => {
                let [width, height] = variant.values(r, ["width", "height"])?;
                Some(Self::Rectangle { width: r.read(&width), height: r.read(&height) })
            }
            "RegularPolygon" => {
                let [sides, radius] = variant.values(r, ["sides", "radius"])?;
                let Within::<SIDES>(sides) = r.read(&sides);
                Some(Self::RegularPolygon { sides, radius: r.read(&radius) })
            }
            "RightAnglePrism" => Some(Self::RightAnglePrism { leg: variant.value(r, "leg")? }),
            "Disk" => Some(Self::Disk { radius: variant.value(r, "radius")? }),
            "HalfDisk" => Some(Self::HalfDisk { radius: variant.value(r, "radius")? }),
            _ => named_shape(r, &variant),
        }
    }

    fn stand_in() -> Self {
        Self::Disk { radius: f64::NAN }
    }
}

fn named_shape(r: &mut Reader, variant: &Variant<'_>) -> Option<Shape> {
    Some(match variant.name {
        "Prism" => {
            let f = variant.fields(r, &["apex_angle", "side"])?;
            Shape::Prism { apex_angle: f.required(r, "apex_angle"), side: f.required(r, "side") }
        }
        "Stop" => {
            let f = variant.fields(r, &["opening", "height"])?;
            Shape::Stop { opening: f.required(r, "opening"), height: f.required(r, "height") }
        }
        "Flat" => {
            let f = variant.fields(r, &["from", "to"])?;
            Shape::Flat { from: f.required(r, "from"), to: f.required(r, "to") }
        }
        "Arc" => {
            let f = variant.fields(r, &["from", "through", "to"])?;
            let [from, through, to] = ["from", "through", "to"].map(|name| f.required(r, name));
            Shape::Arc { from, through, to }
        }
        "Lens" => lens(r, variant)?,
        "Outline" => {
            let f = variant.fields(r, &["start", "path"])?;
            Shape::Outline { start: f.required(r, "start"), path: f.required(r, "path") }
        }
        _ => {
            let f = variant.fields(r, &["diameter", "surfaces"])?;
            Shape::LensGroup { diameter: f.required(r, "diameter"), surfaces: f.required(r, "surfaces") }
        }
    })
}

fn lens(r: &mut Reader, variant: &Variant<'_>) -> Option<Shape> {
    let f = variant.fields(r, &["radii", "thickness", "diameter", "facets"])?;
    let radii: [MaybeInfinite; 2] = f.required(r, "radii");
    Some(Shape::Lens {
        radii: radii.map(|radius| radius.0),
        thickness: f.required(r, "thickness"),
        diameter: f.required(r, "diameter"),
        facets: f.optional::<Within<SIDES>>(r, "facets").map(|facets| facets.0),
    })
}

/// The radii of a lens's two faces.
impl Read for [MaybeInfinite; 2] {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let help = "write the radii of the left and the right face: `(50, -50)`; `inf` is a plane face";
        r.pair(node, "two radii `(r1, r2)`", help)
    }

    fn stand_in() -> Self {
        [MaybeInfinite::stand_in(); 2]
    }
}

impl Read for Vec<PathStep> {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        r.each(node, "steps", Limit::Points)
    }

    fn stand_in() -> Self {
        Self::new()
    }
}

impl Read for PathStep {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let variant = r.variant(node, "a step", &STEPS)?;
        if variant.name == "LineTo" {
            return Some(Self::LineTo(variant.value(r, "to")?));
        }
        let f = variant.fields(r, &["through", "to"])?;
        Some(Self::ArcTo { through: f.required(r, "through"), to: f.required(r, "to") })
    }

    fn stand_in() -> Self {
        Self::LineTo(DVec2::NAN)
    }
}

impl Read for Vec<Element> {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        r.each(node, "surfaces", Limit::Points)
    }

    fn stand_in() -> Self {
        Self::new()
    }
}

impl Read for Element {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let example = "(radius: 60, thickness: 6, medium: Catalog(\"N-BK7\"))";
        let f = r.fields(node, "a surface of a lens group", &["radius", "thickness", "medium"], example)?;
        let MaybeInfinite(radius) = f.required(r, "radius");
        Some(Self { radius, thickness: f.optional(r, "thickness"), medium: f.optional(r, "medium") })
    }

    fn stand_in() -> Self {
        Self { radius: f64::NAN, thickness: None, medium: None }
    }
}
