//! What a scene may ask for, so that no file makes the program run away.

/// Longest text of a scene, in bytes.
pub const MAX_TEXT_BYTES: usize = 64 << 20;
/// Most bodies in a scene.
pub const MAX_BODIES: usize = 1_000_000;
/// Most points of a polygon, steps of an outline, or surfaces of a lens group.
pub const MAX_POINTS: usize = 2_000_000;
/// Most sides of a regular polygon, and most facets of a lens face.
pub const MAX_SIDES: u32 = 100_000;
/// Most rays in a scene, each counted once per spectral line.
pub const MAX_RAYS: u64 = 10_000_000;
/// Most objects in a scene.
pub const MAX_OBJECTS: usize = 100;
/// Most spectral lines of a source.
pub const MAX_LINES: usize = 10_000;
/// Most segments that may be followed.
pub const MAX_SEGMENTS: u64 = 1_000_000_000;
/// Most notes on a figure.
pub const MAX_NOTES: usize = 10_000;
/// Most deviations marked in a figure.
pub const MAX_DEVIATIONS: usize = 100;
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
