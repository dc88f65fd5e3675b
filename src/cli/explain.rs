use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::console::{Fault, Mistake, Status};
use super::limits::Allowance;
use super::output::Target;
use super::progress;
use super::scene::{self, Ready};
use super::stats::{Stats, Stopwatch};
use crate::explain::{self, Explanation, Part};
use crate::trace::{self, RayTree, Trace};

/// Print the worked solution of a ray's path: at every hit the laws, with the numbers put in.
#[derive(Args)]
pub(super) struct Explain {
    /// Scene file; '-' is standard input.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// The branch SOURCE.RAY[@NM]:PATH, as 'snellius trace' shows it; without it, the brightest path of each source.
    #[arg(long, value_name = "ADDRESS")]
    ray: Option<String>,
    /// Form of the result; otherwise the extension of -o decides, and without one it is text.
    #[arg(long, value_enum)]
    format: Option<Format>,
    /// File to write; '-' is standard output.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Print a worksheet: what is given and the laws, with blanks for the results.
    #[arg(long, conflicts_with = "key")]
    blank: bool,
    /// Print the results alone, under the worksheet's numbers.
    #[arg(long)]
    key: bool,
    /// Print on standard error what was done and what was skipped, where the light went, and the times.
    #[arg(long)]
    stats: bool,
    #[command(flatten)]
    allowance: Allowance,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// Markdown, formulas in LaTeX between dollar signs.
    Markdown,
    /// A LaTeX document.
    Latex,
    /// Plain text, formulas in Unicode.
    Text,
}

impl Format {
    fn of_extension(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "md" | "markdown" => Some(Self::Markdown),
            "tex" => Some(Self::Latex),
            "txt" | "text" => Some(Self::Text),
            _ => None,
        }
    }

    fn write(self, mut out: &mut dyn Write, explanations: &[Explanation], part: Part) -> io::Result<()> {
        match self {
            Self::Markdown => explain::write_markdown(&mut out, explanations, part),
            Self::Latex => explain::write_latex(&mut out, explanations, part),
            Self::Text => explain::write_text(&mut out, explanations, part),
        }
    }
}

impl Explain {
    pub(super) fn run(&self) -> Result<Status, Mistake> {
        let target = self.output.as_deref().map_or(Target::Stdout, Target::from_argument);
        target.refuse_to_overwrite(std::slice::from_ref(&self.scene))?;
        let format = self.format(&target)?;
        let mut watch = Stopwatch::start();
        let ready = match scene::prepare(&self.scene, &self.allowance.limits(), &mut watch) {
            Ok(ready) => ready,
            Err(fault) => return Ok(Status::of(Err(fault))),
        };
        watch.begin("tracing");
        let Trace { tree, summary } = trace::trace_watched(&ready.system, &progress::count);
        ready.warn_of_light(&self.scene, Some(&tree));
        let explanations = self.explanations(&ready, &tree)?;
        if explanations.is_empty() {
            let name = scene::name(&self.scene);
            return Ok(Status::of(Err(Fault(format!("{name}: the scene has no source of light to explain a ray of")))));
        }
        watch.begin("writing");
        let status = Status::of(target.write(|out| format.write(out, &explanations, self.part())));
        if self.stats {
            Stats { system: &ready.system, summary: &summary, keeps_tree: true, figure: None }
                .show(&scene::name(&self.scene), &watch);
        }
        Ok(status)
    }

    fn format(&self, target: &Target) -> Result<Format, Mistake> {
        target.form(self.format, Format::Text, Format::of_extension, "md, tex and txt")
    }

    fn part(&self) -> Part {
        match (self.blank, self.key) {
            (true, _) => Part::Worksheet,
            (_, true) => Part::Key,
            _ => Part::Worked,
        }
    }

    fn explanations(&self, Ready { scene, system, .. }: &Ready, tree: &RayTree) -> Result<Vec<Explanation>, Mistake> {
        let branches = match &self.ray {
            Some(address) => {
                vec![explain::find(tree, address).map_err(|unknown| Mistake(unknown.to_string()))?]
            }
            None => explain::brightest(tree),
        };
        Ok(branches.into_iter().filter_map(|(ray, branch)| explain::explain(scene, system, ray, branch)).collect())
    }
}
