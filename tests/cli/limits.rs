//! What a scene may take: refused before memory is taken, and raised on the command line.

use std::fmt::Write as _;

use snellius::scene::{Limit, Limits, Problem, load_within};

use crate::place::Place;
#[cfg(target_os = "linux")]
use crate::place::Run;

/// A scene that takes as many of something as `n`, and one more than that.
fn taking(limit: Limit, n: u64) -> String {
    let times = |part: &str| part.repeat(usize::try_from(n).unwrap());
    let words = |count: u64| "é".repeat(usize::try_from(count).unwrap());
    match limit {
        Limit::Bytes => format!("(){}", " ".repeat(usize::try_from(n - 2).unwrap())),
        Limit::Bodies => format!("(bodies: [{}])", times("(shape: Disk(1), surface: Mirror),")),
        Limit::Points => {
            let points: String = (0..n - 9).map(|k| format!("({k}, {}),", k * k)).collect();
            let lens = "Lens(radii: (9, -9), thickness: 2, diameter: 4, facets: 2)";
            format!(
                "(bodies: [(shape: {lens}, surface: Mirror), (shape: RegularPolygon(3, 1), surface: Mirror), \
                     (shape: Polygon([{points}]), surface: Mirror)])"
            )
        }
        Limit::Sides => format!("(bodies: [(shape: RegularPolygon({n}, 1), surface: Mirror)])"),
        Limit::Sources => format!("(sources: [{}])", times("(light: Point(at: (0, 0), rays: 1)),")),
        Limit::Objects => {
            let lens = "(shape: Flat(from: (0, -9), to: (0, 9)), surface: ThinLens(focal_length: 2))";
            format!("(bodies: [{lens}], sources: [{}])", times("(light: Object(from: (-5, 0), to: (-5, 1))),"))
        }
        Limit::Rays => {
            let beam = format!("Fan(from: (0, 0), direction: Angle(0), spread: 9, rays: {})", n - 6);
            format!("(sources: [(light: {beam}), (light: Point(at: (0, 0), rays: 2), spectrum: White(samples: 3))])")
        }
        Limit::Lines => format!("(sources: [(light: Point(at: (0, 0), rays: 1), spectrum: White(samples: {n}))])"),
        Limit::Indices => {
            let bodies: String =
                (1..n).map(|k| format!("(shape: Disk(1), medium: Cauchy([1.{k:02}, 0.1])),")).collect();
            format!("(bodies: [{bodies}], sources: [(light: Point(at: (0, 0), rays: 1))])")
        }
        Limit::Segments => format!("(trace: (max_segments: {n}))"),
        Limit::Pixels => format!("(diagram: (size: (100, {})))", n / 100),
        Limit::Notes => format!("(notes: [{}])", times("(at: (0, 0), text: \"\"),")),
        Limit::Deviations => format!("(diagram: (deviations: [{}]))", times("(\"0.0:\", \"0.0:t\"),")),
        Limit::Letters => format!("(title: \"{}\", notes: [(at: (0, 0), text: \"{}\")])", words(n), words(n - 1)),
        _ => panic!("{limit:?} has no scene"),
    }
}

fn problems(text: &str, limits: &Limits) -> Vec<Problem> {
    load_within(text, limits).err().unwrap_or_default()
}

#[test]
fn every_limit_is_held_to_the_last_and_moved_by_its_name() {
    let place = Place::new();
    for limit in Limit::ALL {
        let (n, one_less) = if limit == Limit::Pixels { (3000, 2999) } else { (20, 19) };
        let text = taking(limit, n);
        assert_eq!(problems(&text, &Limits::default().with(limit, n)), [], "{limit:?} at its limit: {text}");
        let refused = problems(&text, &Limits::default().with(limit, one_less));
        let cure = format!("`--limit {}=N` raises this limit", limit.name());
        assert_eq!(refused.len(), 1, "{limit:?} above its limit: {refused:?}");
        assert!(refused[0].help.contains(&cure) && refused[0].span.is_some(), "{refused:?}");
        let [at, below] = [n, one_less].map(|most| {
            let limit = format!("{}={most}", limit.name());
            place.feed(&["check", "-", "--limit", &limit], &text)
        });
        assert!(!at.status(0).stderr().contains("error"), "{limit:?}");
        assert!(below.status(1).stderr().contains(&cure), "{limit:?}");
    }
}

#[test]
fn the_usual_limits_hold_and_can_be_raised() {
    for limit in
        [Limit::Sides, Limit::Rays, Limit::Lines, Limit::Segments, Limit::Notes, Limit::Deviations, Limit::Letters]
    {
        let most = limit.usual();
        let [at, above] = [most, most + 1].map(|n| taking(limit, n));
        assert_eq!(problems(&at, &Limits::default()), [], "{limit:?}");
        assert_eq!(problems(&above, &Limits::default()).len(), 1, "{limit:?}");
        assert_eq!(problems(&above, &Limits::default().with(limit, most + 1)), [], "{limit:?}");
    }
}

#[test]
fn many_sides_count_as_points() {
    let body = "(shape: RegularPolygon(100000, 1), surface: Mirror),";
    let [at, above] = [20, 21].map(|bodies| format!("(bodies: [{}])", body.repeat(bodies)));
    let [few, many] = [1_999_999, 2_100_000].map(|most| Limits::default().with(Limit::Points, most));
    assert!(problems(&at, &few)[0].message.contains("2000000 points so far"), "{:?}", problems(&at, &few));
    assert!(problems(&above, &Limits::default())[0].path.starts_with("bodies[20]"));
    assert_eq!(problems(&above, &many), []);
}

#[test]
fn a_limit_is_named_and_numbered_strictly() {
    let place = Place::with(&[("a.ron", "()")]);
    for (given, told) in [
        ("ray=5", "did you mean 'rays'?"),
        ("speed=5", "the limits are bytes, bodies"),
        ("rays", "a name and a number are needed"),
        ("rays=", "a whole number from 1 to 4294967295"),
        ("rays=0", "a whole number"),
        ("rays=-1", "a whole number"),
        ("rays=+1", "a whole number"),
        ("rays=1e6", "a whole number"),
        ("rays=1.0", "a whole number"),
        ("rays= 1", "a whole number"),
        ("rays=4294967296", "a whole number"),
        ("segments=18446744073709551616", "a whole number from 1 to 2147483648"),
    ] {
        for command in ["check", "trace", "render", "explain"] {
            let run = place.run(&[command, "a.ron", "--limit", given]).status(2);
            assert!(run.stderr().contains(told), "{command} {given}: {}", run.stderr());
        }
    }
    assert_eq!(
        place.run(&["check", "a.ron", "--limit", "rays=1", "--limit", "rays=4294967295"]).status(0).stderr(),
        ""
    );
}

#[test]
fn pixels_of_a_picture_count_with_scale_and_panels() {
    let place = Place::with(&[("a.ron", "(diagram: (size: (40, 30)))"), ("b.ron", "(diagram: (size: (40, 30)))")]);
    let scaled = ["render", "a.ron", "-o", "a.png", "--scale", "2", "--limit"];
    let refused = place.run(&[&scaled[..], &["pixels=4799"]].concat()).status(1);
    assert!(refused.stderr().contains("80 × 60 pixels cannot be made"), "{}", refused.stderr());
    assert!(refused.stderr().contains("`--limit pixels=N`"), "{}", refused.stderr());
    place.run(&[&scaled[..], &["pixels=4800"]].concat()).status(0);
    let panels = ["render", "--panels", "a.ron", "b.ron", "-o", "p.png", "--size", "96x30", "--limit"];
    let refused = place.run(&[&panels[..], &["pixels=2879"]].concat()).status(2);
    assert!(refused.stderr().contains("--size asks for 2880 pixels"), "{}", refused.stderr());
    place.run(&[&panels[..], &["pixels=2880"]].concat()).status(0);
    assert_eq!(place.files(), ["a.png", "a.ron", "b.ron", "p.png"]);
}

#[test]
fn of_very_many_problems_the_first_are_shown_and_all_are_counted() {
    let place = Place::new();
    let faulty = |count: usize| format!("(bodies: [{}])", "(shape: Disk(-1), surface: Mirror),\n".repeat(count));
    for (count, text) in [(120_000, faulty(120_000)), (99_990, format!("(notes: [],{})", "a:0,\n".repeat(99_990)))] {
        let stderr = place.feed(&["check", "-"], &text).status(1).stderr();
        assert_eq!(stderr.lines().filter(|line| line.contains("error: ")).count(), 100);
        assert!(
            stderr.trim_end().ends_with(&format!("<stdin>: {} more problems follow", count - 100)),
            "{}",
            &stderr[stderr.len() - 200..]
        );
    }
}

#[test]
fn no_problem_repeats_more_than_a_line_of_the_scene() {
    let long = "a".repeat(1_000_000);
    for text in [
        format!("({long}: 1)"),
        format!("(surroundings: {long}(1))"),
        format!("(surroundings: Catalog(\"{long}\"))"),
        format!("(bodies: [(shape: Disk(1), surface: Mirror, color: \"{long}\")])"),
        format!("(trace: (max_depth: -{}))", long.replace('a', "1")),
        format!(
            "(bodies: [(shape: Disk(1), surface: Mirror, name: \"{long}\"), (shape: Disk(1), surface: Mirror, name: \"{long}\")])"
        ),
    ] {
        let stderr = Place::new().feed(&["check", "-"], &text).status(1).stderr();
        assert!(stderr.len() < 6000 && stderr.starts_with("<stdin>:1:"), "{} bytes: {:.300}", stderr.len(), stderr);
    }
}

/// Runs with so many megabytes of memory to take, which counts what is reserved and never touched.
#[cfg(target_os = "linux")]
fn run_within(place: &Place, megabytes: u32, arguments: &[&str]) -> Run {
    let mut shell = std::process::Command::new("sh");
    shell.args(["-c", &format!("ulimit -v {}; exec \"$0\" \"$@\"", 1024 * megabytes), env!("CARGO_BIN_EXE_snellius")]);
    shell.args(arguments).current_dir(place.path("")).env("RAYON_NUM_THREADS", "2");
    Run(shell.output().unwrap())
}

#[cfg(target_os = "linux")]
#[test]
fn what_asks_for_too_much_is_refused_in_little_memory() {
    let light = |light: &str| format!("(sources: [(light: {light})])");
    let white = |spectrum: &str| format!("(sources: [(light: Point(at: (0, 0), rays: 1), spectrum: {spectrum})])");
    let body = |shape: &str| format!("(bodies: [(shape: {shape}, surface: Mirror)])");
    let point = "Point(at: (0, 0), rays: 4000000),";
    let mut lines = String::new();
    (0..10_001).for_each(|k| write!(lines, "{},", 500.0 + 0.01 * f64::from(k)).unwrap());
    let hostile = [
        light("Point(at: (0, 0), rays: 1000000000000)"),
        light("Point(at: (0, 0), rays: 1e12)"),
        light("Point(at: (0, 0), rays: 4294967295)"),
        light("Point(at: (0, 0), rays: 18446744073709551616)"),
        light("Point(at: (0, 0), rays: -1)"),
        light("Point(at: (0, 0), rays: 1e300)"),
        white("White(samples: 1000000000000)"),
        white("White(samples: 4294967295)"),
        white(&format!("Lines([{lines}])")),
        format!("(sources: [{}])", format!("(light: {point} spectrum: White(samples: 10000)),").repeat(1000)),
        "(trace: (max_segments: 1000000000000000000))".to_owned(),
        "(trace: (max_segments: 2000001))".to_owned(),
        "(diagram: (size: (1000000000, 1000000000)))".to_owned(),
        "(diagram: (size: (16384, 16384)))".to_owned(),
        body("RegularPolygon(4000000000, 1)"),
        body("RegularPolygon(4e9, 1)"),
        body("Lens(radii: (50, -50), thickness: 6, diameter: 30, facets: 4000000000)"),
        format!("(bodies: [{}])", "(shape: RegularPolygon(100000, 1), surface: Mirror),".repeat(10_000)),
        format!("(title: \"{}\")", "wide ".repeat(200_000)),
        // Lists of a million of what does not belong there, and more elements than any list may have.
        body(&format!("Polygon([{}])", "(NaN,0),".repeat(300_000))),
        format!("(bodies: [{}])", "0,".repeat(1_000_000)),
        format!("(bodies: [{}])", "0,".repeat(1_000_001)),
        format!("(surroundings: Index({}))", "1,".repeat(1_000_000)),
        format!("(diagram: (size: ({})))", "1,".repeat(1_000_000)),
        format!("({})", "a:0,".repeat(1_000_000)),
        white(&format!("Lines([{}])", "x,".repeat(1_000_000))),
        format!("(title: r{0}\"{1}\"{0})", "#".repeat(50_000), "\"".repeat(500_000)),
    ];
    let place = Place::new();
    for text in hostile {
        std::fs::write(place.path("hostile.ron"), &text).unwrap();
        for command in [&["check", "hostile.ron"][..], &["trace", "hostile.ron", "--format", "summary"]] {
            let run = run_within(&place, 700, command).status(1);
            assert!(run.stderr().starts_with("hostile.ron:"), "{text:.90}: {:.300}", run.stderr());
            assert!(run.stderr().contains("\nhelp: "), "{text:.90}: {:.300}", run.stderr());
        }
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_deep_tree_is_written_with_short_addresses() {
    let scene = "(bodies: [(shape: Disk(20), surface: Mirror)], trace: (max_depth: 1000000, max_segments: 60000),
        sources: [(light: Ray(from: (0, 17), direction: Angle(0)))])";
    let place = Place::with(&[("deep.ron", scene)]);
    run_within(&place, 700, &["trace", "deep.ron", "-o", "deep.txt"]).status(0);
    let text = std::fs::read_to_string(place.path("deep.txt")).unwrap();
    assert!(text.lines().count() > 60_000 && text.lines().all(|line| line.len() < 600), "{}", text.len());
}
