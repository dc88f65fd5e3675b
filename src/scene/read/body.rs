use glam::DVec2;

use super::fields::Fields;
use super::medium::medium;
use super::node::Node;
use super::reader::{Form, Reader};
use super::shape::shape;
use crate::scene::color::{COLOR_HELP, parse_color};
use crate::scene::{Body, Medium, Shape, Substance, Surface};

const FIELDS: [&str; 8] = ["name", "label", "color", "shape", "at", "rotate", "medium", "surface"];

const SURFACES: [Form; 5] = [
    ("Mirror", "Mirror"),
    ("Absorber", "Absorber"),
    ("Screen", "Screen"),
    ("BeamSplitter", "BeamSplitter(reflect: 0.5, transmit: 0.5)"),
    ("ThinLens", "ThinLens(focal_length: 50)"),
];

/// One entry of `bodies`.
pub(super) fn body(r: &mut Reader, node: &Node<'_>) -> Option<Body> {
    let f = r.fields(node, "a body", &FIELDS, "(shape: Disk(20), medium: Index(1.5))")?;
    let name = f.optional(r, "name", Reader::text);
    let label = f.optional(r, "label", Reader::text);
    let color = f.optional(r, "color", color);
    let at = f.or(r, "at", DVec2::ZERO, Reader::point);
    let rotate = f.or(r, "rotate", 0.0, Reader::number);
    let shape = f.required(r, "shape", shape);
    let substance = substance(r, &f, shape.as_ref());
    Some(Body { name, label, color, shape: shape?, at, rotate, substance: substance? })
}

/// A color by name or as `#rrggbb`.
pub(super) fn color(r: &mut Reader, node: &Node<'_>) -> Option<[u8; 3]> {
    let text = r.text(node)?;
    let color = parse_color(&text);
    if color.is_none() {
        r.refuse(node, format!("`{text}` is not a known color"), "unknown color", COLOR_HELP);
    }
    color
}

fn substance(r: &mut Reader, f: &Fields<'_>, shape: Option<&Shape>) -> Option<Substance> {
    // Another medium or surface stands in for a refused one, so that the rest of the body is still checked.
    let medium = f.optional(r, "medium", |r, node| Some(medium(r, node).unwrap_or(Medium::Index(1.0))));
    let surface = f.optional(r, "surface", |r, node| Some(surface(r, node).unwrap_or(Surface::Absorber)));
    match (medium, surface, shape) {
        (Some(_), Some(_), _) => {
            let help = "keep `medium` for a filled body or `surface` for a boundary; a coating is a body of its own, laid on the face";
            r.refuse(f.node(), "a body has either a `medium` or a `surface`, not both", "has both", help);
            None
        }
        (Some(medium), None, _) => Some(Substance::Medium(medium)),
        (None, Some(surface), _) => Some(Substance::Surface(surface)),
        (None, None, Some(Shape::LensGroup { .. })) => Some(Substance::Elements),
        (None, None, Some(Shape::Stop { .. })) => Some(Substance::Surface(Surface::Absorber)),
        (None, None, Some(Shape::Flat { .. } | Shape::Arc { .. })) => {
            let help = "add what the line does to light, such as `surface: Mirror`";
            r.refuse(f.node(), "a body with an open shape needs a `surface`", "`surface` is missing", help);
            None
        }
        (None, None, Some(_)) => {
            let help =
                "add what fills it, such as `medium: Index(1.5)`, or what its boundary does, such as `surface: Mirror`";
            r.refuse(f.node(), "a body needs a `medium` or a `surface`", "neither is given", help);
            None
        }
        (None, None, None) => None,
    }
}

fn surface(r: &mut Reader, node: &Node<'_>) -> Option<Surface> {
    let variant = r.variant(node, "a surface", &SURFACES)?;
    match variant.name {
        "Mirror" => variant.alone(r).map(|()| Surface::Mirror),
        "Absorber" => variant.alone(r).map(|()| Surface::Absorber),
        "Screen" => variant.alone(r).map(|()| Surface::Screen),
        "BeamSplitter" => {
            let f = variant.fields(r, &["reflect", "transmit"])?;
            let (reflect, transmit) =
                (f.required(r, "reflect", Reader::number), f.required(r, "transmit", Reader::number));
            Some(Surface::BeamSplitter { reflect: reflect?, transmit: transmit? })
        }
        _ => {
            let f = variant.fields(r, &["focal_length"])?;
            Some(Surface::ThinLens { focal_length: f.required(r, "focal_length", Reader::number)? })
        }
    }
}
