//! The rays of sources: where each starts, where it heads, and what it stands in.

use glam::DVec2;

use crate::compile::arrangement::tolerance;
use crate::compile::effort::{Effort, Exhausted};
use crate::compile::interfaces::is_interface;
use crate::compile::region::Regions;
use crate::compile::runs::{NODES, Runs};
use crate::geometry::{Bounds, Curve, lies_on};
use crate::light::{Power, Wavelength};
use crate::media::Dispersion;
use crate::numerics::{Turn, cross, side};
use crate::scene::{Body, Direction, Light, Polarization, Source};
use crate::system::{Interface, MediumId, PlacedSource, RayStart, Start, VertexId};

/// What rays start among.
pub(crate) struct Ground<'a> {
    pub(crate) origin: DVec2,
    /// Boundaries between equal media too.
    pub(crate) walls: &'a [Interface],
    /// The walls between equal media, by their places.
    pub(crate) dropped: Vec<usize>,
    /// Runs of what the walls are pieces of, and the first wall of each.
    pub(crate) runs: &'a Runs,
    pub(crate) firsts: Vec<usize>,
    /// Distances below this are rounding.
    pub(crate) near: f64,
    pub(crate) regions: &'a Regions<'a>,
    pub(crate) surroundings: MediumId,
    pub(crate) bodies: &'a [Body],
    pub(crate) media: &'a [Dispersion],
    pub(crate) effort: &'a Effort,
}

/// The points that a source's rays start from.
pub(crate) fn first_points(light: &Light) -> Vec<DVec2> {
    match light {
        Light::Object { to, .. } => vec![*to],
        _ => rays(light, DVec2::ZERO).into_iter().map(|(from, _)| from).collect(),
    }
}

/// First points and unit directions of a source's rays, relative to `origin`; those of an object depend on what it faces.
fn rays(light: &Light, origin: DVec2) -> Vec<(DVec2, DVec2)> {
    match light {
        Light::Ray { from, direction } => vec![(*from - origin, heading(*from, *direction, 0.0))],
        Light::Beam { center, direction, width, rays } => {
            let ahead = heading(*center, *direction, 0.0);
            let start = |k: u32| *center - origin + fraction(k, *rays) * *width * ahead.perp();
            (0..*rays).map(|k| (start(k), ahead)).collect()
        }
        Light::Fan { from, direction, spread, rays } => {
            let turned = |k: u32| heading(*from, *direction, fraction(k, *rays) * spread);
            (0..*rays).map(|k| (*from - origin, turned(k))).collect()
        }
        Light::Point { at, rays } => {
            let angle = |k: u32| 360.0 * f64::from(k) / f64::from(*rays);
            (0..*rays).map(|k| (*at - origin, Turn::degrees(angle(k)).direction())).collect()
        }
        Light::Object { .. } => Vec::new(),
    }
}

/// Place of ray k of n between −1/2 and 1/2; 0 for a single ray.
fn fraction(k: u32, n: u32) -> f64 {
    if n > 1 { f64::from(k) / f64::from(n - 1) - 0.5 } else { 0.0 }
}

fn heading(from: DVec2, direction: Direction, turned: f64) -> DVec2 {
    match direction {
        Direction::Angle(degrees) => Turn::degrees(degrees + turned).direction(),
        Direction::Towards(point) => {
            let ahead = unit(point - from);
            if turned == 0.0 { ahead } else { unit(Turn::degrees(turned).apply(ahead)) }
        }
    }
}

/// The unit vector along `v`, whatever its magnitude; zero for zero. A component so small that its products with
/// coordinates would underflow is 0.
pub(crate) fn unit(v: DVec2) -> DVec2 {
    let scaled = v / v.abs().max_element();
    let unit = scaled / scaled.length();
    let unit = DVec2::select(unit.abs().cmplt(DVec2::splat(1e-200)), DVec2::ZERO, unit);
    if unit.is_finite() { unit } else { DVec2::ZERO }
}

impl Ground<'_> {
    /// Lays out the rays of a source.
    pub(crate) fn place(&self, number: usize, source: &Source) -> Result<PlacedSource, Exhausted> {
        let (rays, object) = match source.light {
            Light::Object { from, to } => {
                let (directions, object) = self.object(source, from, to).unzip();
                let rays = directions.unwrap_or_default().into_iter().map(|direction| (to - self.origin, direction));
                (rays.collect(), object)
            }
            _ => (rays(&source.light, self.origin), None),
        };
        let start = |(p, d)| self.effort.check(number).map(|()| self.start(p, d));
        let starts = rays.into_iter().map(start).collect::<Result<Vec<_>, _>>()?;
        let lines: Vec<_> = source.spectrum.lines().filter_map(Wavelength::from_nanometers).collect();
        #[expect(clippy::cast_precision_loss, reason = "ray counts are far below 2^53")]
        let power = source.power / (starts.len() as f64 * lines.len() as f64);
        let power = match source.polarization {
            Polarization::Unpolarized => Power::both(0.5 * power),
            Polarization::S => Power { s: power, p: 0.0 },
            Polarization::P => Power { s: 0.0, p: power },
        };
        Ok(PlacedSource { starts, lines, power, object })
    }

    /// The medium that a ray starts in, and the boundary it starts on and must not hit there.
    pub(crate) fn start(&self, from: DVec2, direction: DVec2) -> RayStart {
        let walls = self.walls_near(from);
        let (start, medium) = self
            .at_vertex(from, direction, &walls)
            .or_else(|| self.on_wall(from, direction, &walls))
            .unwrap_or_else(|| (Start::Free, self.medium_at(from, &walls)));
        RayStart { from, direction, medium, start }
    }

    /// The places of all walls that a ray may start on or beside, up to rounding, in order.
    fn walls_near(&self, p: DVec2) -> Vec<usize> {
        let mut places = Vec::new();
        let margin = self.near + tolerance(self.reach(p));
        let around = Bounds { min: p, max: p }.grown(margin);
        let nodes = self.runs.meeting(around, |run| places.extend(self.firsts[run]..self.firsts[run + 1]));
        self.effort.spend((places.len() + nodes) / NODES);
        places.sort_unstable();
        places
    }

    /// The medium of the last region that holds a point. Beside a wall, up to rounding, its own side decides: where others
    /// cut it, rounding bends it.
    fn medium_at(&self, p: DVec2, walls: &[usize]) -> MediumId {
        let beside = walls.iter().map(|k| &self.walls[*k]).filter(|wall| lies_on(&wall.curve, p, self.near));
        let nearest = beside.min_by(|u, v| u.curve.offset(p).abs().total_cmp(&v.curve.offset(p).abs()));
        if let Some(Interface { curve, left, right, .. }) = nearest {
            let turn = if curve.is_straight() { side(curve.a, curve.b, p) } else { curve.offset(p) };
            return if turn > 0.0 { *left } else { *right };
        }
        self.regions.at(p, self.effort).map_or(self.surroundings, |region| region.medium)
    }

    /// Largest absolute coordinate of a point, relative to the origin or in the scene.
    fn reach(&self, p: DVec2) -> f64 {
        p.abs().max((p + self.origin).abs()).max_element()
    }

    /// Distance within which a start is on a curve: a quarter of that within which two curves are one, since the start is
    /// as exact as it is given and only the curve's placement rounds, by some 4 units in the last place.
    fn contact(&self, from: DVec2, curve: &Curve) -> f64 {
        0.25 * tolerance([from, curve.a, curve.b].map(|p| self.reach(p)).into_iter().fold(0.0, f64::max))
    }

    fn on_wall(&self, from: DVec2, direction: DVec2, walls: &[usize]) -> Option<(Start, MediumId)> {
        let holds = |wall: &Interface| {
            let Interface { curve, .. } = wall;
            let is_on = curve.is_straight() && side(curve.a, curve.b, from) == 0.0 && lies_on(curve, from, self.near);
            is_on || lies_on(curve, from, self.contact(from, curve))
        };
        // An interface before a boundary that touches it between equal media.
        let interface = walls.iter().find(|k| is_interface(&self.walls[**k]) && holds(&self.walls[**k]));
        let place = *interface.or_else(|| walls.iter().find(|k| holds(&self.walls[**k])))?;
        let wall = &self.walls[place];
        let Interface { curve, left: on_left, right: on_right, .. } = wall;
        let rise = curve.normal_at(from).dot(direction);
        let left = if rise != 0.0 {
            rise > 0.0
        } else if curve.is_straight() {
            // Along the edge: the medium on the ray's own left.
            curve.tangent_at(from).dot(direction) > 0.0
        } else {
            curve.curvature < 0.0
        };
        let interface = place - self.dropped.partition_point(|dropped| *dropped < place);
        let start = if is_interface(wall) { Start::On { interface, left } } else { Start::Free };
        Some((start, if left { *on_left } else { *on_right }))
    }

    /// At a vertex the ray starts in the sector it heads into: on the counter-clockwise side of the interface that comes
    /// last before it, turning counter-clockwise.
    fn at_vertex(&self, from: DVec2, direction: DVec2, walls: &[usize]) -> Option<(Start, MediumId)> {
        let walls = || walls.iter().map(|k| &self.walls[*k]);
        let vertex = walls().find_map(|interface| {
            let ends = [(interface.curve.a, interface.ends[0]), (interface.curve.b, interface.ends[1])];
            let contact = self.contact(from, &interface.curve);
            ends.into_iter().find(|(p, _)| p.distance(from) <= contact).map(|(_, vertex)| vertex)
        })?;
        let near = self.near;
        let sectors = walls().flat_map(|interface| sectors(interface, vertex));
        let turned = sectors.map(|sector| (sector.turn_to(direction, near), sector));
        let before =
            turned.reduce(|first, second| if Sector::is_nearer(&second, &first, near) { second } else { first })?;
        Some((Start::AtVertex(vertex), before.1.medium))
    }
}

/// The way in which an interface leaves a vertex.
struct Sector {
    /// Unit direction.
    along: DVec2,
    /// How far the line or circle goes on: the edge's length, or the diameter.
    length: f64,
    /// Positive where it bends counter-clockwise.
    bend: f64,
    /// The medium on its counter-clockwise side.
    medium: MediumId,
}

impl Sector {
    /// A measure of the counter-clockwise angle to a ray, growing from 0 to 4 over the full turn. A ray along an edge, up to
    /// rounding, is on its left.
    fn turn_to(&self, direction: DVec2, near: f64) -> f64 {
        let (sin, cos) = (cross(self.along, direction), self.along.dot(direction));
        let is_along = cos > 0.0 && sin.abs() * self.length <= near;
        match (is_along, sin >= 0.0) {
            (true, _) if self.bend > 0.0 => 4.0,
            (true, _) => 0.0,
            (false, true) => 1.0 - cos / (sin + cos.abs()),
            (false, false) => 3.0 + cos / (cos.abs() - sin),
        }
    }

    /// Whether it is nearer to a ray than another, each with its turn to it; of two tangent ones that which bends more
    /// towards the ray.
    fn is_nearer((turn, sector): &(f64, Self), (other_turn, other): &(f64, Self), near: f64) -> bool {
        let tangent = (turn - other_turn).abs() * sector.length.min(other.length) <= near;
        if tangent { sector.bend > other.bend } else { turn < other_turn }
    }
}

/// The ways in which an interface leaves a vertex.
fn sectors(interface: &Interface, vertex: VertexId) -> Vec<Sector> {
    let Interface { curve, ends, left, right, .. } = interface;
    let length = if curve.is_straight() { curve.length() } else { 2.0 / curve.curvature.abs() };
    let mut sectors = Vec::new();
    if ends[0] == vertex {
        sectors.push(Sector { along: curve.tangent_at(curve.a), length, bend: curve.curvature, medium: *left });
    }
    if ends[1] == vertex {
        sectors.push(Sector { along: -curve.tangent_at(curve.b), length, bend: -curve.curvature, medium: *right });
    }
    sectors
}
