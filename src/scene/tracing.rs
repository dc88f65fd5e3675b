/// How far rays are followed, and what their secondary rays carry.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct TraceSettings {
    /// How a hit shares power between reflected and transmitted ray.
    pub secondary_rays: SecondaryRays,
    /// A segment with this many hits behind it is not followed; at least 1.
    pub max_depth: u32,
    /// A segment below this share of its ray's and line's starting power is not followed; 0 ≤ m < 1.
    pub min_power: f64,
    /// Number of segments followed in the whole scene.
    pub max_segments: u64,
}

impl Default for TraceSettings {
    fn default() -> Self {
        Self { secondary_rays: SecondaryRays::Fresnel, max_depth: 32, min_power: 1e-3, max_segments: 1_000_000 }
    }
}

/// How a hit on the face between two media shares power; [`Shares`](crate::laws::Shares) are what comes of it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SecondaryRays {
    /// The Fresnel equations, s and p apart.
    Fresnel,
    /// The constants of c = c_local + k_r c_r + k_t c_t; the share 1 − k_r − k_t stays at the hit.
    Fixed {
        /// Reflected share k_r, 0 to 1.
        kr: f64,
        /// Transmitted share k_t, 0 to 1 − k_r.
        kt: f64,
    },
    /// The transmitted ray carries everything; past the critical angle the reflected one does.
    TransmittedOnly,
}
