//! Scenes of `scenes/lenses`.

use crate::Lesson;

pub const LESSONS: &[Lesson] = &[];
