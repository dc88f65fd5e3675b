//! From the arrangement's pieces to interfaces: the medium on each side, and what acts there.

use std::collections::BTreeMap;

use crate::compile::arrangement::{Boundary, Member, Piece};
use crate::compile::region::Region;
use crate::scene::Surface;
use crate::system::{Action, Interface, MediumId, VertexId};

/// What the interfaces of a scene are made from.
pub(crate) struct Sides<'a> {
    pub(crate) boundaries: &'a [Boundary],
    /// In painter's order.
    pub(crate) regions: &'a [Region],
    pub(crate) outlines: &'a [OutlineRole],
    pub(crate) surroundings: MediumId,
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
    pub(crate) fn walls(&self, pieces: &[Piece]) -> Vec<Interface> {
        let mut vertices = BTreeMap::new();
        let mut vertex = |point: usize| {
            let next = u32::try_from(vertices.len()).unwrap_or(u32::MAX);
            VertexId(*vertices.entry(point).or_insert(next))
        };
        pieces.iter().map(|piece| Interface { ends: piece.ends.map(&mut vertex), ..self.wall(piece) }).collect()
    }

    fn wall(&self, piece: &Piece) -> Interface {
        let (left, right) = (self.medium_beside(piece, true), self.medium_beside(piece, false));
        let surface = piece.members.iter().rev().find_map(|member| Some((member, self.surface_of(member)?)));
        let (action, body) = match surface {
            Some((member, surface)) => (self.action(surface, member, piece), self.role(member).body),
            None => (Action::Refract, piece.members.iter().map(|member| self.role(member).body).max().unwrap_or(0)),
        };
        Interface { curve: piece.curve, ends: [VertexId(0); 2], left, right, action, body }
    }

    /// The medium of the last region that holds the piece's left (or right) side.
    fn medium_beside(&self, piece: &Piece, left: bool) -> MediumId {
        let middle = piece.curve.midpoint();
        let holds = |region: &&Region| {
            let is_own = |member: &&Member| self.boundaries[member.boundary].outline == region.outline;
            let own: Vec<_> = piece.members.iter().filter(is_own).collect();
            match own[..] {
                // An outline that runs here there and back leaves both sides alike.
                [member, ..] if own.len() % 2 == 1 => (region.inside_left == member.forward) == left,
                _ => region.contains(middle),
            }
        };
        self.regions.iter().rev().find(holds).map_or(self.surroundings, |region| region.medium)
    }

    fn role(&self, member: &Member) -> OutlineRole {
        self.outlines[self.boundaries[member.boundary].outline]
    }

    fn surface_of(&self, member: &Member) -> Option<Surface> {
        self.role(member).surface
    }

    fn action(&self, surface: Surface, member: &Member, piece: &Piece) -> Action {
        let boundary = &self.boundaries[member.boundary];
        match surface {
            Surface::Mirror => Action::Mirror,
            Surface::Absorber => Action::Absorb,
            Surface::Screen => Action::Detect {
                along: boundary.along + boundary.curve.length_to(piece.curve.a),
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
