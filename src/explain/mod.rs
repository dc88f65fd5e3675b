//! A ray's path as a worked solution: hit by hit, every law in letters, with the numbers put in, and its result.
//!
//! [`brightest`] or [`find`] choose a branch of the ray tree, [`explain`] takes its path apart into [`Step`]s, and [`text`],
//! [`markdown`] and [`latex`] write it down, whole or as a worksheet or its key ([`Part`]). Nothing is traced anew: the numbers
//! are those of the tree.
//!
//! # Letters
//!
//! At a hit, P is the point of incidence, V the unit direction of the light, N the unit normal against it, n1 and n2 the
//! indices before and behind, η = n2/n1. C1, S1, C2, S2 are cosine and sine of the angles θ1 of incidence and θ2 of
//! transmission, both from the normal, 0° to 90°, and θc is the critical angle. T and R are the transmitted and the reflected
//! direction. R_s and R_p are the reflectances of the polarizations, w_s and w_p their shares of the power that arrives, and
//! k_r, k_t, c_local its shares that are reflected, transmitted, and stay at the hit. V0 is the direction at the source and δ
//! the deviation from it, counter-clockwise positive. At an ideal thin lens M is its center, f its focal length, τ the unit
//! vector along it (−N turned by +90°), h the height of P above M along τ, and m1 and m2 are the slopes tan θ1 and tan θ2,
//! signed along τ.
//!
//! # Digits
//!
//! Lengths have 7 digits against the size of the scene, everything else 6 of its own, so that a reader who starts from the
//! printed numbers gets the printed results up to the last digit, but for what a step itself amplifies: near the critical
//! angle, say. Numbers below 10⁻¹² other than C2² are rounding and print as 0.
//!
//! # Source
//! The vector form of Snell's law: Glassner, "Surface Physics for Ray Tracing", in "An Introduction to Ray Tracing", 1989,
//! chapter 4. Each law's own source stands in [`laws`](crate::laws).

mod branch;
mod document;
mod lines;
mod math;
mod step;
mod writers;

pub use branch::{UnknownAddress, brightest, find};
pub use document::Part;
pub use step::{Explanation, Step, explain};
pub use writers::{latex, markdown, text, write_latex, write_markdown, write_text};
