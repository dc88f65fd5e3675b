//! What a scene must fulfil beyond its form, the same for files and for scenes built in Rust.

use crate::scene::{Problem, Scene};

/// The numbers that entries have in their file, where some before them could not be read.
#[derive(Clone, Debug, Default)]
pub(super) struct Numbering {
    pub(super) bodies: Vec<usize>,
    pub(super) sources: Vec<usize>,
    pub(super) notes: Vec<usize>,
}

/// All problems of a scene, by path.
pub(super) fn check_scene(_scene: &Scene, _numbering: &Numbering) -> Vec<Problem> {
    Vec::new()
}
