//! The ray tree for reading and for snapshot tests: one line a segment, indented by depth, numbers rounded so that the
//! last bits of a computation do not show.

use std::collections::HashMap;
use std::io::{self, Write};

use glam::DVec2;

use super::number::{decimal_exponent, fixed, share, significant};
use super::{body_name, in_memory};
use crate::characters::one_line;
use crate::system::OpticalSystem;
use crate::trace::{Ending, Hit, PowerBalance, RayTree, ScreenRecord, Segment, SegmentId, Summary, Trace, TracedRay};

/// Decimals of directions and indices: finer than any reading, coarser than rounding.
const DECIMALS: usize = 6;
/// Decimals of angles in degrees.
const ANGLE_DECIMALS: usize = 4;

/// The ray tree by address, the power balance and the screens.
///
/// Lengths have 7 digits against the size of the scene, powers 6 of their own. A segment's share is that of the power
/// that its ray started with. The columns are aligned within each ray.
#[must_use]
pub fn text(system: &OpticalSystem, trace: &Trace) -> String {
    in_memory(|out| write_text(out, system, trace))
}

/// Writes what [`text`] returns.
///
/// # Errors
/// When `out` cannot be written.
pub fn write_text(out: &mut impl Write, system: &OpticalSystem, trace: &Trace) -> io::Result<()> {
    let starts = trace.tree.rays.iter().filter_map(|ray| ray.segments.first()).map(|segment| segment.from);
    let report = Report { system, decimals: length_decimals(system, starts) };
    if !system.title().is_empty() {
        writeln!(out, "{}\n", one_line(system.title()))?;
    }
    for ray in &trace.tree.rays {
        report.ray(out, ray)?;
    }
    report.balance(out, &trace.summary)?;
    let landed = landed(&trace.tree);
    for screen in &trace.summary.screens {
        report.screen(out, screen, landed.get(&screen.body).map_or(&[], Vec::as_slice))?;
    }
    Ok(())
}

struct Report<'a> {
    system: &'a OpticalSystem,
    /// Decimals of lengths.
    decimals: usize,
}

/// The cells of a segment's line, but for what it met, which comes last and needs no width.
const COLUMNS: usize = 7;
/// Letters of a path that are shown, and steps of indentation.
const LONGEST: usize = 100;

impl Report<'_> {
    fn ray(&self, out: &mut impl Write, ray: &TracedRay) -> io::Result<()> {
        let (name, nm, power) = (ray.name(), ray.wavelength.nanometers(), significant(ray.power));
        writeln!(out, "ray {name}  {nm} nm  power {power}")?;
        // Once for the widths and once to write: the cells of a large tree take more memory than the tree.
        let depths = depths(ray);
        let lines = || depths.iter().zip(&ray.segments).map(|(depth, segment)| self.cells(ray, segment, *depth));
        let mut widths = [0; COLUMNS];
        for cells in lines() {
            for (width, cell) in widths.iter_mut().zip(&cells) {
                *width = cell.chars().count().max(*width);
            }
        }
        for (cells, segment) in lines().zip(&ray.segments) {
            write!(out, "  ")?;
            for (cell, width) in cells.iter().zip(widths).filter(|(_, width)| *width > 0) {
                // A width in the form of `write!` has 16 bits.
                write!(out, "{cell}{}", " ".repeat(width - cell.chars().count() + 2))?;
            }
            writeln!(out, "{}", self.end(segment))?;
        }
        writeln!(out)
    }

    fn cells(&self, ray: &TracedRay, segment: &Segment, depth: usize) -> [String; COLUMNS] {
        let address = shortened(ray, segment.id);
        let to = match (segment.to, segment.ending) {
            (Some(to), _) => self.point(to),
            (None, Ending::Escaped) => "∞".into(),
            (None, _) => "…".into(),
        };
        let (x, y) = (fixed(segment.direction.x, DECIMALS), fixed(segment.direction.y, DECIMALS));
        [
            "  ".repeat(depth.min(LONGEST)) + &address,
            segment.via.word().into(),
            format!("{} → {to}", self.point(segment.from)),
            format!("along ({x}, {y})"),
            format!("n {}", fixed(segment.medium_index, DECIMALS)),
            format!("share {}", share(segment.power.total() / ray.power, 1.0)),
            segment.hit.as_ref().map_or_else(String::new, angles),
        ]
    }

    /// How a segment ended, and where.
    fn end(&self, segment: &Segment) -> String {
        let word = segment.ending.word();
        match &segment.hit {
            Some(hit) => format!("{word} {}", self.body(hit.body)),
            None => word.into(),
        }
    }

    fn point(&self, p: DVec2) -> String {
        format!("({}, {})", fixed(p.x, self.decimals), fixed(p.y, self.decimals))
    }

    fn body(&self, body: usize) -> String {
        one_line(&body_name(self.system, body))
    }

    fn balance(&self, out: &mut impl Write, summary: &Summary) -> io::Result<()> {
        writeln!(out, "{}, {}\n", count(summary.rays, "ray"), count(summary.segments, "segment"))?;
        writeln!(out, "power balance")?;
        let balance = &summary.balance;
        let emitted = balance.emitted.value();
        for (name, power) in parts(balance) {
            writeln!(out, "  {name:16}  {}", share(power, emitted))?;
        }
        // Rounding of the many sums is no news; a residual that shows is.
        let residual = balance.residual();
        let closed = residual.abs() <= 1e-9 * emitted;
        writeln!(out, "  {:16}  {}", "residual", if closed { "0".into() } else { significant(residual) })
    }

    fn screen(&self, out: &mut impl Write, screen: &ScreenRecord, landed: &[(&TracedRay, &Segment)]) -> io::Result<()> {
        let hits = count(screen.hits.len() as u64, "hit");
        writeln!(out, "\nscreen {}  {hits}", self.body(screen.body))?;
        for (ray, segment) in landed {
            let position = segment.hit.and_then(|hit| hit.position);
            let position = fixed(position.unwrap_or(0.0), self.decimals);
            let power = share(segment.power.total(), ray.power);
            writeln!(out, "  {}  position {position}  power {power}", shortened(ray, segment.id))?;
        }
        Ok(())
    }
}

/// The segments that landed on each screen, by its body.
fn landed(tree: &RayTree) -> HashMap<usize, Vec<(&TracedRay, &Segment)>> {
    let mut landed: HashMap<usize, Vec<_>> = HashMap::new();
    for (ray, segment) in tree.rays.iter().flat_map(|ray| ray.segments.iter().map(move |segment| (ray, segment))) {
        if let (Ending::Detected, Some(hit)) = (segment.ending, &segment.hit) {
            landed.entry(hit.body).or_default().push((ray, segment));
        }
    }
    landed
}

/// The address of a branch, of whose path at most the last letters are shown: each segment has one, and they grow as the path.
fn shortened(ray: &TracedRay, id: SegmentId) -> String {
    let letters = ray.ancestors(id).filter_map(|segment| segment.via.letter());
    let backward: Vec<char> = letters.take(LONGEST + 1).collect();
    let gap = if backward.len() > LONGEST { "…" } else { "" };
    let path: String = backward.into_iter().take(LONGEST).rev().collect();
    format!("{}:{gap}{path}", ray.name())
}

/// The angles from the normal at a hit: incidence, and transmission where something can be transmitted.
fn angles(hit: &Hit) -> String {
    let degrees = |angle| format!("{}°", fixed(angle, ANGLE_DECIMALS));
    let incidence = degrees(hit.theta_i_degrees());
    match hit.theta_t_degrees() {
        Some(transmission) => format!("{incidence} → {}", degrees(transmission)),
        None if hit.total_internal_reflection => format!("{incidence} → total"),
        None => incidence,
    }
}

fn parts(balance: &PowerBalance) -> [(&'static str, f64); 7] {
    [
        ("emitted", balance.emitted.value()),
        ("escaped", balance.escaped.value()),
        ("absorbed", balance.absorbed.value()),
        ("detected", balance.detected.value()),
        ("cut_min_power", balance.cut_min_power.value()),
        ("cut_max_depth", balance.cut_max_depth.value()),
        ("cut_max_segments", balance.cut_max_segments.value()),
    ]
}

/// The number of hits behind each segment of a ray.
fn depths(ray: &TracedRay) -> Vec<usize> {
    let mut depths: Vec<usize> = Vec::with_capacity(ray.segments.len());
    for segment in &ray.segments {
        let parent = segment.parent.and_then(|parent| depths.get(parent.index()));
        depths.push(parent.map_or(0, |depth| depth + 1));
    }
    depths
}

/// Decimals that give the size of the scene 7 digits, as far as its distance from the origin leaves any.
pub(crate) fn length_decimals(system: &OpticalSystem, starts: impl IntoIterator<Item = DVec2>) -> usize {
    let curves = system.bodies().iter().flat_map(|body| &body.outlines).flat_map(|outline| &outline.curves);
    let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    for p in curves.flat_map(|curve| [curve.a, curve.midpoint(), curve.b]).chain(starts) {
        low = low.min(p);
        high = high.max(p);
    }
    let size = (high - low).max_element();
    let finest = 15 - decimal_exponent(low.abs().max(high.abs()).max_element());
    let wanted = if size.is_finite() && size > 0.0 { 6 - decimal_exponent(size) } else { 6 };
    usize::try_from(wanted.min(finest - 2)).unwrap_or(0)
}

fn count(number: u64, noun: &str) -> String {
    format!("{number} {noun}{}", if number == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::sample;

    #[test]
    fn a_small_tree() {
        let (system, trace) = sample::turn_in_a_prism();
        assert_eq!(
            text(&system, &trace),
            "\
Turn in a prism

ray 0.0  587.5618 nm  power 1
  0.0:        source                     (-30, 10) → (0, 10)  along (1, 0)   n 1    share 1     0° → 0°      interface prism
    0.0:t     transmission               (0, 10) → (30, 10)   along (1, 0)   n 1.5  share 0.96  45° → total  interface prism
      0.0:ti  total_internal_reflection  (30, 10) → (30, 0)   along (0, -1)  n 1.5  share 0.96  0°           detected wall
    0.0:r     reflection                 (0, 10) → …          along (-1, 0)  n 1    share 0.04               cut_min_power

1 ray, 4 segments

power balance
  emitted           1
  escaped           0
  absorbed          0
  detected          0.96
  cut_min_power     0.04
  cut_max_depth     0
  cut_max_segments  0
  residual          0

screen wall  1 hit
  0.0:ti  position 12.5  power 0.96
"
        );
    }

    #[test]
    fn the_last_bits_do_not_show() {
        let (system, mut trace) = sample::turn_in_a_prism();
        let before = text(&system, &trace);
        for segment in &mut trace.tree.rays[0].segments {
            segment.from.y = segment.from.y.next_up();
            segment.direction.x += 1e-16;
            segment.power.s = segment.power.s.next_down();
            segment.medium_index = segment.medium_index.next_up();
            if let Some(hit) = &mut segment.hit {
                hit.sin_i += 1e-16;
            }
        }
        assert_eq!(text(&system, &trace), before);
    }

    #[test]
    fn lengths_keep_their_digits_in_a_scene_of_any_size() {
        let (system, mut trace) = sample::turn_in_a_prism();
        let second = TracedRay { ray: 1, ..trace.tree.rays[0].clone() };
        trace.tree.rays.push(second);
        for (scale, shown) in [(2e-7, "-0.000006"), (1.0, "-30"), (1e9, "-30000000000")] {
            let mut scaled = trace.clone();
            scaled.tree.rays[0].segments[0].from *= scale;
            scaled.tree.rays[1].segments[0].from *= 2.0 * scale;
            let report = text(&system, &scaled);
            assert!(report.contains(&format!("({shown}, ")), "{report}");
        }
    }

    #[test]
    fn a_title_with_line_breaks_stays_on_one_line() {
        let (mut system, trace) = sample::turn_in_a_prism();
        system.title = "two\nlines\u{1b}[2J".into();
        assert!(text(&system, &trace).starts_with("two lines [2J\n\n"));
    }
}
