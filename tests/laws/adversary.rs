//! Rays aimed where tracers leak, at whatever a scene offers: its vertices, seams, tangents, and corners where bodies meet.

use std::collections::BTreeMap;

use glam::DVec2;
use snellius::OpticalSystem;
use snellius::geometry::Curve;
use snellius::scene::{Direction, Light, Source};

use crate::scenes::{source, towards};
use crate::support::random::Random;

/// What a ray is aimed at; all but the last within an ulp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Aim {
    Vertex,
    /// From one end of a straight edge at the other.
    AlongEdge,
    /// At a point of an arc along its tangent there, from outside.
    Tangent,
    /// Where an edge goes over into an arc.
    Seam,
    /// Where boundaries of several bodies meet: cemented corners, touching vertices, crossings.
    Meeting,
    /// Through one vertex at another.
    TwoVertices,
    Anywhere,
}

pub(crate) const AIMS: [Aim; 7] =
    [Aim::Vertex, Aim::AlongEdge, Aim::Tangent, Aim::Seam, Aim::Meeting, Aim::TwoVertices, Aim::Anywhere];

/// The places of a scene that rays are aimed at, in scene coordinates.
pub(crate) struct Marks {
    curves: Vec<Curve>,
    edges: Vec<Curve>,
    arcs: Vec<Curve>,
    vertices: Vec<DVec2>,
    seams: Vec<DVec2>,
    meetings: Vec<DVec2>,
    size: f64,
}

impl Marks {
    pub(crate) fn new(system: &OpticalSystem) -> Self {
        let outlines = system.bodies().iter().flat_map(|body| &body.outlines);
        let curves: Vec<_> = outlines.flat_map(|outline| outline.curves.clone()).collect();
        let (edges, arcs): (Vec<_>, Vec<_>) = curves.iter().partition(|curve| curve.is_straight());
        let mut ends = BTreeMap::<_, Vec<_>>::new();
        for interface in system.interfaces() {
            let Curve { a, b, .. } = interface.curve;
            for (vertex, p) in interface.ends.into_iter().zip([a, b]) {
                ends.entry(vertex).or_default().push((p + system.origin(), interface.curve.is_straight()));
            }
        }
        let place = |here: &Vec<(DVec2, bool)>| here[0].0;
        let is_seam = |here: &&Vec<(DVec2, bool)>| here.iter().any(|end| end.1) && here.iter().any(|end| !end.1);
        Self {
            edges,
            arcs,
            vertices: ends.values().map(place).collect(),
            seams: ends.values().filter(is_seam).map(place).collect(),
            meetings: ends.values().filter(|here| here.len() > 2).map(place).collect(),
            size: curves.iter().map(|curve| curve.a.distance(curves[0].a)).fold(0.0, f64::max),
            curves,
        }
    }

    /// A ray and what it is aimed at; `None` where the scene has no such place, or the ray would start at it.
    pub(crate) fn ray(&self, random: &mut Random) -> Option<(Aim, Source)> {
        let aim = AIMS[random.below(AIMS.len())];
        let (from, to) = match aim {
            Aim::Vertex => (self.start(random)?, beside(random, &self.vertices)?),
            Aim::Seam => (self.start(random)?, beside(random, &self.seams)?),
            Aim::Meeting => (self.start(random)?, beside(random, &self.meetings)?),
            Aim::AlongEdge => {
                let edge = pick(random, &self.edges)?;
                let [from, to] = [[edge.a, edge.b], [edge.b, edge.a]][random.below(2)];
                (from.lerp(to, [0.0, -0.5, 0.5][random.below(3)]), random.beside_point(to))
            }
            Aim::Tangent => {
                let arc = pick(random, &self.arcs)?;
                let [first, second] = arc.halves();
                let at = [arc.a, arc.b, first.b, first.midpoint(), second.midpoint()][random.below(5)];
                let ahead = [1.0, -1.0][random.below(2)] * (0.1 + random.unit()) * self.size;
                (at - ahead * arc.tangent_at(at), random.beside_point(at))
            }
            Aim::TwoVertices => {
                let (u, v) = (pick(random, &self.vertices)?, pick(random, &self.vertices)?);
                (u + [0.25, 0.5, random.unit()][random.below(3)] * (u - v), random.beside_point(v))
            }
            Aim::Anywhere => {
                let from = self.start(random)?;
                return Some((aim, source(Light::Ray { from, direction: self.heading(random) })));
            }
        };
        (from != to).then(|| (aim, towards(from, to)))
    }

    /// On or an ulp beside a vertex, near one, on a curve's chord, inside of the scene or outside.
    fn start(&self, random: &mut Random) -> Option<DVec2> {
        let (first, second) = (pick(random, &self.curves)?, pick(random, &self.curves)?);
        Some(match random.below(7) {
            0 => beside(random, &self.vertices)?,
            1 => beside(random, &self.meetings).unwrap_or(first.a),
            2 => first.a.lerp(first.b, 1e-9 * random.unit()),
            3 => first.a.lerp(first.b, random.unit()),
            4 => first.a.lerp(second.b, 3.0 * random.unit() - 1.0),
            _ => first.a.lerp(second.b, 0.2 + 0.6 * random.unit()),
        })
    }

    /// Along a curve's tangent or anywhere.
    fn heading(&self, random: &mut Random) -> Direction {
        let along = self.curves[random.below(self.curves.len())];
        let tangent = along.tangent_at(along.a);
        let degrees = snellius::numerics::atan2_degrees(tangent.y, tangent.x);
        Direction::Angle([degrees, 360.0 * random.unit()][random.below(2)])
    }
}

fn beside(random: &mut Random, points: &[DVec2]) -> Option<DVec2> {
    let point = pick(random, points)?;
    Some(random.beside_point(point))
}

fn pick<T: Copy>(random: &mut Random, from: &[T]) -> Option<T> {
    (!from.is_empty()).then(|| from[random.below(from.len())])
}
