//! `render`: which picture goes where.

use std::fs;
use std::path::Path;

use crate::place::{Place, SCENE, assert_png, assert_svg};

#[test]
fn render_draws_an_svg_under_the_stem_into_the_current_directory() {
    let place = Place::new();
    fs::create_dir(place.path("scenes")).unwrap();
    fs::write(place.path("scenes/in.glass.ron"), SCENE).unwrap();
    assert_eq!(place.run(&["render", "scenes/in.glass.ron"]).clean(), "in.glass.svg\n");
    assert_svg(&place.path("in.glass.svg"));
    assert_eq!(place.feed(&["render", "-"], SCENE).clean(), "stdin.svg\n");
    assert_eq!(place.files(), ["in.glass.svg", "scenes", "stdin.svg"]);
}

#[test]
fn render_to_a_file_follows_its_extension() {
    let place = Place::with(&[("a.ron", SCENE)]);
    assert_eq!(place.run(&["render", "a.ron", "-o", "x.svg"]).clean(), "x.svg\n");
    assert_svg(&place.path("x.svg"));
    assert_eq!(place.run(&["render", "a.ron", "-o", "x.PNG"]).clean(), "x.PNG\n");
    assert_png(&fs::read(place.path("x.PNG")).unwrap());
    assert_eq!(place.run(&["render", "a.ron", "-o", "picture", "--format", "png"]).clean(), "picture\n");
    assert_png(&fs::read(place.path("picture")).unwrap());
    place.run(&["render", "a.ron", "-o", "x.gif"]).refused("none of svg, png and pdf");
    place.run(&["render", "a.ron", "-o", "x"]).refused("none of svg, png and pdf");
    assert_eq!(place.files(), ["a.ron", "picture", "x.PNG", "x.svg"]);
}

#[test]
fn render_to_standard_output_prints_no_path() {
    let place = Place::with(&[("a.ron", SCENE)]);
    let svg = place.run(&["render", "a.ron", "-o", "-"]).clean();
    place.run(&["render", "a.ron"]).clean();
    assert_eq!(fs::read_to_string(place.path("a.svg")).unwrap(), svg);
    let png = place.run(&["render", "a.ron", "-o", "-", "--format", "png"]).status(0);
    assert_png(&png.0.stdout);
}

#[test]
fn render_many_into_a_folder() {
    let place = Place::with(&[("a.ron", SCENE), ("b.ron", SCENE), ("bad.ron", "(title: 1)")]);
    let run = place.run(&["render", "a.ron", "bad.ron", "b.ron", "--out-dir", "out/deep", "--format", "svg,png"]);
    let run = run.status(1);
    let paths: Vec<_> = run.stdout().lines().map(String::from).collect();
    let expected = ["a.svg", "a.png", "b.svg", "b.png"].map(|name| Path::new("out/deep").join(name));
    assert_eq!(paths, expected.each_ref().map(|path| path.display().to_string()), "one bad scene stops no other");
    assert!(run.stderr().starts_with("bad.ron:1:"), "{}", run.stderr());
    assert_svg(&place.path("out/deep/a.svg"));
    assert_png(&fs::read(place.path("out/deep/b.png")).unwrap());
}

#[test]
fn render_refuses_what_would_overwrite() {
    let place = Place::with(&[("a.ron", SCENE), ("b.ron", SCENE), ("c.svg", SCENE)]);
    fs::create_dir(place.path("sub")).unwrap();
    fs::write(place.path("sub/a.ron"), SCENE).unwrap();
    place.run(&["render", "a.ron", "b.ron", "-o", "x.svg"]).refused("several scenes");
    place.run(&["render", "a.ron", "sub/a.ron", "--out-dir", "out"]).refused("two scenes");
    place.run(&["render", "a.ron", "sub/a.ron"]).refused("two scenes");
    place.run(&["render", "a.ron", "-o", "x.svg", "--format", "svg,png"]).refused("several formats");
    place.run(&["render", "a.ron", "-o", "x.svg", "--out-dir", "out"]).refused("--out-dir");
    place.run(&["render", "a.ron", "--format", "gif"]).refused("invalid value 'gif'");
    place.run(&["render", "c.svg"]).refused("would overwrite the scene 'c.svg'");
    place.run(&["render", "a.ron", "-o", "sub/../a.ron", "--format", "svg"]).refused("would overwrite");
    assert_eq!(place.files(), ["a.ron", "b.ron", "c.svg", "sub"]);
}

#[test]
fn render_takes_a_size_a_scale_and_no_ground() {
    let place = Place::with(&[("a.ron", SCENE)]);
    let pixels = |name: &str| tiny_skia::Pixmap::decode_png(&fs::read(place.path(name)).unwrap()).unwrap();
    let render = |arguments: &[&str]| place.run(&[&["render", "a.ron"], arguments].concat()).clean();
    render(&["-o", "x.png", "--size", "640x400", "--scale", "2"]);
    let picture = pixels("x.png");
    assert_eq!((picture.width(), picture.height(), picture.pixel(0, 0).unwrap().alpha()), (1280, 800, 255));
    render(&["-o", "y.png", "--transparent"]);
    let picture = pixels("y.png");
    assert_eq!((picture.width(), picture.pixel(0, 0).unwrap().alpha()), (960, 0));
    render(&["-o", "x.svg", "--size", "640x400", "--transparent"]);
    let svg = fs::read_to_string(place.path("x.svg")).unwrap();
    assert!(svg.contains(r#"viewBox="0 0 640 400""#) && !svg.contains(r##"fill="#ffffff""##), "{svg}");
    for wrong in [
        ["--size", "640"],
        ["--size", "8x8"],
        ["--size", "0x0"],
        ["--size", "-1x90"],
        ["--scale", "0"],
        ["--scale", "nan"],
    ] {
        let refused = place.run(&["render", "a.ron", &wrong.join("=")]).status(2);
        assert!(refused.stderr().contains("needed, such as"), "{}", refused.stderr());
    }
}

#[test]
fn render_warns_of_a_mark_that_cannot_be_made() {
    let text =
        SCENE.trim_end().strip_suffix(')').unwrap().to_owned() + "\ndiagram: (deviations: [(\"0.0:\", \"0.9:t\")]))";
    let place = Place::with(&[("a.ron", &text)]);
    let run = place.run(&["render", "a.ron"]);
    assert!(
        run.stderr().contains(": warning: this deviation is not marked: there is no ray \"0.9:t\""),
        "{}",
        run.stderr()
    );
    assert!(run.stderr().starts_with("a.ron:") && run.stdout().contains("a.svg"), "{}", run.stderr());
    run.status(0);
}

#[test]
fn render_takes_a_theme() {
    let place = Place::with(&[("a.ron", SCENE)]);
    for (theme, ground) in [("light", "#ffffff"), ("dark", "#10161d"), ("print", "#ffffff")] {
        place.run(&["render", "a.ron", "-o", "x.svg", "--theme", theme]).clean();
        let svg = fs::read_to_string(place.path("x.svg")).unwrap();
        assert!(svg.contains(&format!("fill=\"{ground}\"")), "{theme}");
        assert_eq!(svg.contains("stroke=\"#000000\""), theme == "print", "{theme}");
    }
    place.run(&["render", "a.ron", "--theme", "sepia"]).status(2);
}

#[test]
fn render_outlines_text_where_it_is_asked_to() {
    let place = Place::with(&[("a.ron", SCENE)]);
    let svg = |name: &str, more: &[&str]| {
        place.run(&[&["render", "a.ron", "-o", name], more].concat()).clean();
        fs::read_to_string(place.path(name)).unwrap()
    };
    let (text, outlines) = (svg("x.svg", &[]), svg("y.svg", &["--outline-text"]));
    let count = |svg: &str, what: &str| svg.matches(what).count();
    assert!(count(&text, "<text") > 1 && count(&outlines, "<text") == 0);
    assert_eq!(count(&outlines, "aria-label"), count(&text, "<text"));
    assert!(outlines.contains("aria-label=\"Into glass\"") && outlines.contains('Q'));
}
