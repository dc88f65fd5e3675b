use glam::DVec2;

use super::fields::Fields;
use super::node::Node;
use super::plain::Within;
use super::reader::{Read, Reader};
use super::variant::Form;
use crate::scene::{Direction, Light, Limit, Polarization, Source, Spectrum};

const FIELDS: [&str; 6] = ["name", "light", "color", "spectrum", "power", "polarization"];

const LIGHTS: [Form; 5] = [
    ("Ray", "Ray(from: (-30, 10), direction: Angle(0))"),
    ("Beam", "Beam(center: (-30, 0), direction: Angle(0), width: 20, rays: 6)"),
    ("Fan", "Fan(from: (-30, 0), direction: Angle(0), spread: 30, rays: 8)"),
    ("Point", "Point(at: (-30, 0), rays: 24)"),
    ("Object", "Object(from: (-60, 0), to: (-60, 12))"),
];
const DIRECTIONS: [Form; 2] = [("Angle", "Angle(30)"), ("Towards", "Towards((0, 1))")];
const SPECTRA: [Form; 3] =
    [("Line", "Line(587.5618)"), ("Lines", "Lines([486.1327, 587.5618, 656.2725])"), ("White", "White(samples: 24)")];
const POLARIZATIONS: [Form; 3] = [("Unpolarized", "Unpolarized"), ("S", "S"), ("P", "P")];

impl Read for Source {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let f = r.fields(node, "a source", &FIELDS, "(light: Ray(from: (-30, 10), direction: Angle(0)))")?;
        Some(Self {
            name: f.optional(r, "name"),
            color: f.optional(r, "color"),
            light: f.required(r, "light"),
            spectrum: f.or(r, "spectrum", Spectrum::default()),
            power: f.or(r, "power", 1.0),
            polarization: f.or(r, "polarization", Polarization::default()),
        })
    }

    fn stand_in() -> Self {
        Self {
            name: None,
            color: None,
            light: Light::stand_in(),
            spectrum: Spectrum::default(),
            power: 1.0,
            polarization: Polarization::default(),
        }
    }
}

impl Read for Light {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let variant = r.variant(node, "a light", &LIGHTS)?;
        Some(match variant.name {
            "Ray" => {
                let f = variant.fields(r, &["from", "direction"])?;
                Self::Ray { from: f.required(r, "from"), direction: f.required(r, "direction") }
            }
            "Beam" => {
                let f = variant.fields(r, &["center", "direction", "width", "rays"])?;
                let (center, direction) = (f.required(r, "center"), f.required(r, "direction"));
                Self::Beam { center, direction, width: f.required(r, "width"), rays: rays(r, &f) }
            }
            "Fan" => {
                let f = variant.fields(r, &["from", "direction", "spread", "rays"])?;
                let (from, direction) = (f.required(r, "from"), f.required(r, "direction"));
                Self::Fan { from, direction, spread: f.required(r, "spread"), rays: rays(r, &f) }
            }
            "Object" => {
                let f = variant.fields(r, &["from", "to"])?;
                Self::Object { from: f.required(r, "from"), to: f.required(r, "to") }
            }
            _ => {
                let f = variant.fields(r, &["at", "rays"])?;
                Self::Point { at: f.required(r, "at"), rays: rays(r, &f) }
            }
        })
    }

    fn stand_in() -> Self {
        Self::Ray { from: DVec2::NAN, direction: Direction::stand_in() }
    }
}

fn rays(r: &mut Reader, f: &Fields<'_>) -> u32 {
    f.required::<Within<{ Limit::Rays as usize }>>(r, "rays").0
}

impl Read for Direction {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let variant = r.variant(node, "a direction", &DIRECTIONS)?;
        if variant.name == "Angle" {
            return Some(Self::Angle(variant.value(r, "degrees")?));
        }
        Some(Self::Towards(variant.value(r, "point")?))
    }

    fn stand_in() -> Self {
        Self::Angle(f64::NAN)
    }
}

impl Read for Spectrum {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let variant = r.variant(node, "a spectrum", &SPECTRA)?;
        Some(match variant.name {
            "Line" => Self::Line(variant.value(r, "nm")?),
            "Lines" => Self::Lines(variant.value(r, "nm")?),
            _ => {
                let Within::<{ Limit::Lines as usize }>(samples) =
                    variant.fields(r, &["samples"])?.required(r, "samples");
                Self::White { samples }
            }
        })
    }

    fn stand_in() -> Self {
        Self::default()
    }
}

impl Read for Polarization {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let variant = r.variant(node, "a polarization", &POLARIZATIONS)?;
        variant.alone(r);
        Some(match variant.name {
            "S" => Self::S,
            "P" => Self::P,
            _ => Self::Unpolarized,
        })
    }

    fn stand_in() -> Self {
        Self::default()
    }
}
