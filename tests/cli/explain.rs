//! `explain`: addresses, forms, files, worksheets and keys.

use std::fs;

use crate::place::{Place, SCENE};

const LINES: &str = r#"(
    title: "Dispersion",
    surroundings: Index(1.25),
    bodies: [(name: "prism", shape: Prism(apex_angle: 40, side: 30), medium: Catalog("N-SF11"))],
    sources: [
        (light: Ray(from: (-30, -4), direction: Angle(20)), spectrum: Lines([486.1327, 656.2725])),
        (name: "lamp", light: Fan(from: (-30, -4), direction: Angle(20), spread: 10, rays: 3)),
    ],
)
"#;

#[test]
fn explain_has_three_forms_and_text_is_the_default() {
    let place = Place::with(&[("a.ron", SCENE)]);
    let text = place.run(&["explain", "a.ron"]).clean();
    assert_eq!(place.run(&["explain", "a.ron", "--format", "text"]).clean(), text);
    assert!(text.starts_with("Into glass\n==========\n\nRay 0.0:tt\n"), "{text}");
    assert!(text.contains("  1.3   η = n2/n1 = 1.5/1 = 1.5\n"), "{text}");
    assert!(text.contains("\n0.0:tt, with 0.9216 of the ray's power, lands on the screen."), "{text}");
    let markdown = place.run(&["explain", "a.ron", "--format", "markdown"]).clean();
    assert!(markdown.starts_with("# Into glass\n\n## Ray 0.0:tt\n"), "{markdown}");
    assert!(markdown.contains("- **1.3** $\\eta = \\frac{n_2}{n_1} = \\frac{1.5}{1} = 1.5$\n"), "{markdown}");
    let latex = place.run(&["explain", "a.ron", "--format", "latex"]).clean();
    assert!(latex.starts_with("\\documentclass") && latex.ends_with("\\end{document}\n"), "{latex}");
    assert!(latex.contains("\\item[1.3] $\\eta = \\frac{n_2}{n_1} = \\frac{1.5}{1} = 1.5$\n"), "{latex}");
    place.run(&["explain", "a.ron", "--format", "html"]).refused("invalid value 'html'");
}

#[test]
fn explain_writes_a_file_in_the_form_of_its_extension() {
    let place = Place::with(&[("a.ron", SCENE)]);
    for (file, format) in [("o.txt", "text"), ("o.md", "markdown"), ("o.TEX", "latex")] {
        assert_eq!(place.run(&["explain", "a.ron", "-o", file]).clean(), "");
        let printed = place.run(&["explain", "a.ron", "--format", format]).clean();
        assert_eq!(fs::read_to_string(place.path(file)).unwrap(), printed);
        assert_eq!(place.run(&["explain", "a.ron", "-o", "-", "--format", format]).clean(), printed);
        assert_eq!(place.feed(&["explain", "-", "--format", format], SCENE).clean(), printed);
    }
    place.run(&["explain", "a.ron", "-o", "o.pdf"]).refused("none of md, tex and txt");
    place.run(&["explain", "a.ron", "-o", "a.ron", "--format", "text"]).refused("would overwrite the scene 'a.ron'");
    assert_eq!(place.files(), ["a.ron", "o.TEX", "o.md", "o.txt"]);
}

#[test]
fn an_address_chooses_the_branch() {
    let place = Place::with(&[("a.ron", LINES)]);
    let rays = |text: &str| -> Vec<String> {
        text.lines().filter_map(|line| line.strip_prefix("Ray ").map(str::to_owned)).collect()
    };
    let all = place.run(&["explain", "a.ron"]).clean();
    assert_eq!(rays(&all), ["0.0@486.1327:tt", "1.0:tt"], "the brightest path of each source");
    assert!(all.contains("Source 1, lamp; vacuum wavelength 587.5618 nm; power 0.333333."), "{all}");
    for (address, hits) in [("0.0@656.2725:", 1), ("0.0@656.2725:tr", 3), ("1.2:r", 1)] {
        let one = place.run(&["explain", "a.ron", "--ray", address]).clean();
        assert_eq!(rays(&one), [address]);
        assert_eq!(one.matches("\nHit ").count(), hits, "{one}");
    }
    let red = place.run(&["explain", "a.ron", "--ray", "0.0@656.2725:tt"]).clean();
    assert!(red.contains("n2 = 1.77596 (N-SF11)"), "{red}");
    let blue = place.run(&["explain", "a.ron", "--ray", "0.0@486.1327:tt"]).clean();
    assert!(blue.contains("n2 = 1.80651 (N-SF11)"), "{blue}");
}

#[test]
fn a_wrong_address_is_answered_with_those_that_are_close() {
    let place = Place::with(&[("a.ron", LINES)]);
    for (address, told) in [
        ("1.1", "an address is SOURCE.RAY:PATH"),
        ("1.3:t", "the scene has no '1.3'; these are close: '1.0:', '1.1:', '1.2:'"),
        ("0.0:t", "the scene has no '0.0'; these are close: '0.0@486.1327:', '0.0@656.2725:'"),
        ("0.0@650:t", "the scene has no '0.0@650'; these are close: '0.0@656.2725:', '0.0@486.1327:'"),
        ("1.1:tx", "no 'x' follows after '1.1:t'; these are close: '1.1:tt', '1.1:tr', '1.1:t'"),
        ("1.1:rr", "no 'r' follows after '1.1:r'; these are close: '1.1:r'"),
        ("", "an address is SOURCE.RAY:PATH"),
    ] {
        place.run(&["explain", "a.ron", "--ray", address]).refused(told);
    }
    let dark = "(\n    bodies: [(shape: Disk(4), medium: Index(1.5))],\n)\n";
    place.feed(&["explain", "-", "--ray", "0.0:"], dark).refused("there is no ray '0.0:': the scene has no '0.0'\n");
    let run = place.feed(&["explain", "-"], dark).status(1);
    assert!(
        run.stdout().is_empty() && run.stderr().starts_with("<stdin>: the scene has no source"),
        "{}",
        run.stderr()
    );
}

/// The numbered lines of a text.
fn items(text: &str) -> Vec<(&str, &str)> {
    let is_item = |line: &&str| line.starts_with("  ");
    text.lines().filter(is_item).map(|line| line.trim().split_once(' ').unwrap()).collect()
}

#[test]
fn a_worksheet_asks_what_the_key_answers_and_tells_no_answer() {
    let place = Place::with(&[("a.ron", LINES)]);
    let run = |flags: &[&str]| place.run(&[&["explain", "a.ron"][..], flags].concat()).clean();
    let (worked, blank, key) = (run(&[]), run(&["--blank"]), run(&["--key"]));
    let numbers = |text: &str| -> Vec<String> { items(text).iter().map(|(number, _)| (*number).to_owned()).collect() };
    assert_eq!(numbers(&blank), numbers(&worked));
    assert_eq!(numbers(&key), numbers(&worked));
    assert!(items(&blank).iter().all(|(_, question)| question.ends_with(" = ________")), "{blank}");
    let mut answers = 0;
    for ((_, worked), (_, key)) in items(&worked).into_iter().zip(items(&key)) {
        let (letter, answer) = key.trim().split_once([' ', ',']).unwrap();
        assert!(worked.trim().starts_with(letter) && worked.ends_with(answer.rsplit("= ").next().unwrap()), "{key}");
        let answer = answer.trim_start_matches("= ").trim_end_matches('°');
        // A number of few digits may stand in the worksheet for something else.
        if answer.chars().filter(char::is_ascii_digit).count() > 4 && !answer.contains("none") {
            answers += 1;
            assert!(!blank.contains(answer), "{answer} in\n{blank}");
        }
    }
    assert!(answers > 40, "{answers}");
    assert!(!blank.contains(":t") && !blank.contains("leaves the scene"), "{blank}");
    place.run(&["explain", "a.ron", "--blank", "--key"]).refused("cannot be used with");
}
