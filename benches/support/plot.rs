//! Log-log plots: powers of ten on both axes, curves told apart by their markers and not by color alone.

use std::ops::Range;
use std::path::Path;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::prelude::*;

/// Curves in one pair of axes.
pub(crate) struct Panel {
    pub(crate) title: String,
    /// What stands along the axes, with units.
    pub(crate) axes: [&'static str; 2],
    pub(crate) curves: Vec<Curve>,
}

/// Points joined by a line or not. Curves of one name look the same in every panel.
#[derive(Clone)]
pub(crate) struct Curve {
    pub(crate) name: String,
    pub(crate) points: Vec<(f64, f64)>,
    pub(crate) is_joined: bool,
}

const PANEL: (u32, u32) = (430, 400);
const LEGEND: u32 = 210;
/// Okabe and Ito's colors, which the color-blind tell apart.
const COLORS: [RGBColor; 8] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(0, 0, 0),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(120, 120, 120),
];

/// Draws panels side by side, with one legend beside them.
pub(crate) fn draw(path: &Path, panels: &[Panel]) {
    let count = u32::try_from(panels.len()).unwrap();
    let size = (count * PANEL.0 + LEGEND, PANEL.1);
    let root = SVGBackend::new(path, size).into_drawing_area();
    root.fill(&WHITE).unwrap();
    let (left, right) = root.split_horizontally(count * PANEL.0);
    let names = names(panels);
    for (panel, area) in panels.iter().zip(left.split_evenly((1, panels.len()))) {
        draw_panel(panel, &names, &area);
    }
    for (k, name) in names.iter().enumerate() {
        let y = 48 + 24 * i32::try_from(k).unwrap();
        mark(&right, k, (14, y));
        right.draw(&Text::new(name.clone(), (28, y - 7), ("sans-serif", 14))).unwrap();
    }
    root.present().unwrap();
}

/// The names of all curves, each once.
fn names(panels: &[Panel]) -> Vec<String> {
    let mut names = Vec::new();
    for curve in panels.iter().flat_map(|panel| &panel.curves) {
        if !names.contains(&curve.name) {
            names.push(curve.name.clone());
        }
    }
    names
}

type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;

fn draw_panel(panel: &Panel, names: &[String], area: &Area) {
    let points = || panel.curves.iter().flat_map(|curve| curve.points.iter().copied());
    let mut chart = ChartBuilder::on(area)
        .caption(&panel.title, ("sans-serif", 15))
        .margin(8)
        .margin_right(16)
        .x_label_area_size(44)
        .y_label_area_size(60)
        .build_cartesian_2d(Decades::around(points().map(|p| p.0)), Decades::around(points().map(|p| p.1)))
        .unwrap();
    chart
        .configure_mesh()
        .light_line_style(RGBColor(240, 240, 240))
        .bold_line_style(RGBColor(205, 205, 205))
        .label_style(("sans-serif", 13))
        .axis_desc_style(("sans-serif", 14))
        .x_desc(panel.axes[0])
        .y_desc(panel.axes[1])
        .draw()
        .unwrap();
    let plane = chart.plotting_area().strip_coord_spec();
    for curve in &panel.curves {
        let style = names.iter().position(|name| *name == curve.name).unwrap_or(0);
        let origin = plane.get_pixel_range();
        let place = |point: &(f64, f64)| {
            let at = chart.backend_coord(point);
            (at.0 - origin.0.start, at.1 - origin.1.start)
        };
        let places: Vec<_> = curve.points.iter().map(place).collect();
        if curve.is_joined {
            plane.draw(&PathElement::new(places.clone(), color(style).stroke_width(2))).unwrap();
        }
        places.into_iter().for_each(|at| mark(&plane, style, at));
    }
}

fn color(style: usize) -> RGBColor {
    COLORS[style % COLORS.len()]
}

/// An axis of powers of ten.
struct Decades {
    /// Exponents at its ends.
    ends: Range<f64>,
}

impl Decades {
    /// Holds all of these numbers, which are above 0, with some space around them.
    fn around(values: impl Iterator<Item = f64>) -> Self {
        let limits = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) = values.map(libm::log10).fold(limits, |(low, high), x| (low.min(x), high.max(x)));
        let space = 0.05 * (high - low) + 0.1;
        Self { ends: low - space..high + space }
    }

    fn span(&self) -> f64 {
        self.ends.end - self.ends.start
    }

    /// The whole exponents on it, every `step`-th of them.
    fn whole(&self, step: i32) -> impl Iterator<Item = f64> {
        let exponents = (-20..=20).map(move |exponent| f64::from(exponent * step));
        exponents.filter(|exponent| self.ends.contains(exponent))
    }
}

impl Ranged for Decades {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        let share = (libm::log10(*value) - self.ends.start) / self.span();
        #[expect(clippy::cast_possible_truncation, reason = "pixels")]
        let pixels = (share * f64::from(limit.1 - limit.0)).round() as i32;
        limit.0 + pixels
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        let powers = self.whole(if self.span() > 8.0 { 2 } else { 1 }).map(libm::exp10);
        if self.span() > 4.0 || !hint.weight().allow_light_points() {
            return powers.collect();
        }
        let all = (-20..=20)
            .flat_map(|exponent| (1..10).map(move |digit| f64::from(digit) * libm::exp10(f64::from(exponent))));
        all.filter(|value| self.ends.contains(&libm::log10(*value))).collect()
    }

    fn range(&self) -> Range<f64> {
        libm::exp10(self.ends.start)..libm::exp10(self.ends.end)
    }
}

impl ValueFormatter<f64> for Decades {
    fn format(value: &f64) -> String {
        power(libm::log10(*value).round())
    }
}

/// A power of ten as it is written by hand.
fn power(exponent: f64) -> String {
    let superscript = |c: char| match c.to_digit(10) {
        Some(digit) => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize],
        None => '⁻',
    };
    match format!("{exponent:.0}").as_str() {
        "0" => "1".into(),
        "1" => "10".into(),
        text => format!("10{}", text.chars().map(superscript).collect::<String>()),
    }
}

/// One of eight markers.
fn mark(area: &Area, style: usize, (x, y): (i32, i32)) {
    let color = color(style);
    let (filled, stroke) = (color.filled(), color.stroke_width(2));
    let r = 5;
    let polygon = |points: &[(i32, i32)]| points.iter().map(|p| (x + p.0, y + p.1)).collect::<Vec<_>>();
    let line = |points: &[(i32, i32)]| area.draw(&PathElement::new(polygon(points), stroke)).unwrap();
    let fill = |points: &[(i32, i32)]| area.draw(&Polygon::new(polygon(points), filled)).unwrap();
    match style % 8 {
        0 => area.draw(&Circle::new((x, y), r, filled)).unwrap(),
        1 => fill(&[(-r, -r), (r, -r), (r, r), (-r, r)]),
        2 => fill(&[(0, -6), (6, 5), (-6, 5)]),
        3 => area.draw(&Circle::new((x, y), 8, stroke)).unwrap(),
        4 => fill(&[(0, -7), (6, 0), (0, 7), (-6, 0)]),
        5 => line(&[(-r, -r), (r, -r), (r, r), (-r, r), (-r, -r)]),
        6 => line(&[(0, -6), (6, 5), (-6, 5), (0, -6)]),
        _ => line(&[(0, -7), (6, 0), (0, 7), (-6, 0), (0, -7)]),
    }
}
