use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::console::{Fault, Mistake, Status, reason};
use super::output::Target;
use super::progress;
use super::scene::{self, is_stdin, refuse_two_stdins};
use super::stats::{Stats, Stopwatch};
use crate::scene::{MAX_PIXELS, MIN_PIXELS};
use crate::trace::{self, Trace};
use crate::{diagram, render};

const MIN_SCALE: f32 = 0.1;
const MAX_SCALE: f32 = 16.0;

/// Draw scenes as ray diagrams.
///
/// Without -o or --out-dir every scene becomes one SVG in the current directory, under its own name. The path of every
/// file that was written is printed.
#[derive(Args)]
pub(super) struct Render {
    /// Scene files; '-' is standard input.
    #[arg(value_name = "SCENE", required = true)]
    scenes: Vec<PathBuf>,
    /// File to write, SVG or PNG by its extension; '-' is standard output. One scene, one format.
    #[arg(short, long, value_name = "FILE", conflicts_with = "out_dir")]
    output: Option<PathBuf>,
    /// Folder to write to, made if need be; every file is named after its scene.
    #[arg(long, value_name = "DIR")]
    out_dir: Option<PathBuf>,
    /// Forms of the picture, separated by commas [default: the extension of -o, else svg].
    #[arg(long, value_enum, value_delimiter = ',')]
    format: Vec<Format>,
    /// Width and height of the figure in pixels, such as 1280x720, in place of the scene's own.
    #[arg(long, value_name = "WIDTHxHEIGHT", value_parser = size)]
    size: Option<[u32; 2]>,
    /// Colors for a white page, a dark room or a black-and-white printer, in place of the scene's own.
    #[arg(long, value_enum)]
    theme: Option<Theme>,
    /// Pixels of a PNG to a pixel of the figure: 2 for screens with fine pixels.
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, value_parser = scale)]
    scale: f32,
    /// Draw no ground, for slides that have their own.
    #[arg(long)]
    transparent: bool,
    /// Draw the letters of an SVG as outlines, for where its font is missing; they are no text any more.
    #[arg(long)]
    outline_text: bool,
    /// Print on standard error what was done and what was skipped, where the light went, and the times.
    #[arg(long)]
    stats: bool,
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
enum Format {
    /// Scalable vector graphics.
    Svg,
    /// Pixels.
    Png,
}

impl Format {
    fn extension(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Png => "png",
        }
    }

    fn writing(self) -> &'static str {
        match self {
            Self::Svg => "writing svg",
            Self::Png => "writing png",
        }
    }

    fn of_extension(path: &Path) -> Option<Self> {
        let extension = path.extension()?;
        [Self::Svg, Self::Png].into_iter().find(|format| extension.eq_ignore_ascii_case(format.extension()))
    }
}

impl From<Theme> for crate::scene::Theme {
    fn from(theme: Theme) -> Self {
        match theme {
            Theme::Light => Self::Light,
            Theme::Dark => Self::Dark,
            Theme::Print => Self::Print,
        }
    }
}

/// One scene and the pictures to make of it.
struct Job<'a> {
    scene: &'a Path,
    pictures: Vec<(Target, Format)>,
}

impl Render {
    pub(super) fn run(&self) -> Result<Status, Mistake> {
        refuse_two_stdins(&self.scenes)?;
        let jobs = self.jobs()?;
        self.refuse_collisions(&jobs)?;
        if let Err(fault) = self.make_folder() {
            return Ok(Status::of(Err(fault)));
        }
        Ok(jobs.iter().fold(Status::Done, |status, job| status.and(Status::of(self.draw(job)))))
    }

    fn jobs(&self) -> Result<Vec<Job<'_>>, Mistake> {
        if let Some(output) = &self.output {
            let [scene] = self.scenes.as_slice() else {
                return Err(Mistake("several scenes cannot go to one file: use --out-dir instead of -o".into()));
            };
            return Ok(vec![Job { scene, pictures: vec![self.only_picture(output)?] }]);
        }
        let formats = if self.formats().is_empty() { vec![Format::Svg] } else { self.formats() };
        let folder = self.out_dir.as_deref().unwrap_or(Path::new(""));
        let picture = |scene: &Path, format| (Target::File(picture_path(folder, scene, format)), format);
        let job = |scene: &'_ PathBuf| formats.iter().map(|format| picture(scene, *format)).collect();
        Ok(self.scenes.iter().map(|scene| Job { scene, pictures: job(scene) }).collect())
    }

    /// The picture that `-o` asks for.
    fn only_picture(&self, output: &Path) -> Result<(Target, Format), Mistake> {
        let target = Target::from_argument(output);
        let format = match (self.formats().as_slice(), &target) {
            ([format], _) => Some(*format),
            ([], Target::Stdout) => Some(Format::Svg),
            ([], Target::File(path)) => Format::of_extension(path),
            _ => return Err(Mistake("several formats cannot go to one file: use --out-dir instead of -o".into())),
        };
        let unknown = || {
            Mistake(format!(
                "the extension of '{}' is neither svg nor png: name the form with --format",
                output.display()
            ))
        };
        Ok((target, format.ok_or_else(unknown)?))
    }

    /// The formats asked for, each once.
    fn formats(&self) -> Vec<Format> {
        let mut formats = self.format.clone();
        formats.sort_by_key(|format| *format as u8);
        formats.dedup();
        formats
    }

    /// Refuses two pictures in one file, and a picture in place of a scene.
    fn refuse_collisions(&self, jobs: &[Job]) -> Result<(), Mistake> {
        let mut taken = HashSet::new();
        for target in jobs.iter().flat_map(|job| &job.pictures).map(|(target, _)| target) {
            target.refuse_to_overwrite(&self.scenes)?;
            match target {
                Target::File(path) if !taken.insert(path) => {
                    return Err(Mistake(format!("two scenes would both be drawn to '{}'", path.display())));
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn make_folder(&self) -> Result<(), Fault> {
        let Some(folder) = &self.out_dir else { return Ok(()) };
        fs::create_dir_all(folder)
            .map_err(|error| Fault(format!("{}: cannot be made: {}", folder.display(), reason(&error))))
    }

    fn draw(&self, job: &Job) -> Result<(), Fault> {
        let mut watch = Stopwatch::start();
        let mut ready = scene::prepare(job.scene, &mut watch)?;
        let settings = &mut ready.scene.diagram;
        settings.size = self.size.unwrap_or(settings.size);
        settings.theme = self.theme.map_or(settings.theme, crate::scene::Theme::from);
        watch.begin("tracing");
        let Trace { tree, summary } = trace::trace_watched(&ready.system, &progress::count);
        ready.warn(diagram::problems(&ready.scene, &tree));
        watch.begin("drawing");
        let (mut drawing, figure) = diagram::draw_counted(&ready.scene, &ready.system, &tree);
        drawing.background = drawing.background.filter(|_| !self.transparent);
        for (target, format) in &job.pictures {
            watch.begin(format.writing());
            let bytes = match format {
                Format::Svg if self.outline_text => render::svg_outlined(&drawing).into_bytes(),
                Format::Svg => render::svg(&drawing).into_bytes(),
                Format::Png => render::png(&drawing, self.scale)
                    .map_err(|error| Fault(format!("{}: no picture: {error}", scene::name(job.scene))))?,
            };
            target.write(|out| out.write_all(&bytes))?;
            if let Target::File(path) = target {
                Target::Stdout.write(|out| writeln!(out, "{}", path.display()))?;
            }
        }
        if self.stats {
            Stats { system: &ready.system, summary: &summary, keeps_tree: true, figure: Some(figure) }
                .show(&scene::name(job.scene), &watch);
        }
        Ok(())
    }
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

/// Where the picture of a scene goes: under the scene's stem.
fn picture_path(folder: &Path, scene: &Path, format: Format) -> PathBuf {
    let stem = if is_stdin(scene) { None } else { scene.file_stem() };
    let mut name = stem.unwrap_or("stdin".as_ref()).to_os_string();
    name.push(".");
    name.push(format.extension());
    folder.join(name)
}
