//! Scenes of `scenes/prisms`.

use crate::Lesson;

pub const LESSONS: &[Lesson] = &[];
