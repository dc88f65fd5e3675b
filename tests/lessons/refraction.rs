//! Scenes of `scenes/refraction`.

use crate::Lesson;

pub const LESSONS: &[Lesson] = &[];
