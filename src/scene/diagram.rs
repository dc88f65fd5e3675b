use glam::DVec2;

/// What the figure shows and how.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct DiagramSettings {
    /// Width and height in pixels, SVG user units.
    pub size: [u32; 2],
    /// What part of the plane is shown.
    pub view: View,
    /// Colors of ground and ink.
    pub theme: Theme,
    /// What a ray's color tells.
    pub color: RayColor,
    /// Branches below this share of the source ray are traced and counted, not drawn.
    pub faintest: f64,
    /// Dashed normals at the hits, but for perpendicular incidence, where the ray is its own normal.
    pub normals: bool,
    /// Angle marks at the hits.
    pub angles: bool,
    /// Labels of bodies.
    pub labels: bool,
    /// Arrowheads on rays.
    pub arrows: bool,
    /// Legend.
    pub legend: bool,
    /// Dashed extensions of rays: to where they seem to come from, and where they would have gone.
    pub extensions: bool,
    /// Pairs of branches by their addresses, `SOURCE.RAY[@NM]:PATH`, whose deviation δ is marked: the angle from the first
    /// one's direction to the second's.
    pub deviations: Vec<[String; 2]>,
    /// Circles of degrees about the hits whose angles are marked.
    pub protractor: bool,
    /// Optical path between the marks of equal optical path, mm; no marks if `None`.
    pub wavefronts: Option<f64>,
    /// Optical axes of lenses and curved mirrors.
    pub optical_axis: bool,
    /// Focal points of lenses and curved mirrors, and centers of curvature of the mirrors.
    pub focal_points: bool,
    /// Principal planes of lenses.
    pub principal_planes: bool,
    /// Coordinate grid.
    pub grid: bool,
    /// Scale bar.
    pub scale_bar: bool,
    /// Beside the scene, how the light on each screen is spread along it.
    pub irradiance: bool,
}

impl Default for DiagramSettings {
    fn default() -> Self {
        Self {
            size: [960, 540],
            view: View::Auto,
            theme: Theme::Light,
            color: RayColor::Auto,
            faintest: 0.01,
            normals: true,
            angles: true,
            labels: true,
            arrows: true,
            legend: true,
            extensions: false,
            deviations: Vec::new(),
            protractor: false,
            wavefronts: None,
            optical_axis: true,
            focal_points: false,
            principal_planes: false,
            grid: false,
            scale_bar: false,
            irradiance: true,
        }
    }
}

/// What part of the plane a figure shows.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum View {
    /// Bodies, sources and the interesting part of the rays, with a margin.
    Auto,
    /// The box between two opposite corners, in scene units.
    Box(DVec2, DVec2),
}

/// Colors of ground and ink.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Theme {
    /// White ground.
    Light,
    /// Dark ground.
    Dark,
    /// White ground, black ink, no color needed.
    Print,
}

/// What a ray's color tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RayColor {
    /// The theme's ray color if all light is one line, else as [`RayColor::Wavelength`].
    Auto,
    /// The wavelength. Lines of one ray that coincide are drawn as one: all of the ray's lines in white on
    /// [`Theme::Dark`] and in ink on the others, only some of them in the color that they add up to.
    Wavelength,
    /// The power.
    Power,
    /// How the segment came about.
    Via,
}
