//! Functions of numbers: NaN gives NaN or `None`, never a finite lie, and nothing panics.

use glam::DVec2;
use proptest::prelude::*;
use snellius::analysis::deviation_degrees;
use snellius::drawing::{Color, hundredths, pixel, shortest};
use snellius::geometry::{Bounds, CircleRoots, Curve, Placement};
use snellius::laws::{
    CardinalPoints, Fresnel, Incidence, RayMatrix, Refraction, Shares, brewster_angle, check_index, critical_angle,
    fresnel, index_from_speed, minimum_deviation, optical_path_length, reflect, refract, refract_vector_form,
    relative_index, thin_lens,
};
use snellius::light::{Power, Wavelength, gray, readable_on_dark, readable_on_light, spectral_color};
use snellius::media::{Dispersion, catalog};
use snellius::numerics::{
    Sum, Turn, acos_degrees, asin_degrees, atan, atan2_degrees, cross, cross_parts, dot, excess_length, exp, pow,
    product_parts, side, side_of_ray, sin, tan_degrees,
};

use crate::config;
use crate::hostile::{number, point, wavelength, words};

/// What a function answers, flattened; empty for `None`.
type Answer = Vec<f64>;

fn vector(v: DVec2) -> Answer {
    vec![v.x, v.y]
}

fn of_refraction(refraction: Refraction) -> Answer {
    let direction = refraction.direction().map_or(Vec::new(), vector);
    [direction, vec![refraction.cos_i(), refraction.sin_i()]].concat()
}

fn of_fresnel(Fresnel { r_s, r_p, reflectance, transmittance }: Fresnel) -> Answer {
    vec![r_s, r_p, reflectance.s, reflectance.p, transmittance.s, transmittance.p]
}

fn of_matrix(RayMatrix { a, b, c, d }: RayMatrix) -> Answer {
    vec![a, b, c, d]
}

fn of_points(points: CardinalPoints) -> Answer {
    vec![
        points.front_focal_length,
        points.back_focal_length,
        points.front_focal_point,
        points.back_focal_point,
        points.front_nodal_point,
        points.back_nodal_point,
    ]
}

fn incoming(x: &[f64]) -> DVec2 {
    DVec2::new(x[0], x[1])
}

/// A law, how many numbers it takes, and numbers at which it has an answer. The first two are a unit vector where it takes one.
type Law = (&'static str, &'static [f64], fn(&[f64]) -> Answer);

const LAWS: [Law; 28] = [
    ("refract", &[0.6, 0.8, -1.0, 0.0, 1.0, 1.5], |x| {
        of_refraction(refract(incoming(x), DVec2::new(x[2], x[3]), x[4], x[5]))
    }),
    ("refract, totally", &[0.6, 0.8, -1.0, 0.0, 1.5, 1.0], |x| {
        of_refraction(refract(incoming(x), DVec2::new(x[2], x[3]), x[4], x[5]))
    }),
    ("refract_vector_form", &[0.6, 0.8, -1.0, 0.0, 1.0, 1.5], |x| {
        refract_vector_form(incoming(x), DVec2::new(x[2], x[3]), x[4], x[5]).map_or(Vec::new(), vector)
    }),
    ("reflect", &[0.6, 0.8, -1.0, 0.0], |x| vector(reflect(incoming(x), DVec2::new(x[2], x[3])))),
    ("Incidence", &[0.6, 0.8, -1.0, 0.0], |x| {
        let Incidence { cos, sin, tangent } = Incidence::new(incoming(x), DVec2::new(x[2], x[3]));
        vec![cos, sin, tangent.x, tangent.y]
    }),
    ("thin_lens", &[0.6, 0.8, -1.0, 0.0, 3.0, 40.0, 1.0, 1.5], |x| {
        vector(thin_lens(incoming(x), DVec2::new(x[2], x[3]), x[4], x[5], x[6], x[7]))
    }),
    ("fresnel", &[1.0, 1.5, 0.6, 0.8, 0.8, 0.6], |x| of_fresnel(fresnel(x[0], x[1], x[2], x[3], x[4], x[5]))),
    ("critical_angle", &[1.5, 1.0], |x| critical_angle(x[0], x[1]).into_iter().collect()),
    ("brewster_angle", &[1.0, 1.5], |x| vec![brewster_angle(x[0], x[1])]),
    ("minimum_deviation", &[1.5, 60.0], |x| minimum_deviation(x[0], x[1]).into_iter().collect()),
    ("check_index", &[1.5], |x| check_index(x[0]).into_iter().collect()),
    ("index_from_speed", &[2e8], |x| index_from_speed(x[0]).into_iter().collect()),
    ("relative_index", &[1.0, 1.5], |x| vec![relative_index(x[0], x[1])]),
    ("optical_path_length", &[1.5, 10.0], |x| vec![optical_path_length(x[0], x[1])]),
    ("Shares", &[0.3, 0.6], |x| vec![Shares::fixed(x[0], x[1]).absorptance]),
    ("translation", &[10.0, 1.5], |x| of_matrix(RayMatrix::translation(x[0], x[1]))),
    ("refraction", &[1.0, 1.5, 0.1], |x| of_matrix(RayMatrix::refraction(x[0], x[1], x[2]))),
    ("lens matrix", &[40.0, 1.0, 1.5], |x| of_matrix(RayMatrix::thin_lens(x[0], x[1], x[2]))),
    ("mirror", &[1.0, 0.1], |x| of_matrix(RayMatrix::mirror(x[0], x[1]))),
    ("cardinal_points", &[1.0, 1.5], |x| {
        let lens = RayMatrix::thin_lens(40.0, 1.0, 1.5);
        lens.cardinal_points(x[0], x[1]).map_or(Vec::new(), of_points)
    }),
    ("deviation_degrees", &[1.0, 0.0, 0.6, 0.8], |x| {
        vec![deviation_degrees(DVec2::new(x[0], x[1]), DVec2::new(x[2], x[3]))]
    }),
    ("from_nanometers", &[500.0], |x| {
        Wavelength::from_nanometers(x[0]).map(Wavelength::nanometers).into_iter().collect()
    }),
    ("Dispersion", &[1.5], |x| {
        Dispersion::constant(x[0]).map(|medium| medium.index(Wavelength::D)).into_iter().collect()
    }),
    ("Turn", &[30.0], |x| vector(Turn::degrees(x[0]).direction())),
    ("arc", &[0.0, 0.0, 1.0, 1.0, 2.0, 0.0], |x| {
        let [a, m, b] = [0, 2, 4].map(|k| DVec2::new(x[k], x[k + 1]));
        Curve::arc(a, m, b).map_or(Vec::new(), |arc| vec![arc.curvature])
    }),
    ("cross", &[0.6, 0.8, -1.0, 0.5], |x| vec![cross(DVec2::new(x[0], x[1]), DVec2::new(x[2], x[3]))]),
    ("tan_degrees", &[30.0], |x| vec![tan_degrees(x[0])]),
    ("Power", &[0.5, 0.25, 0.5, 0.25], |x| vec![Power { s: x[0], p: x[1] }.times(Power { s: x[2], p: x[3] }).total()]),
];

#[test]
fn a_number_that_is_none_gives_no_finite_answer() {
    for (name, numbers, law) in LAWS {
        let answer = law(numbers);
        assert!(!answer.is_empty() && answer.iter().all(|x| x.is_finite()), "{name}: {answer:?}");
        for k in 0..numbers.len() {
            let mut spoiled = numbers.to_vec();
            spoiled[k] = f64::NAN;
            let answer = law(&spoiled);
            assert!(answer.is_empty() || answer.iter().any(|x| x.is_nan()), "{name} {spoiled:?}: {answer:?}");
        }
    }
}

#[test]
fn a_lens_bends_as_far_as_it_can_where_the_numbers_overflow() {
    // A ray far above the axis of a strong lens is turned along the lens, toward the axis.
    for (height, focal_length) in [(1e200, 1e-200), (1e200, 1.0), (1.0, 5e-324)] {
        assert_eq!(thin_lens(DVec2::X, DVec2::NEG_X, height, focal_length, 1.0, 1.0), DVec2::NEG_Y);
        assert_eq!(thin_lens(DVec2::X, DVec2::NEG_X, height, -focal_length, 1.0, 1.0), DVec2::Y);
    }
}

proptest! {
    #![proptest_config(config(4000))]

    #[test]
    fn laws_take_any_numbers(which in 0..LAWS.len(), x in proptest::array::uniform8(number())) {
        let (name, _, law) = LAWS[which];
        let answer = law(&x);
        prop_assert!(answer.len() <= 8, "{}", name);
    }

    #[test]
    fn numerics_take_any_numbers(a in point(), b in point(), c in point(), x in number(), y in number()) {
        let _any = (cross(a, b), dot(a, b), cross_parts(a, b), product_parts(x, y), excess_length(a));
        let _any = (side(a, b, c), side_of_ray(a, b, c), Turn::degrees(x).apply(a), atan2_degrees(x, y));
        let _any = (acos_degrees(x), asin_degrees(x), atan(x), sin(x), exp(x), pow(x, y), tan_degrees(x));
        let (mut sum, mut other) = (Sum::default(), Sum::default());
        sum.add(x);
        other.add(y);
        sum.add_sum(other);
        let _any = sum.value();
    }

    #[test]
    fn curves_take_any_numbers(p in proptest::array::uniform5(point()), x in number()) {
        let bent = Curve { a: p[0], b: p[1], m: p[2], n: p[3], curvature: x };
        let arc = Curve::arc(p[0], p[2], p[1]);
        for curve in [Curve::line(p[0], p[1]), Curve::arc_from_bulge(p[0], p[1], x), bent].into_iter().chain(arc) {
            let _any = (curve.center(), curve.midpoint(), curve.spans_more_than_half(), curve.normal_at(p[4]));
            let _any = (curve.tangent_at(p[4]), curve.offset(p[4]), curve.power(p[4]), curve.project(p[4]));
            let _any = (curve.clamp(p[4]), curve.along(p[4]), curve.bulge_holds(p[4]), curve.segment_holds(p[4]));
            let _any = (curve.same_circle(&bent), curve.length(), curve.length_to(p[4]), curve.segment_area());
            let _any = (curve.halves(), curve.reversed(), CircleRoots::new(&curve, p[2], p[3]));
            let bounds = Bounds::from(&Placement::new(x, p[4]).curve(&curve)).with(p[0]).grown(x);
            let _any = (bounds.contains(p[1]), bounds.meets(Bounds::of(p)), bounds.size(), bounds.center(), bounds.reach());
        }
    }

    #[test]
    fn matrices_take_any_numbers(x in proptest::array::uniform8(number())) {
        let [a, b, c, d, ..] = x;
        let next = RayMatrix { a: x[4], b: x[5], c: x[6], d: x[7] };
        let _any = RayMatrix { a, b, c, d }.then(next).cardinal_points(x[0], x[1]);
    }

    #[test]
    fn media_take_any_numbers(x in proptest::collection::vec(number(), 0..6), at in wavelength(), name in words()) {
        let pairs: Vec<(f64, f64)> = x.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect();
        for medium in [Dispersion::cauchy(&x), Dispersion::sellmeier(&pairs)].into_iter().flatten() {
            if let Ok(n) = medium.check(at) {
                prop_assert!(n >= 1.0 && n.is_finite());
            }
            let _any = (medium.index(at), medium.range_nm(), medium.is_dispersive(), medium == medium.clone());
        }
        prop_assert!(catalog::find(&name).is_none());
        let _any = catalog::nearest(&name);
    }

    #[test]
    fn colors_take_any_values(at in wavelength(), x in number(), color: [u8; 3], other: [u8; 3]) {
        let _any = (spectral_color(at), gray(color), readable_on_light(color), readable_on_dark(color, other));
        let _any = Color(color).toward(Color(other), x);
        prop_assert!(pixel(x).abs() <= 1e6 && hundredths(x).abs() <= 100_000_000);
        prop_assert_eq!(shortest(x).parse::<f64>().unwrap().to_bits() << 1, x.to_bits() << 1);
    }
}
