use f256::f256;

use crate::wide::Wide2;

/// The unit direction of the transmitted ray to 237 bits, for the *directions* of `v` and `n`, whatever their lengths;
/// `None` at total internal reflection.
pub(crate) fn refract(v: Wide2, n: Wide2, n_i: f256, n_t: f256) -> Option<Wide2> {
    let (v, n) = (v.unit(), n.unit());
    let sin_t = n_i * v.cross(n) / n_t;
    let cos_squared = (f256::ONE - sin_t) * (f256::ONE + sin_t);
    (cos_squared > f256::ZERO).then(|| sin_t * -n.perp() - cos_squared.sqrt() * n)
}
