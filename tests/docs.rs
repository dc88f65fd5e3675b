//! What README.md and docs/ show is true: scenes compile, command lines run, outputs are those of the program, and the
//! references name every word of the scene file and every field of the trace.
//!
//! - A block marked `ron` is a whole scene. If its first line is a comment like `// prism.ron`, the command lines of the
//!   same page find it under this name.
//! - A block marked `ron,fragment` is entries of `bodies`, of `sources`, or fields of a scene.
//! - A block marked `sh` holds command lines; they run one after the other in a folder of the page's own. A block marked
//!   `text` right after it shows what the last of them prints.
//! - A block marked `json` is the JSON trace of the page's scene, or a part of it, and one marked `csv` its first line.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test that cannot go on fails")]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::Value;
use snellius::scene::{self, DiagramSettings, Source, Spectrum, TraceSettings};
use snellius::trace::Ending;
use snellius::{Scene, compile};
use tempfile::TempDir;

const SCENE_FORMAT: &str = "docs/scene-format.md";
const TRACE_FORMAT: &str = "docs/trace-format.md";

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// A page of documentation.
struct Page {
    name: String,
    /// Its text without the blocks.
    prose: String,
    blocks: Vec<Block>,
}

/// A fenced block.
struct Block {
    line: usize,
    mark: String,
    text: String,
    /// Whether nothing but blank lines stands between it and the block before.
    follows: bool,
}

impl Page {
    fn read(name: &str) -> Self {
        let text = fs::read_to_string(root().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
        Self::parse(name, &text)
    }

    fn parse(name: &str, text: &str) -> Self {
        let mut page = Self { name: name.into(), prose: String::new(), blocks: Vec::new() };
        let mut open: Option<Block> = None;
        let mut follows = false;
        for (number, line) in text.lines().enumerate() {
            match (&mut open, line.strip_prefix("```")) {
                (None, Some(mark)) => {
                    let mark = mark.trim().to_owned();
                    open = Some(Block { line: number + 1, mark, text: String::new(), follows });
                }
                (Some(_), Some("")) => {
                    page.blocks.extend(open.take());
                    follows = true;
                }
                (Some(block), _) => block.text += &format!("{line}\n"),
                (None, None) => {
                    follows &= line.trim().is_empty();
                    page.prose += &format!("{line}\n");
                }
            }
        }
        assert!(open.is_none(), "{name}: a block never ends");
        page
    }

    fn marked<'a>(&'a self, mark: &'a str) -> impl Iterator<Item = &'a Block> {
        self.blocks.iter().filter(move |block| block.mark == mark)
    }

    fn place(&self, block: &Block) -> String {
        format!("{}:{}", self.name, block.line)
    }

    /// The words in inline code.
    fn code_words(&self) -> BTreeSet<String> {
        self.prose.lines().flat_map(|line| line.split('`').skip(1).step_by(2)).flat_map(words).collect()
    }

    /// The part under a heading of the second level.
    fn section(&self, heading: &str) -> &str {
        let start = self.prose.find(&format!("\n## {heading}\n")).unwrap_or_else(|| panic!("no section {heading}"));
        let rest = &self.prose[start + 1..];
        rest.find("\n## ").map_or(rest, |end| &rest[..end])
    }
}

/// README.md, if there is one, and everything in docs/.
fn pages() -> Vec<Page> {
    let mut names: Vec<String> = fs::read_dir(root().join("docs"))
        .unwrap()
        .map(|entry| format!("docs/{}", entry.unwrap().file_name().into_string().unwrap()))
        .filter(|name| Path::new(name).extension().is_some_and(|extension| extension == "md"))
        .collect();
    names.extend(Some("README.md".to_owned()).filter(|name| root().join(name).exists()));
    names.sort();
    names.iter().map(|name| Page::read(name)).collect()
}

fn words(text: &str) -> Vec<String> {
    let parts = text.split(|c: char| !(c.is_alphanumeric() || c == '_'));
    parts.filter(|word| !word.is_empty()).map(str::to_owned).collect()
}

/// The first cells of the tables in some text, without their backquotes; cells that are no inline code are left out.
fn first_cells(text: &str) -> Vec<&str> {
    text.lines().filter_map(|line| line.strip_prefix("| `")?.split('`').next()).collect()
}

// Scenes.

fn compiles(text: &str) -> Result<Scene, String> {
    let scene = Scene::from_ron(text).map_err(|problems| problems.to_string())?;
    let compiled = compile(&scene).map_err(|problems| problems.to_string())?;
    match compiled.warnings.first() {
        None => Ok(scene),
        Some(warning) => Err(warning.message.clone()),
    }
}

#[test]
fn every_scene_compiles() {
    for page in pages() {
        for block in page.marked("ron") {
            compiles(&block.text).unwrap_or_else(|problems| panic!("{}:\n{problems}", page.place(block)));
        }
    }
}

#[test]
fn every_fragment_is_part_of_a_scene() {
    for page in pages() {
        for block in page.marked("ron,fragment") {
            let text = &block.text;
            let scenes = [format!("(\n{text})"), format!("(bodies: [\n{text}])"), format!("(sources: [\n{text}])")];
            let tried: Vec<_> = scenes.iter().map(|scene| compiles(scene)).collect();
            assert!(tried.iter().any(Result::is_ok), "{}:\n{tried:#?}", page.place(block));
        }
    }
}

#[test]
fn every_block_has_a_known_mark() {
    for page in pages() {
        for block in &page.blocks {
            let known = ["ron", "ron,fragment", "sh", "text", "json", "csv", "rust", "toml", "math"];
            assert!(known.contains(&block.mark.as_str()), "{}: {}", page.place(block), block.mark);
        }
    }
}

// Command lines.

/// A folder with the named scenes of a page.
fn folder(page: &Page) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for block in page.marked("ron") {
        let name = block.text.lines().next().and_then(|line| line.strip_prefix("// "));
        if let Some(name) = name.filter(|name| name.ends_with(".ron") && !name.contains(' ')) {
            fs::write(folder.path().join(name), &block.text).unwrap();
        }
    }
    folder
}

/// What runs in a page's folder for a command line that it shows; `None` for one that is not this program's.
fn runnable(line: &str) -> Option<String> {
    let line = line.strip_prefix("$ ").unwrap_or(line);
    if line == "snellius" || line.starts_with("snellius ") {
        return Some(line.into());
    }
    // From the project's own folder: its scenes are meant.
    let (_, arguments) = line.strip_prefix("cargo run ")?.split_once("-- ")?;
    Some(format!("snellius {arguments}").replace(" scenes/", &format!(" {}/scenes/", root().display())))
}

/// Runs a command line and returns what it prints.
fn run(line: &str, folder: &Path) -> Result<String, String> {
    let program = Path::new(env!("CARGO_BIN_EXE_snellius"));
    let path = std::env::var("PATH").unwrap_or_default();
    let path = format!("{}:{path}", program.parent().unwrap().display());
    let mut command = Command::new("sh");
    command.args(["-c", line]).current_dir(folder).env("PATH", path).stdin(Stdio::null());
    let output = command.output().unwrap();
    let [stdout, stderr] = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    if output.status.success() { Ok(stdout) } else { Err(format!("{line}\n{stdout}{stderr}")) }
}

#[cfg(unix)]
#[test]
fn every_command_line_runs_and_prints_what_is_shown() {
    for page in pages() {
        let folder = folder(&page);
        let mut printed = String::new();
        for block in &page.blocks {
            match block.mark.as_str() {
                "sh" => {
                    let lines = block.text.lines().filter(|line| !line.trim().is_empty() && !line.starts_with('#'));
                    for line in lines {
                        let Some(line) = runnable(line) else {
                            assert!(line.starts_with("cargo ") || line.starts_with("git "), "{line}");
                            continue;
                        };
                        printed =
                            run(&line, folder.path()).unwrap_or_else(|error| panic!("{}: {error}", page.place(block)));
                    }
                }
                "text" if block.follows => assert_eq!(block.text, printed, "{}", page.place(block)),
                _ => {}
            }
        }
    }
}

// The scene file.

/// The names that the loader takes at a place: it lists them when it meets another one.
fn valid_names(probe: &str) -> Vec<String> {
    let problems = scene::load(probe).expect_err(probe);
    let list = problems.iter().find_map(|problem| problem.help.split_once("alid here: "));
    let (_, list) = list.unwrap_or_else(|| panic!("{probe}: {problems:?}"));
    words(list)
}

#[test]
fn the_reference_names_and_shows_every_word_of_the_format() {
    let page = Page::read(SCENE_FORMAT);
    let explained = page.code_words();
    let shown: BTreeSet<String> =
        page.blocks.iter().filter(|block| block.mark.starts_with("ron")).flat_map(|block| words(&block.text)).collect();
    let shapes =
        ["Lens(x: 0)", "Prism(x: 0)", "Outline(x: 0)", "LensGroup(x: 0)", "Flat(x: 0)", "Arc(x: 0)", "Stop(x: 0)"];
    let lights = ["Ray(x: 0)", "Beam(x: 0)", "Fan(x: 0)", "Point(x: 0)", "Ray(from: (0, 0), direction: X)"];
    let mut probes: Vec<String> = [
        "(x: 0)",
        "(surroundings: X)",
        "(surroundings: Sellmeier(x: 0))",
        "(bodies: [(x: 0)])",
        "(bodies: [(shape: X)])",
        "(bodies: [(shape: Outline(start: (0, 0), path: [X]))])",
        "(bodies: [(shape: Outline(start: (0, 0), path: [ArcTo(x: 0)]))])",
        "(bodies: [(shape: LensGroup(diameter: 1, surfaces: [(x: 0)]))])",
        "(bodies: [(surface: X)])",
        "(bodies: [(surface: BeamSplitter(x: 0))])",
        "(bodies: [(surface: ThinLens(x: 0))])",
        "(sources: [(x: 0)])",
        "(sources: [(light: X)])",
        "(sources: [(spectrum: X)])",
        "(sources: [(spectrum: White(x: 0))])",
        "(sources: [(polarization: X)])",
        "(trace: (x: 0))",
        "(trace: (secondary_rays: X))",
        "(trace: (secondary_rays: Fixed(x: 0)))",
        "(diagram: (x: 0))",
        "(diagram: (view: X))",
        "(diagram: (theme: X))",
        "(diagram: (color: X))",
        "(notes: [(x: 0)])",
    ]
    .map(str::to_owned)
    .to_vec();
    probes.extend(shapes.map(|shape| format!("(bodies: [(shape: {shape})])")));
    probes.extend(lights.map(|light| format!("(sources: [(light: {light})])")));
    for probe in probes {
        for name in valid_names(&probe) {
            assert!(explained.contains(&name), "`{name}` is not explained: {probe}");
            assert!(shown.contains(&name), "`{name}` is in no example: {probe}");
        }
    }
}

#[test]
fn the_reference_names_every_color() {
    let page = Page::read(SCENE_FORMAT);
    let problems = scene::load(r#"(bodies: [(shape: Disk(1), medium: Index(1), color: "x")])"#).unwrap_err();
    let help = &problems[0].help;
    let names: Vec<&str> = help.split('`').skip(1).step_by(2).collect();
    assert!(names.len() > 10, "{help}");
    for name in names {
        assert!(page.prose.contains(&format!("`{name}`")), "{name}");
    }
}

#[test]
fn the_reference_writes_out_every_default() {
    let page = Page::read(SCENE_FORMAT);
    let block = page.marked("ron").find(|block| block.text.starts_with("// every default")).unwrap();
    let scene = Scene::from_ron(&block.text).unwrap();
    assert_eq!(scene.trace, TraceSettings::default());
    assert_eq!(scene.diagram, DiagramSettings::default());
    assert_eq!(scene.surroundings, Scene::default().surroundings);
    let bare = "(bodies: [(shape: Rectangle(40, 20), medium: Index(1.5))],
        sources: [(light: Ray(from: (-30, 30), direction: Towards((-10, 10))))])";
    assert_eq!(scene, Scene::from_ron(bare).unwrap());
    let Source { spectrum, .. } = &scene.sources[0];
    assert_eq!(*spectrum, Spectrum::default());
    for setting in words(block.text.split_once("trace:").unwrap().1).into_iter().filter(|word| word.contains('_')) {
        assert!(page.prose.contains(&format!("| `{setting}` |")), "{setting} has no row");
    }
}

#[test]
fn the_reference_names_every_limit() {
    let page = Page::read(SCENE_FORMAT);
    let limits = page.section("Limits");
    let whole = [
        scene::MAX_TEXT_BYTES as u64,
        scene::MAX_BODIES as u64,
        scene::MAX_POINTS as u64,
        u64::from(scene::MAX_SIDES),
        scene::MAX_RAYS,
        scene::MAX_LINES as u64,
        scene::MAX_NOTES as u64,
    ];
    for limit in whole.map(grouped) {
        assert!(limits.contains(&format!("| {limit} ")), "{limit}");
    }
    for limit in [scene::MAX_LENGTH, scene::MIN_LENGTH] {
        assert!(limits.contains(&format!("{limit:e}")), "{limit:e}");
    }
    assert!(page.section("Trace").contains(&grouped(scene::MAX_SEGMENTS)));
    assert!(page.section("Diagram").contains(&format!("{} to {}", scene::MIN_PIXELS, scene::MAX_PIXELS)));
}

/// A number with a space between its thousands.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let first = digits.len() % 3;
    let (head, tail) = digits.split_at(first);
    let tail: Vec<&str> = (0..tail.len() / 3).map(|k| &tail[3 * k..3 * k + 3]).collect();
    format!("{head} {}", tail.join(" ")).trim().to_owned()
}

// The trace.

/// The JSON trace and the summary of the first scene of the page.
fn traces(page: &Page) -> [Value; 2] {
    let folder = folder(page);
    ["json", "summary"].map(|format| {
        let printed = run(&format!("snellius trace prism.ron --format {format}"), folder.path()).unwrap();
        serde_json::from_str(&printed).unwrap()
    })
}

/// Every field of a value, as a path such as `rays[].segments[].id`.
fn fields(value: &Value, path: &str, found: &mut BTreeSet<String>) {
    match value {
        Value::Object(map) => {
            for (name, value) in map {
                let path = if path.is_empty() { name.clone() } else { format!("{path}.{name}") };
                fields(value, &path, found);
                found.insert(path);
            }
        }
        Value::Array(list) => list.iter().for_each(|value| fields(value, &format!("{path}[]"), found)),
        _ => {}
    }
}

fn contains(whole: &Value, part: &Value) -> bool {
    whole == part
        || match whole {
            Value::Object(map) => map.values().any(|value| contains(value, part)),
            Value::Array(list) => list.iter().any(|value| contains(value, part)),
            _ => false,
        }
}

#[cfg(unix)]
#[test]
fn the_reference_names_the_fields_of_json_and_no_others() {
    let page = Page::read(TRACE_FORMAT);
    let mut named = BTreeSet::new();
    for part in page.section("JSON").split("\n### ").skip(1) {
        let heading = part.lines().next().unwrap();
        let path = heading.split('`').nth(1).map_or(String::new(), |path| format!("{path}."));
        named.extend(first_cells(part).iter().map(|field| format!("{path}{field}")));
    }
    let mut found = BTreeSet::new();
    fields(&traces(&page)[0], "", &mut found);
    assert_eq!(named, found);
}

#[cfg(unix)]
#[test]
fn json_that_is_shown_is_real() {
    let page = Page::read(TRACE_FORMAT);
    let real = traces(&page);
    let mut shown = 0;
    for block in page.marked("json") {
        let part: Value = serde_json::from_str(&block.text).unwrap();
        assert!(real.iter().any(|whole| contains(whole, &part)), "{}", page.place(block));
        shown += 1;
    }
    assert!(shown >= 2);
}

#[cfg(unix)]
#[test]
fn the_columns_of_csv_are_those_shown() {
    let page = Page::read(TRACE_FORMAT);
    let printed = run("snellius trace prism.ron --format csv", folder(&page).path()).unwrap();
    let block = page.marked("csv").next().unwrap();
    assert_eq!(printed.lines().next(), Some(block.text.trim_end()));
}

#[test]
fn the_reference_names_every_ending() {
    let page = Page::read(TRACE_FORMAT);
    let endings = [
        Ending::Interface,
        Ending::Absorbed,
        Ending::Detected,
        Ending::Escaped,
        Ending::CutMinPower,
        Ending::CutMaxDepth,
        Ending::CutMaxSegments,
    ];
    assert_eq!(first_cells(page.section("Endings")), endings.map(Ending::word));
}

#[test]
fn links_between_pages_lead_somewhere() {
    for page in pages() {
        let here = root().join(&page.name);
        let targets = page.prose.split("](").skip(1).filter_map(|rest| rest.split(')').next());
        for target in targets.filter(|target| !target.contains("://")) {
            let (file, heading) = target.split_once('#').unwrap_or((target, ""));
            let file = if file.is_empty() { here.clone() } else { here.parent().unwrap().join(file) };
            assert!(file.exists(), "{}: {target}", page.name);
            if !heading.is_empty() {
                let text = fs::read_to_string(&file).unwrap();
                assert!(text.lines().any(|line| anchor(line) == Some(heading.into())), "{}: {target}", page.name);
            }
        }
    }
}

/// The anchor of a heading.
fn anchor(line: &str) -> Option<String> {
    let words = line.strip_prefix('#')?.trim_start_matches('#').trim().to_lowercase();
    let kept = words.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    Some(kept.map(|c| if c == ' ' { '-' } else { c }).collect())
}
