//! Light along a screen.

use snellius::analysis::{Irradiance, irradiance};
use snellius::numerics::Turn;

use crate::support::{run_text, tables::close};

fn screens(bodies: &str, sources: &str) -> (Vec<Irradiance>, f64) {
    let run = run_text(&format!("(bodies: [{bodies}], sources: [{sources}])"));
    let screens = irradiance(&run.system, &run.trace.tree);
    assert_eq!(screens.len(), run.trace.summary.screens.len());
    for (screen, record) in screens.iter().zip(&run.trace.summary.screens) {
        assert_eq!((screen.body, screen.hits), (record.body, record.hits.len()));
    }
    (screens, run.trace.summary.balance.detected.value())
}

/// Power under a screen's curves.
fn power(screen: &Irradiance) -> f64 {
    screen.curves.iter().map(|curve| curve.values.iter().sum::<f64>() * part(screen)).sum()
}

fn part(screen: &Irradiance) -> f64 {
    let ([begin, end], _) = screen.parts(&screen.curves[0]).next().unwrap();
    end - begin
}

/// The value at a position.
fn value(screen: &Irradiance, position: f64) -> f64 {
    screen.parts(&screen.curves[0]).find(|([_, end], _)| *end > position).unwrap().1
}

const SCREEN: &str = "(shape: Flat(from: (60, -30), to: (60, 30)), surface: Screen)";

#[test]
fn no_power_is_lost_or_made() {
    let lens = r#"(shape: Lens(radii: (50, -50), thickness: 8, diameter: 30), medium: Catalog("N-BK7"))"#;
    let prism = "(shape: Prism(apex_angle: 40, side: 40), rotate: 70, at: (20, 3), medium: Catalog(\"F2\"))";
    let ring = "(shape: Disk(80), surface: Screen)";
    let beam = "(light: Beam(center: (-40, 1), direction: Angle(3), width: 26, rays: 21), spectrum: Lines([450, 550, 650]), power: 7)";
    let point = "(light: Point(at: (-30, 5), rays: 360), power: 0.3)";
    for bodies in [format!("{SCREEN}, {lens}"), format!("{SCREEN}, {prism}"), format!("{ring}, {lens}, {prism}")] {
        let (screens, detected) = screens(&bodies, &format!("{beam}, {point}"));
        assert_eq!(screens[0].curves.len(), 4);
        assert!(detected > 1.0);
        close(power(&screens[0]), detected, 1e-13 * detected, &bodies);
    }
}

/// A point at distance a over a screen: dP/dx = P/(2π) · a/(a² + x²).
#[test]
fn a_point_source_falls_off_as_it_should() {
    let (screens, _) = screens(SCREEN, "(light: Point(at: (40, 0), rays: 720))");
    for x in [-20.0, -7.3, 0.1, 12.0, 25.0] {
        let expected = 20.0 / (400.0 + x * x) * 0.5 / std::f64::consts::PI;
        close(value(&screens[0], 30.0 + x) / expected, 1.0, 0.02, "at x");
    }
}

#[test]
fn an_even_beam_has_an_even_curve_however_few_rays_show_it() {
    for rays in [2, 5, 40, 41, 999] {
        let light = format!("(light: Beam(center: (0, 0), direction: Angle(0), width: 20, rays: {rays}))");
        let (screens, _) = screens(SCREEN, &light);
        let lit = 20.0 * f64::from(rays) / f64::from(rays - 1);
        for x in [-9.0, -3.1, 0.0, 5.5, 9.0] {
            close(value(&screens[0], 30.0 + x), 1.0 / lit, 1e-12, "lit");
        }
        for x in [-25.0, 25.0] {
            assert_eq!(value(&screens[0], 30.0 + x), 0.0);
        }
    }
}

/// Turned by 60°, the same light takes twice the length.
#[test]
fn an_oblique_screen_gets_less_per_length() {
    let end = 30.0 * Turn::degrees(30.0).direction();
    let tilted = format!("(shape: Flat(from: ({}, {}), to: ({}, {})), surface: Screen)", -end.x, -end.y, end.x, end.y);
    let (screens, _) = screens(&tilted, "(light: Beam(center: (-50, 0), direction: Angle(0), width: 20, rays: 21))");
    close(value(&screens[0], 30.0), 0.5 / 21.0, 1e-12, "per length");
}

#[test]
fn beams_add_up_and_do_not_run_into_each_other() {
    let splitter = "(shape: Flat(from: (0, -40), to: (40, 0)), surface: BeamSplitter(reflect: 0.5, transmit: 0.5))";
    let (screens, _) = screens(
        &format!("{SCREEN}, {splitter}"),
        "(light: Beam(center: (-9, 25), direction: Angle(0), width: 4, rays: 5)),
        (light: Beam(center: (-9, 26), direction: Angle(0), width: 4, rays: 5), power: 3)",
    );
    let screen = &screens[0];
    close(value(screen, 53.0), 0.2, 1e-12, "one beam");
    close(value(screen, 55.5), 0.8, 1e-12, "both beams");
    close(value(screen, 58.0), 0.6, 1e-12, "the other beam");
}

/// Neighbors that came by different bodies are none: the screen is dark between their spots.
#[test]
fn no_light_between_what_two_bodies_made_of_a_beam() {
    let lens = |y: f64| {
        format!("(shape: Flat(from: (0, {}), to: (0, {})), surface: ThinLens(focal_length: 60))", y - 9.9, y + 9.9)
    };
    let bodies = format!("{SCREEN}, {}, {}", lens(10.0), lens(-10.0));
    let (screens, _) = screens(&bodies, "(light: Beam(center: (-9, 0), direction: Angle(0), width: 36, rays: 36))");
    let lit: Vec<_> = screens[0].curves[0].values.iter().filter(|value| **value > 0.0).collect();
    assert!(lit.len() <= 4, "{} parts are lit", lit.len());
    assert_eq!(value(&screens[0], 30.1), 0.0);
}

/// What a stop takes out of a beam is missing on the screen.
#[test]
fn the_shadow_of_a_stop_is_dark() {
    let stop = "(shape: Flat(from: (20, -3), to: (20, 3)), surface: Absorber)";
    let light = "(light: Beam(center: (0, 0), direction: Angle(0), width: 20, rays: 41))";
    let (screens, _) = screens(&format!("{SCREEN}, {stop}"), light);
    for x in [-2.5, 0.0, 2.5] {
        assert_eq!(value(&screens[0], 30.0 + x), 0.0);
    }
    close(value(&screens[0], 35.0), 2.0 / 41.0, 1e-12, "beside the shadow");
}

/// On a closed screen the last ray before its first point and the next behind it are no neighbors all round.
#[test]
fn light_over_the_seam_of_a_closed_screen_stays_there() {
    let (screens, _) = screens(
        "(shape: Disk(10), surface: Screen)",
        "(light: Fan(from: (0, 0), direction: Angle(0), spread: 20, rays: 8)), (light: Fan(from: (0, 0), direction: Angle(90), spread: 20, rays: 8)),
        (light: Fan(from: (0, 0), direction: Angle(180), spread: 20, rays: 8)), (light: Fan(from: (0, 0), direction: Angle(270), spread: 20, rays: 8))",
    );
    let length = screens[0].length;
    close(length, 20.0 * std::f64::consts::PI, 1e-12, "all round");
    let lit = screens[0].curves[0].values.iter().filter(|value| **value > 0.0).count();
    assert!((57..=70).contains(&lit), "{lit} parts are lit of 241, four fans of 20° and half a way more on each side");
}

#[test]
fn a_lamp_in_a_ring_lights_it_evenly_over_the_seam() {
    for rays in [36, 360] {
        let (screens, detected) =
            screens("(shape: Disk(20), surface: Screen)", &format!("(light: Point(at: (0, 0), rays: {rays}))"));
        close(power(&screens[0]), detected, 1e-12, "all of it");
        for value in &screens[0].curves[0].values {
            close(*value, 1.0 / (40.0 * std::f64::consts::PI), 1e-12, "everywhere alike");
        }
    }
}

#[test]
fn light_beyond_a_screens_ends_raises_no_spike_there() {
    let lamp = "(light: Point(at: (0, 0), rays: 720))";
    let (screens, detected) = screens("(shape: Flat(from: (60, -50), to: (60, 50)), surface: Screen)", lamp);
    close(power(&screens[0]), detected, 1e-12, "all that landed");
    for (place, y) in [(0.5, -49.5_f64), (50.0, 0.0), (99.5, 49.5)] {
        let expected = 60.0 / (60.0 * 60.0 + y * y) / (2.0 * std::f64::consts::PI);
        let value = value(&screens[0], place);
        assert!((value / expected - 1.0).abs() < 0.03, "at {y}: {value}, not {expected}");
    }
}

#[test]
fn a_screen_that_nothing_hits_has_no_curves() {
    let (screens, _) = screens(SCREEN, "(light: Ray(from: (0, 0), direction: Angle(180)))");
    assert!(screens[0].curves.is_empty() && screens[0].hits == 0 && screens[0].length == 60.0);
}
