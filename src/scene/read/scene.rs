use super::body::body;
use super::medium::medium;
use super::node::Node;
use super::reader::{Form, Reader};
use super::source::source;
use crate::scene::{
    DiagramSettings, Medium, Note, RayColor, Scene, SecondaryRays, Theme, TraceSettings, View, check::Numbering,
};

const FIELDS: [&str; 8] = ["title", "caption", "surroundings", "bodies", "sources", "trace", "diagram", "notes"];
const TRACE: [&str; 4] = ["secondary_rays", "max_depth", "min_power", "max_segments"];
const DIAGRAM: [&str; 13] = [
    "size",
    "view",
    "theme",
    "color",
    "faintest",
    "normals",
    "angles",
    "labels",
    "arrows",
    "legend",
    "extensions",
    "grid",
    "scale_bar",
];

const SECONDARY_RAYS: [Form; 3] =
    [("Fresnel", "Fresnel"), ("Fixed", "Fixed(kr: 0.1, kt: 0.9)"), ("TransmittedOnly", "TransmittedOnly")];
const VIEWS: [Form; 2] = [("Auto", "Auto"), ("Box", "Box((-50, -30), (50, 30))")];
const THEMES: [Form; 3] = [("Light", "Light"), ("Dark", "Dark"), ("Print", "Print")];
const RAY_COLORS: [Form; 4] = [("Auto", "Auto"), ("Wavelength", "Wavelength"), ("Power", "Power"), ("Via", "Via")];

/// The whole scene as far as it can be read, with the numbers that its entries have in the file.
pub(super) fn scene(r: &mut Reader, root: &Node<'_>) -> Option<(Scene, Numbering)> {
    r.places.insert("", root.span());
    let example = "(bodies: […], sources: […])";
    let f = r.fields(root, "a scene", &FIELDS, example)?;
    let title = f.or(r, "title", String::new(), Reader::text);
    let caption = f.or(r, "caption", String::new(), Reader::text);
    let surroundings = f.or(r, "surroundings", Medium::Index(1.0), medium);
    let (bodies, body_numbers) = f.or(r, "bodies", Default::default(), |r, node| kept(r, node, "bodies", body));
    let (sources, source_numbers) = f.or(r, "sources", Default::default(), |r, node| kept(r, node, "sources", source));
    let trace = f.or(r, "trace", TraceSettings::default(), trace);
    let diagram = f.or(r, "diagram", DiagramSettings::default(), diagram);
    let (notes, note_numbers) = f.or(r, "notes", Default::default(), |r, node| kept(r, node, "notes", note));
    let scene = Scene { title, caption, surroundings, bodies, sources, trace, diagram, notes };
    Some((scene, Numbering { bodies: body_numbers, sources: source_numbers, notes: note_numbers }))
}

/// The entries of a list that can be read, and their numbers in it.
fn kept<T>(
    r: &mut Reader,
    node: &Node<'_>,
    of: &str,
    read: impl Fn(&mut Reader, &Node<'_>) -> Option<T>,
) -> Option<(Vec<T>, Vec<usize>)> {
    let elements = r.list(node, of)?;
    let kept = elements.iter().enumerate().filter_map(|(k, element)| Some((read(r, element)?, k)));
    Some(kept.unzip())
}

fn note(r: &mut Reader, node: &Node<'_>) -> Option<Note> {
    let f = r.fields(node, "a note", &["at", "text"], "(at: (10, 40), text: \"eye\")")?;
    let (at, text) = (f.required(r, "at", Reader::point), f.required(r, "text", Reader::text));
    Some(Note { at: at?, text: text? })
}

fn trace(r: &mut Reader, node: &Node<'_>) -> Option<TraceSettings> {
    let d = TraceSettings::default();
    let f = r.fields(node, "`trace`", &TRACE, "(max_depth: 32, min_power: 1e-3)")?;
    Some(TraceSettings {
        secondary_rays: f.or(r, "secondary_rays", d.secondary_rays, secondary_rays),
        max_depth: f.or(r, "max_depth", d.max_depth, Reader::count32),
        min_power: f.or(r, "min_power", d.min_power, Reader::number),
        max_segments: f.or(r, "max_segments", d.max_segments, |r, node| r.count(node, u64::MAX)),
    })
}

fn secondary_rays(r: &mut Reader, node: &Node<'_>) -> Option<SecondaryRays> {
    let variant = r.variant(node, "a rule for secondary rays", &SECONDARY_RAYS)?;
    match variant.name {
        "Fresnel" => variant.alone(r).map(|()| SecondaryRays::Fresnel),
        "TransmittedOnly" => variant.alone(r).map(|()| SecondaryRays::TransmittedOnly),
        _ => {
            let f = variant.fields(r, &["kr", "kt"])?;
            let (kr, kt) = (f.required(r, "kr", Reader::number), f.required(r, "kt", Reader::number));
            Some(SecondaryRays::Fixed { kr: kr?, kt: kt? })
        }
    }
}

fn diagram(r: &mut Reader, node: &Node<'_>) -> Option<DiagramSettings> {
    let d = DiagramSettings::default();
    let f = r.fields(node, "`diagram`", &DIAGRAM, "(size: (960, 540), normals: true)")?;
    Some(DiagramSettings {
        size: f.or(r, "size", d.size, size),
        view: f.or(r, "view", d.view, view),
        theme: f.or(r, "theme", d.theme, theme),
        color: f.or(r, "color", d.color, ray_color),
        faintest: f.or(r, "faintest", d.faintest, Reader::number),
        normals: f.or(r, "normals", d.normals, Reader::switch),
        angles: f.or(r, "angles", d.angles, Reader::switch),
        labels: f.or(r, "labels", d.labels, Reader::switch),
        arrows: f.or(r, "arrows", d.arrows, Reader::switch),
        legend: f.or(r, "legend", d.legend, Reader::switch),
        extensions: f.or(r, "extensions", d.extensions, Reader::switch),
        grid: f.or(r, "grid", d.grid, Reader::switch),
        scale_bar: f.or(r, "scale_bar", d.scale_bar, Reader::switch),
    })
}

fn size(r: &mut Reader, node: &Node<'_>) -> Option<[u32; 2]> {
    let [width, height] = r.pair(node, "a size `(width, height)`", "write width and height in pixels: `(960, 540)`")?;
    let (width, height) = (r.count32(&width), r.count32(&height));
    Some([width?, height?])
}

fn view(r: &mut Reader, node: &Node<'_>) -> Option<View> {
    let variant = r.variant(node, "a view", &VIEWS)?;
    if variant.name == "Auto" {
        return variant.alone(r).map(|()| View::Auto);
    }
    let [first, second] = variant.values(r, ["corners[0]", "corners[1]"])?;
    let (first, second) = (r.point(&first), r.point(&second));
    Some(View::Box(first?, second?))
}

fn theme(r: &mut Reader, node: &Node<'_>) -> Option<Theme> {
    let variant = r.variant(node, "a theme", &THEMES)?;
    variant.alone(r)?;
    Some(match variant.name {
        "Dark" => Theme::Dark,
        "Print" => Theme::Print,
        _ => Theme::Light,
    })
}

fn ray_color(r: &mut Reader, node: &Node<'_>) -> Option<RayColor> {
    let variant = r.variant(node, "a color rule", &RAY_COLORS)?;
    variant.alone(r)?;
    Some(match variant.name {
        "Wavelength" => RayColor::Wavelength,
        "Power" => RayColor::Power,
        "Via" => RayColor::Via,
        _ => RayColor::Auto,
    })
}
