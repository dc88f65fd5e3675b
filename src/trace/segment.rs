use glam::DVec2;

use crate::laws::critical_angle;
use crate::light::{Power, Wavelength};
use crate::numerics::atan2_degrees;

/// All rays of a scene with their branches.
///
/// At each hit up to two segments begin, so that the segments of a ray are a tree. [`TracedRay::address`] names a branch by
/// the letters on the way to it.
///
#[cfg_attr(doc, doc = include_str!("../../docs/figures/ray-tree.svg"))]
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct RayTree {
    /// One entry per source ray and line, in the order of sources, rays and lines.
    pub rays: Vec<TracedRay>,
}

/// One source ray at one wavelength, with every branch that came of it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct TracedRay {
    /// The source, by its place in the scene.
    pub source: usize,
    /// The ray within its source, from 0.
    pub ray: usize,
    /// Vacuum wavelength.
    pub wavelength: Wavelength,
    /// Power at the start, both polarizations.
    pub power: f64,
    /// Whether the source has several lines, so that an address needs the wavelength.
    pub one_of_several_lines: bool,
    /// The branches, depth-first, transmitted before reflected; a [`SegmentId`] is a place in this list.
    pub segments: Vec<Segment>,
}

/// A segment's place within its ray's list, from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SegmentId(pub u32);

impl SegmentId {
    /// The place as an index.
    #[must_use]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// The straight way of light from one hit to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Segment {
    /// Place within the ray's list.
    pub id: SegmentId,
    /// The segment that spawned this one; `None` for the source's own.
    pub parent: Option<SegmentId>,
    /// How it came about.
    pub via: Via,
    /// Where it starts, scene units.
    pub from: DVec2,
    /// Where it ends; `None` if it escaped or was not followed.
    pub to: Option<DVec2>,
    /// Unit direction.
    pub direction: DVec2,
    /// Refractive index of what it runs in, at the ray's wavelength.
    pub medium_index: f64,
    /// Power it carries.
    pub power: Power,
    /// Σ n·length from the source to this segment's end (to its start where `to` is `None`), scene units.
    pub optical_path: f64,
    /// How it ended.
    pub ending: Ending,
    /// What it met; `None` if nothing.
    pub hit: Option<Hit>,
}

/// How a segment came about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Via {
    /// It starts at the source.
    Source,
    /// Reflected.
    Reflection,
    /// Transmitted.
    Transmission,
    /// Totally reflected.
    TotalInternalReflection,
}

/// How a segment ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Ending {
    /// At a hit that spawned secondary rays.
    Interface,
    /// At a hit that spawned nothing.
    Absorbed,
    /// On a screen.
    Detected,
    /// It left the scene.
    Escaped,
    /// Not followed: below `min_power`.
    CutMinPower,
    /// Not followed: `max_depth` hits behind it.
    CutMaxDepth,
    /// Not followed: the scene's `max_segments` were spent.
    CutMaxSegments,
}

/// What happened where a segment met a boundary.
///
/// Its normal N points against the light, V, and its angles count from N. Past the critical angle θc there is no
/// transmitted light:
///
#[cfg_attr(doc, doc = include_str!("../../docs/figures/total-reflection.svg"))]
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Hit {
    /// The body, by its place in the scene.
    pub body: usize,
    /// Unit normal against the incoming ray: N·V < 0.
    pub normal: DVec2,
    /// Index of the incident medium.
    pub n_i: f64,
    /// Index of the transmitting medium; `None` at a mirror, screen or absorber.
    pub n_t: Option<f64>,
    /// Cosine C1 = −N·V of the angle of incidence, 0 to 1.
    pub cos_i: f64,
    /// Sine S1 of the angle of incidence, signed: positive where V turns counter-clockwise from −N.
    pub sin_i: f64,
    /// Cosine C2 of the angle of transmission; `None` at total internal reflection and where nothing can be transmitted.
    pub cos_t: Option<f64>,
    /// Sine S2 of the angle of transmission, signed alike; `None` as `cos_t`.
    pub sin_t: Option<f64>,
    /// Reflected fractions applied, by polarization.
    pub reflectance: Power,
    /// Transmitted fractions applied, by polarization.
    pub transmittance: Power,
    /// Fraction that stays at the hit, 0 to 1, alike for both polarizations.
    pub absorptance: f64,
    /// Whether the light was totally reflected.
    pub total_internal_reflection: bool,
    /// On a screen, the distance along it from its first point, scene units.
    pub position: Option<f64>,
}

impl Hit {
    /// The unit vector τ along the boundary: −N turned by +90°.
    #[must_use]
    pub fn tangent(&self) -> DVec2 {
        -self.normal.perp()
    }

    /// The reflected unit direction R = V + 2 C1 N, computed as S1 τ + C1 N.
    #[must_use]
    pub fn reflected(&self) -> DVec2 {
        self.sin_i * self.tangent() + self.cos_i * self.normal
    }

    /// The transmitted unit direction T, computed as S2 τ − C2 N. `None` at total internal reflection and where nothing can be
    /// transmitted.
    #[must_use]
    pub fn transmitted(&self) -> Option<DVec2> {
        let direction = self.sin_t? * self.tangent() - self.cos_t? * self.normal;
        (!self.total_internal_reflection).then_some(direction)
    }

    /// Angle of incidence in degrees from the normal, 0 to 90.
    #[must_use]
    pub fn theta_i_degrees(&self) -> f64 {
        atan2_degrees(self.sin_i.abs(), self.cos_i)
    }

    /// Angle of transmission in degrees from the normal, 0 to 90; `None` past the critical angle, 90 at it.
    #[must_use]
    pub fn theta_t_degrees(&self) -> Option<f64> {
        Some(atan2_degrees(self.sin_t?.abs(), self.cos_t?))
    }

    /// Critical angle in degrees, where n_i > n_t.
    #[must_use]
    pub fn critical_degrees(&self) -> Option<f64> {
        critical_angle(self.n_i, self.n_t?)
    }

    /// Share of this segment's power that is reflected, 0 to 1.
    #[must_use]
    pub fn reflected_share(&self, power: Power) -> f64 {
        share(self.reflectance, power)
    }

    /// Share of this segment's power that is transmitted, 0 to 1.
    #[must_use]
    pub fn transmitted_share(&self, power: Power) -> f64 {
        share(self.transmittance, power)
    }
}

/// The mean of two fractions, weighted by the power in each polarization.
fn share(fraction: Power, power: Power) -> f64 {
    fraction.times(power).total() / power.total()
}

impl TracedRay {
    /// The address of a branch: `SOURCE.RAY[@NM]:PATH`, a letter a hit: t transmitted, r reflected, i totally reflected.
    #[must_use]
    pub fn address(&self, id: SegmentId) -> String {
        let letters: Vec<char> = self.ancestors(id).filter_map(|segment| segment.via.letter()).collect();
        let path: String = letters.iter().rev().collect();
        format!("{}:{path}", self.name())
    }

    /// A branch and those before it, back to the source's. A parent that does not stand before its child, as in a tree edited
    /// to nonsense, is none.
    pub(crate) fn ancestors(&self, id: SegmentId) -> impl Iterator<Item = &Segment> {
        let mut next = Some(id);
        std::iter::from_fn(move || {
            let id = next?;
            let segment = self.segments.get(id.index())?;
            next = segment.parent.filter(|parent| *parent < id);
            Some(segment)
        })
    }

    /// The segments that begin where each one ends, by its place. One that does not stand at its id, or not behind its
    /// parent, as in a tree edited to nonsense, is left out.
    pub(crate) fn children(&self) -> Vec<Vec<&Segment>> {
        let mut children = vec![Vec::new(); self.segments.len()];
        for (place, segment) in self.segments.iter().enumerate().filter(|(place, segment)| segment.id.index() == *place)
        {
            if let Some(parent) = segment.parent.map(SegmentId::index).filter(|parent| *parent < place) {
                children[parent].push(segment);
            }
        }
        children
    }

    /// The first part of the address: `SOURCE.RAY`, and `@NM` where the source has several lines.
    #[must_use]
    pub fn name(&self) -> String {
        let Self { source, ray, .. } = self;
        if self.one_of_several_lines {
            format!("{source}.{ray}@{}", self.wavelength.nanometers())
        } else {
            format!("{source}.{ray}")
        }
    }
}

impl Via {
    /// The letter in a branch's address; `None` for the source's own segment.
    #[must_use]
    pub fn letter(self) -> Option<char> {
        match self {
            Self::Source => None,
            Self::Reflection => Some('r'),
            Self::Transmission => Some('t'),
            Self::TotalInternalReflection => Some('i'),
        }
    }

    /// The word in traces and drawings, such as `total_internal_reflection`.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Source => "source",
            Self::Reflection => "reflection",
            Self::Transmission => "transmission",
            Self::TotalInternalReflection => "total_internal_reflection",
        }
    }
}

impl Ending {
    /// The word in traces, such as `cut_min_power`.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Interface => "interface",
            Self::Absorbed => "absorbed",
            Self::Detected => "detected",
            Self::Escaped => "escaped",
            Self::CutMinPower => "cut_min_power",
            Self::CutMaxDepth => "cut_max_depth",
            Self::CutMaxSegments => "cut_max_segments",
        }
    }
}
