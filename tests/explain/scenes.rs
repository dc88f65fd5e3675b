//! Solutions of scenes that have every kind of hit, and of all in `scenes/`.

use std::collections::BTreeSet;

use snellius::explain::{Explanation, Part, brightest, explain, latex, markdown, text};
use snellius::trace::SegmentId;

use crate::laws::faults;
use crate::page::{Solution, solutions};
use crate::support::{self, Run};

/// Branches of a ray, and rays of a scene, that are explained at most.
const MOST: usize = 24;

/// The brightest path of each source, and every end of some rays.
fn explanations(run: &Run) -> Vec<Explanation> {
    let rays = &run.trace.tree.rays;
    let mut branches = brightest(&run.trace.tree);
    for ray in rays.iter().step_by(rays.len().div_ceil(MOST).max(1)) {
        let parents: BTreeSet<SegmentId> = ray.segments.iter().filter_map(|segment| segment.parent).collect();
        let ends = ray.segments.iter().map(|segment| segment.id).filter(|id| !parents.contains(id));
        branches.extend(ends.take(MOST).map(|end| (ray, end)));
    }
    let explained = branches.into_iter().map(|(ray, end)| explain(&run.scene, &run.system, ray, end).unwrap());
    explained.collect()
}

fn printed(run: &Run) -> String {
    // A title would be read as a ray's if it began so.
    format!("\n{}", text(&explanations(run), Part::Worked))
}

fn assert_right(name: &str, run: &Run) -> Vec<Solution> {
    let text = printed(run);
    let solutions = solutions(&text);
    for solution in &solutions {
        let (faults, checked) = faults(solution);
        assert!(faults.is_empty(), "{name}: {}\n{}", solution.end, faults.join("\n"));
        assert!(checked > 10 * solution.hits.len(), "{name}: only {checked} results were looked at");
    }
    solutions
}

/// A scene of its own from its fields.
fn scene(fields: &str) -> Run {
    support::run_text(&format!("({fields})"))
}

fn headings(solutions: &[Solution]) -> String {
    let hits = solutions.iter().flat_map(|solution| &solution.hits);
    hits.map(|hit| hit.heading.as_str()).collect::<Vec<_>>().join("\n")
}

fn remarks(solutions: &[Solution], letter: &str) -> Vec<String> {
    let lines = solutions.iter().flat_map(|solution| &solution.hits).flat_map(|hit| &hit.lines);
    lines.filter(|line| line.letter == letter).map(|line| line.remark.clone()).collect()
}

#[test]
fn every_scene_of_the_collection() {
    let mut hits = 0;
    for name in support::scene_names() {
        hits += assert_right(&name, &support::run(&name)).iter().map(|solution| solution.hits.len()).sum::<usize>();
    }
    assert!(hits > 2500, "{hits}");
}

#[test]
fn refraction_and_total_reflection_in_a_prism() {
    let solutions = assert_right(
        "prism",
        &scene(
            r#"bodies: [(shape: Prism(apex_angle: 50, side: 30), rotate: 7, medium: Catalog("N-SF11"))],
            sources: [(light: Fan(from: (-30, -9), direction: Angle(13), spread: 7, rays: 1), polarization: S,
                       spectrum: Lines([486.1327, 587.5618, 656.2725]))]"#,
        ),
    );
    let signs = remarks(&solutions, "C2²");
    assert!(
        signs.contains(&String::new()) && signs.contains(&"negative: total internal reflection".into()),
        "{signs:?}"
    );
}

#[test]
fn at_the_critical_angle_itself() {
    // From n = 1.25, sin θ = 4/5 is critical.
    let solutions = assert_right(
        "critical",
        &scene(
            "surroundings: Index(1.25),
            bodies: [(shape: Rectangle(60, 20), at: (0, 10), medium: Index(1))],
            sources: [(light: Ray(from: (-8, -6), direction: Towards((0, 0))))]",
        ),
    );
    assert_eq!(remarks(&solutions, "C2²"), ["zero: the critical angle itself"; 2]);
    assert!(remarks(&solutions, "T")[0].starts_with("none: at the critical angle"));
}

#[test]
fn grazing_normal_and_nearly_normal_incidence() {
    for from in ["(-1000, 1e-3)", "(-30, 0)", "(-0.001, 30)"] {
        let fields = format!(
            "bodies: [(shape: Rectangle(20, 80), at: (10, 0), medium: Index(1.5))],
            sources: [(light: Ray(from: {from}, direction: Towards((0, 0))))]"
        );
        assert_right(from, &scene(&fields));
    }
}

#[test]
fn surfaces_of_every_kind() {
    let solutions = assert_right(
        "surfaces",
        &scene(
            r#"surroundings: Catalog("water"), bodies: [
                (shape: Rectangle(20, 60), at: (40, 0), medium: Catalog("N-BK7")),
                (name: "splitter", shape: Flat(from: (10, -20), to: (24, 20)), surface: BeamSplitter(reflect: 0.3, transmit: 0.6)),
                (name: "coat", shape: Flat(from: (50, -30), to: (50, 30)), surface: Mirror),
                (name: "wall", shape: Disk(200), surface: Screen),
                (name: "trap", shape: Flat(from: (-20, -40), to: (-20, -2)), surface: Absorber),
            ],
            sources: [(light: Fan(from: (-15, 1), direction: Angle(8), spread: 10, rays: 2), polarization: P),
                      (light: Ray(from: (-15, -4), direction: Angle(182)))]"#,
        ),
    );
    let headings = headings(&solutions);
    for kind in ["splitter, beam splitter", "coat, mirror", "wall, screen", "trap, absorber", "#0, face between"] {
        assert!(headings.contains(kind), "{kind} in\n{headings}");
    }
}

#[test]
fn a_beam_splitter_past_the_critical_angle() {
    let solutions = assert_right(
        "splitter",
        &scene(
            "bodies: [
                (shape: RightAnglePrism(40), medium: Index(1.5)),
                (shape: Flat(from: (40, 0), to: (0, 40)), surface: BeamSplitter(reflect: 0.25, transmit: 0.5)),
            ],
            sources: [(light: Ray(from: (-30, 10), direction: Angle(0)))]",
        ),
    );
    let remarks = remarks(&solutions, "k_r").join("\n");
    assert!(remarks.contains("what would be transmitted is reflected too"), "{remarks}");
}

#[test]
fn thin_lenses_in_one_medium_and_between_two() {
    let solutions = assert_right(
        "lenses",
        &scene(
            "bodies: [
                (shape: Rectangle(60, 60), at: (80, 0), medium: Index(1.5)),
                (name: \"on a face\", shape: Flat(from: (50, -30), to: (50, 30)), surface: ThinLens(focal_length: -35)),
                (name: \"free\", shape: Flat(from: (0, -30), to: (4, 30)), surface: ThinLens(focal_length: 40)),
            ],
            sources: [(light: Beam(center: (-60, 4), direction: Angle(3), width: 20, rays: 2))]",
        ),
    );
    let headings = headings(&solutions);
    assert!(
        headings.contains("free, ideal thin lens") && headings.contains("on a face, ideal thin lens"),
        "{headings}"
    );
}

#[test]
fn shares_set_by_the_scene() {
    for shares in ["Fixed(kr: 0.3, kt: 0.6)", "Fixed(kr: 0, kt: 0)", "TransmittedOnly"] {
        let fields = format!(
            "bodies: [(shape: Rectangle(20, 80), rotate: 30, medium: Index(1.5))],
            sources: [(light: Ray(from: (-30, 0), direction: Angle(5)))], trace: (secondary_rays: {shares})"
        );
        assert_right(shares, &scene(&fields));
    }
}

#[test]
fn far_from_the_origin_and_in_scenes_of_every_size() {
    for (size, offset) in [(1.0, 1e6), (1e-4, 0.0), (1e5, -3e7)] {
        let at = |x: f64, y: f64| format!("({}, {})", size * x + offset, size * y - offset);
        let fields = format!(
            "bodies: [
                (shape: Disk({}), at: {}, medium: Index(1.7)),
                (shape: Flat(from: {}, to: {}), surface: ThinLens(focal_length: {})),
            ],
            sources: [(light: Ray(from: {}, direction: Angle(0)))]",
            20.0 * size,
            at(0.0, 0.0),
            at(40.0, -60.0),
            at(41.0, 60.0),
            30.0 * size,
            at(-30.0, 7.0),
        );
        assert_right(&fields, &scene(&fields));
    }
}

/// The three forms say the same, and what TeX reads is well formed.
#[test]
fn markdown_and_latex_have_the_lines_of_the_text() {
    for name in support::scene_names() {
        let explanations = explanations(&support::run(&name));
        for part in [Part::Worked, Part::Worksheet, Part::Key] {
            let [text, markdown, latex] = [text, markdown, latex].map(|form| form(&explanations, part));
            let numbers = |form: &str, before: &str, after: char| -> Vec<String> {
                let items = form.lines().filter_map(|line| line.strip_prefix(before));
                items.map(|item| item.split(after).next().unwrap().to_owned()).collect()
            };
            assert_eq!(numbers(&markdown, "- **", '*'), numbers(&text, "  ", ' '), "{name}");
            assert_eq!(numbers(&latex, r"\item[", ']'), numbers(&text, "  ", ' '), "{name}");
            for line in latex.lines().chain(markdown.lines()) {
                let bare = line.replace(r"\$", "").replace(r"\{", "").replace(r"\}", "");
                assert_eq!(bare.matches('$').count() % 2, 0, "{name}: {line}");
                assert_eq!(bare.matches('{').count(), bare.matches('}').count(), "{name}: {line}");
                assert_eq!(bare.matches(r"\left(").count(), bare.matches(r"\right)").count(), "{name}: {line}");
            }
        }
    }
}

/// A result that is 5 units of its last digits off is told in nearly every line that works it out: the intervals are narrow.
#[test]
fn a_wrong_result_is_found() {
    let text = printed(&support::run("prisms/white-light"));
    assert!(solutions(&text).iter().all(|solution| faults(solution).0.is_empty()));
    let lines: Vec<&str> = text.lines().collect();
    let (mut planted, mut found) = (0, 0);
    for (at, line) in lines.iter().enumerate() {
        let Some(spoiled) = spoiled(line) else { continue };
        let mut lines = lines.clone();
        lines[at] = &spoiled;
        planted += 1;
        found += usize::from(solutions(&lines.join("\n")).iter().any(|solution| !faults(solution).0.is_empty()));
    }
    assert!(planted > 30 && found * 20 >= planted * 19, "{found} of {planted}");
}

/// A numbered line whose result's fifth digit is changed.
fn spoiled(line: &str) -> Option<String> {
    let (before, result) = line.strip_prefix("  ")?.rsplit_once(" = ")?;
    let digits: Vec<_> = result.match_indices(|c: char| c.is_ascii_digit()).skip_while(|(_, c)| *c == "0").collect();
    let (at, digit) = *digits.get(4)?;
    let other = (digit.parse::<u8>().ok()? + 5) % 10;
    Some(format!("  {before} = {}{other}{}", &result[..at], &result[at + 1..]))
}

/// What a worksheet gives in words is what the scene says.
#[test]
fn given_shares_are_those_of_the_scene() {
    let body = "(shape: Rectangle(20, 80), rotate: 30, medium: Index(1.5))";
    let splitter = "(shape: Flat(from: (0, -40), to: (9, 40)), surface: BeamSplitter(reflect: 0.3, transmit: 0.6))";
    let source = "sources: [(light: Ray(from: (-30, 0), direction: Angle(5)))]";
    for (fields, words) in [
        (format!("bodies: [{splitter}], {source}"), "The beam splitter reflects 0.3 and transmits 0.6."),
        (
            format!("bodies: [{body}], {source}, trace: (secondary_rays: Fixed(kr: 0.2, kt: 0.7))"),
            "The scene sets k_r to 0.2 and k_t to 0.7 where light is transmitted.",
        ),
    ] {
        for part in [Part::Worked, Part::Worksheet] {
            let text = text(&explanations(&scene(&fields)), part);
            assert!(text.contains(words), "{text}");
        }
    }
}
