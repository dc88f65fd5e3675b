use clap::{Args, ValueEnum};

use super::console::Status;
use super::output::Target;

/// Print a commented scene to start from.
#[derive(Args)]
pub(super) struct New {
    /// What the scene is about.
    #[arg(value_enum)]
    template: Template,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Template {
    /// One ray and one block of glass: the smallest scene.
    Minimal,
    /// A glass prism that spreads white light into its colors.
    Prism,
    /// A lens that brings a parallel beam to a focus on a screen.
    Lens,
    /// Total internal reflection in a right-angle prism.
    Tir,
    /// A concave mirror, an aperture stop and a beam splitter.
    Mirror,
}

impl Template {
    fn text(self) -> &'static str {
        match self {
            Self::Minimal => include_str!("templates/minimal.ron"),
            Self::Prism => include_str!("templates/prism.ron"),
            Self::Lens => include_str!("templates/lens.ron"),
            Self::Tir => include_str!("templates/tir.ron"),
            Self::Mirror => include_str!("templates/mirror.ron"),
        }
    }
}

impl New {
    pub(super) fn run(&self) -> Status {
        Status::of(Target::Stdout.write(|out| out.write_all(self.template.text().as_bytes())))
    }
}
