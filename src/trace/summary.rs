use crate::light::Wavelength;
use crate::numerics::Sum;
use crate::system::OpticalSystem;
use crate::trace::tracer::Leg;
use crate::trace::{Ending, Segment, SegmentId, TracedRay, Visitor, Work};

/// What became of all the light: counts, powers and screens, without the tree.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Summary {
    /// Source rays, one per line.
    pub rays: u64,
    /// Listed segments, those not followed included.
    pub segments: u64,
    /// Where the power went.
    pub balance: PowerBalance,
    /// Every screen in the bodies' order, hit or not.
    pub screens: Vec<ScreenRecord>,
    /// What the trace took.
    pub work: Work,
}

/// What became of the light of some rays.
#[derive(Clone, Debug, Default)]
pub(crate) struct LightSummary {
    rays: u64,
    pub(crate) segments: u64,
    /// Of these, those of which somebody was told.
    pub(crate) told: u64,
    balance: PowerBalance,
    /// What landed on screens, by body.
    pub(crate) landed: Vec<(usize, ScreenHit)>,
}

/// Where the power of the sources went, in their unit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct PowerBalance {
    /// Sent out by the sources.
    pub emitted: Sum,
    /// Left the scene.
    pub escaped: Sum,
    /// Stayed at hits.
    pub absorbed: Sum,
    /// Landed on screens.
    pub detected: Sum,
    /// In branches below `min_power`.
    pub cut_min_power: Sum,
    /// In branches beyond `max_depth`.
    pub cut_max_depth: Sum,
    /// In branches beyond `max_segments`.
    pub cut_max_segments: Sum,
}

/// One screen's record.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ScreenRecord {
    /// The screen, by its place among the scene's bodies.
    pub body: usize,
    /// Where light landed, in the order of the trace.
    pub hits: Vec<ScreenHit>,
}

/// Light that landed on a screen.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ScreenHit {
    /// The source, by its place in the scene.
    pub source: usize,
    /// The ray within its source.
    pub ray: usize,
    /// Vacuum wavelength.
    pub wavelength: Wavelength,
    /// The segment that landed, within its ray.
    pub segment: SegmentId,
    /// Distance along the screen from its first point, scene units.
    pub position: f64,
    /// Power that landed.
    pub power: f64,
}

impl Visitor for Summary {
    fn segment(&mut self, ray: &TracedRay, segment: Segment) {
        let (power, hit) = (segment.power.total(), segment.hit.as_ref());
        self.rays = self.rays.saturating_add(u64::from(segment.parent.is_none()));
        self.segments = self.segments.saturating_add(1);
        self.balance.count(segment.id, segment.ending, power, hit.map_or(0.0, |hit| hit.absorptance));
        if segment.ending == Ending::Detected {
            let landed = hit.map(|hit| (hit.body, hit.position.unwrap_or(0.0)));
            self.land(landed.map(|landed| landing(ray, segment.id, power, landed)));
        }
    }
}

impl PowerBalance {
    /// Counts a segment: its place in its ray, how it ended, the power it carried, and which fraction of it stayed at its hit.
    #[inline(always)]
    fn count(&mut self, id: SegmentId, ending: Ending, power: f64, absorptance: f64) {
        if id.0 == 0 {
            self.emitted.add(power);
        }
        match ending {
            Ending::Escaped => self.escaped.add(power),
            Ending::CutMinPower => self.cut_min_power.add(power),
            Ending::CutMaxDepth => self.cut_max_depth.add(power),
            Ending::CutMaxSegments => self.cut_max_segments.add(power),
            Ending::Detected => self.detected.add(power),
            Ending::Absorbed => self.absorbed.add(power),
            Ending::Interface => {
                if absorptance != 0.0 {
                    self.absorbed.add(power * absorptance);
                }
            }
        }
    }

    /// Adds another balance.
    fn add(&mut self, other: &Self) {
        self.emitted.add_sum(other.emitted);
        let sums = [
            (&mut self.escaped, other.escaped),
            (&mut self.absorbed, other.absorbed),
            (&mut self.detected, other.detected),
            (&mut self.cut_min_power, other.cut_min_power),
            (&mut self.cut_max_depth, other.cut_max_depth),
            (&mut self.cut_max_segments, other.cut_max_segments),
        ];
        for (sum, more) in sums {
            if more != Sum::default() {
                sum.add_sum(more);
            }
        }
    }

    /// Emitted power less all the others: 0 up to rounding.
    #[must_use]
    pub fn residual(&self) -> f64 {
        let mut sum = self.emitted;
        let gone =
            [self.escaped, self.absorbed, self.detected, self.cut_min_power, self.cut_max_depth, self.cut_max_segments];
        for part in gone {
            sum.add(-part.value());
        }
        sum.value()
    }
}

impl Summary {
    /// No light yet, and a record for every screen of the system.
    #[must_use]
    pub fn new(system: &OpticalSystem) -> Self {
        let screens = system.screens.iter().map(|&body| ScreenRecord { body, hits: Vec::new() }).collect();
        Self { screens, ..Self::default() }
    }

    /// Adds what became of more light.
    pub(crate) fn add(&mut self, light: LightSummary) {
        self.rays += light.rays;
        self.segments += light.segments;
        self.balance.add(&light.balance);
        self.land(light.landed);
    }

    fn land(&mut self, landed: impl IntoIterator<Item = (usize, ScreenHit)>) {
        for (body, hit) in landed {
            if let Ok(place) = self.screens.binary_search_by_key(&body, |screen| screen.body) {
                self.screens[place].hits.push(hit);
            }
        }
    }
}

impl LightSummary {
    #[inline(always)]
    pub(crate) fn count(&mut self, ray: &TracedRay, leg: &Leg) {
        self.rays += u64::from(leg.id.0 == 0);
        self.segments += 1;
        self.balance.count(leg.id, leg.ending, leg.power(), leg.absorptance());
        if leg.ending == Ending::Detected {
            self.landed.extend(leg.landed().map(|landed| landing(ray, leg.id, leg.power(), landed)));
        }
    }

    /// Tells how many segments have come since it told last.
    pub(crate) fn tell(&mut self, progress: &dyn Fn(u64)) {
        progress(self.segments - self.told);
        self.told = self.segments;
    }

    pub(crate) fn append(&mut self, mut other: Self) {
        self.rays += other.rays;
        self.segments += other.segments;
        self.told += other.told;
        self.balance.add(&other.balance);
        self.landed.append(&mut other.landed);
    }
}

/// What a segment leaves on a screen, with the screen's body: given that and the place on it.
fn landing(ray: &TracedRay, segment: SegmentId, power: f64, (body, position): (usize, f64)) -> (usize, ScreenHit) {
    let &TracedRay { source, ray, wavelength, .. } = ray;
    (body, ScreenHit { source, ray, wavelength, segment, position, power })
}
