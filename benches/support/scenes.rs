//! Scenes that several programs measure.

use glam::DVec2;
use snellius::Scene;
use snellius::scene::{Body, Direction, Light, Medium, Polarization, Shape, Source, Spectrum, Substance};

/// Deep enough that only power cuts.
pub(crate) const NO_DEPTH: u32 = 100_000;

/// A body of index 1.5.
pub(crate) fn body(shape: Shape, at: DVec2) -> Body {
    let substance = Substance::Medium(Medium::Index(1.5));
    Body::new(shape, substance).placed(at, 0.0)
}

pub(crate) fn source(light: Light) -> Source {
    let (spectrum, polarization) = (Spectrum::default(), Polarization::Unpolarized);
    let mut source = Source::new(light);
    source.spectrum = spectrum;
    source.polarization = polarization;
    source
}

pub(crate) fn beam(center: DVec2, degrees: f64, width: f64, rays: u32) -> Light {
    Light::Beam { center, direction: Direction::Angle(degrees), width, rays }
}

/// An equilateral prism, lit over one face.
pub(crate) fn prism(rays: u32) -> Scene {
    let body = body(Shape::Prism { apex_angle: 60.0, side: 30.0 }, DVec2::ZERO);
    let light = beam(DVec2::new(-30.0, -6.0), 12.0, 16.0, rays);
    Scene::new(vec![body], vec![source(light)])
}

/// Five slabs, ten surfaces.
pub(crate) fn slabs(rays: u32) -> Scene {
    let slab = |k: u32| body(Shape::Rectangle { width: 4.0, height: 1000.0 }, DVec2::new(10.0 * f64::from(k), 0.0));
    let light = beam(DVec2::new(-20.0, 0.0), 40.0, 8.0, rays);
    Scene::new((0..5).map(slab).collect(), vec![source(light)])
}
