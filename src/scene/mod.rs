//! What a scene file says: bodies, sources, how to trace and what to draw, with every problem in it found and placed.

mod axis;
mod body;
mod check;
mod color;
mod diagram;
mod limits;
mod lines;
mod listing;
mod medium;
mod names;
mod places;
mod problem;
mod read;
mod source;
mod tracing;

use glam::DVec2;

pub use axis::{Imaging, OpticalAxis, facing};
pub use body::{Body, Element, PathStep, Shape, Substance, Surface};
pub use diagram::{DiagramSettings, RayColor, Theme, View};
pub use limits::{Limit, Limits, MAX_INDEX, MAX_LENGTH, MAX_PIXELS, MIN_LENGTH, MIN_PIXELS};
pub(crate) use lines::{LineSpan, Lines};
pub use listing::render_problems;
pub use medium::Medium;
pub(crate) use names::nearest;
pub use places::Places;
pub use problem::{Problem, Problems, Severity};
pub use read::{Loaded, load, load_within, text_of};
pub use source::{Direction, Light, Polarization, Source, Spectrum};
pub use tracing::{SecondaryRays, TraceSettings};

/// A whole scene, as its file describes it.
///
/// Lengths are millimeters, angles degrees counter-clockwise, x to the right and y up. A file and its figure:
///
/// ```ron
#[cfg_attr(doc, doc = include_str!("../../docs/figures/scene.ron"))]
/// ```
///
#[cfg_attr(doc, doc = include_str!("../../docs/figures/scene.svg"))]
///
/// The same from Rust: parts have a constructor for what they cannot be without, and fields for the rest. Any values may stand in
/// them; [`validate`](Self::validate) and [`compile`](crate::compile()) say what is wrong.
///
/// ```
/// use snellius::glam::DVec2;
/// use snellius::scene::{Body, Direction, Light, Medium, Shape, Source, Surface};
/// use snellius::{Scene, compile, trace};
///
/// let glass = Medium::Catalog("N-BK7".into());
/// let prism = Body::new(Shape::Prism { apex_angle: 60.0, side: 30.0 }, glass).named("prism");
/// let (low, high) = (DVec2::new(0.0, -40.0), DVec2::new(0.0, 40.0));
/// let wall = Body::new(Shape::Flat { from: low, to: high }, Surface::Screen).placed(DVec2::new(60.0, 0.0), 0.0);
/// let light = Light::Ray { from: DVec2::new(-30.0, -8.0), direction: Direction::Angle(20.0) };
///
/// let mut scene = Scene::new(vec![prism, wall], vec![Source::new(light)]);
/// scene.title = "Near the least deviation".into();
/// scene.trace.max_depth = 8;
///
/// let system = compile(&scene)?.system;
/// assert!(trace(&system).summary.balance.detected.value() > 0.8);
/// # Ok::<(), snellius::scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Scene {
    /// Heading of the figure; may be empty.
    pub title: String,
    /// Sentence under the title; may be empty.
    pub caption: String,
    /// What fills the plane outside every body.
    pub surroundings: Medium,
    /// Bodies; where two overlap, the later one fills the overlap.
    pub bodies: Vec<Body>,
    /// Light sources.
    pub sources: Vec<Source>,
    /// How far rays are followed.
    pub trace: TraceSettings,
    /// What the figure shows.
    pub diagram: DiagramSettings,
    /// Words on the figure.
    pub notes: Vec<Note>,
}

/// Words at a place of the figure.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Note {
    /// Where the words stand, in scene units.
    pub at: DVec2,
    /// The words.
    pub text: String,
}

impl Note {
    /// Words at a place.
    #[must_use]
    pub fn new(at: DVec2, text: impl Into<String>) -> Self {
        Self { at, text: text.into() }
    }
}

impl Scene {
    /// Bodies and sources in vacuum; the rest by default.
    #[must_use]
    pub fn new(bodies: Vec<Body>, sources: Vec<Source>) -> Self {
        Self { bodies, sources, ..Self::default() }
    }
}

impl Default for Scene {
    /// Vacuum without bodies or sources.
    fn default() -> Self {
        Self {
            title: String::new(),
            caption: String::new(),
            surroundings: Medium::Index(1.0),
            bodies: Vec::new(),
            sources: Vec::new(),
            trace: TraceSettings::default(),
            diagram: DiagramSettings::default(),
            notes: Vec::new(),
        }
    }
}
