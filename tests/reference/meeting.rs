//! What a hit sends on: the direction and the power of what is reflected and of what is transmitted.

use f256::f256;
use snellius::scene::{SecondaryRays, Surface};

use crate::bench::Wall;
use crate::condition::{Bundle, Nudge, State};
use crate::doubts::{self, Doubt};
use crate::laws::{beyond_critical, reflect, reflectances, refract, thin_lens};
use crate::support::wide::{Wide2, wide};

/// A direction, and the shares of s and p that go there.
type Way = (Wide2, [f256; 2]);

/// A ray at a wall that does not swallow it.
pub(crate) struct Meeting<'a> {
    /// The wall that gives the geometry.
    pub(crate) wall: &'a Wall,
    /// The wall that acts, if it does more than refract.
    pub(crate) surface: Option<&'a Wall>,
    /// Towards the ray.
    pub(crate) normal: Wide2,
    pub(crate) n_i: f256,
    pub(crate) n_t: f256,
    pub(crate) secondary_rays: SecondaryRays,
}

impl Meeting<'_> {
    fn surface(&self) -> Option<Surface> {
        self.surface.and_then(|wall| wall.surface)
    }

    fn normal(&self, state: &State, nudge: &Nudge) -> Wide2 {
        let normal = nudge.curve(self.wall).normal(state.p);
        if normal.dot(self.normal) < f256::ZERO { -normal } else { normal }
    }

    fn is_refracting(&self) -> bool {
        matches!(self.surface(), None | Some(Surface::BeamSplitter { .. })) && self.n_i != self.n_t
    }

    /// n_i sin θ_i − n_t.
    fn beyond(&self, state: &State, nudge: &Nudge) -> f256 {
        beyond_critical(state.d, self.normal(state, nudge), nudge.index(self.n_i), nudge.index(self.n_t))
    }

    /// Whether the light is totally reflected.
    pub(crate) fn is_total(&self, state: &State) -> bool {
        self.is_refracting() && self.beyond(state, &Nudge::NONE) >= f256::ZERO
    }

    /// Whether rounding decides that.
    pub(crate) fn doubt(&self, arrived: &Bundle) -> Option<Doubt> {
        if !self.is_refracting() || self.n_i < self.n_t {
            return None;
        }
        let scale = self.n_i * arrived.truth().d.dot(self.normal).abs();
        doubts::at_critical_angle(arrived, scale, |state, nudge| self.beyond(state, nudge))
    }

    /// What goes one way; `None` if nothing can.
    pub(crate) fn way(&self, state: &State, nudge: &Nudge, transmitted: bool) -> Option<State> {
        let (reflected, onward) = self.ways(state, nudge);
        let (d, shares) = if transmitted { onward? } else { reflected };
        let power = [0, 1].map(|k| nudge.number(state.power[k] * shares[k]));
        Some(State { d: nudge.direction(d), power, ..*state })
    }

    /// What is reflected, and what is transmitted.
    fn ways(&self, state: &State, nudge: &Nudge) -> (Way, Option<Way>) {
        let (v, n) = (state.d, self.normal(state, nudge));
        let (n_i, n_t) = (nudge.index(self.n_i), nudge.index(self.n_t));
        let (none, all) = ([f256::ZERO; 2], [f256::ONE; 2]);
        let back = reflect(v, n);
        let refracted = refract(v, n, n_i, n_t);
        let fixed =
            |reflect: f64, transmit: f64| ((back, [wide(reflect); 2]), refracted.map(|t| (t, [wide(transmit); 2])));
        match (self.surface(), refracted, self.secondary_rays) {
            (Some(Surface::Mirror), ..) => ((back, all), Some((v, none))),
            (Some(Surface::ThinLens { focal_length }), ..) => {
                let center = self.surface.map_or(Wide2::ZERO, |wall| nudge.curve(wall).middle());
                let onward = thin_lens(v, n, state.p - center, wide(focal_length), n_i, n_t);
                ((back, none), Some((onward, all)))
            }
            (Some(Surface::BeamSplitter { reflect, transmit }), None, _) => {
                ((back, [wide(reflect) + wide(transmit); 2]), None)
            }
            (Some(Surface::BeamSplitter { reflect, transmit }), ..) => fixed(reflect, transmit),
            (_, None, _) => ((back, all), None),
            (_, Some(t), SecondaryRays::Fresnel) => {
                let reflected = reflectances(v, n, t, n_i, n_t);
                ((back, reflected), Some((t, reflected.map(|r| f256::ONE - r))))
            }
            (_, Some(_), SecondaryRays::Fixed { kr, kt }) => fixed(kr, kt),
            (_, Some(t), SecondaryRays::TransmittedOnly) => ((back, none), Some((t, all))),
            (.., other) => panic!("the reference knows no {other:?}"),
        }
    }
}
