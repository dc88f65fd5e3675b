//! A small trace made by hand: into a prism at right angles, turned there by total internal reflection, onto a screen.

use glam::DVec2;

use crate::light::{Power, Wavelength};
use crate::numerics::Sum;
use crate::scene::TraceSettings;
use crate::system::{Cells, MediumId, OpticalSystem, PlacedBody};
use crate::trace::{
    Ending, Hit, PowerBalance, RayTree, ScreenHit, ScreenRecord, Segment, SegmentId, Summary, Trace, TracedRay, Via,
    Work,
};

/// The trace and a system with the names of its bodies.
pub(super) fn turn_in_a_prism() -> (OpticalSystem, Trace) {
    let body = |name: &str| PlacedBody { name: name.into(), outlines: Vec::new() };
    let system = OpticalSystem {
        origin: DVec2::ZERO,
        interfaces: Vec::new(),
        near: 0.0,
        tree: None,
        cells: Cells::default(),
        dropped: 0,
        screens: vec![1],
        media: Vec::new(),
        surroundings: MediumId(0),
        bodies: vec![body("prism"), body("wall")],
        sources: Vec::new(),
        settings: TraceSettings::default(),
        title: "Turn in a prism".into(),
    };
    (system, Trace { tree: RayTree { rays: vec![ray()] }, summary: summary() })
}

fn ray() -> TracedRay {
    TracedRay {
        source: 0,
        ray: 0,
        wavelength: Wavelength::D,
        power: 1.0,
        one_of_several_lines: false,
        segments: vec![entering(), turning(), landing(), reflected()],
    }
}

fn segment(id: u32, parent: Option<u32>, via: Via, power: f64, ending: Ending) -> Segment {
    Segment {
        id: SegmentId(id),
        parent: parent.map(SegmentId),
        via,
        from: DVec2::ZERO,
        to: None,
        direction: DVec2::X,
        medium_index: 1.0,
        power: Power::both(0.5 * power),
        optical_path: 30.0,
        ending,
        hit: None,
    }
}

fn hit(body: usize, normal: DVec2, n_i: f64, n_t: Option<f64>) -> Hit {
    Hit {
        body,
        normal,
        n_i,
        n_t,
        cos_i: 1.0,
        sin_i: 0.0,
        cos_t: n_t.map(|_| 1.0),
        sin_t: n_t.map(|_| -0.0),
        reflectance: Power::default(),
        transmittance: Power::default(),
        absorptance: 0.0,
        total_internal_reflection: false,
        position: None,
    }
}

fn entering() -> Segment {
    let hit = Hit {
        reflectance: Power::both(0.04),
        transmittance: Power::both(0.96),
        ..hit(0, DVec2::NEG_X, 1.0, Some(1.5))
    };
    Segment {
        from: DVec2::new(-30.0, 10.0),
        to: Some(DVec2::new(-0.0, 10.0)),
        hit: Some(hit),
        ..segment(0, None, Via::Source, 1.0, Ending::Interface)
    }
}

fn turning() -> Segment {
    let diagonal = 0.5_f64.sqrt();
    let hit = Hit {
        cos_i: diagonal,
        sin_i: diagonal,
        cos_t: None,
        sin_t: None,
        reflectance: Power::both(1.0),
        total_internal_reflection: true,
        ..hit(0, DVec2::new(-diagonal, -diagonal), 1.5, Some(1.0))
    };
    Segment {
        from: DVec2::new(0.0, 10.0),
        to: Some(DVec2::new(30.0, 10.0)),
        medium_index: 1.5,
        optical_path: 75.0,
        hit: Some(hit),
        ..segment(1, Some(0), Via::Transmission, 0.96, Ending::Interface)
    }
}

fn landing() -> Segment {
    Segment {
        from: DVec2::new(30.0, 10.0),
        to: Some(DVec2::new(30.0, -1e-17)),
        direction: DVec2::new(6e-17, -1.0),
        medium_index: 1.5,
        optical_path: 90.0,
        hit: Some(Hit { position: Some(12.5), ..hit(1, DVec2::Y, 1.5, None) }),
        ..segment(2, Some(1), Via::TotalInternalReflection, 0.96, Ending::Detected)
    }
}

fn reflected() -> Segment {
    Segment {
        from: DVec2::new(0.0, 10.0),
        direction: DVec2::NEG_X,
        ..segment(3, Some(0), Via::Reflection, 0.04, Ending::CutMinPower)
    }
}

fn summary() -> Summary {
    let sum = |term| {
        let mut sum = Sum::default();
        sum.add(term);
        sum
    };
    let hit =
        ScreenHit { source: 0, ray: 0, wavelength: Wavelength::D, segment: SegmentId(2), position: 12.5, power: 0.96 };
    Summary {
        work: Work::default(),
        rays: 1,
        segments: 4,
        balance: PowerBalance {
            emitted: sum(1.0),
            detected: sum(0.96),
            cut_min_power: sum(0.04),
            ..PowerBalance::default()
        },
        screens: vec![ScreenRecord { body: 1, hits: vec![hit] }],
    }
}
