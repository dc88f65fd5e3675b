//! From the arrangement's pieces to interfaces: the medium on each side, and what acts there.

use std::ops::Range;

use glam::DVec2;

use crate::compile::arrangement::{Boundary, Member, Piece, Pieces};
use crate::compile::effort::{Effort, Exhausted};
use crate::compile::lists::Lists;
use crate::compile::region::{Region, Regions};
use crate::compile::runs::{NODES, Runs};
use crate::geometry::Curve;
use crate::numerics::excess_length;
use crate::scene::Surface;
use crate::system::{Action, Interface, MediumId, VertexId};

/// What the interfaces of a scene are made from.
pub(crate) struct Sides<'a> {
    pub(crate) boundaries: &'a [Boundary],
    pub(crate) runs: &'a Runs,
    pub(crate) neighbors: &'a Lists,
    pub(crate) regions: &'a Regions<'a>,
    pub(crate) outlines: &'a [OutlineRole],
    pub(crate) surroundings: MediumId,
    pub(crate) effort: &'a Effort,
}

/// What an outline is there for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OutlineRole {
    pub(crate) body: usize,
    /// What its boundary does; `None` where it is filled with a medium.
    pub(crate) surface: Option<Surface>,
    pub(crate) closed: bool,
}

/// Whether light changes at a wall: one between equal media that carries no surface is no interface.
pub(crate) fn is_interface(wall: &Interface) -> bool {
    wall.left != wall.right || wall.action != Action::Refract
}

impl Sides<'_> {
    /// The pieces with what lies on their sides, those between equal media too.
    pub(crate) fn walls(&self, pieces: &Pieces) -> Result<Vec<Interface>, Exhausted> {
        let mut vertices = Vertices::default();
        let mut nearby = Nearby { run: None, regions: Vec::new() };
        let mut wall = |(k, piece): (usize, &Piece)| {
            self.effort.check(piece.boundary)?;
            let curve = pieces.curve(self.boundaries, piece);
            self.find_regions(piece.boundary, &mut nearby);
            let [left, right] = self.media_beside(&pieces.members(k), curve.midpoint(), &nearby.regions);
            let (action, body) = self.role_of(pieces.members(k), &curve);
            let (ends, excess) = (piece.ends.map(|end| vertices.id(end)), excess_length(curve.n));
            Ok(Interface { curve, ends, left, right, excess, action, body })
        };
        pieces.list.iter().enumerate().map(&mut wall).collect()
    }

    /// Regions that may hold the sides of a boundary: those near its run.
    fn find_regions<'a>(&'a self, boundary: usize, nearby: &mut Nearby<'a>) {
        if nearby.run.as_ref().is_none_or(|run| !run.contains(&boundary)) {
            let run = self.runs.run_of(boundary);
            // Its box is larger than boundaries that coincide are apart.
            let near = (self.neighbors.of(run), self.runs.around()[run]);
            self.regions.near(near.0, near.1, &mut nearby.regions, self.effort);
            nearby.run = Some(self.runs.range(run));
        }
    }

    /// The media of the last regions that hold a piece's left side and its right one.
    fn media_beside(
        &self,
        members: &(impl Iterator<Item = Member> + Clone),
        middle: DVec2,
        regions: &[&Region],
    ) -> [MediumId; 2] {
        let (mut media, mut looked_at) = ([None; 2], 0);
        for region in regions {
            looked_at += 1;
            let mut own = members.clone().filter(|member| self.boundaries[member.boundary].outline == region.outline);
            let holds = match (own.next(), own.count() % 2) {
                (Some(Member { forward, .. }), 0) => [true, false].map(|left| (region.inside_left == forward) == left),
                // An outline that runs here there and back leaves both sides alike.
                _ => [region.contains(middle, self.effort); 2],
            };
            for (medium, holds) in media.iter_mut().zip(holds) {
                *medium = medium.or(holds.then_some(region.medium));
            }
            if media.iter().all(Option::is_some) {
                break;
            }
        }
        self.effort.spend(looked_at / NODES);
        media.map(|medium| medium.unwrap_or(self.surroundings))
    }

    /// What a piece does, and the body that a hit there names.
    fn role_of(&self, members: impl DoubleEndedIterator<Item = Member> + Clone, curve: &Curve) -> (Action, usize) {
        let surface = members.clone().rev().find_map(|member| Some((member, self.surface_of(&member)?)));
        match surface {
            Some((member, surface)) => (self.action(surface, &member, curve), self.role(&member).body),
            None => (Action::Refract, members.map(|member| self.role(&member).body).max().unwrap_or(0)),
        }
    }

    fn role(&self, member: &Member) -> OutlineRole {
        self.outlines[self.boundaries[member.boundary].outline]
    }

    fn surface_of(&self, member: &Member) -> Option<Surface> {
        self.role(member).surface
    }

    fn action(&self, surface: Surface, member: &Member, curve: &Curve) -> Action {
        let boundary = &self.boundaries[member.boundary];
        match surface {
            Surface::Mirror => Action::Mirror,
            Surface::Absorber => Action::Absorb,
            Surface::Screen => Action::Detect {
                along: boundary.along + boundary.curve.length_to(curve.a),
                sense: if member.forward { 1.0 } else { -1.0 },
                perimeter: self.role(member).closed.then(|| self.length(boundary.outline)),
            },
            Surface::BeamSplitter { reflect, transmit } => Action::Split { reflect, transmit },
            Surface::ThinLens { focal_length } => Action::ThinLens { center: boundary.curve.midpoint(), focal_length },
        }
    }

    /// Length of an outline, summed as positions along it are.
    fn length(&self, outline: usize) -> f64 {
        let end = self.boundaries.partition_point(|boundary| boundary.outline <= outline);
        self.boundaries[..end].last().map_or(0.0, |last| last.along + last.curve.length())
    }
}

/// The regions near a run of boundaries.
struct Nearby<'a> {
    run: Option<Range<usize>>,
    regions: Vec<&'a Region<'a>>,
}

/// Numbers of vertices, in the order of their first use.
#[derive(Default)]
struct Vertices {
    /// By point; `UNKNOWN` where there is none yet.
    ids: Vec<u32>,
    used: u32,
}

impl Vertices {
    const UNKNOWN: u32 = u32::MAX;

    fn id(&mut self, point: usize) -> VertexId {
        if point >= self.ids.len() {
            self.ids.resize((point + 1).max(2 * self.ids.len()), Self::UNKNOWN);
        }
        if self.ids[point] == Self::UNKNOWN {
            self.ids[point] = self.used;
            self.used += 1;
        }
        VertexId(self.ids[point])
    }
}
