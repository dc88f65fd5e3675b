//! What the browser shows is what the PNG shows.

use snellius::drawing::Drawing;
use snellius::scene::Theme;
use snellius::{diagram, render};
use tiny_skia::{IntRect, Pixmap};

use crate::chromium::Chromium;
use crate::support::{run, run_text};

const WIDTH: u32 = 960;
const HEIGHT: u32 = 540;
/// Text of many kinds, dispersion, dashes, a caustic of very many rays, light that adds up, the light on a screen.
const FIGURES: [(&str, Theme); 6] = [
    ("prisms/minimum-deviation", Theme::Light),
    ("prisms/white-light", Theme::Dark),
    ("lenses/achromat", Theme::Print),
    ("mirrors/caustic", Theme::Light),
    ("nature/rainbow-primary", Theme::Dark),
    ("lenses/caustic-on-screen", Theme::Light),
];
/// Writing from right to left, with marks and numbers.
const SCRIPTS: &str = r#"(
    title: "שבירה (n = 1.5) של אור",
    caption: "انكسار الضوء في عدسة: n = 1.5, زاوية 30°. نور از منشور می‌گذرد؛ ثلاث لمبات (لا ظل). Light, אור 12, light.",
    bodies: [
        (name: "عدسة 7", shape: Lens(radii: (50, -50), thickness: 12, diameter: 30), medium: Index(1.5)),
        (name: "מסך", shape: Flat(from: (60, -20), to: (60, 20)), surface: Screen),
    ],
    sources: [(light: Beam(center: (-30, 0), direction: Angle(0), width: 20, rays: 20))],
)"#;

/// Half the side of the squares over which colors are averaged, since edges and baselines may lie half a pixel apart.
const BLUR: u32 = 1;
/// Levels of 255 by which an averaged channel may differ.
const LEVEL: i32 = 32;
/// Share of the pixels that may differ by more: three times what is seen, a third of what the smallest label has.
const SHARE: f64 = 2.5e-4;

fn drawing(mut run: crate::support::Run, theme: Theme) -> Drawing {
    run.scene.diagram.theme = theme;
    run.scene.diagram.size = [WIDTH, HEIGHT];
    diagram::draw(&run.scene, &run.system, &run.trace.tree)
}

/// Channels of a pixel, averaged over its neighbors.
fn averaged(picture: &Pixmap, x: u32, y: u32) -> [i32; 3] {
    let mut sums = [0; 3];
    let mut count = 0;
    for x in x.saturating_sub(BLUR)..=(x + BLUR).min(WIDTH - 1) {
        for y in y.saturating_sub(BLUR)..=(y + BLUR).min(HEIGHT - 1) {
            let pixel = picture.pixel(x, y).unwrap();
            let channels = [pixel.red(), pixel.green(), pixel.blue()].map(i32::from);
            sums = [0, 1, 2].map(|k| sums[k] + channels[k]);
            count += 1;
        }
    }
    sums.map(|sum| sum / count)
}

/// The share of pixels that differ.
fn difference(one: &Pixmap, other: &Pixmap) -> f64 {
    let differs = |(x, y): &(u32, u32)| {
        let [one, other] = [one, other].map(|picture| averaged(picture, *x, *y));
        one.iter().zip(other).any(|(a, b)| (a - b).abs() > LEVEL)
    };
    let pixels = (0..WIDTH).flat_map(|x| (0..HEIGHT).map(move |y| (x, y)));
    f64::from(u32::try_from(pixels.filter(differs).count()).unwrap()) / f64::from(WIDTH * HEIGHT)
}

/// What the browser shows of figures that stand one below the other on a page.
fn shown(browser: &Chromium, svgs: &[String]) -> Vec<Pixmap> {
    let mut page = String::from("<!doctype html><style>body { margin: 0 } img { display: block }</style>\n");
    for (k, svg) in svgs.iter().enumerate() {
        browser.put(&format!("{k}.svg"), svg);
        page += &format!("<img src=\"{k}.svg\">\n");
    }
    browser.put("figures.html", &page);
    let count = u32::try_from(svgs.len()).unwrap();
    let whole = browser.picture("figures.html", [WIDTH, HEIGHT * count]);
    let part = |k: u32| {
        let top = i32::try_from(k * HEIGHT).unwrap();
        whole.clone_rect(IntRect::from_xywh(0, top, WIDTH, HEIGHT).unwrap()).unwrap()
    };
    (0..count).map(part).collect()
}

/// The figure with its first line of some kind made into another.
fn changed(svg: &str, start: &str, class: &str, change: impl Fn(&str) -> String) -> String {
    let line = svg.lines().find(|line| line.starts_with(start) && line.contains(&format!("class=\"{class}"))).unwrap();
    svg.replacen(line, &change(line), 1)
}

#[test]
fn the_browser_shows_the_png() {
    let Some(browser) = Chromium::find("the_browser_shows_the_png") else { return };
    let mut figures: Vec<_> = FIGURES.iter().map(|(name, theme)| (*name, drawing(run(name), *theme))).collect();
    figures.push(("right to left", drawing(run_text(SCRIPTS), Theme::Light)));
    let mut svgs: Vec<String> = figures.iter().map(|(_, figure)| render::svg(figure)).collect();
    // What must be noticed.
    svgs.push(changed(&svgs[0], "<path", "ray ", |line| {
        line.replacen("<path", "<path transform=\"translate(0 3)\"", 1)
    }));
    svgs.push(changed(&svgs[0], "<text", "label\"", |_| String::new()));
    svgs.push(changed(&svgs[0], "<text", "angle-value\"", |_| String::new()));
    let pages = shown(&browser, &svgs);
    let pngs: Vec<_> =
        figures.iter().map(|(_, figure)| Pixmap::decode_png(&render::png(figure, 1.0).unwrap()).unwrap()).collect();
    for (((name, _), page), png) in figures.iter().zip(&pages).zip(&pngs) {
        let share = difference(page, png);
        assert!(share < SHARE, "{name}: {share:.1e} of the pixels differ");
    }
    let faults = ["a ray moved by 3 pixels", "a label is missing", "an angle is missing"];
    for (what, page) in faults.iter().zip(&pages[figures.len()..]) {
        let share = difference(page, &pngs[0]);
        assert!(share > 2.0 * SHARE, "{what}, and only {share:.1e} of the pixels differ");
    }
}
