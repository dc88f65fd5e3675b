//! A scene written down in the scene format.

#![allow(unreachable_patterns, reason = "the format may grow")]

use std::fmt::{Debug, Display, Write};

use snellius::glam::DVec2;
use snellius::scene::{
    Body, DiagramSettings, Direction, Element, Light, Medium, PathStep, Scene, SecondaryRays, Shape, Source, Spectrum,
    Substance, Surface, TraceSettings, View,
};

/// The scene as text, every field of it; reading it gives the same scene.
pub fn ron(scene: &Scene) -> String {
    let Scene { title, caption, surroundings, bodies, sources, trace, diagram, notes, .. } = scene;
    let notes = list(notes, |note| format!("(at: {}, text: {:?})", point(note.at), note.text));
    format!(
        "(\n  title: {title:?},\n  caption: {caption:?},\n  surroundings: {},\n  bodies: {},\n  sources: {},\n  \
         trace: {},\n  diagram: {},\n  notes: {notes},\n)\n",
        medium(surroundings),
        list(bodies, body),
        list(sources, source),
        tracing(trace),
        drawing(diagram),
    )
}

fn unknown<T>(part: impl Debug) -> T {
    panic!("how is {part:?} written?")
}

fn list<T>(items: &[T], written: impl Fn(&T) -> String) -> String {
    let items: Vec<String> = items.iter().map(written).collect();
    format!("[{}]", items.join(", "))
}

fn point(p: DVec2) -> String {
    format!("({:?}, {:?})", p.x, p.y)
}

/// `, name: value` where there is a value.
fn optional(out: &mut String, name: &str, value: Option<impl Display>) {
    if let Some(value) = value {
        let _ = write!(out, ", {name}: {value}");
    }
}

fn color([r, g, b]: [u8; 3]) -> String {
    format!("\"#{r:02x}{g:02x}{b:02x}\"")
}

fn quoted(text: &Option<String>) -> Option<String> {
    text.as_ref().map(|text| format!("{text:?}"))
}

fn body(body: &Body) -> String {
    let mut out = format!("\n    (shape: {}, at: {}, rotate: {:?}", shape(&body.shape), point(body.at), body.rotate);
    match &body.substance {
        Substance::Medium(filling) => optional(&mut out, "medium", Some(medium(filling))),
        Substance::Surface(action) => optional(&mut out, "surface", Some(surface(*action))),
        Substance::Elements => {}
        _ => unknown(&body.substance),
    }
    optional(&mut out, "name", quoted(&body.name));
    optional(&mut out, "label", quoted(&body.label));
    optional(&mut out, "color", body.color.map(color));
    out + ")"
}

fn shape(shape: &Shape) -> String {
    match shape {
        Shape::Polygon(points) => format!("Polygon({})", list(points, |p| point(*p))),
        Shape::Rectangle { width, height } => format!("Rectangle({width:?}, {height:?})"),
        Shape::RegularPolygon { sides, radius } => format!("RegularPolygon({sides}, {radius:?})"),
        Shape::Prism { apex_angle, side } => format!("Prism(apex_angle: {apex_angle:?}, side: {side:?})"),
        Shape::RightAnglePrism { leg } => format!("RightAnglePrism({leg:?})"),
        Shape::Disk { radius } => format!("Disk({radius:?})"),
        Shape::HalfDisk { radius } => format!("HalfDisk({radius:?})"),
        Shape::Lens { radii: [left, right], thickness, diameter, facets } => {
            let mut out =
                format!("Lens(radii: ({left:?}, {right:?}), thickness: {thickness:?}, diameter: {diameter:?}");
            optional(&mut out, "facets", *facets);
            out + ")"
        }
        Shape::Outline { start, path } => format!("Outline(start: {}, path: {})", point(*start), list(path, step)),
        Shape::LensGroup { diameter, surfaces } => {
            format!("LensGroup(diameter: {diameter:?}, surfaces: {})", list(surfaces, element))
        }
        Shape::Flat { from, to } => format!("Flat(from: {}, to: {})", point(*from), point(*to)),
        Shape::Arc { from, through, to } => {
            format!("Arc(from: {}, through: {}, to: {})", point(*from), point(*through), point(*to))
        }
        Shape::Stop { opening, height } => format!("Stop(opening: {opening:?}, height: {height:?})"),
        _ => unknown(shape),
    }
}

fn step(step: &PathStep) -> String {
    match step {
        PathStep::LineTo(to) => format!("LineTo({})", point(*to)),
        PathStep::ArcTo { through, to } => format!("ArcTo(through: {}, to: {})", point(*through), point(*to)),
        _ => unknown(step),
    }
}

fn element(element: &Element) -> String {
    let mut out = format!("(radius: {:?}", element.radius);
    optional(&mut out, "thickness", element.thickness.map(|thickness| format!("{thickness:?}")));
    optional(&mut out, "medium", element.medium.as_ref().map(medium));
    out + ")"
}

fn surface(surface: Surface) -> String {
    match surface {
        Surface::ThinLens { focal_length } => format!("ThinLens(focal_length: {focal_length:?})"),
        Surface::BeamSplitter { reflect, transmit } => {
            format!("BeamSplitter(reflect: {reflect:?}, transmit: {transmit:?})")
        }
        Surface::Mirror | Surface::Absorber | Surface::Screen => format!("{surface:?}"),
        _ => unknown(surface),
    }
}

fn medium(medium: &Medium) -> String {
    match medium {
        Medium::Sellmeier { b, c } => format!("Sellmeier(b: {b:?}, c: {c:?})"),
        Medium::Index(_) | Medium::Speed(_) | Medium::Cauchy(_) | Medium::Catalog(_) => format!("{medium:?}"),
        _ => unknown(medium),
    }
}

fn source(source: &Source) -> String {
    let mut out = format!("\n    (light: {}, spectrum: {}", light(&source.light), spectrum(&source.spectrum));
    let _ = write!(out, ", power: {:?}, polarization: {:?}", source.power, source.polarization);
    optional(&mut out, "name", quoted(&source.name));
    optional(&mut out, "color", source.color.map(color));
    out + ")"
}

fn light(light: &Light) -> String {
    let direction = |direction: &Direction| match direction {
        Direction::Angle(degrees) => format!("Angle({degrees:?})"),
        Direction::Towards(p) => format!("Towards({})", point(*p)),
        _ => unknown(direction),
    };
    match light {
        Light::Ray { from, direction: d } => format!("Ray(from: {}, direction: {})", point(*from), direction(d)),
        Light::Beam { center, direction: d, width, rays } => {
            format!("Beam(center: {}, direction: {}, width: {width:?}, rays: {rays})", point(*center), direction(d))
        }
        Light::Fan { from, direction: d, spread, rays } => {
            format!("Fan(from: {}, direction: {}, spread: {spread:?}, rays: {rays})", point(*from), direction(d))
        }
        Light::Point { at, rays } => format!("Point(at: {}, rays: {rays})", point(*at)),
        Light::Object { from, to } => format!("Object(from: {}, to: {})", point(*from), point(*to)),
        _ => unknown(light),
    }
}

fn spectrum(spectrum: &Spectrum) -> String {
    match spectrum {
        Spectrum::White { samples } => format!("White(samples: {samples})"),
        Spectrum::Line(_) | Spectrum::Lines(_) => format!("{spectrum:?}"),
        _ => unknown(spectrum),
    }
}

fn tracing(trace: &TraceSettings) -> String {
    let TraceSettings { secondary_rays, max_depth, min_power, max_segments, .. } = trace;
    let rays = match secondary_rays {
        SecondaryRays::Fixed { kr, kt } => format!("Fixed(kr: {kr:?}, kt: {kt:?})"),
        SecondaryRays::Fresnel | SecondaryRays::TransmittedOnly => format!("{secondary_rays:?}"),
        _ => unknown(secondary_rays),
    };
    format!("(secondary_rays: {rays}, max_depth: {max_depth}, min_power: {min_power:?}, max_segments: {max_segments})")
}

fn drawing(diagram: &DiagramSettings) -> String {
    let d = diagram;
    let view = match d.view {
        View::Auto => "Auto".into(),
        View::Box(first, second) => format!("Box({}, {})", point(first), point(second)),
        other => unknown(other),
    };
    let [width, height] = d.size;
    let deviations = list(&d.deviations, |[from, to]| format!("({from:?}, {to:?})"));
    let mut out = format!("(size: ({width}, {height}), view: {view}, theme: {:?}, color: {:?}", d.theme, d.color);
    let _ = write!(out, ", faintest: {:?}, deviations: {deviations}", d.faintest);
    optional(&mut out, "wavefronts", d.wavefronts.map(|step| format!("{step:?}")));
    let switches = [
        ("normals", d.normals),
        ("angles", d.angles),
        ("labels", d.labels),
        ("arrows", d.arrows),
        ("legend", d.legend),
        ("extensions", d.extensions),
        ("protractor", d.protractor),
        ("optical_axis", d.optical_axis),
        ("focal_points", d.focal_points),
        ("principal_planes", d.principal_planes),
        ("grid", d.grid),
        ("scale_bar", d.scale_bar),
        ("irradiance", d.irradiance),
    ];
    switches.iter().for_each(|(name, is_on)| optional(&mut out, name, Some(is_on)));
    out + ")"
}
