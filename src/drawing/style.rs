use crate::drawing::Color;

/// How a line is drawn.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Stroke {
    /// Color.
    pub color: Color,
    /// Width in pixels.
    pub width: f64,
    /// 0 invisible to 1 solid.
    pub opacity: f64,
    /// Lengths of dashes and gaps in turn, pixels; empty is a solid line.
    pub dash: Vec<f64>,
    /// How ends look.
    pub cap: Cap,
}

/// How the ends of a line look.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Cap {
    /// Cut at the end point.
    Butt,
    /// Half a disk about the end point.
    Round,
}

/// How an area is filled; the rule is nonzero.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Fill {
    /// Color.
    pub color: Color,
    /// 0 invisible to 1 solid.
    pub opacity: f64,
}

impl Stroke {
    /// A solid opaque line with round ends.
    #[must_use]
    pub fn solid(color: Color, width: f64) -> Self {
        Self { color, width, opacity: 1.0, dash: Vec::new(), cap: Cap::Round }
    }

    /// The same with dashes, whose ends are cut.
    #[must_use]
    pub fn dashed(self, dash: &[f64]) -> Self {
        Self { dash: dash.to_vec(), cap: Cap::Butt, ..self }
    }

    /// The same with another opacity.
    #[must_use]
    pub fn faded(self, opacity: f64) -> Self {
        Self { opacity, ..self }
    }

    /// The same with another cap.
    #[must_use]
    pub fn capped(self, cap: Cap) -> Self {
        Self { cap, ..self }
    }
}

impl Fill {
    /// An opaque fill.
    #[must_use]
    pub fn solid(color: Color) -> Self {
        Self { color, opacity: 1.0 }
    }
}
