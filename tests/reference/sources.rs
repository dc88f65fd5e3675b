//! Where rays start, where they head, and what they carry.

use f256::f256;
use glam::DVec2;
use snellius::scene::{Direction, Light, Polarization, Source, Spectrum};

use crate::placement::{direction, turned};
use crate::support::wide::{Wide2, wide};

/// First points and unit directions of a source's rays.
pub(crate) fn starts(light: &Light) -> Vec<(Wide2, Wide2)> {
    match light {
        Light::Ray { from, direction } => vec![((*from).into(), heading(*from, *direction))],
        Light::Beam { center, direction, width, rays } => {
            let ahead = heading(*center, *direction);
            let from = |k| Wide2::from(*center) + (fraction(k, *rays) * wide(*width)) * ahead.perp();
            (0..*rays).map(|k| (from(k), ahead)).collect()
        }
        Light::Fan { from, direction: middle, spread, rays } => {
            let ahead = |k| turned(heading(*from, *middle), direction(fraction(k, *rays) * wide(*spread)));
            (0..*rays).map(|k| ((*from).into(), ahead(k))).collect()
        }
        Light::Point { at, rays } => {
            let degrees = |k: u32| wide(360.0) * wide(f64::from(k)) / wide(f64::from(*rays));
            (0..*rays).map(|k| ((*at).into(), direction(degrees(k)))).collect()
        }
        Light::Object { .. } => panic!("an object is given as its rays"),
        other => panic!("the reference knows no {other:?}"),
    }
}

/// k/(n − 1) − 1/2; 0 for a single ray.
fn fraction(k: u32, n: u32) -> f256 {
    if n == 1 { f256::ZERO } else { wide(f64::from(k)) / wide(f64::from(n - 1)) - wide(0.5) }
}

fn heading(from: DVec2, towards: Direction) -> Wide2 {
    match towards {
        Direction::Angle(degrees) => direction(wide(degrees)),
        Direction::Towards(point) => (Wide2::from(point) - from.into()).unit(),
        other => panic!("the reference knows no {other:?}"),
    }
}

/// Vacuum wavelengths in nanometers.
pub(crate) fn lines(spectrum: &Spectrum) -> Vec<f256> {
    match spectrum {
        Spectrum::Line(nm) => vec![wide(*nm)],
        Spectrum::Lines(lines) => lines.iter().map(|nm| wide(*nm)).collect(),
        Spectrum::White { samples: 1 } => vec![wide(560.0)],
        Spectrum::White { samples } => {
            let step = wide(280.0) / wide(f64::from(samples - 1));
            (0..*samples).map(|k| wide(420.0) + wide(f64::from(k)) * step).collect()
        }
        other => panic!("the reference knows no {other:?}"),
    }
}

/// s and p power of one of `shares` rays and lines.
pub(crate) fn power(source: &Source, shares: usize) -> [f256; 2] {
    let power = wide(source.power) / wide(f64::from(u32::try_from(shares).unwrap()));
    match source.polarization {
        Polarization::Unpolarized => [wide(0.5) * power; 2],
        Polarization::S => [power, f256::ZERO],
        Polarization::P => [f256::ZERO, power],
        other => panic!("the reference knows no {other:?}"),
    }
}
