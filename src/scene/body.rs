use glam::DVec2;

use crate::scene::Medium;

/// A shape in its place, and what it does to light.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Body {
    /// Unique name, by which results refer to the body.
    pub name: Option<String>,
    /// Words for the figure; the name stands for `None`, and `""` keeps it out of the figure.
    pub label: Option<String>,
    /// Fill color of the figure as red, green, blue; by the index if `None`.
    pub color: Option<[u8; 3]>,
    /// The outline, about the shape's own origin.
    pub shape: Shape,
    /// Where the shape's origin stands.
    pub at: DVec2,
    /// Degrees counter-clockwise about the shape's origin, before it is moved.
    pub rotate: f64,
    /// What the outline is filled with, or what its boundary does.
    pub substance: Substance,
}

impl Body {
    /// A body at the origin, without name and label, in the colors of the figure's theme.
    #[must_use]
    pub fn new(shape: Shape, substance: impl Into<Substance>) -> Self {
        let substance = substance.into();
        Self { name: None, label: None, color: None, shape, at: DVec2::ZERO, rotate: 0.0, substance }
    }

    /// The same, turned by `rotate` degrees about the shape's origin, which then stands `at` a place.
    #[must_use]
    pub fn placed(self, at: DVec2, rotate: f64) -> Self {
        Self { at, rotate, ..self }
    }

    /// The same with a name.
    #[must_use]
    pub fn named(self, name: impl Into<String>) -> Self {
        Self { name: Some(name.into()), ..self }
    }
}

/// What a body is made of.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Substance {
    /// A closed outline filled with a medium.
    Medium(Medium),
    /// A boundary that acts from both sides; a closed one is hollow.
    Surface(Surface),
    /// A [`Shape::LensGroup`], whose elements carry their own media.
    Elements,
}

impl From<Medium> for Substance {
    fn from(medium: Medium) -> Self {
        Self::Medium(medium)
    }
}

impl From<Surface> for Substance {
    fn from(surface: Surface) -> Self {
        Self::Surface(surface)
    }
}

/// What a boundary does to a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Surface {
    /// Reflects everything.
    Mirror,
    /// Takes everything.
    Absorber,
    /// Takes everything and records where it landed.
    Screen,
    /// Reflects and transmits fixed shares; the rest is absorbed.
    BeamSplitter {
        /// Reflected share, 0 to 1.
        reflect: f64,
        /// Transmitted share, 0 to 1 − `reflect`.
        transmit: f64,
    },
    /// The ideal thin lens, on a [`Shape::Flat`].
    ThinLens {
        /// Focal length in scene units, positive converging; not 0.
        focal_length: f64,
    },
}

impl Shape {
    /// How many edges and arcs the outlines have at most, without making them.
    pub(crate) fn curves(&self) -> u64 {
        match self {
            Self::Polygon(points) => points.len() as u64,
            Self::RegularPolygon { sides, .. } => u64::from(*sides),
            Self::Lens { facets, .. } => 2 * u64::from(facets.unwrap_or(1)) + 2,
            Self::Outline { path, .. } => path.len() as u64 + 1,
            Self::LensGroup { surfaces, .. } => 4 * (surfaces.len() as u64).saturating_sub(1),
            Self::Rectangle { .. } => 4,
            Self::Prism { .. } | Self::RightAnglePrism { .. } => 3,
            Self::Disk { .. } | Self::HalfDisk { .. } | Self::Stop { .. } => 2,
            Self::Flat { .. } | Self::Arc { .. } => 1,
        }
    }
}

/// An outline about its own origin, lengths in scene units.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Shape {
    /// Simple polygon by its vertices, in either orientation.
    Polygon(Vec<DVec2>),
    /// Rectangle centered on the origin.
    Rectangle {
        /// Extent in x, above 0.
        width: f64,
        /// Extent in y, above 0.
        height: f64,
    },
    /// Regular polygon with its first vertex at (0, `radius`).
    RegularPolygon {
        /// Number of sides, at least 3.
        sides: u32,
        /// Radius of the circle through the vertices.
        radius: f64,
    },
    /// Isosceles prism, apex up, its centroid at the origin.
    Prism {
        /// Angle at the apex in degrees, between 0 and 180.
        apex_angle: f64,
        /// Length of the two equal sides.
        side: f64,
    },
    /// Right-angle prism with its right angle at the origin and its legs along +x and +y.
    RightAnglePrism {
        /// Length of a leg.
        leg: f64,
    },
    /// Full disk about the origin.
    Disk {
        /// Radius.
        radius: f64,
    },
    /// Half disk with its flat face on x = 0, bulging to +x, the flat's center at the origin.
    HalfDisk {
        /// Radius.
        radius: f64,
    },
    /// Lens on the x axis, the origin midway between its vertices.
    Lens {
        /// Radii of curvature, left face first; positive when the center lies to the right, infinite for a plane.
        radii: [f64; 2],
        /// Distance from vertex to vertex.
        thickness: f64,
        /// Height of the lens; its rim is two straight edges at y = ± half of it.
        diameter: f64,
        /// Chords that replace each curved face, ends on the true face; `None` keeps the true arcs.
        facets: Option<u32>,
    },
    /// Closed outline of edges and arcs.
    Outline {
        /// First point.
        start: DVec2,
        /// Edges and arcs in order; a straight edge closes the outline if need be.
        path: Vec<PathStep>,
    },
    /// A lens prescription along the x axis, its first vertex at the origin.
    LensGroup {
        /// Height of every element.
        diameter: f64,
        /// Surfaces from left to right.
        surfaces: Vec<Element>,
    },
    /// Straight open line.
    Flat {
        /// First point.
        from: DVec2,
        /// Last point.
        to: DVec2,
    },
    /// Open circular arc.
    Arc {
        /// First point.
        from: DVec2,
        /// A point between the two.
        through: DVec2,
        /// Last point.
        to: DVec2,
    },
    /// Aperture stop on x = 0: two straight pieces that leave |y| < `opening`/2 free.
    Stop {
        /// Free height.
        opening: f64,
        /// Whole height, above `opening`.
        height: f64,
    },
}

/// One step of a [`Shape::Outline`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum PathStep {
    /// Straight to a point.
    LineTo(DVec2),
    /// Along a circular arc to a point.
    ArcTo {
        /// A point on the way.
        through: DVec2,
        /// Where the arc ends.
        to: DVec2,
    },
}

/// One surface of a [`Shape::LensGroup`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Element {
    /// Radius of curvature, positive when the center lies to the right, infinite for a plane.
    pub radius: f64,
    /// Distance along the axis to the next surface; `None` on the last.
    pub thickness: Option<f64>,
    /// Medium that follows the surface; `None` on the last.
    pub medium: Option<Medium>,
}

impl Element {
    /// A surface, how far the next one stands behind it, and what is between; `None` on the last.
    #[must_use]
    pub fn new(radius: f64, thickness: Option<f64>, medium: Option<Medium>) -> Self {
        Self { radius, thickness, medium }
    }
}
