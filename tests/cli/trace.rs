//! `trace`: its forms, streams and files.

use std::fs;

use crate::place::{Place, SCENE};

#[test]
fn trace_has_four_forms() {
    let place = Place::with(&[("a.ron", SCENE)]);
    let text = place.run(&["trace", "a.ron"]).clean();
    assert_eq!(place.run(&["trace", "a.ron", "--format", "text"]).clean(), text);
    assert!(text.starts_with("Into glass\n") && text.contains("0.0:tt "), "{text}");

    let json: serde_json::Value =
        serde_json::from_str(&place.run(&["trace", "a.ron", "--format", "json"]).clean()).unwrap();
    assert_eq!(json["schema"], 1);
    assert_eq!(json["rays"][0]["segments"][0]["hit"]["body"], "glass");
    assert_eq!(json["screens"][0]["hits"][0]["position"], 20.0);

    let csv = place.run(&["trace", "a.ron", "--format", "csv"]).clean();
    assert!(csv.starts_with("source,ray,wavelength_nm,id,parent,via,"));
    assert_eq!(csv.lines().count() as u64, 1 + json["counts"]["segments"].as_u64().unwrap());

    let summary: serde_json::Value =
        serde_json::from_str(&place.run(&["trace", "a.ron", "--format", "summary"]).clean()).unwrap();
    assert!(summary.get("rays").is_none());
    assert_eq!(summary["power_balance"], json["power_balance"]);
    assert_eq!(summary["screens"], json["screens"]);
    place.run(&["trace", "a.ron", "--format", "yaml"]).refused("invalid value 'yaml'");
}

#[test]
fn trace_reads_and_writes_the_standard_streams() {
    let place = Place::with(&[("a.ron", SCENE)]);
    let text = place.run(&["trace", "a.ron"]).clean();
    assert_eq!(place.feed(&["trace", "-"], SCENE).clean(), text);
    assert_eq!(place.feed(&["trace", "-", "-o", "-"], SCENE).clean(), text);
    assert_eq!(place.feed(&["trace", "-"], &format!("\u{feff}{SCENE}")).clean(), text, "with an editor's mark");
}

#[test]
fn trace_writes_a_file_in_the_form_of_its_extension() {
    let place = Place::with(&[("a.ron", SCENE)]);
    for (file, format) in [("o.txt", "text"), ("o.json", "json"), ("o.CSV", "csv")] {
        assert_eq!(place.run(&["trace", "a.ron", "-o", file]).clean(), "");
        let printed = place.run(&["trace", "a.ron", "--format", format]).clean();
        assert_eq!(fs::read_to_string(place.path(file)).unwrap(), printed);
    }
    assert_eq!(place.run(&["trace", "a.ron", "-o", "o.dat", "--format", "summary"]).clean(), "");
    place.run(&["trace", "a.ron", "-o", "o.xml"]).refused("'o.xml'");
    place.run(&["trace", "a.ron", "-o", "a.ron", "--format", "json"]).refused("would overwrite the scene 'a.ron'");
    assert_eq!(place.files(), ["a.ron", "o.CSV", "o.dat", "o.json", "o.txt"]);
}

#[test]
fn stats_go_to_standard_error() {
    let place = Place::with(&[("a.ron", SCENE)]);
    let plain = place.run(&["trace", "a.ron"]).clean();
    let run = place.run(&["trace", "a.ron", "--stats"]).status(0);
    assert_eq!(run.stdout(), plain);
    let stats = run.stderr();
    assert!(stats.lines().skip(1).all(|line| line.starts_with("  ") && !line[20..].starts_with(' ')), "{stats}");
    let run = place.run(&["render", "a.ron", "--stats"]).status(0);
    assert_eq!(run.stdout(), "a.svg\n");
    assert!(run.stderr().starts_with("stats of a.ron\n"), "{}", run.stderr());
}
