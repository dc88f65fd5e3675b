//! Ray diagrams from the vector law of refraction, in two dimensions.
//!
//! A scene file in RON names bodies, media and light sources. snellius compiles it into boundaries with a medium on each
//! side, follows every ray through every boundary (at each one a reflected and a transmitted ray set out) and draws the
//! ray tree as SVG or PNG.
//!
//! ```
//! use snellius::{Scene, compile, diagram, render, report, trace};
//!
//! let scene = Scene::from_ron(r#"(
//!     title: "Total internal reflection",
//!     bodies: [(name: "prism", shape: RightAnglePrism(40), medium: Catalog("N-BK7"))],
//!     sources: [(light: Ray(from: (-30, 10), direction: Angle(0)))],
//! )"#)?;
//! let system = compile(&scene)?.system;
//! let trace = trace(&system);
//!
//! let inside = &trace.tree.rays[0].segments[1];
//! let hit = inside.hit.ok_or("the ray meets the hypotenuse")?;
//! assert!(hit.total_internal_reflection && hit.theta_i_degrees() > 41.2);
//! assert!(trace.summary.balance.residual().abs() < 1e-15);
//!
//! println!("{}", report::text(&system, &trace));
//! let svg = render::svg(&diagram::draw(&scene, &system, &trace.tree));
//! assert!(svg.starts_with("<svg"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # The way of a scene
//!
//! [`Scene`] (what the file says) → [`compile()`] → [`OpticalSystem`] (boundaries and ray starts) → [`trace()`] →
//! [`RayTree`] → [`analysis`] (focal points, images, deviation, irradiance), [`report`] (text, JSON, CSV), [`explain`] (worked
//! solutions) and [`diagram`] → [`drawing`] → [`render`] (SVG, PNG, PDF with the feature `pdf`). A module uses only modules that
//! come before it. [`summarize`] keeps no tree, and a [`Visitor`] of one's own sees every segment as it comes.
//!
//! # Units and signs
//!
//! - Points and directions are [`glam::DVec2`], re-exported, so that a crate of one's own needs no matching version of glam.
//! - Lengths are in one unit of the scene's author, taken as millimeters; x points right, y up.
//! - Angles are degrees, counter-clockwise positive; angles of incidence and transmission count from the normal, 0 to 90.
//! - Wavelengths are vacuum wavelengths in nanometers; refractive indices are absolute.
//! - V is the unit direction of the incoming ray, N the unit normal against it (N·V < 0), C1 and S1 are cosine and sine of
//!   the angle of incidence, C2 and S2 of the angle of transmission, η = n_t/n_i.
//! - s polarization: electric field perpendicular to the drawing plane (TE). p: in the plane (TM).
//! - Powers add; there is no interference.
//!
//! # Any value
//!
//! No function panics or runs on, whatever it is given, and time and memory grow with what the arguments hold. What has no meaning
//! gives an error, `None` or NaN, as each item says. Results of different scenes given together, trees whose fields were changed
//! and drawings made by hand may give a figure or a report of no use, and do no other harm: what leads nowhere is passed over.
//! Every type is `Send` and `Sync`. Nothing but the arguments has a say: there is no global state, and no look at the environment
//! or a clock.
//!
//! # What a version promises
//!
//! Versions follow [Semantic Versioning](https://semver.org/spec/v2.0.0.html); before 1.0 a minor version may break. These break:
//!
//! - a public item that is gone or takes or gives something else; the module `cli` is no part of the library;
//! - a scene file that was sound and is refused, or whose rays go elsewhere by more than rounding;
//! - a command, an option or an exit status that is gone or means something else;
//! - in the trace output a key or a column that is gone, has another name or means something else, which also raises
//!   [`report::SCHEMA`];
//! - in an SVG a class or a `data-` attribute that is gone or means something else.
//!
//! These do not: new fields and variants (types that will grow are `#[non_exhaustive]`: they are made by `new` or `default`, and a
//! `match` has a last arm `_`), new keys, columns, classes and attributes, the words of messages, the looks and the layout of a
//! figure, last digits where results become more accurate, and a newer minimum Rust version, which a minor version may ask for.
//!
//! # What stays the same
//!
//! The same scene gives the same bits on every machine and for any number of processors: the trace uses only +, −, ×, ÷ and
//! √, and every other function comes from libm.
#![cfg_attr(test, allow(clippy::float_cmp, reason = "tests compare exact bits on purpose"))]

pub mod analysis;
mod characters;
pub mod compile;
pub mod diagram;
pub mod drawing;
pub mod explain;
pub mod geometry;
pub mod laws;
pub mod light;
pub mod media;
pub mod numerics;
pub mod render;
pub mod report;
pub mod scene;
pub mod system;
pub mod trace;

#[doc(hidden)]
pub mod cli;

/// For what unit tests share with the tests of the whole library.
#[cfg(test)]
extern crate self as snellius;

/// The README's Rust examples, tested with the documentation's.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

/// The vector library of the public interface: points, directions and normals are its `DVec2`.
pub use glam;

pub use compile::{Compiled, compile};
pub use scene::Scene;
pub use system::OpticalSystem;
pub use trace::{
    Ending, Hit, PowerBalance, RayTree, Segment, SegmentId, Summary, Trace, TracedRay, Via, Visitor, retrace,
    summarize, trace, visit,
};
