use std::collections::HashSet;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use crate::cli::console::{Fault, Mistake, legible, tell};
use crate::cli::output::Target;
use crate::cli::stats::Stopwatch;
use crate::drawing::Drawing;
use crate::render;
use crate::scene::{self, DiagramSettings, MAX_PIXELS, MIN_PIXELS};

const MIN_SCALE: f32 = 0.1;
const MAX_SCALE: f32 = 16.0;

/// How pictures are made.
#[derive(Args)]
pub(super) struct Look {
    /// Width and height of the picture in pixels, such as 1280x720, in place of the scene's own.
    #[arg(long, value_name = "WIDTHxHEIGHT", value_parser = size)]
    pub(super) size: Option<[u32; 2]>,
    /// Colors for a white page, a dark room or a black-and-white printer, in place of the scene's own.
    #[arg(long, value_enum)]
    theme: Option<Theme>,
    /// Pixels of a PNG to a pixel of the figure: 2 for screens with fine pixels.
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, value_parser = scale)]
    scale: f32,
    /// Draw no ground, for slides that have their own.
    #[arg(long)]
    pub(super) transparent: bool,
    /// Draw the letters of an SVG as outlines, for where its font is missing; they are no text any more.
    #[arg(long)]
    outline_text: bool,
}

impl Look {
    /// Puts what is asked for in place of a scene's own settings, but for the size.
    pub(super) fn dress(&self, settings: &mut DiagramSettings) {
        settings.theme = match self.theme {
            None => settings.theme,
            Some(Theme::Light) => scene::Theme::Light,
            Some(Theme::Dark) => scene::Theme::Dark,
            Some(Theme::Print) => scene::Theme::Print,
        };
    }
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Theme {
    /// White ground.
    Light,
    /// Dark ground.
    Dark,
    /// White ground, black ink; dashes tell lines apart.
    Print,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// Scalable vector graphics.
    Svg,
    /// Pixels.
    Png,
    /// A page of vector graphics, for LaTeX; needs a build with the feature 'pdf'.
    Pdf,
}

impl Format {
    const ALL: [Self; 3] = [Self::Svg, Self::Png, Self::Pdf];

    pub(super) fn extension(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Png => "png",
            Self::Pdf => "pdf",
        }
    }

    fn writing(self) -> &'static str {
        match self {
            Self::Svg => "writing svg",
            Self::Png => "writing png",
            Self::Pdf => "writing pdf",
        }
    }

    pub(super) fn of_extension(path: &Path) -> Option<Self> {
        let extension = path.extension()?;
        Self::ALL.into_iter().find(|format| extension.eq_ignore_ascii_case(format.extension()))
    }

    /// Refuses what this build cannot write.
    pub(super) fn refuse_unknown(self) -> Result<(), Mistake> {
        if self == Self::Pdf && cfg!(not(feature = "pdf")) {
            let cure = "cargo install --path . --features pdf";
            return Err(Mistake(format!("this build writes no PDF; one that does: {cure}")));
        }
        Ok(())
    }
}

/// A picture to make.
pub(super) struct Picture {
    pub(super) target: Target,
    pub(super) format: Format,
}

impl Picture {
    /// The picture after the n-th step of a build-up, counted from 1 as overlays are.
    pub(super) fn of_step(&self, number: usize) -> Self {
        let target = match &self.target {
            Target::Stdout => Target::Stdout,
            Target::File(path) => {
                let mut name = path.file_stem().map(OsString::from).unwrap_or_default();
                name.push(format!("-{number}"));
                if let Some(extension) = path.extension() {
                    name.push(".");
                    name.push(extension);
                }
                Target::File(path.with_file_name(name))
            }
        };
        Self { target, format: self.format }
    }

    /// Writes a figure and prints the path of the file.
    pub(super) fn write(
        &self,
        drawing: &Drawing,
        look: &Look,
        scene: &str,
        watch: &mut Stopwatch,
    ) -> Result<(), Fault> {
        watch.begin(self.format.writing());
        let bytes = look.bytes(drawing, self.format, scene)?;
        self.target.write(|out| out.write_all(&bytes))?;
        self.target.announce()
    }
}

impl Look {
    fn bytes(&self, drawing: &Drawing, format: Format, scene: &str) -> Result<Vec<u8>, Fault> {
        let failed = |error| Fault(format!("{scene}: no picture: {error}"));
        match format {
            Format::Svg if self.outline_text => Ok(render::svg_outlined(drawing).into_bytes()),
            Format::Svg => Ok(render::svg(drawing).into_bytes()),
            Format::Png => render::png(drawing, self.scale).map_err(failed),
            #[cfg(feature = "pdf")]
            Format::Pdf => render::pdf(drawing).map_err(failed),
            #[cfg(not(feature = "pdf"))]
            Format::Pdf => Format::Pdf.refuse_unknown().map(|()| Vec::new()).map_err(|Mistake(why)| Fault(why)),
        }
    }
}

/// Warns of characters that the font of figures lacks.
pub(super) fn warn_of_missing_glyphs(drawing: &Drawing, scene: &str) {
    let missing = drawing.missing_glyphs();
    if missing.is_empty() {
        return;
    }
    let named = |c: &char| format!("'{}' (U+{:04X})", c.escape_debug(), u32::from(*c));
    let named: Vec<String> = missing.iter().map(named).collect();
    tell(format!(
        "{scene}: warning: DejaVu Sans, the font of figures, has no {}: a box stands in its place, in the text of an SVG \
         whatever the viewer has",
        named.join(", ")
    ));
}

/// Refuses two pictures in one file, and a picture in place of a scene.
pub(super) fn refuse_collisions<'a>(
    pictures: impl Iterator<Item = &'a Picture>,
    scenes: &[PathBuf],
) -> Result<(), Mistake> {
    let mut taken = HashSet::new();
    for Picture { target, .. } in pictures {
        target.refuse_to_overwrite(scenes)?;
        match target {
            Target::File(path) if !taken.insert(path) => {
                return Err(Mistake(format!("two scenes would both be drawn to '{}'", legible(path))));
            }
            _ => {}
        }
    }
    Ok(())
}

fn size(argument: &str) -> Result<[u32; 2], String> {
    let side = |side: &str| side.parse().ok().filter(|side| (MIN_PIXELS..=MAX_PIXELS).contains(side));
    let sides = argument.split_once(['x', '×']).and_then(|(width, height)| Some([side(width)?, side(height)?]));
    sides.ok_or_else(|| format!("two sides of {MIN_PIXELS} to {MAX_PIXELS} pixels are needed, such as 1280x720"))
}

fn scale(argument: &str) -> Result<f32, String> {
    let scale = argument.parse().ok().filter(|scale| (MIN_SCALE..=MAX_SCALE).contains(scale));
    scale.ok_or_else(|| format!("a number from {MIN_SCALE} to {MAX_SCALE} is needed, such as 2"))
}
