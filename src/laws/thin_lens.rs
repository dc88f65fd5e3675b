//! The ideal thin lens.

use glam::DVec2;

use super::{Incidence, relative_index};

/// The unit direction in which an ideal thin lens sends the unit direction `v`.
///
/// `n` is the lens's unit normal against the ray (its optical axis is −N), `height` the signed distance of the hit from
/// the lens's center along τ = −N turned counter-clockwise by 90° ([`Incidence::tangent`]), `focal_length` in the unit of
/// `height`, positive converging, not 0. The slopes obey n_t tan θ_t = n_i tan θ_i − n h/f with n the mean of the two
/// indices: in one medium that is tan θ_t = tan θ_i − h/f, and between two media light that turns back returns. The
/// center ray between equal indices returns `v` itself; so does the limit f = ∞. A ray along the lens (C1 → 0) has no
/// slope and goes on along it. Where h/f overflows, the light leaves along the lens. NaN gives NaN.
///
/// # Source
/// Hecht, "Optics", 4th ed., section 5.2.3 (1/f = 1/s_o + 1/s_i) and, for the ray-transfer form, section 6.2.1, here with
/// slopes in place of small angles, so that every object point has a sharp image.
#[must_use]
pub fn thin_lens(v: DVec2, n: DVec2, height: f64, focal_length: f64, n_i: f64, n_t: f64) -> DVec2 {
    let bend = height / focal_length;
    #[expect(clippy::float_cmp, reason = "only the very same index leaves the center ray alone")]
    if bend == 0.0 && n_i == n_t {
        return v;
    }
    let Incidence { cos, sin, tangent } = Incidence::new(v, n);
    // Both components times C1, so that nothing is divided by it.
    let eta = relative_index(n_i, n_t);
    let along = sin / eta - cos * bend * (0.5 * (1.0 + 1.0 / eta));
    match (along * tangent - cos * n).try_normalize() {
        Some(direction) => direction,
        None if cos == 0.0 => v,
        // Too steep for a number.
        None if along.abs() > 1.0 => along.signum() * tangent,
        None => DVec2::NAN,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const N: DVec2 = DVec2::NEG_X;

    #[test]
    fn parallel_rays_meet_in_the_focus() {
        for height in [-30.0, -1.0, 5.0, 80.0] {
            let t = thin_lens(DVec2::X, N, height, 40.0, 1.0, 1.0);
            assert!((height + 40.0 * t.y / t.x).abs() < 1e-13, "{height}");
        }
    }

    #[test]
    fn the_center_ray_is_not_deflected() {
        let v = DVec2::new(0.6, 0.8);
        assert_eq!(thin_lens(v, N, 0.0, 40.0, 1.0, 1.0), v);
    }

    #[test]
    fn a_diverging_lens_seen_from_the_other_side() {
        // Light along −x: τ = −y, so a hit at y = +10 has height −10.
        let t = thin_lens(-DVec2::X, DVec2::X, -10.0, -20.0, 1.0, 1.0);
        assert!((t.y / t.x + 0.5).abs() < 1e-15 && t.y > 0.0, "{t}");
    }

    #[test]
    fn without_power_slopes_go_as_the_indices() {
        // tan θ_i = 4/3 from n = 1.5 into 1.
        let t = thin_lens(DVec2::new(0.6, 0.8), N, 7.0, f64::INFINITY, 1.5, 1.0);
        assert!((t.y / t.x - 2.0).abs() < 1e-15);
    }

    #[test]
    fn light_turned_back_between_two_media_returns() {
        let v = DVec2::new(0.8, 0.6);
        let t = thin_lens(v, N, 7.0, 40.0, 1.0, 1.5);
        let back = thin_lens(-t, -N, -7.0, 40.0, 1.5, 1.0);
        assert!((back + v).length() < 1e-15, "{back}");
    }

    #[test]
    fn edge_on_rays_go_on() {
        assert_eq!(thin_lens(DVec2::Y, N, 3.0, 40.0, 1.0, 1.0), DVec2::Y);
    }
}
