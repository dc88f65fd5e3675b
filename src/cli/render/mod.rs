//! `render`: figures of scenes, one by one, step by step, or side by side.

mod panels;
mod picture;

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;

use super::console::{Fault, Mistake, Status, legible, reason, summarize};
use super::output::Target;
use super::progress;
use super::scene::{self, Ready, is_stdin, refuse_two_stdins};
use super::stats::{Stats, Stopwatch};
use crate::diagram::{self, Margins, Statistics};
use crate::drawing::Drawing;
use crate::trace::{self, Trace};

use picture::{Format, Look, Picture, refuse_collisions, warn_of_missing_glyphs};

/// Draw scenes as ray diagrams.
///
/// Without -o or --out-dir every scene becomes one SVG in the current directory, under its own name. The path of every
/// file that was written is printed.
#[derive(Args)]
pub(super) struct Render {
    /// Scene files; '-' is standard input.
    #[arg(value_name = "SCENE", required = true)]
    scenes: Vec<PathBuf>,
    /// File to write, SVG, PNG or PDF by its extension; '-' is standard output. One scene, one format.
    #[arg(short, long, value_name = "FILE", conflicts_with = "out_dir")]
    output: Option<PathBuf>,
    /// Folder to write to, made if need be; every file is named after its scene.
    #[arg(long, value_name = "DIR")]
    out_dir: Option<PathBuf>,
    /// Forms of the picture, separated by commas [default: the extension of -o, else svg].
    #[arg(long, value_enum, value_delimiter = ',')]
    format: Vec<Format>,
    /// Write a picture for every step of the light from hit to hit, NAME-1, NAME-2 and so on; the last one is whole.
    #[arg(long, conflicts_with = "panels")]
    steps: bool,
    /// Put all scenes side by side into one picture, named 'panels' unless -o names it.
    #[arg(long)]
    panels: bool,
    #[command(flatten)]
    look: Look,
    /// Print on standard error what was done and what was skipped, where the light went, and the times.
    #[arg(long)]
    stats: bool,
}

/// One scene and the pictures to make of it.
struct Job<'a> {
    scene: &'a Path,
    pictures: Vec<Picture>,
}

/// A scene and where its light goes.
struct Traced {
    ready: Ready,
    trace: Trace,
}

impl Traced {
    fn of(scene: &Path, look: &Look, watch: &mut Stopwatch) -> Result<Self, Fault> {
        let mut ready = scene::prepare(scene, &look.allowance.limits(), watch)?;
        look.dress(&mut ready.scene.diagram);
        watch.begin("tracing");
        let trace = trace::trace_watched(&ready.system, &progress::count);
        ready.warn_of_light(scene, Some(&trace.tree));
        Ok(Self { ready, trace })
    }
}

impl Render {
    pub(super) fn run(&self) -> Result<Status, Mistake> {
        refuse_two_stdins(&self.scenes)?;
        self.look.refuse_size()?;
        if self.panels {
            let pictures = self.pictures("panels".as_ref())?;
            refuse_collisions(pictures.iter(), &self.scenes)?;
            return match self.make_folder() {
                Err(fault) => Ok(Status::of(Err(fault))),
                Ok(()) => self.draw_panels(&pictures),
            };
        }
        let jobs = self.jobs()?;
        refuse_collisions(jobs.iter().flat_map(|job| &job.pictures), &self.scenes)?;
        if let Err(fault) = self.make_folder() {
            return Ok(Status::of(Err(fault)));
        }
        let fails = |job: &&Job| Status::of(self.draw(job)) == Status::Fault;
        let failed: Vec<_> = jobs.iter().filter(fails).map(|job| job.scene).collect();
        Ok(summarize(&failed, jobs.len(), ""))
    }

    fn jobs(&self) -> Result<Vec<Job<'_>>, Mistake> {
        if self.output.is_some() && self.scenes.len() > 1 {
            return Err(Mistake(
                "several scenes cannot go to one file: use --out-dir instead of -o, or --panels".into(),
            ));
        }
        self.scenes.iter().map(|scene| Ok(Job { scene, pictures: self.pictures(stem(scene))? })).collect()
    }

    /// The pictures of one figure, which have this name unless `-o` gives another.
    fn pictures(&self, name: &OsStr) -> Result<Vec<Picture>, Mistake> {
        let pictures = match &self.output {
            Some(output) => vec![self.only_picture(output)?],
            None => {
                let formats = if self.formats().is_empty() { vec![Format::Svg] } else { self.formats() };
                let folder = self.out_dir.as_deref().unwrap_or(Path::new(""));
                let picture = |format| Picture { target: Target::File(picture_path(folder, name, format)), format };
                formats.into_iter().map(picture).collect()
            }
        };
        pictures.iter().try_for_each(|picture| picture.format.refuse_unknown())?;
        Ok(pictures)
    }

    /// The picture that `-o` asks for.
    fn only_picture(&self, output: &Path) -> Result<Picture, Mistake> {
        let target = Target::from_argument(output);
        if self.steps && target == Target::Stdout {
            return Err(Mistake("the pictures of --steps cannot all go to standard output".into()));
        }
        let format = match (self.formats().as_slice(), &target) {
            ([format], _) => Some(*format),
            ([], Target::Stdout) => Some(Format::Svg),
            ([], Target::File(path)) => Format::of_extension(path),
            _ => return Err(Mistake("several formats cannot go to one file: use --out-dir instead of -o".into())),
        };
        let unknown = || {
            let output = legible(output);
            Mistake(format!("the extension of '{output}' is none of svg, png and pdf: name the form with --format"))
        };
        Ok(Picture { target, format: format.ok_or_else(unknown)? })
    }

    /// The formats asked for, each once.
    fn formats(&self) -> Vec<Format> {
        let mut formats = self.format.clone();
        formats.sort_by_key(|format| *format as u8);
        formats.dedup();
        formats
    }

    fn make_folder(&self) -> Result<(), Fault> {
        let Some(folder) = &self.out_dir else { return Ok(()) };
        fs::create_dir_all(folder)
            .map_err(|error| Fault(format!("{}: cannot be made: {}", legible(folder), reason(&error))))
    }

    fn draw(&self, job: &Job) -> Result<(), Fault> {
        let mut watch = Stopwatch::start();
        let mut traced = Traced::of(job.scene, &self.look, &mut watch)?;
        let size = &mut traced.ready.scene.diagram.size;
        *size = self.look.size.unwrap_or(*size);
        watch.begin("drawing");
        let (drawing, figure) = self.figure(&traced, Margins::default());
        let name = scene::name(job.scene);
        warn_of_missing_glyphs(&drawing, &name);
        if self.steps {
            self.write_steps(job, &drawing, figure, &mut watch)?;
        } else {
            let write = |picture: &Picture| picture.write(&drawing, &self.look, &name, &mut watch);
            job.pictures.iter().try_for_each(write)?;
        }
        self.show_stats(job.scene, &traced, figure, &watch);
        Ok(())
    }

    /// A figure as it is asked for.
    fn figure(&self, traced: &Traced, margins: Margins) -> (Drawing, Statistics) {
        let Traced { ready, trace } = traced;
        let (drawing, figure) = diagram::draw_within(&ready.scene, &ready.system, &trace.tree, margins);
        let background = drawing.background.filter(|_| !self.look.transparent);
        (Drawing { background, ..drawing }, figure)
    }

    /// A picture for every step of a build-up, which have all the places of the whole figure.
    fn write_steps(
        &self,
        job: &Job,
        drawing: &Drawing,
        figure: Statistics,
        watch: &mut Stopwatch,
    ) -> Result<(), Fault> {
        let name = scene::name(job.scene);
        let mut steps = drawing.steps();
        if steps.is_empty() && figure.segments_drawn > 0 {
            return Err(Fault(format!(
                "{name}: no steps: this figure has so many branches that they are not told apart; fewer rays or a larger \
                 'faintest' leave fewer"
            )));
        }
        if steps.is_empty() {
            // Without light there is nothing to build up.
            steps.insert(0);
        }
        let numbered = (1..).zip(steps);
        let pictures = numbered.flat_map(|(number, step)| job.pictures.iter().map(move |p| (step, p.of_step(number))));
        let pictures: Vec<(u32, Picture)> = pictures.collect();
        refuse_collisions(pictures.iter().map(|(_, picture)| picture), &self.scenes)
            .map_err(|Mistake(why)| Fault(why))?;
        pictures.iter().try_for_each(|(step, picture)| picture.write(&drawing.up_to(*step), &self.look, &name, watch))
    }

    fn show_stats(&self, scene: &Path, traced: &Traced, figure: Statistics, watch: &Stopwatch) {
        if self.stats {
            let Traced { ready, trace } = traced;
            Stats { system: &ready.system, summary: &trace.summary, keeps_tree: true, figure: Some(figure) }
                .show(&scene::name(scene), watch);
        }
    }
}

/// What the pictures of a scene are named after.
fn stem(scene: &Path) -> &OsStr {
    scene.file_stem().filter(|_| !is_stdin(scene)).unwrap_or("stdin".as_ref())
}

/// Where a picture of some name goes.
fn picture_path(folder: &Path, name: &OsStr, format: Format) -> PathBuf {
    let mut name = name.to_os_string();
    name.push(".");
    name.push(format.extension());
    folder.join(name)
}
