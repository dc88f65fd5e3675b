//! A path taken apart into hits.

use glam::DVec2;

use crate::analysis::deviation_degrees;
use crate::geometry::Curve;
use crate::light::Wavelength;
use crate::report::{applied, body_name, length_decimals};
use crate::scene::{Scene, SecondaryRays};
use crate::system::{Action, Interface, MediumId, OpticalSystem};
use crate::trace::{Hit, Segment, SegmentId, TracedRay, Via};

/// A branch with all its ancestors, hit by hit.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Explanation {
    /// Title of the scene; may be empty.
    pub title: String,
    /// The source, by its place in the scene.
    pub source: usize,
    /// The source's name, if it has one.
    pub source_name: Option<String>,
    /// The ray's name: `SOURCE.RAY`, and `@NM` where the source has several lines.
    pub ray: String,
    /// The branch's address.
    pub address: String,
    /// Vacuum wavelength.
    pub wavelength: Wavelength,
    /// Power that the ray starts with.
    pub power: f64,
    /// How faces between two media share the light.
    pub secondary_rays: SecondaryRays,
    /// The source's own segment: where the ray starts, and along which direction V0.
    pub start: Segment,
    /// Every hit from the source to the branch's own.
    pub steps: Vec<Step>,
    /// The branch itself.
    pub end: Segment,
    /// Addresses of what begins where the branch ends.
    pub children: Vec<String>,
    /// Decimals to which lengths are rounded.
    pub length_decimals: usize,
}

/// A hit of the path, in the letters of the [module](super).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Step {
    /// The segment that arrives.
    pub segment: Segment,
    /// What it met.
    pub hit: Hit,
    /// Point of incidence P, scene coordinates.
    pub at: DVec2,
    /// Name of the body, or `#k` for the k-th from 0.
    pub body: String,
    /// What the boundary does; a thin lens's center is in scene coordinates here.
    pub action: Action,
    /// Catalog names of the media before and behind, where they have one.
    pub media: [Option<&'static str>; 2],
    /// The segment by which the path goes on; `None` at its end.
    pub next: Option<Segment>,
}

/// Takes the way from a ray's source to the end of one of its branches apart; `None` if the ray has no such branch. `scene` and
/// `system` are those that the ray was traced in. A branch that ends without a hit adds no step.
#[must_use]
pub fn explain(scene: &Scene, system: &OpticalSystem, ray: &TracedRay, branch: SegmentId) -> Option<Explanation> {
    let path = path(ray, branch);
    let (start, end) = (**path.first()?, **path.last()?);
    let next = path.iter().skip(1).map(|next| Some(**next)).chain([None]);
    let steps = path.iter().zip(next).filter_map(|(segment, next)| step(system, ray, segment, next)).collect();
    let children = ray.segments.iter().filter(|segment| segment.parent == Some(branch));
    Some(Explanation {
        title: system.title().into(),
        source: ray.source,
        source_name: scene.sources.get(ray.source).and_then(|source| source.name.clone()),
        ray: ray.name(),
        address: ray.address(branch),
        wavelength: ray.wavelength,
        power: ray.power,
        secondary_rays: system.settings.secondary_rays,
        start,
        steps,
        end,
        children: children.map(|child| ray.address(child.id)).collect(),
        length_decimals: length_decimals(system, [start.from]),
    })
}

/// The segments from the source to a branch.
fn path(ray: &TracedRay, branch: SegmentId) -> Vec<&Segment> {
    let mut path: Vec<_> = ray.ancestors(branch).collect();
    path.reverse();
    path
}

fn step(system: &OpticalSystem, ray: &TracedRay, segment: &Segment, next: Option<Segment>) -> Option<Step> {
    let (at, hit) = (segment.to?, segment.hit?);
    let met = interface(system, ray.wavelength, at - system.origin(), &hit);
    let action = met.map_or(Action::Refract, |(interface, _)| match interface.action {
        Action::ThinLens { center, focal_length } => {
            Action::ThinLens { center: center + system.origin(), focal_length }
        }
        action => action,
    });
    let media = met.map_or([None; 2], |(_, media)| media.map(|medium| system.media[medium.place()].name()));
    Some(Step { segment: *segment, hit, at, body: body_name(system, hit.body), action, media, next })
}

/// The interface of a hit, with the media before and behind: of its body's, the nearest, those first that have the hit's
/// indices on their sides.
fn interface<'a>(
    system: &'a OpticalSystem,
    wavelength: Wavelength,
    at: DVec2,
    hit: &Hit,
) -> Option<(&'a Interface, [MediumId; 2])> {
    let is_index = |medium, n: f64| system.index(medium, wavelength).to_bits() == n.to_bits();
    let mut nearest = None;
    system.near_point(at, |place| {
        let interface = &system.interfaces[place];
        if interface.body != hit.body {
            return;
        }
        let [before, behind] = sides(interface, at, hit.normal);
        let fits = is_index(before, hit.n_i) && hit.n_t.is_none_or(|n_t| is_index(behind, n_t));
        let rank = (!fits, distance(&interface.curve, at));
        if nearest.is_none_or(|(least, _)| rank < least) {
            nearest = Some((rank, (interface, [before, behind])));
        }
    });
    nearest.map(|(_, found)| found)
}

/// The media on the side to which a normal points, and on the other.
fn sides(interface: &Interface, at: DVec2, normal: DVec2) -> [MediumId; 2] {
    let Interface { curve, left, right, .. } = interface;
    let is_left = curve.normal_at(curve.clamp(curve.project(at))).dot(normal) > 0.0;
    if is_left { [*left, *right] } else { [*right, *left] }
}

fn distance(curve: &Curve, p: DVec2) -> f64 {
    curve.clamp(curve.project(p)).distance(p)
}

impl Explanation {
    /// Address of the path's branch that has so many hits behind it; the path's own where it has no more.
    #[must_use]
    pub fn address_behind(&self, hits: usize) -> &str {
        // One letter a hit, and all of ASCII.
        self.address.get(..(self.ray.len() + 1).saturating_add(hits)).unwrap_or(&self.address)
    }

    /// The deviation δ of a direction from the ray's at its source, degrees counter-clockwise, above −180 to 180.
    #[must_use]
    pub fn deviation_degrees(&self, direction: DVec2) -> f64 {
        deviation_degrees(self.start.direction, direction)
    }
}

impl Step {
    /// Relative index η = n2/n1; `None` at a mirror, screen or absorber.
    #[must_use]
    pub fn eta(&self) -> Option<f64> {
        Some(self.hit.n_t? / self.hit.n_i)
    }

    /// Whether the light arrives at the critical angle itself, up to the rounding of V and N.
    #[must_use]
    pub fn is_critical(&self) -> bool {
        self.hit.total_internal_reflection && self.hit.cos_t.is_some()
    }

    /// The discriminant C2² = 1 + (C1² − 1)/η², not above 0 at total internal reflection, and 0 at the critical angle;
    /// `None` where nothing can be transmitted. Computed as (1 − S1/η)(1 + S1/η), which does not cancel.
    #[must_use]
    pub fn discriminant(&self) -> Option<f64> {
        if let Some(cos_t) = self.hit.cos_t {
            return Some(cos_t * cos_t);
        }
        let sin_t = self.hit.sin_i / self.eta()?;
        Some((1.0 - sin_t) * (1.0 + sin_t))
    }

    /// Whether the path goes on with the transmitted light; false at its end.
    #[must_use]
    pub fn next_is_transmitted(&self) -> bool {
        self.next.as_ref().is_some_and(|next| next.via == Via::Transmission)
    }

    /// The shares k_r, k_t and c_local of the arriving power that are reflected, transmitted, and stay; they add to 1.
    #[must_use]
    pub fn shares(&self) -> [f64; 3] {
        let Self { hit, segment: Segment { power, .. }, .. } = self;
        [applied(hit.reflectance, *power), applied(hit.transmittance, *power), hit.absorptance]
    }

    /// The shares w_s and w_p of the polarizations in the arriving power.
    #[must_use]
    pub fn polarization(&self) -> [f64; 2] {
        let power = self.segment.power;
        [power.s / power.total(), power.p / power.total()]
    }
}
