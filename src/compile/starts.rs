//! Sources that stand on boundaries.

use std::collections::HashMap;

use crate::compile::display_name;
use crate::scene::{Light, Problem, Scene};
use crate::system::{Action, Interface, OpticalSystem, PlacedSource, RayStart, Start, VertexId};

/// A warning for each source of which a ray starts on an interface: it is not plain what it meets. Light that leaves a screen or an
/// absorber in one medium does so by intent: they also stand for objects.
pub(crate) fn warnings(scene: &Scene, system: &OpticalSystem) -> Vec<Problem> {
    let starts = || system.sources.iter().flat_map(|source| &source.starts);
    if starts().all(|start| start.start == Start::Free) {
        return Vec::new();
    }
    let of_vertices = system.interfaces.iter().flat_map(|interface| interface.ends.map(|end| (end, interface)));
    let bounds = Boundaries { system, of_vertices: of_vertices.collect() };
    let sources = system.sources.iter().zip(&scene.sources).enumerate();
    sources.filter_map(|(k, (placed, source))| bounds.warning(scene, k, placed, &source.light)).collect()
}

struct Boundaries<'a> {
    system: &'a OpticalSystem,
    of_vertices: HashMap<VertexId, &'a Interface>,
}

impl Boundaries<'_> {
    fn warning(&self, scene: &Scene, source: usize, placed: &PlacedSource, light: &Light) -> Option<Problem> {
        let mut on = placed.starts.iter().enumerate().filter_map(|(ray, start)| Some((ray, start, self.under(start)?)));
        let (ray, start, interface) = on.next()?;
        let name = display_name(&scene.bodies[interface.body], interface.body);
        let index = self.system.index(start.medium, *placed.lines.first()?);
        let others = match on.count() {
            0 => String::new(),
            more => format!(", and {more} more of its rays on boundaries too"),
        };
        let message = format!(
            "ray {source}.{ray} starts on the boundary of `{name}`, in the medium of index {} that it heads into{others}",
            rounded(index)
        );
        let help = "it does not meet this boundary where it starts; to be clear, start it well before the boundary or well \
                    behind it";
        let field = match light {
            Light::Ray { .. } | Light::Fan { .. } => "from",
            Light::Beam { .. } => "center",
            Light::Point { .. } => "at",
            Light::Object { .. } => "to",
        };
        Some(Problem::warning(format!("sources[{source}].light.{field}"), message, help).label("on a boundary"))
    }

    /// The interface that a ray starts on.
    fn under(&self, start: &RayStart) -> Option<&Interface> {
        let interface = match start.start {
            Start::Free => None,
            Start::On { interface, .. } => self.system.interfaces.get(interface),
            // A vertex of boundaries between equal media alone has none.
            Start::AtVertex(vertex) => self.of_vertices.get(&vertex).copied(),
        };
        let is_object =
            |one: &Interface| one.left == one.right && matches!(one.action, Action::Absorb | Action::Detect { .. });
        interface.filter(|one| !is_object(one))
    }
}

/// An index to four decimals at most.
fn rounded(index: f64) -> String {
    let text = format!("{index:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
