//! Optical path length.

/// The optical path length n·s of a straight way of geometrical `length` s in a medium of absolute index `n`: the distance
/// that light goes in vacuum in the same time. Along a path the lengths of its parts add.
///
/// # Source
/// Hecht, "Optics", 4th ed., section 4.5 (Fermat's principle); Born & Wolf, "Principles of Optics", 7th ed., section 3.1.
#[must_use]
pub fn optical_path_length(n: f64, length: f64) -> f64 {
    n * length
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;
    use crate::laws::{SPEED_OF_LIGHT, index_from_speed};

    #[test]
    fn the_vacuum_is_as_long_as_it_is() {
        assert_eq!(optical_path_length(1.0, 12.5), 12.5);
        assert_eq!(optical_path_length(1.5, 10.0), 15.0);
    }

    #[test]
    fn it_is_c_times_the_time_of_flight() {
        let speed = 0.75 * SPEED_OF_LIGHT;
        let n = index_from_speed(speed).unwrap();
        assert!((optical_path_length(n, 3.0) - SPEED_OF_LIGHT * (3.0 / speed)).abs() < 1e-15);
    }

    #[test]
    fn fermat_the_refracted_way_is_the_shortest() {
        // From (−3, −4) in n = 1 over a point of the boundary x = 0 to (4, 3) in n = 4/3: sines 4/5 and 3/5 at the origin.
        let over = |y: f64| {
            optical_path_length(1.0, DVec2::new(3.0, 4.0 + y).length())
                + optical_path_length(4.0 / 3.0, DVec2::new(4.0, 3.0 - y).length())
        };
        assert!((over(0.0) - 35.0 / 3.0).abs() < 4e-15);
        for y in [-0.5, -1e-3, 1e-3, 0.5] {
            assert!(over(y) > over(0.0), "{y}");
        }
    }
}
