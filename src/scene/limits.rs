//! What a scene may ask for, so that no file makes the program run away.

/// Longest text of a scene, in bytes.
pub const MAX_TEXT_BYTES: usize = 64 << 20;
