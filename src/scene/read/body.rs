use glam::DVec2;

use super::fields::Fields;
use super::node::Node;
use super::reader::{Read, Reader};
use super::variant::Form;
use crate::scene::color::{color_help, parse_color};
use crate::scene::problem::shortened;
use crate::scene::{Body, Medium, Shape, Substance, Surface};

const FIELDS: [&str; 8] = ["name", "label", "color", "shape", "at", "rotate", "medium", "surface"];

const SURFACES: [Form; 5] = [
    ("Mirror", "Mirror"),
    ("Absorber", "Absorber"),
    ("Screen", "Screen"),
    ("BeamSplitter", "BeamSplitter(reflect: 0.5, transmit: 0.5)"),
    ("ThinLens", "ThinLens(focal_length: 50)"),
];

impl Read for Body {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let f = r.fields(node, "a body", &FIELDS, "(shape: Disk(20), medium: Index(1.5))")?;
        let mut shape = f.required(r, "shape");
        let substance = substance(r, &f, &shape);
        if matches!(substance, Substance::Surface(_)) && r.is_stand_in(&node.field_path("shape")) {
            // The stand-in on which every surface may lie.
            shape = Shape::Flat { from: DVec2::NAN, to: DVec2::NAN };
        }
        Some(Self {
            name: f.optional(r, "name"),
            label: f.optional(r, "label"),
            color: f.optional(r, "color"),
            shape,
            at: f.or(r, "at", DVec2::ZERO),
            rotate: f.or(r, "rotate", 0.0),
            substance,
        })
    }

    fn stand_in() -> Self {
        let (shape, substance) = (Shape::stand_in(), Substance::Medium(Medium::stand_in()));
        Self { name: None, label: None, color: None, shape, at: DVec2::ZERO, rotate: 0.0, substance }
    }
}

/// A color by name or as `#rrggbb`.
impl Read for [u8; 3] {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let text = String::read(r, node)?;
        let color = parse_color(&text);
        if color.is_none() {
            r.refuse(node, format!("`{}` is not a known color", shortened(&text)), "unknown color", color_help(&text));
        }
        color
    }

    fn stand_in() -> Self {
        [0; 3]
    }
}

fn substance(r: &mut Reader, f: &Fields<'_>, shape: &Shape) -> Substance {
    let (medium, surface) = (f.optional(r, "medium"), f.optional(r, "surface"));
    match (medium, surface) {
        (None, None) => default_substance(r, f, shape),
        (Some(medium), None) => Substance::Medium(medium),
        (None, Some(surface)) => Substance::Surface(surface),
        (Some(medium), Some(_)) => {
            let help = "keep `medium` for a filled body or `surface` for a boundary; to coat a face, lay a body of its own on it";
            r.refuse(f.node(), "a body has either a `medium` or a `surface`, not both", "has both", help);
            Substance::Medium(medium)
        }
    }
}

/// What a body without `medium` and `surface` is made of.
fn default_substance(r: &mut Reader, f: &Fields<'_>, shape: &Shape) -> Substance {
    if f.is_meant("medium") {
        return Substance::Medium(r.stand_in(&f.node().field_path("medium")));
    }
    if f.is_meant("surface") {
        return Substance::Surface(r.stand_in(&f.node().field_path("surface")));
    }
    match shape {
        Shape::LensGroup { .. } => return Substance::Elements,
        Shape::Stop { .. } => {}
        Shape::Flat { .. } | Shape::Arc { .. } => {
            let help = "add what the line does to light, such as `surface: Mirror`";
            r.refuse(f.node(), "a body with an open shape needs a `surface`", "`surface` is missing", help);
        }
        _ => {
            let help =
                "add what fills it, such as `medium: Index(1.5)`, or what its boundary does, such as `surface: Mirror`";
            r.refuse(f.node(), "a body needs a `medium` or a `surface`", "neither is given", help);
        }
    }
    Substance::Surface(Surface::Absorber)
}

impl Read for Surface {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let variant = r.variant(node, "a surface", &SURFACES)?;
        let simple = match variant.name {
            "Mirror" => Self::Mirror,
            "Absorber" => Self::Absorber,
            "Screen" => Self::Screen,
            "BeamSplitter" => {
                let f = variant.fields(r, &["reflect", "transmit"])?;
                return Some(Self::BeamSplitter {
                    reflect: f.required(r, "reflect"),
                    transmit: f.required(r, "transmit"),
                });
            }
            _ => {
                let f = variant.fields(r, &["focal_length"])?;
                return Some(Self::ThinLens { focal_length: f.required(r, "focal_length") });
            }
        };
        variant.alone(r);
        Some(simple)
    }

    fn stand_in() -> Self {
        Self::Absorber
    }
}
