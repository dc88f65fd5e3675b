//! Scenes of `scenes/total-reflection`.

use crate::Lesson;

pub const LESSONS: &[Lesson] = &[];
