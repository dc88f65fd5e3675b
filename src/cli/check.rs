use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use serde::Serialize;

use super::console::{Fault, Mistake, Status, summarize};
use super::limits::Allowance;
use super::output::Target;
use super::scene::{self, Refusal, refuse_two_stdins};
use super::stats::Stopwatch;
use crate::characters::harmless;
use crate::scene::{Limits, LineSpan, Lines, Problem, Severity};

/// Check scenes and show every problem in them.
#[derive(Args)]
pub(super) struct Check {
    /// Scene files; '-' is standard input.
    #[arg(value_name = "SCENE", required = true)]
    scenes: Vec<PathBuf>,
    /// Form of the result.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    #[command(flatten)]
    allowance: Allowance,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// A line for each sound scene on standard output, problems on standard error.
    Text,
    /// One object with the problems of all scenes, for editors.
    Json,
}

impl Check {
    pub(super) fn run(&self) -> Result<Status, Mistake> {
        refuse_two_stdins(&self.scenes)?;
        let limits = self.allowance.limits();
        Ok(match self.format {
            Format::Text => {
                let fails = |path: &&Path| Status::of(check(path, &limits)) == Status::Fault;
                let failed: Vec<_> = self.scenes.iter().map(PathBuf::as_path).filter(fails).collect();
                summarize(&failed, self.scenes.len(), "")
            }
            Format::Json => self.report(&limits),
        })
    }

    fn report(&self, limits: &Limits) -> Status {
        let files = self.scenes.iter().map(|path| Checked::of(path, limits)).collect();
        let report = Report { schema: 1, files };
        let written = Target::Stdout.write(|mut out| {
            serde_json::to_writer_pretty(&mut out, &report)?;
            writeln!(out)
        });
        let status = Status::of(written);
        if report.files.iter().all(|file| file.ok) { status } else { Status::Fault }
    }
}

/// Every problem of a scene and its text; whether the scene can be used.
fn problems(path: &Path, limits: &Limits) -> Result<(Vec<Problem>, String), Refusal> {
    scene::load(path, limits, &mut Stopwatch::start()).map(|ready| {
        let light = ready.light_warnings(None);
        ([ready.warnings, light].concat(), ready.text)
    })
}

fn check(path: &Path, limits: &Limits) -> Result<(), Fault> {
    let (warnings, text) = problems(path, limits).map_err(|refusal| refusal.fault(path))?;
    scene::warn(&warnings, &text, path);
    let verdict = match warnings.len() {
        0 => "ok".into(),
        1 => "ok, 1 warning".into(),
        many => format!("ok, {many} warnings"),
    };
    Target::Stdout.write(|out| writeln!(out, "{}: {verdict}", scene::name(path)))
}

#[derive(Serialize)]
struct Report {
    schema: u32,
    files: Vec<Checked>,
}

#[derive(Serialize)]
struct Checked {
    file: String,
    /// Whether the scene can be used.
    ok: bool,
    problems: Vec<Shown>,
}

/// A problem in the words of the text form.
#[derive(Serialize)]
struct Shown {
    severity: &'static str,
    path: String,
    message: String,
    label: String,
    help: String,
    line: Option<usize>,
    column: Option<usize>,
    end_line: Option<usize>,
    end_column: Option<usize>,
    start_byte: Option<usize>,
    end_byte: Option<usize>,
}

impl Checked {
    fn of(path: &Path, limits: &Limits) -> Self {
        let file = scene::plain_name(path);
        let (problems, text) = match problems(path, limits) {
            Ok(found) => found,
            Err(Refusal::Problems(problems, text)) => (problems, text),
            Err(Refusal::Unread(why)) => (vec![Problem::error("", why, "")], String::new()),
        };
        let lines = Lines::new(&text);
        let ok = problems.iter().all(|problem| problem.severity == Severity::Warning);
        Self { file, ok, problems: problems.iter().map(|problem| Shown::of(problem, &lines)).collect() }
    }
}

impl Shown {
    fn of(problem: &Problem, lines: &Lines<'_>) -> Self {
        let place = problem.span.as_ref().and_then(|span| Some((span, lines.span(span)?)));
        let (span, place) = place.unzip();
        let of = |value: fn(&LineSpan) -> usize| place.as_ref().map(value);
        let text = |words: &str| harmless(words).into_owned();
        Self {
            severity: problem.severity.word(),
            path: text(&problem.path),
            message: text(&problem.message),
            label: text(&problem.label),
            help: text(&problem.help),
            line: of(|place| place.line),
            column: of(|place| place.column),
            end_line: of(|place| place.end_line),
            end_column: of(|place| place.end_column),
            start_byte: span.map(|span| span.start),
            end_byte: span.map(|span| span.end),
        }
    }
}
