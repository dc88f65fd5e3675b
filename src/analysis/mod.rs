//! What a compiled scene and its trace tell about images and spectra, as numbers: nothing here draws.
//!
//! Points are scene coordinates; units and signs are the [crate]'s.
//!
//! ```
//! use snellius::analysis::{Axis, Bundle, paraxial};
//! use snellius::light::Wavelength;
//! use snellius::{Scene, compile, glam::DVec2, trace};
//!
//! let scene = Scene::from_ron(r#"(
//!     bodies: [(shape: Lens(radii: (60, -60), thickness: 8, diameter: 30), medium: Index(1.5))],
//!     sources: [(light: Beam(center: (-40, 0), direction: Angle(0), width: 24, rays: 9))],
//! )"#)?;
//! let system = compile(&scene)?.system;
//! let tree = trace(&system).tree;
//!
//! let axis = Axis { from: DVec2::new(-40.0, 0.0), direction: DVec2::X };
//! let lens = paraxial(&system, axis, Wavelength::D).ok_or("no power")?;
//! let beam = Bundle::of(&tree, 0, "tt");
//! let marginal = beam.marginal().focus().ok_or("parallel")?;
//! let narrowest = beam.least_confusion().ok_or("parallel")?;
//! // Spherical aberration: the marginal rays meet before F′, and the beam is narrowest in between.
//! assert!(marginal.at.x < narrowest.at.x && narrowest.at.x < lens.focal_points[1].x);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod axis;
mod bundle;
mod confusion;
mod deviation;
mod images;
mod irradiance;
mod least_deviation;
mod objects;
mod paraxial;
mod unmet;

pub use axis::Axis;
pub use bundle::{Bundle, BundleRay, Focus, ImageKind};
pub use confusion::Confusion;
pub use deviation::{deviation_degrees, turning_degrees};
pub use images::{Image, images};
pub use irradiance::{Curve, Irradiance, irradiance};
pub use least_deviation::{LeastDeviation, least_deviation};
pub use objects::{ObjectImage, object_images};
pub use paraxial::{Paraxial, paraxial, paraxial_of};
pub use unmet::{problems, unmet_bodies};
