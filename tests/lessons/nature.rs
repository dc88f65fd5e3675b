//! Scenes of `scenes/nature`.

use crate::Lesson;

pub const LESSONS: &[Lesson] = &[];
