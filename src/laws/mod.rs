//! The laws of geometrical optics at a boundary, as pure functions in the plane.
//!
//! Letters are those of the vector derivation of Snell's law: V is the unit direction of the incoming ray, N the unit
//! normal against it (N·V < 0), T the transmitted and R the reflected direction, C1 = −N·V and S1 cosine and sine of the
//! angle of incidence, C2 and S2 those of the angle of transmission. n_i and n_t are the absolute indices of the incident
//! and the transmitting medium. Angles in and out are degrees from the normal.
//!
//! # Why refraction is computed along the tangent
//!
//! The vector form in textbooks is T = V/η + (C1/η − C2) N with η = n_t/n_i and C2 = √(1 + (C1² − 1)/η²). It is kept as
//! [`refract_by_notes`]. The tracer uses [`refract`], the same law by components: with the unit tangent τ,
//! V = S1 τ − C1 N becomes T = S2 τ − C2 N, where S2 = k/n_t, C2 = √((n_t − k)(n_t + k))/n_t and k = n_i S1.
//! - Toward normal incidence 1 − C1² cancels: the transmitted sine loses all its digits once the angle is below 1e-8.
//!   The cross product S1 keeps them.
//! - Toward the critical angle 1 + (C1² − 1)/η² cancels after two roundings; (n_t − k)(n_t + k) subtracts before any
//!   square is rounded.
//! - k is what a stack of parallel boundaries conserves, so that a slab gives back the direction that entered it.

mod critical;
mod fresnel;
mod incidence;
mod index;
mod reflection;
mod snell;
mod thin_lens;

pub use critical::{brewster_angle, critical_angle};
pub use fresnel::{Fresnel, fresnel};
pub use incidence::Incidence;
pub use index::{IndexError, SPEED_OF_LIGHT, check_index, index_from_speed, relative_index};
pub use reflection::reflect;
pub use snell::{Refraction, refract, refract_by_notes};
pub use thin_lens::thin_lens;

use glam::DVec2;

/// One Newton step for 1/√x at x ≈ 1: takes the rounding out of a length that is 1 but for a few ulp.
fn renormalized(d: DVec2) -> DVec2 {
    d * (1.5 - 0.5 * d.length_squared())
}
