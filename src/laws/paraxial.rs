//! Ray-transfer matrices of centered systems, for rays near the axis.

/// What a centered system does to a ray near its axis: it acts on (y, n θ), height above the axis in scene units and
/// reduced slope in radians, of light that travels along the axis.
///
/// # Source
/// Hecht, "Optics", 4th ed., section 6.2.1 (analytical ray tracing, matrix methods); the order (y, nθ) is that of Born & Wolf,
/// "Principles of Optics", 7th ed., section 4.4. The determinant is 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayMatrix {
    /// y′ per y.
    pub a: f64,
    /// y′ per n θ, scene units.
    pub b: f64,
    /// n′θ′ per y, per scene unit: minus the power.
    pub c: f64,
    /// n′θ′ per n θ.
    pub d: f64,
}

impl RayMatrix {
    /// Nothing in the way.
    pub const IDENTITY: Self = Self { a: 1.0, b: 0.0, c: 0.0, d: 1.0 };

    /// A way of `length` scene units through a medium of absolute index `n`; a negative length goes back.
    #[must_use]
    pub fn translation(length: f64, n: f64) -> Self {
        Self { b: length / n, ..Self::IDENTITY }
    }

    /// A boundary from index `n_1` to `n_2` of signed `curvature`, 1/R with R positive where the center lies ahead; 0 is a
    /// plane.
    #[must_use]
    pub fn refraction(n_1: f64, n_2: f64, curvature: f64) -> Self {
        Self { c: -(n_2 - n_1) * curvature, ..Self::IDENTITY }
    }

    /// An ideal thin lens of focal length `f` scene units between indices `n_1` and `n_2`, as [`thin_lens`](super::thin_lens)
    /// bends rays: its power is the mean index over f.
    #[must_use]
    pub fn thin_lens(f: f64, n_1: f64, n_2: f64) -> Self {
        Self { c: -0.5 * (n_1 + n_2) / f, ..Self::IDENTITY }
    }

    /// A mirror of signed `curvature` in a medium of index `n`, the light's new way counted as forward: a mirror hollow
    /// towards the light (R negative) gathers it.
    #[must_use]
    pub fn mirror(n: f64, curvature: f64) -> Self {
        Self { c: 2.0 * n * curvature, ..Self::IDENTITY }
    }

    /// This system, and `next` behind it.
    #[must_use]
    pub fn then(self, next: Self) -> Self {
        Self {
            a: next.a * self.a + next.b * self.c,
            b: next.a * self.b + next.b * self.d,
            c: next.c * self.a + next.d * self.c,
            d: next.c * self.b + next.d * self.d,
        }
    }

    /// The cardinal points of a system between its first vertex in index `n_1` and its last in `n_2`; `None` without power, as
    /// in a plane-parallel slab or a telescope at infinity.
    ///
    /// Heights and slopes mix lengths with numbers, so that no power is small by itself: it counts as none where it bends a
    /// ray by less than 1e-13 of the slope that the way B gives it.
    #[must_use]
    pub fn cardinal_points(&self, n_1: f64, n_2: f64) -> Option<CardinalPoints> {
        let power = -self.c;
        let is_afocal = (self.b * power).abs() <= 1e-13 * (self.a * self.d).abs().max(1.0);
        // An element without thickness has no way within it: its power is its own number.
        let has_power = power != 0.0 && !(is_afocal && self.b != 0.0);
        has_power.then(|| CardinalPoints {
            front_focal_length: n_1 / power,
            back_focal_length: n_2 / power,
            front_focal_point: -n_1 * self.d / power,
            back_focal_point: n_2 * self.a / power,
            front_principal_point: n_1 * (1.0 - self.d) / power,
            back_principal_point: n_2 * (self.a - 1.0) / power,
            front_nodal_point: (n_2 - n_1 * self.d) / power,
            back_nodal_point: (n_2 * self.a - n_1) / power,
        })
    }
}

/// Cardinal points of a centered system on its axis, scene units along the light: the front ones from the first vertex, the
/// back ones from the last.
///
/// # Source
/// Born & Wolf, "Principles of Optics", 7th ed., section 4.3.1; Hecht, "Optics", 4th ed., section 6.1 and 6.2.1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CardinalPoints {
    /// f, from F to H; positive for a system that gathers light.
    pub front_focal_length: f64,
    /// f′, from H′ to F′.
    pub back_focal_length: f64,
    /// F, whose light leaves parallel to the axis.
    pub front_focal_point: f64,
    /// F′, where light parallel to the axis meets it.
    pub back_focal_point: f64,
    /// H: a ray aimed at a height of this plane leaves from the same height of that through H′.
    pub front_principal_point: f64,
    /// H′.
    pub back_principal_point: f64,
    /// N: a ray aimed at it leaves from N′ in its own direction.
    pub front_nodal_point: f64,
    /// N′.
    pub back_nodal_point: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn thick_lens(n: f64, r: [f64; 2], thickness: f64, n_1: f64, n_2: f64) -> RayMatrix {
        RayMatrix::refraction(n_1, n, 1.0 / r[0])
            .then(RayMatrix::translation(thickness, n))
            .then(RayMatrix::refraction(n, n_2, 1.0 / r[1]))
    }

    /// Hecht, "Optics", 4th ed., equations 6.1 to 6.4: the thick lens in air.
    #[test]
    fn thick_lens_formulas() {
        for (n, r, t) in [(1.5, [50.0, -50.0], 6.0), (1.5168, [20.0, 35.0], 4.0), (1.9, [-30.0, 80.0], 9.0)] {
            let power = (n - 1.0) * (1.0 / r[0] - 1.0 / r[1] + (n - 1.0) * t / (n * r[0] * r[1]));
            let f = 1.0 / power;
            let points = thick_lens(n, r, t, 1.0, 1.0).cardinal_points(1.0, 1.0).unwrap();
            let near = |value: f64, expected: f64| {
                assert!((value - expected).abs() < 1e-12 * f.abs(), "{value} is not {expected}");
            };
            near(points.back_focal_length, f);
            near(points.front_principal_point, -f * (n - 1.0) * t / (n * r[1]));
            near(points.back_principal_point, -f * (n - 1.0) * t / (n * r[0]));
            near(points.front_nodal_point, points.front_principal_point);
            near(points.back_focal_point - points.back_principal_point, f);
            near(points.front_principal_point - points.front_focal_point, f);
        }
    }

    /// A ball in water on one side: nodal points fall together in its center whatever stands around it.
    #[test]
    fn nodal_points_of_one_surface_are_its_center() {
        let points = RayMatrix::refraction(1.0, 1.33, 1.0 / 8.0).cardinal_points(1.0, 1.33).unwrap();
        assert!((points.front_nodal_point - 8.0).abs() < 1e-13 && (points.back_nodal_point - 8.0).abs() < 1e-13);
        assert!((points.back_focal_length - 1.33 * 8.0 / 0.33).abs() < 1e-12);
    }

    #[test]
    fn a_hollow_mirror_has_its_focus_halfway_to_its_center() {
        let points = RayMatrix::mirror(1.0, -1.0 / 80.0).cardinal_points(1.0, 1.0).unwrap();
        assert!((points.back_focal_point - 40.0).abs() < 1e-13);
        let points = RayMatrix::mirror(1.0, 1.0 / 80.0).cardinal_points(1.0, 1.0).unwrap();
        assert!((points.back_focal_point + 40.0).abs() < 1e-13, "behind a bulging one");
    }

    #[test]
    fn a_telescope_and_a_slab_have_no_cardinal_points() {
        let lens = |f| RayMatrix::thin_lens(f, 1.0, 1.0);
        let telescope = lens(100.0).then(RayMatrix::translation(125.0, 1.0)).then(lens(25.0));
        assert_eq!(telescope.cardinal_points(1.0, 1.0), None);
        assert!((telescope.a + 0.25).abs() < 1e-15, "it shrinks a beam four times");
        assert_eq!(thick_lens(1.5, [f64::INFINITY; 2], 10.0, 1.0, 1.0).cardinal_points(1.0, 1.0), None);
    }
}
