//! What happens where a ray meets an interface: the secondary rays that it spawns, and the hit as it is recorded.

use glam::DVec2;

use crate::laws::{Incidence, Refraction, Shares, fresnel, reflect_at, refract_at, thin_lens};
use crate::numerics::excess_length;
use crate::scene::SecondaryRays;
use crate::system::{Action, Interface, MediumId};
use crate::trace::Hit;

/// A ray's arrival at an interface.
#[derive(Clone, Copy)]
pub(crate) struct Arrival<'a> {
    pub(crate) interface: &'a Interface,
    /// Its place in the system's list.
    pub(crate) place: usize,
    pub(crate) from_left: bool,
    /// The incident medium.
    pub(crate) medium: MediumId,
    /// The medium behind.
    pub(crate) behind: MediumId,
    /// Σ n·length from the source.
    pub(crate) optical_path: f64,
    /// Where it arrives, relative to the system's origin.
    pub(crate) at: DVec2,
    /// Unit direction V.
    pub(crate) direction: DVec2,
    /// Unit normal N on the ray's side.
    pub(crate) normal: DVec2,
    /// V taken apart along N.
    pub(crate) incidence: Incidence,
    /// Index of the incident medium.
    pub(crate) n_i: f64,
    /// Index of the medium behind.
    pub(crate) n_t: f64,
    /// Distances below this are rounding.
    pub(crate) near: f64,
}

/// What comes of an arrival.
pub(crate) struct Outcome {
    pub(crate) shares: Shares,
    pub(crate) transmitted: Option<Transmitted>,
    /// Unit direction of the reflected ray.
    pub(crate) reflected: Option<DVec2>,
    /// Of total internal reflection, whether at the critical angle.
    pub(crate) total: Option<bool>,
}

/// A transmitted ray.
pub(crate) struct Transmitted {
    pub(crate) direction: DVec2,
    /// Cosine C2 of the angle of transmission.
    pub(crate) cos: f64,
    /// Its sine S2, signed.
    pub(crate) sin: f64,
}

impl Arrival<'_> {
    /// What a face between two media makes of it.
    #[inline(always)]
    pub(crate) fn refract(&self) -> Refraction {
        let Interface { curve, excess, .. } = self.interface;
        let excess = if curve.is_straight() { *excess } else { excess_length(self.normal) };
        refract_at(&self.incidence, self.direction, (self.normal, excess), self.n_i, self.n_t)
    }

    /// The outcome on a face that lets the light through.
    #[inline(always)]
    pub(crate) fn refracted(&self, transmitted: Transmitted, shares: Shares) -> Outcome {
        Outcome { shares, transmitted: Some(transmitted), reflected: Some(self.reflect()), total: None }
    }

    /// The outcome past the critical angle, or at it.
    #[inline(always)]
    pub(crate) fn totally_reflected(&self, critical: bool, shares: Shares) -> Outcome {
        Outcome { shares, transmitted: None, reflected: Some(self.reflect()), total: Some(critical) }
    }

    /// The outcome at an interface that is more than the face between two media.
    #[inline(never)]
    pub(crate) fn at_surface(self) -> Outcome {
        let nothing = Outcome { shares: Shares::absorbed(), transmitted: None, reflected: None, total: None };
        match self.interface.action {
            Action::Refract | Action::Absorb | Action::Detect { .. } => nothing,
            Action::Split { reflect, transmit } => match self.refract() {
                Refraction::Refracted { direction, cos_t: cos, sin_t: sin, .. } => {
                    self.refracted(Transmitted { direction, cos, sin }, Shares::fixed(reflect, transmit))
                }
                Refraction::TotalInternalReflection { critical, .. } => {
                    self.totally_reflected(critical, Shares::fixed(reflect + transmit, 0.0))
                }
            },
            Action::Mirror => {
                Outcome { shares: Shares::total_reflection(), reflected: Some(self.reflect()), ..nothing }
            }
            Action::ThinLens { center, focal_length } => {
                let transmitted = Some(self.thin_lens(center, focal_length));
                Outcome { shares: Shares::transmitted_only(), transmitted, ..nothing }
            }
        }
    }

    /// The shares of refracted light on the face between two media.
    #[inline(always)]
    pub(crate) fn shares(&self, secondary_rays: SecondaryRays, transmitted: &Transmitted) -> Shares {
        let Incidence { cos: cos_i, sin: sin_i, .. } = self.incidence;
        match secondary_rays {
            SecondaryRays::Fresnel => {
                Shares::fresnel(fresnel(self.n_i, self.n_t, cos_i, sin_i, transmitted.cos, transmitted.sin))
            }
            SecondaryRays::Fixed { kr, kt } => Shares::fixed(kr, kt),
            SecondaryRays::TransmittedOnly => Shares::transmitted_only(),
        }
    }

    #[inline(always)]
    fn reflect(&self) -> DVec2 {
        reflect_at(&self.incidence, self.normal)
    }

    fn thin_lens(&self, center: DVec2, focal_length: f64) -> Transmitted {
        let tangent = self.incidence.tangent;
        let height = (self.at - center).dot(tangent);
        let direction = thin_lens(self.direction, self.normal, height, focal_length, self.n_i, self.n_t);
        Transmitted { direction, cos: -self.normal.dot(direction), sin: tangent.dot(direction) }
    }

    /// On a screen, where the light lands. A closed screen ends where it begins: its first point is at 0.
    pub(crate) fn position(&self) -> Option<f64> {
        let Action::Detect { along, sense, perimeter } = self.interface.action else { return None };
        let position = along + sense * self.interface.curve.length_to(self.at);
        let is_end = perimeter.is_some_and(|perimeter| position >= perimeter - self.near);
        Some(if is_end { 0.0 } else { position })
    }

    /// What is recorded of it.
    #[inline]
    pub(crate) fn hit(&self, outcome: &Outcome) -> Hit {
        let Incidence { cos: cos_i, sin: sin_i, .. } = self.incidence;
        let is_opaque = matches!(self.interface.action, Action::Mirror | Action::Absorb | Action::Detect { .. });
        let (cos_t, sin_t) = match (&outcome.transmitted, outcome.total) {
            (Some(transmitted), _) => (Some(transmitted.cos), Some(transmitted.sin)),
            // At the critical angle itself T runs along the boundary.
            (None, Some(true)) => (Some(0.0), Some(sin_i.signum())),
            (None, _) => (None, None),
        };
        Hit {
            body: self.interface.body,
            normal: self.normal,
            n_i: self.n_i,
            n_t: (!is_opaque).then_some(self.n_t),
            cos_i,
            sin_i,
            cos_t,
            sin_t,
            reflectance: outcome.shares.reflectance,
            transmittance: outcome.shares.transmittance,
            absorptance: outcome.shares.absorptance,
            total_internal_reflection: outcome.total.is_some(),
            position: self.position(),
        }
    }
}
