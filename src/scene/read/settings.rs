use super::node::Node;
use super::plain::UpTo;
use super::reader::{Read, Reader};
use super::variant::Form;
use crate::scene::{DiagramSettings, Limit, MAX_PIXELS, RayColor, SecondaryRays, Theme, TraceSettings, View};

const TRACE: [&str; 4] = ["secondary_rays", "max_depth", "min_power", "max_segments"];
const DIAGRAM: [&str; 20] = [
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
    "deviations",
    "protractor",
    "wavefronts",
    "optical_axis",
    "focal_points",
    "principal_planes",
    "grid",
    "scale_bar",
    "irradiance",
];

const SECONDARY_RAYS: [Form; 3] =
    [("Fresnel", "Fresnel"), ("Fixed", "Fixed(kr: 0.1, kt: 0.9)"), ("TransmittedOnly", "TransmittedOnly")];
const VIEWS: [Form; 2] = [("Auto", "Auto"), ("Box", "Box((-50, -30), (50, 30))")];
const THEMES: [Form; 3] = [("Light", "Light"), ("Dark", "Dark"), ("Print", "Print")];
const RAY_COLORS: [Form; 4] = [("Auto", "Auto"), ("Wavelength", "Wavelength"), ("Power", "Power"), ("Via", "Via")];

impl Read for TraceSettings {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let d = Self::default();
        let f = r.fields(node, "`trace`", &TRACE, "(max_depth: 32, min_power: 1e-3)")?;
        Some(Self {
            secondary_rays: f.or(r, "secondary_rays", d.secondary_rays),
            max_depth: f.or(r, "max_depth", UpTo::<{ u32::MAX as u64 }>(d.max_depth)).0,
            min_power: f.or(r, "min_power", d.min_power),
            max_segments: f.or(r, "max_segments", d.max_segments),
        })
    }

    fn stand_in() -> Self {
        Self::default()
    }
}

impl Read for SecondaryRays {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let variant = r.variant(node, "a rule for secondary rays", &SECONDARY_RAYS)?;
        if variant.name == "Fixed" {
            let f = variant.fields(r, &["kr", "kt"])?;
            return Some(Self::Fixed { kr: f.required(r, "kr"), kt: f.required(r, "kt") });
        }
        variant.alone(r);
        Some(if variant.name == "Fresnel" { Self::Fresnel } else { Self::TransmittedOnly })
    }

    fn stand_in() -> Self {
        Self::Fresnel
    }
}

impl Read for DiagramSettings {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let d = Self::default();
        let f = r.fields(node, "`diagram`", &DIAGRAM, "(size: (960, 540), normals: true)")?;
        Some(Self {
            size: f.or(r, "size", d.size),
            view: f.or(r, "view", d.view),
            theme: f.or(r, "theme", d.theme),
            color: f.or(r, "color", d.color),
            faintest: f.or(r, "faintest", d.faintest),
            normals: f.or(r, "normals", d.normals),
            angles: f.or(r, "angles", d.angles),
            labels: f.or(r, "labels", d.labels),
            arrows: f.or(r, "arrows", d.arrows),
            legend: f.or(r, "legend", d.legend),
            extensions: f.or(r, "extensions", d.extensions),
            deviations: f.or(r, "deviations", d.deviations),
            protractor: f.or(r, "protractor", d.protractor),
            wavefronts: f.optional(r, "wavefronts"),
            optical_axis: f.or(r, "optical_axis", d.optical_axis),
            focal_points: f.or(r, "focal_points", d.focal_points),
            principal_planes: f.or(r, "principal_planes", d.principal_planes),
            grid: f.or(r, "grid", d.grid),
            scale_bar: f.or(r, "scale_bar", d.scale_bar),
            irradiance: f.or(r, "irradiance", d.irradiance),
        })
    }

    fn stand_in() -> Self {
        Self::default()
    }
}

/// Width and height in pixels.
impl Read for [u32; 2] {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let help = "write width and height in pixels: `(960, 540)`";
        let size = r.pair::<UpTo<{ MAX_PIXELS as u64 }>>(node, "a size `(width, height)`", help)?;
        Some(size.map(|pixels| pixels.0))
    }

    fn stand_in() -> Self {
        [0; 2]
    }
}

impl Read for Vec<[String; 2]> {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        r.each(node, "pairs of addresses", Limit::Deviations)
    }

    fn stand_in() -> Self {
        Self::new()
    }
}

/// Two branches by their addresses.
impl Read for [String; 2] {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let help = "write the addresses that `snellius trace` shows: `(\"0.0:\", \"0.0:tt\")`";
        r.pair::<String>(node, "two branches `(\"SOURCE.RAY:PATH\", \"SOURCE.RAY:PATH\")`", help)
    }

    fn stand_in() -> Self {
        Self::default()
    }
}

impl Read for View {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let variant = r.variant(node, "a view", &VIEWS)?;
        if variant.name == "Auto" {
            variant.alone(r);
            return Some(Self::Auto);
        }
        let [first, second] = variant.values(r, ["corners[0]", "corners[1]"])?;
        Some(Self::Box(r.read(&first), r.read(&second)))
    }

    fn stand_in() -> Self {
        Self::Auto
    }
}

impl Read for Theme {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let variant = r.variant(node, "a theme", &THEMES)?;
        variant.alone(r);
        Some(match variant.name {
            "Dark" => Self::Dark,
            "Print" => Self::Print,
            _ => Self::Light,
        })
    }

    fn stand_in() -> Self {
        Self::Light
    }
}

impl Read for RayColor {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let variant = r.variant(node, "a color rule", &RAY_COLORS)?;
        variant.alone(r);
        Some(match variant.name {
            "Wavelength" => Self::Wavelength,
            "Power" => Self::Power,
            "Via" => Self::Via,
            _ => Self::Auto,
        })
    }

    fn stand_in() -> Self {
        Self::Auto
    }
}
