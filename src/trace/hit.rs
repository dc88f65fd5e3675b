//! What happens where a ray meets an interface: the hit as it is recorded, and the secondary rays that it spawns.

use glam::DVec2;

use crate::laws::{Incidence, Refraction, Shares, fresnel, reflect_at, refract_at, thin_lens};
use crate::scene::SecondaryRays;
use crate::system::{Action, Interface};
use crate::trace::{Hit, Via};

/// A ray's arrival at an interface.
pub(crate) struct Arrival<'a> {
    pub(crate) interface: &'a Interface,
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

/// A secondary ray: how it came about, and its unit direction.
pub(crate) type Secondary = (Via, DVec2);

/// What comes of an arrival.
pub(crate) struct Outcome {
    pub(crate) hit: Hit,
    pub(crate) transmitted: Option<Secondary>,
    pub(crate) reflected: Option<Secondary>,
}

impl Arrival<'_> {
    #[inline]
    pub(crate) fn outcome(&self, secondary_rays: SecondaryRays) -> Outcome {
        match self.interface.action {
            Action::Refract => self.refract(|refracted| shares(secondary_rays, refracted)),
            Action::Split { reflect, transmit } => self.refract(|refracted| match refracted {
                Some(_) => Shares::fixed(reflect, transmit),
                None => Shares::fixed(reflect + transmit, 0.0),
            }),
            Action::Mirror => self.mirror(),
            Action::Absorb => self.take(None),
            Action::Detect { along, sense, perimeter } => self.take(Some(self.position(along, sense, perimeter))),
            Action::ThinLens { center, focal_length } => self.thin_lens(center, focal_length),
        }
    }

    /// A boundary that refracts: `share` gives the reflected and the transmitted fraction, for the refracted light or
    /// past the critical angle.
    #[inline]
    fn refract(&self, share: impl Fn(Option<&Refracted>) -> Shares) -> Outcome {
        let hit = |shares| Hit { n_t: Some(self.n_t), ..self.hit(shares) };
        let reflected = reflect_at(&self.incidence, self.normal);
        let (direction, refracted) = match refract_at(&self.incidence, self.direction, self.normal, self.n_i, self.n_t)
        {
            Refraction::Refracted { direction, cos_i, sin_i, cos_t, sin_t } => {
                (direction, Refracted { n_i: self.n_i, n_t: self.n_t, cos_i, sin_i, cos_t, sin_t })
            }
            // Total internal reflection: nothing is transmitted. At the critical angle itself T runs along the boundary.
            Refraction::TotalInternalReflection { sin_i, critical, .. } => {
                let (cos_t, sin_t) = (critical.then_some(0.0), critical.then_some(sin_i.signum()));
                let hit = Hit { cos_t, sin_t, total_internal_reflection: true, ..hit(share(None)) };
                return Outcome { hit, transmitted: None, reflected: Some((Via::TotalInternalReflection, reflected)) };
            }
        };
        let (cos_t, sin_t) = (Some(refracted.cos_t), Some(refracted.sin_t));
        Outcome {
            hit: Hit { cos_t, sin_t, ..hit(share(Some(&refracted))) },
            transmitted: Some((Via::Transmission, direction)),
            reflected: Some((Via::Reflection, reflected)),
        }
    }

    fn mirror(&self) -> Outcome {
        let reflected = Some((Via::Reflection, reflect_at(&self.incidence, self.normal)));
        Outcome { hit: self.hit(Shares::total_reflection()), transmitted: None, reflected }
    }

    /// An absorber, or a screen with the place where the light lands.
    fn take(&self, position: Option<f64>) -> Outcome {
        Outcome { hit: Hit { position, ..self.hit(Shares::absorbed()) }, transmitted: None, reflected: None }
    }

    /// Where on a screen the light lands. A closed screen ends where it begins: its first point is at 0.
    fn position(&self, along: f64, sense: f64, perimeter: Option<f64>) -> f64 {
        let position = along + sense * self.interface.curve.length_to(self.at);
        if perimeter.is_some_and(|perimeter| position >= perimeter - self.near) { 0.0 } else { position }
    }

    fn thin_lens(&self, center: DVec2, focal_length: f64) -> Outcome {
        let tangent = self.incidence.tangent;
        let height = (self.at - center).dot(tangent);
        let direction = thin_lens(self.direction, self.normal, height, focal_length, self.n_i, self.n_t);
        let hit = Hit {
            n_t: Some(self.n_t),
            cos_t: Some(-self.normal.dot(direction)),
            sin_t: Some(tangent.dot(direction)),
            ..self.hit(Shares::transmitted_only())
        };
        Outcome { hit, transmitted: Some((Via::Transmission, direction)), reflected: None }
    }

    /// The hit with its shares, but without what only some interfaces have.
    #[inline]
    fn hit(&self, shares: Shares) -> Hit {
        let Incidence { cos: cos_i, sin: sin_i, .. } = self.incidence;
        Hit {
            body: self.interface.body,
            normal: self.normal,
            n_i: self.n_i,
            n_t: None,
            cos_i,
            sin_i,
            cos_t: None,
            sin_t: None,
            reflectance: shares.reflectance,
            transmittance: shares.transmittance,
            absorptance: shares.absorptance,
            total_internal_reflection: false,
            position: None,
        }
    }
}

/// Indices and angles of a refraction.
struct Refracted {
    n_i: f64,
    n_t: f64,
    cos_i: f64,
    sin_i: f64,
    cos_t: f64,
    sin_t: f64,
}

/// The shares on the face between two media.
#[inline]
fn shares(secondary_rays: SecondaryRays, refracted: Option<&Refracted>) -> Shares {
    match (secondary_rays, refracted) {
        // Past the critical angle everything is reflected.
        (_, None) => Shares::total_reflection(),
        (SecondaryRays::Fresnel, Some(r)) => Shares::fresnel(fresnel(r.n_i, r.n_t, r.cos_i, r.sin_i, r.cos_t, r.sin_t)),
        (SecondaryRays::Fixed { kr, kt }, Some(_)) => Shares::fixed(kr, kt),
        (SecondaryRays::TransmittedOnly, Some(_)) => Shares::transmitted_only(),
    }
}
