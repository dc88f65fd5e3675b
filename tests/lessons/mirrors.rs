//! Scenes of `scenes/mirrors`.

use crate::Lesson;

pub const LESSONS: &[Lesson] = &[];
