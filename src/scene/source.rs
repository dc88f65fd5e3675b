use glam::DVec2;

/// A light source: where its rays start, their lines, power and polarization.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Source {
    /// Unique name.
    pub name: Option<String>,
    /// Color of its rays in the figure as red, green, blue; by the diagram's rule if `None`.
    pub color: Option<[u8; 3]>,
    /// Where rays start and where they head.
    pub light: Light,
    /// Spectral lines of every ray.
    pub spectrum: Spectrum,
    /// Total power, above 0, shared equally by rays and lines.
    pub power: f64,
    /// How the power is shared between s and p.
    pub polarization: Polarization,
}

impl Source {
    /// Unpolarized light of the helium d line and power 1, without name and color.
    #[must_use]
    pub fn new(light: Light) -> Self {
        let (spectrum, polarization) = (Spectrum::default(), Polarization::default());
        Self { name: None, color: None, light, spectrum, power: 1.0, polarization }
    }
}

/// Where the rays of a source start and where they head.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Light {
    /// One ray.
    Ray {
        /// Start.
        from: DVec2,
        /// Where it heads.
        direction: Direction,
    },
    /// Parallel rays, evenly over a width across their direction.
    Beam {
        /// Middle of the starting points.
        center: DVec2,
        /// Where they head.
        direction: Direction,
        /// Distance between the outermost rays.
        width: f64,
        /// Number of rays, at least 1.
        rays: u32,
    },
    /// Rays from one point, evenly over an angle.
    Fan {
        /// Start.
        from: DVec2,
        /// Middle direction.
        direction: Direction,
        /// Full angle in degrees, below 360.
        spread: f64,
        /// Number of rays, at least 1.
        rays: u32,
    },
    /// Rays from one point, all round, the first along +x.
    Point {
        /// Start.
        at: DVec2,
        /// Number of rays, at least 1.
        rays: u32,
    },
    /// An upright arrow that sends from its tip the principal rays through the element that it faces.
    Object {
        /// Foot.
        from: DVec2,
        /// Tip, which is not the foot.
        to: DVec2,
    },
}

/// Where a ray heads.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Direction {
    /// Degrees counter-clockwise from +x.
    Angle(f64),
    /// At a point, which is not the start itself.
    Towards(DVec2),
}

/// Spectral lines of a source, vacuum wavelengths in nanometers.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Spectrum {
    /// One line.
    Line(f64),
    /// Several lines of equal power.
    Lines(Vec<f64>),
    /// Lines of equal power, evenly from 420 to 700 nm, both ends included; one line is 560 nm.
    White {
        /// Number of lines, at least 1.
        samples: u32,
    },
}

/// How power is shared between the polarizations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Polarization {
    /// Half s, half p.
    #[default]
    Unpolarized,
    /// All s: electric field perpendicular to the drawing plane.
    S,
    /// All p: electric field in the drawing plane.
    P,
}

impl Default for Spectrum {
    /// The yellow helium d line.
    fn default() -> Self {
        Self::Line(587.5618)
    }
}

impl Spectrum {
    /// The lines in order, in nanometers.
    pub fn lines(&self) -> impl Iterator<Item = f64> {
        let (given, samples) = match self {
            Self::Line(nm) => (std::slice::from_ref(nm), 0),
            Self::Lines(lines) => (lines.as_slice(), 0),
            Self::White { samples: 1 } => ([560.0].as_slice(), 0),
            Self::White { samples } => ([].as_slice(), *samples),
        };
        let last = f64::from(samples.saturating_sub(1));
        given.iter().copied().chain((0..samples).map(move |k| 420.0 + 280.0 * (f64::from(k) / last)))
    }
}
