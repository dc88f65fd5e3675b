//! What a scene may ask for, so that no file makes the program run away.

/// Smallest width and height of a figure, in pixels.
pub const MIN_PIXELS: u32 = 16;
/// Largest width and height of a figure, in pixels.
pub const MAX_PIXELS: u32 = 16_384;
/// Largest coordinate, length and radius other than `inf`, in scene units; squares of squares of it are still finite.
pub const MAX_LENGTH: f64 = 1e30;
/// Smallest length and radius above 0, in scene units.
pub const MIN_LENGTH: f64 = 1e-30;
/// Largest refractive index; the squares and fourth powers in the laws stay finite.
pub const MAX_INDEX: f64 = 1e6;

/// A resource that a scene takes, and of which it may take only so much.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Limit {
    /// Bytes of a scene's text.
    Bytes,
    /// Bodies in a scene.
    Bodies,
    /// Points of all outlines in a scene, one for every edge or arc; sides and facets count.
    Points,
    /// Sides of a regular polygon, and facets of a lens face.
    Sides,
    /// Sources in a scene.
    Sources,
    /// Objects in a scene.
    Objects,
    /// Rays of all sources, each counted once a spectral line.
    Rays,
    /// Spectral lines of one source.
    Lines,
    /// Refractive indices in a scene: its different media times its different spectral lines.
    Indices,
    /// Segments that are followed, the most that `max_segments` may be.
    Segments,
    /// Width times height of a figure, and of a PNG made of figures, in pixels.
    Pixels,
    /// Notes on a figure.
    Notes,
    /// Deviations marked in a figure.
    Deviations,
    /// Characters of a title, caption, name, label or note.
    Letters,
}

/// How many limits there are.
const COUNT: usize = Limit::ALL.len();

impl Limit {
    /// Every limit, in the order of the documentation.
    pub const ALL: [Self; 14] = [
        Self::Bytes,
        Self::Bodies,
        Self::Points,
        Self::Sides,
        Self::Sources,
        Self::Objects,
        Self::Rays,
        Self::Lines,
        Self::Indices,
        Self::Segments,
        Self::Pixels,
        Self::Notes,
        Self::Deviations,
        Self::Letters,
    ];

    /// The name on the command line, as in `--limit rays=20000000`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Bytes => "bytes",
            Self::Bodies => "bodies",
            Self::Points => "points",
            Self::Sides => "sides",
            Self::Sources => "sources",
            Self::Objects => "objects",
            Self::Rays => "rays",
            Self::Lines => "lines",
            Self::Indices => "indices",
            Self::Segments => "segments",
            Self::Pixels => "pixels",
            Self::Notes => "notes",
            Self::Deviations => "deviations",
            Self::Letters => "letters",
        }
    }

    /// The limit where nobody sets another: every command stays below some 4 GB of memory.
    #[must_use]
    pub const fn usual(self) -> u64 {
        match self {
            Self::Bytes => 64 << 20,
            Self::Bodies => 1_000_000,
            Self::Points | Self::Segments => 2_000_000,
            Self::Sides | Self::Sources => 100_000,
            Self::Objects | Self::Deviations => 100,
            Self::Rays => 4_000_000,
            Self::Lines | Self::Notes => 10_000,
            Self::Indices => 20_000_000,
            Self::Pixels => 150_000_000,
            Self::Letters => 1000,
        }
    }

    /// How far the limit can be raised: ids and counts have 32 bits.
    #[must_use]
    pub const fn highest(self) -> u64 {
        match self {
            Self::Segments => 1 << 31,
            _ => u32::MAX as u64,
        }
    }

    /// How to raise the limit, for the end of a problem's cure.
    pub(crate) fn cure(self) -> String {
        format!("`--limit {}=N` raises this limit (in Rust: `Limits`)", self.name())
    }
}

/// How much of every resource a scene may take.
///
/// ```
/// use snellius::scene::{Limit, Limits, load_within};
///
/// let text = "(sources: [(light: Point(at: (0, 0), rays: 5000000))])";
/// assert!(load_within(text, &Limits::default()).is_err());
/// assert!(load_within(text, &Limits::default().with(Limit::Rays, 5_000_000)).is_ok());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits([u64; COUNT]);

impl Default for Limits {
    /// Every limit at its [`usual`](Limit::usual) value.
    fn default() -> Self {
        Self(Limit::ALL.map(Limit::usual))
    }
}

impl Limits {
    /// The most that may be taken of something.
    #[must_use]
    pub fn of(&self, limit: Limit) -> u64 {
        self.0[limit as usize]
    }

    /// The same limits but for one, which is held within 1 and the [`highest`](Limit::highest) it can be.
    #[must_use]
    pub fn with(mut self, limit: Limit, most: u64) -> Self {
        self.0[limit as usize] = most.clamp(1, limit.highest());
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_limit_has_its_own_value_and_name() {
        for (k, limit) in Limit::ALL.into_iter().enumerate() {
            assert_eq!(limit as usize, k, "{limit:?} stands in its place");
            let raised = Limits::default().with(limit, limit.usual() + 1);
            for other in Limit::ALL {
                let most = other.usual() + u64::from(other == limit);
                assert_eq!(raised.of(other), most, "{other:?} where {limit:?} is raised");
                assert_eq!(other.name() == limit.name(), other == limit);
            }
            assert_eq!(raised.with(limit, u64::MAX).of(limit), limit.highest());
            assert_eq!(raised.with(limit, 0).of(limit), 1);
        }
    }
}
