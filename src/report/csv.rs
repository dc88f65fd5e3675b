//! One row a segment, for spreadsheets and data frames. Scripts rely on the columns and their order.

use std::io;

use serde::Serialize;

use super::course::Course;
use super::number::Number;
use super::{applied, body_name, in_memory};
use crate::characters::one_line;
use crate::system::OpticalSystem;
use crate::trace::{RayTree, Segment, TracedRay};

const COLUMNS: [&str; 25] = [
    "source",
    "ray",
    "wavelength_nm",
    "id",
    "parent",
    "via",
    "from_x",
    "from_y",
    "to_x",
    "to_y",
    "direction_x",
    "direction_y",
    "medium_index",
    "power",
    "power_s",
    "power_p",
    "optical_path",
    "ending",
    "body",
    "n_i",
    "n_t",
    "theta_i_deg",
    "theta_t_deg",
    "reflectance",
    "transmittance",
];

/// One row a segment under one row of column names; what does not apply is empty.
#[must_use]
pub fn csv(system: &OpticalSystem, tree: &RayTree) -> String {
    in_memory(|out| write_csv(out, system, tree))
}

/// Writes what [`csv()`] returns.
///
/// # Errors
/// When `out` cannot be written.
pub fn write_csv(out: &mut impl io::Write, system: &OpticalSystem, tree: &RayTree) -> io::Result<()> {
    let mut table = ::csv::WriterBuilder::new().has_headers(false).from_writer(out);
    table.write_record(COLUMNS).map_err(plain)?;
    for ray in &tree.rays {
        for segment in &ray.segments {
            table.serialize(Row::new(system, ray, segment)).map_err(plain)?;
        }
    }
    table.flush()
}

/// The error of the stream itself, so that a closed pipe is still known as one.
fn plain(error: ::csv::Error) -> io::Error {
    match error.into_kind() {
        ::csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}

/// The cells in the order of [`COLUMNS`].
#[derive(Serialize)]
struct Row {
    source: usize,
    ray: usize,
    wavelength_nm: Number,
    id: u32,
    parent: Option<u32>,
    via: &'static str,
    from_x: Number,
    from_y: Number,
    to_x: Option<Number>,
    to_y: Option<Number>,
    direction_x: Number,
    direction_y: Number,
    course: Course,
    body: Option<String>,
    n_i: Option<Number>,
    n_t: Option<Number>,
    theta_i_deg: Option<Number>,
    theta_t_deg: Option<Number>,
    reflectance: Option<Number>,
    transmittance: Option<Number>,
}

impl Row {
    fn new(system: &OpticalSystem, ray: &TracedRay, segment: &Segment) -> Self {
        let hit = segment.hit.as_ref();
        Self {
            source: ray.source,
            ray: ray.ray,
            wavelength_nm: Number(ray.wavelength.nanometers()),
            id: segment.id.0,
            parent: segment.parent.map(|parent| parent.0),
            via: segment.via.word(),
            from_x: Number(segment.from.x),
            from_y: Number(segment.from.y),
            to_x: segment.to.map(|to| Number(to.x)),
            to_y: segment.to.map(|to| Number(to.y)),
            direction_x: Number(segment.direction.x),
            direction_y: Number(segment.direction.y),
            course: Course::new(segment),
            body: hit.map(|hit| cell(&body_name(system, hit.body))),
            n_i: hit.map(|hit| Number(hit.n_i)),
            n_t: hit.and_then(|hit| hit.n_t).map(Number),
            theta_i_deg: hit.map(|hit| Number(hit.theta_i_degrees())),
            theta_t_deg: hit.and_then(|hit| hit.theta_t_degrees()).map(Number),
            reflectance: hit.map(|hit| Number(applied(hit.reflectance, segment.power))),
            transmittance: hit.map(|hit| Number(applied(hit.transmittance, segment.power))),
        }
    }
}

/// Where some spreadsheet may see a cell begin: here, and behind a semicolon, which separates cells where the comma is decimal.
const SEPARATOR: char = ';';
/// What makes a spreadsheet take a cell for a formula, each also in full width; what could hide that; and the guard itself.
const GUARDED: [char; 10] = ['=', '+', '-', '@', '＝', '＋', '－', '＠', '"', GUARD];
const GUARD: char = '\'';

/// A name as a cell: on one line, and no formula anywhere. An apostrophe stands where one could begin, and is to be dropped there.
fn cell(name: &str) -> String {
    let guarded = |part: &str| {
        let is_guarded = part.trim_start().starts_with(GUARDED);
        format!("{}{part}", if is_guarded { "'" } else { "" })
    };
    one_line(name).split(SEPARATOR).map(guarded).collect::<Vec<_>>().join(";")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::sample;

    #[test]
    fn the_columns_are_those_that_scripts_know() {
        let (system, trace) = sample::turn_in_a_prism();
        let table = csv(&system, &trace.tree);
        let mut rows = table.lines();
        assert_eq!(
            rows.next(),
            Some(
                "source,ray,wavelength_nm,id,parent,via,from_x,from_y,to_x,to_y,direction_x,direction_y,\
                 medium_index,power,power_s,power_p,optical_path,ending,body,n_i,n_t,theta_i_deg,theta_t_deg,\
                 reflectance,transmittance"
            )
        );
        assert_eq!(
            rows.next(),
            Some(
                "0,0,587.5618,0,,source,-30.0,10.0,0.0,10.0,1.0,0.0,1.0,1.0,0.5,0.5,30.0,interface,prism,1.0,1.5,\
                 0.0,0.0,0.04,0.96"
            )
        );
        assert_eq!(table.lines().count(), 1 + trace.tree.rays[0].segments.len());
    }

    #[test]
    fn what_does_not_apply_is_empty() {
        let (system, trace) = sample::turn_in_a_prism();
        let table = csv(&system, &trace.tree);
        let cut = table.lines().find(|row| row.contains("cut_min_power")).unwrap();
        let cells: Vec<_> = cut.split(',').collect();
        assert_eq!(cells[8..10], ["", ""], "not followed: it ends nowhere");
        assert_eq!(cells[18..], [""; 7], "and hits nothing");
    }

    #[test]
    fn a_tree_without_rays_has_its_column_names() {
        let (system, _) = sample::turn_in_a_prism();
        assert_eq!(csv(&system, &RayTree::default()).trim_end(), COLUMNS.join(","));
    }

    #[test]
    fn a_name_with_a_comma_is_quoted() {
        let (mut system, trace) = sample::turn_in_a_prism();
        system.bodies[0].name = "a, \"b\"".into();
        assert!(csv(&system, &trace.tree).contains(r#","a, ""b""","#));
    }
}
