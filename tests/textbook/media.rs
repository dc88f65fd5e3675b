//! The catalog's indices, as rays meet them.

use crate::truth::{close, table, traced};

/// Columns of the table and their vacuum wavelengths in nanometers.
const LINES: [(&str, f64); 7] = [
    ("g", 435.8343),
    ("F", 486.1327),
    ("e", 546.074),
    ("d", 587.5618),
    ("D", 589.2938),
    ("HeNe", 632.8),
    ("C", 656.2725),
];

#[test]
fn index_of_every_medium_at_every_line() {
    let wavelengths = LINES.map(|(_, nanometers)| nanometers.to_string()).join(", ");
    for row in table("materials_lines.csv", 20) {
        let trace = traced(&format!(
            "(
                title: \"A ray of seven lines\",
                bodies: [(shape: Rectangle(10, 10), medium: Catalog({:?}))],
                sources: [(light: Ray(from: (-10, 0), direction: Angle(0)), spectrum: Lines([{wavelengths}]))],
                trace: (secondary_rays: TransmittedOnly),
            )",
            row.text("material")
        ));
        assert_eq!(trace.tree.rays.len(), LINES.len());
        for ((line, nanometers), ray) in LINES.iter().zip(&trace.tree.rays) {
            close(ray.wavelength.nanometers(), *nanometers, 0.0, &row.what);
            close(ray.segments[1].medium_index, row.number(line), 1e-9, &format!("{line} in {}", row.what));
        }
    }
}
