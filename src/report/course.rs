use serde::Serialize;

use super::number::Number;
use crate::trace::Segment;

/// What a segment carries on its way and how that ends: the same fields in every form of the trace.
#[derive(Serialize)]
pub(super) struct Course {
    medium_index: Number,
    power: Number,
    power_s: Number,
    power_p: Number,
    optical_path: Number,
    ending: &'static str,
}

impl Course {
    pub(super) fn new(segment: &Segment) -> Self {
        Self {
            medium_index: Number(segment.medium_index),
            power: Number(segment.power.total()),
            power_s: Number(segment.power.s),
            power_p: Number(segment.power.p),
            optical_path: Number(segment.optical_path),
            ending: segment.ending.word(),
        }
    }
}
