//! The hits whose angles are marked.

use glam::DVec2;

use crate::diagram::Figure;
use crate::diagram::branches::Branch;
use crate::numerics::atan2_degrees;
use crate::scene::{Body, Imaging, Light, Substance, Surface};
use crate::trace::Hit;

/// More marks would be noise.
const MOST: usize = 12;
/// Branches beyond this many are not looked at.
const MOST_TRIED: usize = 4000;
/// Hits closer than this are one, pixels.
const COINCIDENT: f64 = 8.0;
/// A fan or point of more rays is a picture of all of them: none has its angles marked, or of a fan the middle one.
const FEW_RAYS: u32 = 5;
/// Below this angle of incidence there is nothing to see, degrees.
const SMALLEST: f64 = 1.5;
/// Angles that are this close are called equal, degrees.
const EQUAL: f64 = 0.05;

/// A hit, and what its marks tell. Directions are unit vectors of the figure.
pub(super) struct MarkedHit<'a> {
    pub(super) branch: &'a Branch<'a>,
    /// Where it is, pixels.
    pub(super) at: DVec2,
    /// The normal on the light's side.
    pub(super) normal: DVec2,
    /// Where the light comes from.
    pub(super) back: DVec2,
    /// Where the reflected light goes, if it is drawn.
    pub(super) reflected: Option<DVec2>,
    /// Where the transmitted light goes, if it is drawn and turned.
    pub(super) transmitted: Option<DVec2>,
    /// Along the boundary, the way that the light takes.
    pub(super) along: DVec2,
    /// Angle of incidence, degrees.
    pub(super) theta_1: f64,
    /// Angle of transmission, degrees.
    pub(super) theta_2: Option<f64>,
    /// Shares of the light that arrives, 0 to 1: reflected, transmitted.
    pub(super) shares: [f64; 2],
    /// What is remarkable about it.
    pub(super) case: Case,
}

/// What is remarkable about an angle of incidence. Angles in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Case {
    /// Nothing, at a boundary with this critical angle, if it has one.
    Plain(Option<f64>),
    /// Beyond the critical angle.
    Total(f64),
    /// At the critical angle.
    Critical,
    /// At Brewster's angle.
    Brewster,
    /// At a mirror.
    Mirror,
}

/// The hits that matter, those with the most light first, each place once.
pub(super) fn marked<'a>(figure: &'a Figure<'_>) -> Vec<MarkedHit<'a>> {
    let mut marked: Vec<MarkedHit<'a>> = Vec::new();
    let strongest = figure.branches.iter().rev().take(MOST_TRIED);
    for one in strongest.filter_map(|branch| marked_hit(figure, branch)) {
        let coincide = |other: &MarkedHit<'_>| (other.at - one.at).length() < COINCIDENT;
        if marked.len() < MOST && !marked.iter().any(coincide) {
            marked.push(one);
        }
    }
    marked
}

/// What is marked at the end of a branch, if it turns there.
fn marked_hit<'a>(figure: &Figure<'_>, branch: &'a Branch<'_>) -> Option<MarkedHit<'a>> {
    let (hit, to) = (branch.segment.hit?, branch.segment.to?);
    let at = figure.frame.place(to);
    let theta_1 = hit.theta_i_degrees();
    let is_part_of_fan = branch.fan.is_some();
    if !stands_for_its_source(figure, branch)
        || is_part_of_fan
        || theta_1 < SMALLEST
        || is_thin_lens(figure, &hit)
        || is_imaging(figure, branch)
    {
        return None;
    }
    let refracts = hit.n_t.is_some_and(|n_t| n_t.to_bits() != hit.n_i.to_bits());
    if !(refracts || hit.reflectance.total() > 0.0) || !figure.frame.area.contains(at) {
        return None;
    }
    let turn = |direction: DVec2| figure.frame.turn(direction).normalize_or_zero();
    let is_drawn = |share: f64| share * branch.share >= figure.scene.diagram.faintest && share > 0.0;
    let power = branch.segment.power;
    let is_reflected = is_drawn(hit.reflected_share(power));
    let is_transmitted = is_drawn(hit.transmitted_share(power)) && refracts;
    // Lines that part have angles of their own.
    let theta_2 = hit.theta_t_degrees().filter(|_| is_transmitted && branch.lines == 1);
    Some(MarkedHit {
        branch,
        at,
        normal: turn(hit.normal),
        back: turn(-branch.segment.direction),
        reflected: is_reflected.then(|| turn(hit.reflected())),
        transmitted: theta_2.and_then(|_| hit.transmitted().map(turn)),
        along: turn(hit.sin_i.signum() * hit.tangent()),
        theta_1,
        theta_2,
        shares: [hit.reflected_share(power), hit.transmitted_share(power)],
        case: case(&hit, theta_1, refracts),
    })
}

fn case(hit: &Hit, theta_1: f64, refracts: bool) -> Case {
    let Some(n_t) = hit.n_t else { return Case::Mirror };
    let critical = hit.critical_degrees();
    let is_at = |angle: f64| (theta_1 - angle).abs() < EQUAL;
    match critical {
        Some(critical) if is_at(critical) => Case::Critical,
        Some(critical) if hit.total_internal_reflection => Case::Total(critical),
        _ if is_at(atan2_degrees(n_t, hit.n_i)) && refracts => Case::Brewster,
        _ => Case::Plain(critical),
    }
}

/// Whether a ray's angles are worth marking among the others of its source: of parallel rays those of one, and none where
/// very many leave a point.
fn stands_for_its_source(figure: &Figure<'_>, branch: &Branch<'_>) -> bool {
    let middle = |rays: u32| branch.ray.ray == (rays.saturating_sub(1) / 2) as usize;
    match figure.scene.sources.get(branch.ray.source).map(|source| &source.light) {
        Some(Light::Beam { rays, .. }) => middle(*rays),
        Some(Light::Fan { rays, .. }) => *rays <= FEW_RAYS || middle(*rays),
        Some(Light::Point { rays, .. }) => *rays <= FEW_RAYS,
        Some(Light::Ray { .. } | Light::Object { .. }) | None => true,
    }
}

/// Whether a hit of an object's ray at what makes an image: there a ray is drawn by the focal points, not by angles. At a
/// flat mirror it is drawn by the law of reflection.
pub(super) fn is_imaging(figure: &Figure<'_>, branch: &Branch<'_>) -> bool {
    let is_object = figure.system.sources().get(branch.ray.source).is_some_and(|source| source.object.is_some());
    let body = branch.segment.hit.and_then(|hit| figure.scene.bodies.get(hit.body));
    let axis = body.filter(|_| is_object).and_then(Body::optical_axis);
    axis.is_some_and(|axis| axis.imaging != Imaging::FlatMirror)
}

/// Whether a hit is at an ideal lens.
pub(super) fn is_thin_lens(figure: &Figure<'_>, hit: &Hit) -> bool {
    let substance = figure.scene.bodies.get(hit.body).map(|body| &body.substance);
    matches!(substance, Some(Substance::Surface(Surface::ThinLens { .. })))
}
