use super::body::color;
use super::node::Node;
use super::reader::{Form, Reader, Variant};
use crate::scene::{Direction, Light, Polarization, Source, Spectrum};

const FIELDS: [&str; 6] = ["name", "light", "color", "spectrum", "power", "polarization"];

const LIGHTS: [Form; 4] = [
    ("Ray", "Ray(from: (-30, 10), direction: Angle(0))"),
    ("Beam", "Beam(center: (-30, 0), direction: Angle(0), width: 20, rays: 6)"),
    ("Fan", "Fan(from: (-30, 0), direction: Angle(0), spread: 30, rays: 8)"),
    ("Point", "Point(at: (-30, 0), rays: 24)"),
];
const DIRECTIONS: [Form; 2] = [("Angle", "Angle(30)"), ("Towards", "Towards((0, 1))")];
const SPECTRA: [Form; 3] =
    [("Line", "Line(587.5618)"), ("Lines", "Lines([486.1327, 587.5618, 656.2725])"), ("White", "White(samples: 24)")];
const POLARIZATIONS: [Form; 3] = [("Unpolarized", "Unpolarized"), ("S", "S"), ("P", "P")];

/// One entry of `sources`.
pub(super) fn source(r: &mut Reader, node: &Node<'_>) -> Option<Source> {
    let f = r.fields(node, "a source", &FIELDS, "(light: Ray(from: (-30, 10), direction: Angle(0)))")?;
    let name = f.optional(r, "name", Reader::text);
    let color = f.optional(r, "color", color);
    let light = f.required(r, "light", light);
    let spectrum = f.or(r, "spectrum", Spectrum::default(), spectrum);
    let power = f.or(r, "power", 1.0, Reader::number);
    let polarization = f.or(r, "polarization", Polarization::default(), polarization);
    Some(Source { name, color, light: light?, spectrum, power, polarization })
}

fn light(r: &mut Reader, node: &Node<'_>) -> Option<Light> {
    let variant = r.variant(node, "a light", &LIGHTS)?;
    match variant.name {
        "Ray" => {
            let f = variant.fields(r, &["from", "direction"])?;
            let (from, direction) = (f.required(r, "from", Reader::point), f.required(r, "direction", direction));
            Some(Light::Ray { from: from?, direction: direction? })
        }
        "Beam" => beam(r, &variant),
        "Fan" => fan(r, &variant),
        _ => {
            let f = variant.fields(r, &["at", "rays"])?;
            let (at, rays) = (f.required(r, "at", Reader::point), f.required(r, "rays", Reader::count32));
            Some(Light::Point { at: at?, rays: rays? })
        }
    }
}

fn beam(r: &mut Reader, variant: &Variant<'_>) -> Option<Light> {
    let f = variant.fields(r, &["center", "direction", "width", "rays"])?;
    let center = f.required(r, "center", Reader::point);
    let direction = f.required(r, "direction", direction);
    let width = f.required(r, "width", Reader::number);
    let rays = f.required(r, "rays", Reader::count32);
    Some(Light::Beam { center: center?, direction: direction?, width: width?, rays: rays? })
}

fn fan(r: &mut Reader, variant: &Variant<'_>) -> Option<Light> {
    let f = variant.fields(r, &["from", "direction", "spread", "rays"])?;
    let from = f.required(r, "from", Reader::point);
    let direction = f.required(r, "direction", direction);
    let spread = f.required(r, "spread", Reader::number);
    let rays = f.required(r, "rays", Reader::count32);
    Some(Light::Fan { from: from?, direction: direction?, spread: spread?, rays: rays? })
}

fn direction(r: &mut Reader, node: &Node<'_>) -> Option<Direction> {
    let variant = r.variant(node, "a direction", &DIRECTIONS)?;
    if variant.name == "Angle" {
        let degrees = variant.value(r, "degrees")?;
        return r.number(&degrees).map(Direction::Angle);
    }
    let point = variant.value(r, "point")?;
    r.point(&point).map(Direction::Towards)
}

fn spectrum(r: &mut Reader, node: &Node<'_>) -> Option<Spectrum> {
    let variant = r.variant(node, "a spectrum", &SPECTRA)?;
    match variant.name {
        "Line" => variant.value(r, "nm").and_then(|nm| r.number(&nm)).map(Spectrum::Line),
        "Lines" => variant.value(r, "nm").and_then(|list| r.numbers(&list)).map(Spectrum::Lines),
        _ => {
            let f = variant.fields(r, &["samples"])?;
            Some(Spectrum::White { samples: f.required(r, "samples", Reader::count32)? })
        }
    }
}

fn polarization(r: &mut Reader, node: &Node<'_>) -> Option<Polarization> {
    let variant = r.variant(node, "a polarization", &POLARIZATIONS)?;
    variant.alone(r)?;
    Some(match variant.name {
        "S" => Polarization::S,
        "P" => Polarization::P,
        _ => Polarization::Unpolarized,
    })
}
