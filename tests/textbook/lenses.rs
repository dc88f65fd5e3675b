//! Rays through whole lenses, surface by surface.

use glam::DVec2;
use serde_json::Value;
use snellius::analysis::{Axis, paraxial_of};
use snellius::light::Wavelength;
use snellius::trace::{Segment, Trace};

use crate::support::run_text;
use crate::truth::{TOLERANCE, close, close_points, entries, list, number, point, text, traced, value};

/// A lens of the table and its diameter, which the table leaves open: every ray passes, and every edge has glass.
const LENSES: [(&str, f64); 4] = [
    ("singlet_bench", 24.0),
    ("cemented_achromat_laikin", 3.4),
    ("airspaced_fraunhofer_laikin", 7.0),
    ("cooke_oslo_50mm_f4_const_n", 15.0),
];

struct Lens {
    name: &'static str,
    entry: Value,
    /// From the first vertex to the last.
    length: f64,
    /// The body in a scene.
    body: String,
}

fn lenses() -> Vec<Lens> {
    let mut entries = entries("lens_rays.json", LENSES.len());
    let lens = |(name, diameter): (&'static str, f64)| {
        let entry = entries.remove(name).unwrap();
        let surfaces = list(&entry, "surfaces");
        let (last, others) = surfaces.split_last().unwrap();
        let length = others.iter().map(|surface| value(surface, "thickness_after")).sum();
        let listed: String = others.iter().map(element).collect();
        let shape =
            format!("LensGroup(diameter: {diameter}, surfaces: [{listed}(radius: {})])", text(last, "R").unwrap());
        Lens { name, length, body: format!("(shape: {shape})"), entry }
    };
    LENSES.map(lens).into()
}

/// A surface of a prescription and what follows it.
fn element(surface: &Value) -> String {
    let [radius, thickness, medium] = ["R", "thickness_after", "medium_after"].map(|key| text(surface, key).unwrap());
    let medium = match medium {
        "air" => "Index(1)".to_owned(),
        index if index.starts_with(|c: char| c.is_ascii_digit()) => format!("Index({index})"),
        glass => format!("Catalog({glass:?})"),
    };
    format!("(radius: {radius}, thickness: {thickness}, medium: {medium}), ")
}

impl Lens {
    fn surfaces(&self) -> &[Value] {
        list(&self.entry, "surfaces")
    }

    fn rays(&self) -> &[Value] {
        list(&self.entry, "rays")
    }

    fn image_plane(&self) -> f64 {
        self.length + value(self.surfaces().last().unwrap(), "thickness_after")
    }

    /// One ray at 587.5618 nm from a height over the first vertex, through a lens to a screen in the image plane.
    fn trace(&self, body: &str, height: &str, angle: &str) -> Trace {
        let z = self.image_plane();
        traced(&format!(
            "(
                title: \"A lens\",
                bodies: [{body}, (shape: Flat(from: ({z}, -20), to: ({z}, 20)), surface: Screen)],
                sources: [(light: Ray(from: (0, {height}), direction: Angle({angle})), spectrum: Line(587.5618))],
                trace: (secondary_rays: TransmittedOnly),
            )"
        ))
    }

    /// Holds a ray of the table against its trace, at every surface and on the screen.
    fn holds(&self, body: &str, ray: &Value) {
        let [height, angle] = ["y0", "u_deg"].map(|key| text(ray, key).unwrap());
        let what = format!("{} at y = {height}, {angle}°", self.name);
        assert_eq!(text(ray, "status"), Some("ok"), "{what}");
        let trace = self.trace(body, height, angle);
        let segments = &trace.tree.rays[0].segments;
        let (image, surfaces) = list(ray, "surfaces").split_last().unwrap();
        assert_eq!((surfaces.len(), segments.len()), (self.surfaces().len(), surfaces.len() + 1), "{what}");
        for (number, (surface, pair)) in surfaces.iter().zip(segments.windows(2)).enumerate() {
            self.holds_at(surface, &pair[0], &pair[1], &format!("{what}, surface {}", number + 1));
        }
        let landed = segments.last().unwrap().to.unwrap();
        close_points(landed, point(image, "image_plane_z", "y"), TOLERANCE * self.length, &what);
    }

    /// One surface, between the segment that arrives and the one that leaves.
    fn holds_at(&self, surface: &Value, arriving: &Segment, leaving: &Segment, what: &str) {
        let hit = arriving.hit.unwrap();
        close_points(arriving.to.unwrap(), point(surface, "z_global", "y"), TOLERANCE * self.length, what);
        close_points(leaving.direction, point(surface, "dir_z", "dir_y"), TOLERANCE, what);
        close(hit.theta_i_degrees(), value(surface, "theta_i_deg"), TOLERANCE, what);
        close(hit.theta_t_degrees().unwrap(), value(surface, "theta_t_deg"), TOLERANCE, what);
        close(leaving.medium_index, value(surface, "n_after"), TOLERANCE, what);
    }
}

/// Whether light can go this way: a sequential computation also lets it run back from one surface to the next, beyond
/// the edge where the two faces of a lens meet.
fn runs_forward(ray: &Value) -> bool {
    let surfaces = list(ray, "surfaces");
    let z: Vec<_> = surfaces.iter().filter(|s| text(s, "z_global").is_some()).map(|s| value(s, "z_global")).collect();
    z.windows(2).all(|pair| pair[0] < pair[1])
}

#[test]
fn rays_through_lens_groups() {
    let mut rays = 0;
    for lens in lenses() {
        for ray in lens.rays().iter().filter(|ray| runs_forward(ray)) {
            lens.holds(&lens.body, ray);
            rays += 1;
        }
    }
    assert_eq!(rays, 41);
}

#[test]
fn rays_through_the_singlet_as_a_lens() {
    let singlet = &lenses()[0];
    let body = "(shape: Lens(radii: (50, -50), thickness: 6, diameter: 24), at: (3, 0), medium: Index(1.5168))";
    for ray in singlet.rays() {
        singlet.holds(body, ray);
    }
}

#[test]
fn a_ray_beyond_the_edge_of_the_last_lens_passes_it_by() {
    let lens = &lenses()[3];
    let beyond: Vec<_> = lens.rays().iter().filter(|ray| !runs_forward(ray)).collect();
    assert_eq!(beyond.len(), 1);
    let [height, angle] = ["y0", "u_deg"].map(|key| text(beyond[0], key).unwrap());
    let trace = lens.trace(&lens.body, height, angle);
    let segments = &trace.tree.rays[0].segments;
    assert_eq!(segments.len(), 5, "two lenses and the way past the third");
    for (surface, pair) in list(beyond[0], "surfaces").iter().zip(segments.windows(2)) {
        lens.holds_at(surface, &pair[0], &pair[1], lens.name);
    }
}

#[test]
fn paraxial_focal_lengths() {
    for lens in lenses() {
        // Spherical aberration is of second order in the height over the focal length: 1e-14 at most.
        let height = 1e-6;
        let trace = lens.trace(&lens.body, "1e-6", "0");
        let out = trace.tree.rays[0].segments.last().unwrap();
        let slope = out.direction.y / out.direction.x;
        let focus = out.from.x - out.from.y / slope;
        let [efl, bfl] = ["EFL", "BFL"].map(|key| number(lens.entry["paraxial"][key].as_str().unwrap()));
        close(-height / slope, efl, TOLERANCE * efl, lens.name);
        close(focus - lens.length, bfl, TOLERANCE * efl, lens.name);
    }
}

#[test]
fn focal_lengths_by_the_matrix_method() {
    for lens in lenses() {
        let system = run_text(&format!("(bodies: [{}])", lens.body)).system;
        let axis = Axis { from: DVec2::new(-9.0, 0.0), direction: DVec2::X };
        let points = paraxial_of(&system, &[0], axis, Wavelength::D).unwrap();
        let [efl, bfl] = ["EFL", "BFL"].map(|key| number(lens.entry["paraxial"][key].as_str().unwrap()));
        close(points.back_focal_length, efl, TOLERANCE * efl, lens.name);
        close(points.front_focal_length, efl, TOLERANCE * efl, lens.name);
        close(points.focal_points[1].x - points.vertices[1].x, bfl, TOLERANCE * efl, lens.name);
    }
}
