/// Room for words above and below the scene of a figure, pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Margins {
    /// Title and caption, with what is free above them.
    pub top: f64,
    /// Legend and the values of numbered hits.
    pub foot: f64,
}

impl Margins {
    /// Room for the words of both.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        Self { top: self.top.max(other.top), foot: self.foot.max(other.foot) }
    }
}
