//! The laws at a boundary, in their plainest forms.
//!
//! # Source
//! Hecht, "Optics", 4th ed., sections 4.3 (reflection), 4.4 (refraction), 4.6 (Fresnel's equations), 5.2 (thin lenses).

use f256::f256;

use crate::support::wide::{Wide2, wide};

/// V − 2 (V·N) N.
pub(crate) fn reflect(v: Wide2, n: Wide2) -> Wide2 {
    v - (wide(2.0) * v.dot(n)) * n
}

/// The part of V along the boundary.
fn along(v: Wide2, n: Wide2) -> Wide2 {
    v - v.dot(n) * n
}

/// The refracted direction; `None` past the critical angle and at it.
pub(crate) fn refract(v: Wide2, n: Wide2, n_i: f256, n_t: f256) -> Option<Wide2> {
    if n_i == n_t {
        return Some(v);
    }
    let along = (n_i / n_t) * along(v, n);
    let square = f256::ONE - along.dot(along);
    (square > f256::ZERO).then(|| along - square.sqrt() * n)
}

/// n_i sin θ_i − n_t: past the critical angle where positive.
pub(crate) fn beyond_critical(v: Wide2, n: Wide2, n_i: f256, n_t: f256) -> f256 {
    n_i * v.cross(n).abs() - n_t
}

/// Reflected shares of s and p.
pub(crate) fn reflectances(v: Wide2, n: Wide2, t: Wide2, n_i: f256, n_t: f256) -> [f256; 2] {
    let (cos_i, cos_t) = (-v.dot(n), -t.dot(n));
    let s = (n_i * cos_i - n_t * cos_t) / (n_i * cos_i + n_t * cos_t);
    let p = (n_t * cos_i - n_i * cos_t) / (n_t * cos_i + n_i * cos_t);
    [s * s, p * p]
}

/// The ideal thin lens: n_t tan θ_t = n_i tan θ_i − (n_i + n_t)/2 · h/f, h the distance of the hit from the center.
pub(crate) fn thin_lens(v: Wide2, n: Wide2, from_center: Wide2, focal_length: f256, n_i: f256, n_t: f256) -> Wide2 {
    let slope = (f256::ONE / -v.dot(n)) * along(v, n);
    let height = along(from_center, n);
    let slope = (f256::ONE / n_t) * (n_i * slope - (wide(0.5) * (n_i + n_t) / focal_length) * height);
    (slope - n).unit()
}
