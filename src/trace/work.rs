use crate::trace::Ending;

/// What a trace took, and what it could leave out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Work {
    /// Segments followed to their ends, as `max_segments` counts them: one that looks at thousands of nodes of the search tree counts
    /// as several.
    pub followed: u64,
    /// Of these, segments at lines that take the way of another line and were not traced again.
    pub spared: u64,
    /// Hits for which Fresnel's equations were evaluated.
    pub fresnel: u64,
    /// Nodes of the search tree looked at; 0 where a scene is so small that it has none.
    pub nodes: u64,
    /// Segments by how they ended.
    pub(crate) ended: [u64; 7],
    /// Whether light met a medium whose index changes with the wavelength.
    pub(crate) disperses: bool,
}

impl Work {
    /// How many segments ended in a way.
    #[must_use]
    pub fn ended(&self, ending: Ending) -> u64 {
        self.ended[ending as usize]
    }

    /// Segments that met an interface.
    #[must_use]
    pub fn hits(&self) -> u64 {
        [Ending::Interface, Ending::Absorbed, Ending::Detected].map(|ending| self.ended(ending)).iter().sum()
    }

    /// Adds the work of another ray.
    pub(crate) fn add(&mut self, other: &Self) {
        self.followed += other.followed;
        self.spared += other.spared;
        self.fresnel += other.fresnel;
        self.nodes += other.nodes;
        self.disperses |= other.disperses;
        for (sum, more) in self.ended.iter_mut().zip(other.ended) {
            *sum += more;
        }
    }

    /// That of the same ray again without the work.
    pub(crate) fn spared(&self) -> Self {
        Self { spared: self.followed, fresnel: 0, nodes: 0, ..*self }
    }
}
