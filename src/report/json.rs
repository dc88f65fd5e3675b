//! The trace as one JSON object, schema 1. Scripts rely on its fields and their order.

use std::io;

use serde::{Serialize, Serializer};

use super::course::Course;
use super::layout::OneLineEach;
use super::number::{Number, pair};
use super::{applied, body_name, in_memory};
use crate::system::OpticalSystem;
use crate::trace::{Hit, PowerBalance, RayTree, ScreenHit, ScreenRecord, Segment, Summary, Trace, TracedRay};

/// Version of the object's form; it grows when a field changes its meaning or goes.
pub const SCHEMA: u32 = 1;

/// The whole trace as a JSON object: one line a segment, numbers in the shortest form that reads back.
#[must_use]
pub fn json(system: &OpticalSystem, trace: &Trace) -> String {
    in_memory(|out| write_json(out, system, trace))
}

/// The same object without its `rays`.
#[must_use]
pub fn summary_json(system: &OpticalSystem, summary: &Summary) -> String {
    in_memory(|out| write_summary_json(out, system, summary))
}

/// Writes what [`json`] returns.
///
/// # Errors
/// When `out` cannot be written.
pub fn write_json(out: &mut impl io::Write, system: &OpticalSystem, trace: &Trace) -> io::Result<()> {
    write(out, &Document::new(system, &trace.summary, Some(&trace.tree)))
}

/// Writes what [`summary_json`] returns.
///
/// # Errors
/// When `out` cannot be written.
pub fn write_summary_json(out: &mut impl io::Write, system: &OpticalSystem, summary: &Summary) -> io::Result<()> {
    write(out, &Document::new(system, summary, None))
}

fn write(out: &mut impl io::Write, document: &Document) -> io::Result<()> {
    document.serialize(&mut serde_json::Serializer::with_formatter(&mut *out, OneLineEach::default()))?;
    out.write_all(b"\n")
}

#[derive(Serialize)]
struct Document<'a> {
    schema: u32,
    title: &'a str,
    counts: Counts,
    power_balance: Balance,
    screens: Screens<'a>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rays: Option<Rays<'a>>,
}

#[derive(Serialize)]
struct Counts {
    rays: u64,
    segments: u64,
}

#[derive(Serialize)]
struct Balance {
    emitted: Number,
    escaped: Number,
    absorbed: Number,
    detected: Number,
    cut_min_power: Number,
    cut_max_depth: Number,
    cut_max_segments: Number,
    residual: Number,
}

struct Screens<'a>(&'a OpticalSystem, &'a [ScreenRecord]);

#[derive(Serialize)]
struct Screen<'a> {
    body: String,
    hits: ScreenHits<'a>,
}

struct ScreenHits<'a>(&'a [ScreenHit]);

#[derive(Serialize)]
struct Landed {
    source: usize,
    ray: usize,
    wavelength_nm: Number,
    segment: u32,
    position: Number,
    power: Number,
}

struct Rays<'a>(&'a OpticalSystem, &'a RayTree);

#[derive(Serialize)]
struct Ray<'a> {
    source: usize,
    ray: usize,
    wavelength_nm: Number,
    power: Number,
    segments: Segments<'a>,
}

struct Segments<'a>(&'a OpticalSystem, &'a [Segment]);

#[derive(Serialize)]
struct SegmentRecord {
    id: u32,
    parent: Option<u32>,
    via: &'static str,
    from: [Number; 2],
    to: Option<[Number; 2]>,
    direction: [Number; 2],
    #[serde(flatten)]
    course: Course,
    hit: Option<HitRecord>,
}

#[derive(Serialize)]
struct HitRecord {
    body: String,
    normal: [Number; 2],
    n_i: Number,
    n_t: Option<Number>,
    theta_i_deg: Number,
    theta_t_deg: Option<Number>,
    critical_deg: Option<Number>,
    reflectance: Number,
    transmittance: Number,
    reflectance_s: Number,
    reflectance_p: Number,
    total_internal_reflection: bool,
}

impl<'a> Document<'a> {
    fn new(system: &'a OpticalSystem, summary: &'a Summary, tree: Option<&'a RayTree>) -> Self {
        Self {
            schema: SCHEMA,
            title: system.title(),
            counts: Counts { rays: summary.rays, segments: summary.segments },
            power_balance: Balance::new(&summary.balance),
            screens: Screens(system, &summary.screens),
            rays: tree.map(|tree| Rays(system, tree)),
        }
    }
}

impl Balance {
    fn new(balance: &PowerBalance) -> Self {
        Self {
            emitted: Number(balance.emitted.value()),
            escaped: Number(balance.escaped.value()),
            absorbed: Number(balance.absorbed.value()),
            detected: Number(balance.detected.value()),
            cut_min_power: Number(balance.cut_min_power.value()),
            cut_max_depth: Number(balance.cut_max_depth.value()),
            cut_max_segments: Number(balance.cut_max_segments.value()),
            residual: Number(balance.residual()),
        }
    }
}

impl Landed {
    fn new(hit: &ScreenHit) -> Self {
        Self {
            source: hit.source,
            ray: hit.ray,
            wavelength_nm: Number(hit.wavelength.nanometers()),
            segment: hit.segment.0,
            position: Number(hit.position),
            power: Number(hit.power),
        }
    }
}

impl<'a> Ray<'a> {
    fn new(system: &'a OpticalSystem, ray: &'a TracedRay) -> Self {
        Self {
            source: ray.source,
            ray: ray.ray,
            wavelength_nm: Number(ray.wavelength.nanometers()),
            power: Number(ray.power),
            segments: Segments(system, &ray.segments),
        }
    }
}

impl SegmentRecord {
    fn new(system: &OpticalSystem, segment: &Segment) -> Self {
        Self {
            id: segment.id.0,
            parent: segment.parent.map(|parent| parent.0),
            via: segment.via.word(),
            from: pair(segment.from),
            to: segment.to.map(pair),
            direction: pair(segment.direction),
            course: Course::new(segment),
            hit: segment.hit.as_ref().map(|hit| HitRecord::new(system, segment, hit)),
        }
    }
}

impl HitRecord {
    fn new(system: &OpticalSystem, segment: &Segment, hit: &Hit) -> Self {
        Self {
            body: body_name(system, hit.body),
            normal: pair(hit.normal),
            n_i: Number(hit.n_i),
            n_t: hit.n_t.map(Number),
            theta_i_deg: Number(hit.theta_i_degrees()),
            theta_t_deg: hit.theta_t_degrees().map(Number),
            critical_deg: hit.critical_degrees().map(Number),
            reflectance: Number(applied(hit.reflectance, segment.power)),
            transmittance: Number(applied(hit.transmittance, segment.power)),
            reflectance_s: Number(hit.reflectance.s),
            reflectance_p: Number(hit.reflectance.p),
            total_internal_reflection: hit.total_internal_reflection,
        }
    }
}

// Lists are made while they are written: a tree of a million segments is never copied.

impl Serialize for Screens<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(
            self.1.iter().map(|screen| Screen { body: body_name(self.0, screen.body), hits: ScreenHits(&screen.hits) }),
        )
    }
}

impl Serialize for ScreenHits<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.iter().map(Landed::new))
    }
}

impl Serialize for Rays<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.1.rays.iter().map(|ray| Ray::new(self.0, ray)))
    }
}

impl Serialize for Segments<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.1.iter().map(|segment| SegmentRecord::new(self.0, segment)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::sample;

    #[test]
    fn every_field_in_its_order() {
        let (system, trace) = sample::turn_in_a_prism();
        let expected = r##"{
  "schema": 1,
  "title": "Turn in a prism",
  "counts": {"rays": 1, "segments": 4},
  "power_balance": {"emitted": 1.0, "escaped": 0.0, "absorbed": 0.0, "detected": 0.96, "cut_min_power": 0.04, "cut_max_depth": 0.0, "cut_max_segments": 0.0, "residual": RESIDUAL},
  "screens": [
    {"body": "wall", "hits": [
      {"source": 0, "ray": 0, "wavelength_nm": 587.5618, "segment": 2, "position": 12.5, "power": 0.96}
    ]}
  ],
  "rays": [
    {"source": 0, "ray": 0, "wavelength_nm": 587.5618, "power": 1.0, "segments": [
      {"id": 0, "parent": null, "via": "source", "from": [-30.0, 10.0], "to": [0.0, 10.0], "direction": [1.0, 0.0], "medium_index": 1.0, "power": 1.0, "power_s": 0.5, "power_p": 0.5, "optical_path": 30.0, "ending": "interface", "hit": {"body": "prism", "normal": [-1.0, 0.0], "n_i": 1.0, "n_t": 1.5, "theta_i_deg": 0.0, "theta_t_deg": 0.0, "critical_deg": null, "reflectance": 0.04, "transmittance": 0.96, "reflectance_s": 0.04, "reflectance_p": 0.04, "total_internal_reflection": false}},
"##;
        let expected = expected.replace("RESIDUAL", &format!("{:?}", trace.summary.balance.residual()));
        assert_eq!(json(&system, &trace).get(..expected.len()), Some(expected.as_str()));
    }

    #[test]
    fn null_stands_where_nothing_applies() {
        let (system, trace) = sample::turn_in_a_prism();
        let value: serde_json::Value = serde_json::from_str(&json(&system, &trace)).unwrap();
        let segments = &value["rays"][0]["segments"];
        assert!(segments[1]["hit"]["theta_t_deg"].is_null(), "total internal reflection");
        assert!((segments[1]["hit"]["critical_deg"].as_f64().unwrap() - 41.810_314_895_778_6).abs() < 1e-12);
        assert_eq!(segments[1]["hit"]["total_internal_reflection"], true);
        assert!(segments[2]["hit"]["n_t"].is_null() && segments[2]["hit"]["critical_deg"].is_null(), "a screen");
        assert!(segments[3]["to"].is_null() && segments[3]["hit"].is_null(), "not followed");
    }

    #[test]
    fn the_summary_is_the_object_without_rays() {
        let (system, trace) = sample::turn_in_a_prism();
        let mut whole: serde_json::Value = serde_json::from_str(&json(&system, &trace)).unwrap();
        whole.as_object_mut().unwrap().remove("rays");
        let summary: serde_json::Value = serde_json::from_str(&summary_json(&system, &trace.summary)).unwrap();
        assert_eq!(summary, whole);
    }

    #[test]
    fn an_empty_trace_is_an_object_too() {
        let (system, _) = sample::turn_in_a_prism();
        let empty = json(&system, &Trace { tree: RayTree::default(), summary: Summary::default() });
        assert!(empty.ends_with("\"screens\": [],\n  \"rays\": []\n}\n"), "{empty}");
    }

    #[test]
    fn a_segment_without_power_has_the_mean_of_the_fractions() {
        let (system, mut trace) = sample::turn_in_a_prism();
        trace.tree.rays[0].segments[0].power = crate::light::Power::default();
        assert!(json(&system, &trace).contains(r#""reflectance": 0.04, "transmittance": 0.96"#));
    }
}
