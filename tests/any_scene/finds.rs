//! Scenes that went wrong once, each the smallest that showed it.

use snellius::Scene;
use snellius::glam::DVec2;
use snellius::scene::Shape;

use crate::any_scene::properties::{Verdict, hold, hold_scene};
use crate::any_scene::ron::ron;

/// Each scene under the name of what it shows: it is drawn, with all properties.
macro_rules! finds {
    ($($name:ident: $scene:expr;)*) => {
        $(
            #[test]
            fn $name() {
                assert_eq!(hold(concat!("(", $scene, ")")), Verdict::Drawn);
            }
        )*
    };
}

finds! {
    starts_apart_by_the_least_number: "sources: [
        (light: Ray(from: (-5, 0), direction: Angle(0))),
        (light: Ray(from: (-5, 5e-324), direction: Angle(90)))]";

    light_lands_beside_the_start_of_a_screen_by_the_least_number: "bodies: [(shape: Disk(1), at: (0, -5e-324), surface: Screen)],
        sources: [(light: Ray(from: (2, 0), direction: Angle(180)))]";
}

#[test]
fn a_point_of_a_polygon_built_in_rust_is_no_number() {
    let mut scene = Scene::from_ron("(bodies: [(shape: Disk(1), medium: Index(1.5))])").unwrap();
    for point in [DVec2::new(f64::NAN, 1.0), DVec2::new(1.0, f64::NAN), DVec2::new(f64::INFINITY, 1.0)] {
        scene.bodies[0].shape = Shape::Polygon(vec![point, DVec2::new(4.0, 0.0), DVec2::new(4.0, 4.0)]);
        assert_eq!(hold_scene(&scene, &ron(&scene)), Verdict::Refused);
    }
}
