//! Scenes in which light once went wrong, each the smallest that showed it.

use crate::leaks::is_leak;
use crate::properties::check;
use crate::support::run_text;

/// Each scene under the name of what it shows, held to all laws.
macro_rules! finds {
    ($($name:ident: $scene:expr;)*) => {
        $(
            #[test]
            fn $name() {
                check(&run_text(concat!("(trace: (min_power: 0, max_depth: 6), ", $scene, ")")));
            }
        )*
    };
}

/// Each scene under the name of what it shows: light whose direction has drifted by rounding, over several bounces, along an
/// edge to where others meet it does not get out.
macro_rules! drifts {
    ($($name:ident: $scene:expr;)*) => {
        $(
            #[test]
            fn $name() {
                let trace = "trace: (secondary_rays: Fixed(kr: 0.5, kt: 0.5), max_depth: 8, min_power: 0)";
                let run = run_text(&format!("({trace}, {})", $scene));
                for ray in &run.trace.tree.rays {
                    assert!(ray.segments.len() > 10, "light bounces");
                    let leak = ray.segments.iter().find(|s| is_leak(ray, s));
                    assert!(leak.is_none(), "{leak:?}");
                }
            }
        )*
    };
}

finds! {
    a_ray_starts_on_the_diameter_of_a_disk: "surroundings: Index(1.33),
        bodies: [(shape: Disk(5.35), at: (1, 2), rotate: 180, medium: Index(1))],
        sources: [(light: Ray(from: (0, 2), direction: Towards((0, 0))))]";

    a_large_arc_moves_the_origin_far_from_a_lens: "surroundings: Index(1.5), bodies: [
        (shape: Arc(from: (-0.11986849681277793, 0.5248331437469955), through: (-2.105066450672489, -1.1641100962023636),
            to: (3.1183390681089973, 3.269737184874688)), surface: Mirror),
        (shape: LensGroup(diameter: 4, surfaces: [(radius: inf, thickness: 0.55, medium: Index(1)),
            (radius: 12.405538028041654, thickness: 0.712279729484542, medium: Index(1.5)), (radius: inf)]),
            at: (-8.789173941032196, 0), rotate: 136.42805198745432)],
        sources: [(light: Ray(from: (-23.429548888162596, 0), direction: Angle(-120.41171554330292)))]";

    a_short_piece_of_a_large_arc_lies_in_glass: "bodies: [
        (shape: Arc(from: (-1.1962391752029056, -0.6045058496930406), through: (-0.45598788984119665, -1.6180389233063708),
            to: (-4.929732051872598, 4.522619108459233)), at: (6.041671502711375, 2.7710265306569983),
            rotate: -76.09948382578789, surface: Mirror),
        (shape: HalfDisk(1.338948886320791), at: (2.0840261218993423, 0), medium: Index(1.33))],
        sources: [(light: Ray(from: (0, 0), direction: Angle(26.412763419346117)))]";

    light_runs_along_an_edge_that_another_body_cuts: "surroundings: Index(1.5), bodies: [
        (shape: Rectangle(2.7596163911205926, 2), at: (3, 0), medium: Index(1)),
        (shape: Rectangle(3.7119266838517953, 4), at: (2, 0), rotate: -90, medium: Index(1.33))],
        sources: [(light: Ray(from: (4, 0), direction: Towards((4, 1))))]";

    light_runs_along_a_mirror_in_pieces: "bodies: [
        (shape: Prism(apex_angle: 68.30213613463638, side: 4.846697630196237), at: (3, 3), medium: Index(1)),
        (shape: Stop(opening: 0.6636471994483479, height: 6.860871774214376), at: (0, 3), rotate: -90, surface: Mirror),
        (shape: HalfDisk(2.225587789584054), at: (1, 2), medium: Index(1))],
        sources: [(light: Ray(from: (2, 3), direction: Towards((0, 3))))]";

    light_runs_along_a_hypotenuse_into_a_disk: "bodies: [
        (shape: RightAnglePrism(3), at: (-3, -2), medium: Index(1.5)),
        (shape: HalfDisk(2), at: (-3, 1), rotate: -90, medium: Index(1))],
        sources: [(light: Ray(from: (0, -2), direction: Towards((-6, 4))))]";

    a_tangent_ray_starts_where_an_edge_touches_an_arc: "bodies: [
        (shape: RightAnglePrism(4.8), at: (-2, 0), rotate: 180, medium: Index(1)),
        (shape: LensGroup(diameter: 4, surfaces: [(radius: -2.5, thickness: 0.55, medium: Index(1.33)),
            (radius: inf, thickness: 0.55, medium: Index(1)), (radius: inf)]), at: (-2, -3)),
        (shape: Stop(opening: 0.5, height: 2.5), at: (-1, -1), rotate: -90, surface: Mirror)],
        sources: [(light: Ray(from: (-2, -3), direction: Towards((-2, 0))))]";

    a_ray_starts_where_a_mirror_touches_a_face: "surroundings: Index(1.33), bodies: [
        (shape: HalfDisk(1), at: (-1, 1), rotate: 90, surface: Mirror),
        (shape: Rectangle(2, 2.993483544783215), at: (0, 1), rotate: 90, medium: Index(1))],
        sources: [(light: Ray(from: (-1, 2), direction: Angle(59.296596652744704)))]";

    arcs_join_at_a_small_angle: "bodies: [(shape: Outline(start: (0, 0), path: [LineTo((2.6414313281422257, 0)),
        LineTo((2.6414313281422257, 3.722442969756314)),
        ArcTo(through: (1.3207156640711128, 5.043158633827427), to: (0, 3.722442969756314)),
        ArcTo(through: (0.04624787298281572, 1.861221484878157), to: (0, 0))]),
        at: (-9.411679105468666, 7.349167484674192), rotate: 31.879815557260795, medium: Index(1.5))],
        sources: [(light: Ray(from: (18, 0), direction: Angle(0))),
            (light: Ray(from: (0, 0), direction: Angle(131.12916662769672)))]";

    a_ray_starts_at_the_seam_of_half_a_circle: "bodies: [(shape: Outline(start: (0, 0), path: [LineTo((2, 0)), LineTo((2, 2)),
        LineTo((0, 2)), ArcTo(through: (-1, 1), to: (0, 0))]), at: (2, -2), rotate: 180, medium: Index(1.5))],
        sources: [(light: Ray(from: (2, -2), direction: Towards((2, -3))))]";

    a_ray_starts_at_the_origin_on_a_slanted_face: "bodies: [
        (shape: HalfDisk(3.1204987039470025), medium: Index(1)),
        (shape: RightAnglePrism(3), at: (2, -1), rotate: 90, medium: Index(1.33))],
        sources: [(light: Ray(from: (0, 0), direction: Angle(0)))]";

    a_ray_starts_where_two_faces_hide_in_equal_media: "surroundings: Index(1.5), bodies: [
        (shape: Polygon([(0, 0), (2, 0), (2, 2), (0, 2)]), at: (88638.26942389272, -2.098076211353316), rotate: 210,
            medium: Index(1)),
        (shape: HalfDisk(1), at: (88637.40339848894, -2.598076211353316), rotate: -60, medium: Index(1.5))],
        sources: [(light: Ray(from: (88637.40339848894, -2.598076211353316), direction: Towards((88635.90339848894, 0))))]";

    a_line_starts_where_it_touches_an_arc: "bodies: [
        (shape: Outline(start: (0, 0), path: [
            ArcTo(through: (2.1325167753193077, -2.1325167753193077), to: (4.2650335506386154, 0)),
            LineTo((4.2650335506386154, 4.387015646531087)),
            ArcTo(through: (2.1325167753193077, 6.5195324218503945), to: (0, 4.387015646531087))]),
            at: (-856.7324643475661, -0.6339745962155611), rotate: 30, surface: BeamSplitter(reflect: 0.4, transmit: 0)),
        (shape: LensGroup(diameter: 4, surfaces: [(radius: inf, thickness: 0.55, medium: Index(1)),
            (radius: inf, thickness: 0.55, medium: Index(1)), (radius: inf)]), at: (-855.7324643475661, -2.3660254037844384),
            rotate: 30),
        (shape: Disk(2), at: (-854.8664389437816, -1.8660254037844386), rotate: 30, medium: Index(1))],
        sources: [(light: Ray(from: (-853.6343881362128, 0), direction: Angle(30)))]";

    a_tangent_far_from_the_origin_rounds_with_its_place: "bodies: [
        (shape: Disk(2), at: (-1.4041103363107732, 206498.34378013725), rotate: 218.14718420513998, medium: Index(1.33))],
        sources: [(light: Ray(from: (-2.9769635642207106, 206497.10841269253),
            direction: Towards((-2.3592798418649057, 206496.32198607858))))]";

    a_cusp_between_a_rim_and_an_arc_lets_light_out: "bodies: [
        (shape: Lens(radii: (3, -3), thickness: 1.8, diameter: 3), medium: Index(1.5)),
        (shape: HalfDisk(1.5), medium: Index(1))],
        sources: [(light: Ray(from: (0.498076211353316, 1.5), direction: Towards((-0.5019237886466841, 1.5))))]";

    a_grazing_reflection_in_a_cusp_gets_out: "bodies: [
        (shape: Lens(radii: (3, -3), thickness: 1.8, diameter: 3), medium: Index(1.5)),
        (shape: Disk(1.5), rotate: 45, medium: Index(1))],
        sources: [(light: Ray(from: (-0.498076211353316, -1.5), direction: Towards((0.5019237886466841, -1.5))))]";

    a_ray_starts_an_ulp_beside_a_seam: "bodies: [
        (shape: Disk(1.5), at: (1000000, -1000000), rotate: 90, medium: Index(1.5))],
        sources: [(light: Ray(from: (1000000, -1000001.4999999977), direction: Towards((999999, -1000001.4999999977))))]";

    a_direction_all_but_level_underflows: "bodies: [
        (shape: Disk(1.5), medium: Index(1.5)), (shape: Disk(1.5), at: (1.5, 1.5), medium: Index(1.5))],
        sources: [(light: Ray(from: (0.5804454433919036, 0), direction: Towards((1.5, -5e-324))))]";

    two_edges_of_a_mirror_meet_at_a_reflex_corner: "bodies: [(shape: Polygon([(397574457.4778098, 334212373.101422),
        (-82114702.56775172, 1111507750.4495432), (-329021699.74848145, 386860370.5227215),
        (-2101221232.4409165, -74270799.89743441), (-1246171197.0863354, -1023695955.943905),
        (-75190723.31701311, -2065416409.900918)]), rotate: 32.18726616170892, surface: Mirror)],
        sources: [(light: Ray(from: (-366524415.6060007, -492777941.39104456),
            direction: Towards((-484530827.0331384, 152138433.1486959))))]";

    a_free_start_beside_a_face_that_another_body_bends_by_an_ulp: "bodies: [
        (shape: HalfDisk(1.5), medium: Index(1.5)),
        (shape: Polygon([(1.5167528122550262, 1.31713904539626), (0.4449643286220056, 2.2590647700688478),
            (-0.6446751893996028, 1.2102899085542405), (-1.6178017445525557, 0.9790741465644587),
            (-1.3853239993264714, -0.2072110075761471), (-0.4437588659064673, -0.393916517665799),
            (-0.2099560500952516, -0.8239096128549455), (0.7360996165317478, -1.5247772425664152)]), at: (0, -2),
            medium: Index(2)),
        (shape: HalfDisk(1.5), rotate: 90, medium: Index(1)),
        (shape: Disk(1.5), at: (1.5, 2), rotate: 90, medium: Index(1.5))],
        sources: [(light: Ray(from: (0.023465520096562026, -0.14662660513243025),
            direction: Towards((0.44496432862200563, 0.2590647700688477))))]";

    a_free_start_on_a_hidden_part_of_an_edge: "bodies: [(shape: Rectangle(2, 1.5), medium: Index(1.5)),
        (shape: Polygon([(1.3738033621864554, 1.3661895560391546), (0.2836785474822929, 0.9965901139245097),
            (-1.0079368415095138, 2.2554181421033594), (-0.4601291390238735, 0.3610729166653866),
            (-2.0943614130436723, 0.20296295629173464), (-1.7483919055752248, -1.2713793822489377),
            (-0.7676186408721295, -1.6554545030928853), (0.1841323483952831, -0.5938293387240147)]), at: (-2, 0),
            rotate: 180, medium: Index(1.5))],
        sources: [(light: Ray(from: (0.09436141270967906, -0.20296295486842897),
            direction: Towards((-0.25160809442477516, 1.2713793822489377))))]";

    light_drifts_along_a_face_far_ahead: "bodies: [(shape: Disk(1.5), medium: Index(1.5)),
        (shape: Rectangle(2, 1.5), at: (0, -2), rotate: 90, medium: Index(2)),
        (shape: Disk(1.5), at: (1.5, -1.5), medium: Index(1)),
        (shape: Rectangle(2, 1.5), at: (-2, 0), rotate: 180, medium: Index(1.5))],
        sources: [(light: Ray(from: (-1, 0.75), direction: Towards((-2, 0.75))))]";

    a_start_between_the_ends_of_a_bent_edge: "bodies: [
        (shape: Polygon([(0.33250149104009846, 1.2740781398170868), (-1.947044736282836, 1.284383136464474),
            (-0.7377870854391321, -0.682086604815762), (0.26934975606939726, -0.44762621849115114)]), medium: Index(1.5)),
        (shape: Outline(start: (0, 0), path: [LineTo((2, 0)), ArcTo(through: (3, 1), to: (2, 2)), LineTo((0, 2)),
            ArcTo(through: (-1, 1), to: (0, 0))]), at: (1.5, -2), rotate: 45, medium: Index(1))],
        sources: [(light: Ray(from: (0.21768838630831888, -0.45388448894549116),
            direction: Towards((2.9142135623730945, -0.5857864376269052))))]";

    a_face_touches_a_disk_of_the_same_glass: "bodies: [(shape: HalfDisk(1.5), medium: Index(1.5)),
        (shape: Lens(radii: (3, -3), thickness: 1.8, diameter: 3), at: (-1.5, -1.5), rotate: 180, medium: Index(2)),
        (shape: Disk(1.5), at: (-1.5, 0), rotate: 180, medium: Index(1.5))],
        sources: [(light: Ray(from: (0, -0.6795620009953999), direction: Towards((0, -1.5))))]";
}

drifts! {
    an_edge_grazes_two_arcs_that_coincide: "bodies: [
        (shape: Polygon([(265506000.6760755, 1982298303.385491), (-1978279183.087365, 293958285.7535883),
            (-1216420850.3541713, -1587551673.1192198), (1433204173.9123466, -1394964442.514657)]),
            rotate: 105.6125009212672, medium: Index(1.5)),
        (shape: Disk(1500000000), at: (403694938.76242715, -1444655805.5182557), rotate: 105.6125009212672, medium: Index(2)),
        (shape: Disk(1500000000), rotate: 150.6125009212672, medium: Index(1)),
        (shape: HalfDisk(1500000000), rotate: 105.6125009212672, medium: Index(1.5))],
        sources: [(light: Ray(from: (-1444655804.453278, -403694938.4648296),
            direction: Towards((1366475173.1513035, 618664368.7502259))))]";

    light_turned_back_at_the_end_of_a_lens_face: "bodies: [
        (shape: Lens(radii: (3, -3), thickness: 1.8, diameter: 3), at: (1e9, -1e9), rotate: 90, medium: Index(1.5)),
        (shape: HalfDisk(1.5), at: (1e9, -1000000002), rotate: 270, medium: Index(2)),
        (shape: Outline(start: (0, 0), path: [LineTo((2, 0)), ArcTo(through: (3, 1), to: (2, 2)), LineTo((0, 2)),
            ArcTo(through: (-1, 1), to: (0, 0))]), at: (1000000001.5, -999999998.5), rotate: 180, medium: Index(1)),
        (shape: Disk(1.5), at: (999999998.5, -1000000001.5), rotate: 135, medium: Index(1.5))],
        sources: [(light: Ray(from: (999999998.4999999, -999999999.9999999), direction: Angle(-90)))]";

    light_drifts_along_an_edge_to_a_disk_that_touches_it: "bodies: [(shape: HalfDisk(1.5), medium: Index(1.5)),
        (shape: Disk(1.5), at: (1.5, -1.5), rotate: 90, medium: Index(2)),
        (shape: Outline(start: (0, 0), path: [LineTo((2, 0)), ArcTo(through: (3, 1), to: (2, 2)), LineTo((0, 2)),
            ArcTo(through: (-1, 1), to: (0, 0))]), at: (1.5, 0), medium: Index(1)),
        (shape: Outline(start: (0, 0), path: [LineTo((2, 0)), ArcTo(through: (3, 1), to: (2, 2)), LineTo((0, 2)),
            ArcTo(through: (-1, 1), to: (0, 0))]), at: (0, -1.5), rotate: 45, medium: Index(1.5))],
        sources: [(light: Ray(from: (1.4544562167629167, -0.045543783237083364),
            direction: Towards((1.4142135623730954, -0.08578643762690508))))]";

    light_drifts_along_cemented_edges_to_a_third: "bodies: [
        (shape: Outline(start: (0, 0), path: [LineTo((2, 0)), ArcTo(through: (3, 1), to: (2, 2)), LineTo((0, 2)),
            ArcTo(through: (-1, 1), to: (0, 0))]), medium: Index(1.5)),
        (shape: Outline(start: (0, 0), path: [LineTo((2, 0)), ArcTo(through: (3, 1), to: (2, 2)), LineTo((0, 2)),
            ArcTo(through: (-1, 1), to: (0, 0))]), at: (1.5, 0), rotate: 180, medium: Index(2)),
        (shape: HalfDisk(1.5), at: (1.5, 1.5), rotate: 180, medium: Index(1)),
        (shape: HalfDisk(1.5), at: (-2, 1.5), rotate: 90, medium: Index(1.5))],
        sources: [(light: Ray(from: (-3.5, 1.5), direction: Towards((-0.5000000000000001, 1.4999999999999998))))]";

    two_ways_out_of_a_lens_lie_at_the_start_beside_a_mirror: "bodies: [
        (shape: Lens(radii: (3, -3), thickness: 1.8, diameter: 3), at: (1000000000, -1000000000),
            rotate: 277.85003820384156, medium: Index(1.5)),
        (shape: HalfDisk(1.5), at: (999999998.240895, -999999998.2236133), rotate: 277.85003820384156, medium: Index(2)),
        (shape: Lens(radii: (3, -3), thickness: 1.8, diameter: 3), at: (1000000001.2810723, -999999998.3091854),
            rotate: 277.85003820384156, medium: Index(1)),
        (shape: Lens(radii: (3, -3), thickness: 1.8, diameter: 3), at: (999999998.3091854, -999999998.7189277),
            rotate: 277.85003820384156, medium: Index(1.5)),
        (shape: Outline(start: (0, 0), path: [LineTo((2, 0)), ArcTo(through: (3, 1), to: (2, 2)), LineTo((0, 2)),
            ArcTo(through: (-1, 1), to: (0, 0))]), at: (999999999.7268385, -999999998.0187421),
            rotate: 457.85003820384156, surface: Mirror)],
        sources: [
            (light: Ray(from: (1000000003.0398512, -999999999.3691823),
                direction: Towards((999999999.7271011, -999999998.020648)))),
            (light: Ray(from: (999999999.7270992, -999999998.020647),
                direction: Towards((1000000001.4179159, -999999999.3017201)))),
            (light: Ray(from: (1000000001.4179159, -999999999.3017203),
                direction: Towards((999999999.7270993, -999999998.0206472))))]";
}
