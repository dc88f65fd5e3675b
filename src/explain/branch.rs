//! Which branch of the tree is explained.

use std::fmt;

use crate::trace::{RayTree, Segment, SegmentId, TracedRay};

/// So many addresses are shown in place of a wrong one.
const SUGGESTIONS: usize = 5;
/// No name of a ray is longer; what is, is compared by its beginning.
const LONGEST_NAME: usize = 64;

/// Why an address leads to no branch.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct UnknownAddress {
    /// The address asked for.
    pub address: String,
    /// What is wrong with it.
    pub reason: String,
    /// Addresses that exist and are close, closest first; empty if the tree has no rays.
    pub close: Vec<String>,
}

impl fmt::Display for UnknownAddress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let quoted: Vec<_> = self.close.iter().map(|address| format!("'{address}'")).collect();
        write!(f, "there is no ray '{}': {}", self.address, self.reason)?;
        if quoted.is_empty() { Ok(()) } else { write!(f, "; these are close: {}", quoted.join(", ")) }
    }
}

impl std::error::Error for UnknownAddress {}

/// The brightest path of each source, in the order of the sources: of its strongest ray, the first of several, at each hit
/// the branch with the most power, the transmitted one of two equals, until the light ends. A source without rays has none.
#[must_use]
pub fn brightest(tree: &RayTree) -> Vec<(&TracedRay, SegmentId)> {
    let mut strongest: Vec<&TracedRay> = Vec::new();
    for ray in tree.rays.iter().filter(|ray| !ray.segments.is_empty()) {
        match strongest.last_mut() {
            Some(last) if last.source == ray.source => {
                if ray.power > last.power {
                    *last = ray;
                }
            }
            _ => strongest.push(ray),
        }
    }
    strongest.into_iter().map(|ray| (ray, brightest_end(ray))).collect()
}

fn brightest_end(ray: &TracedRay) -> SegmentId {
    let stronger = |first: &'_ Segment, second: &'_ Segment| second.power.total() > first.power.total();
    let brightest: Vec<Option<&Segment>> = ray
        .children()
        .into_iter()
        .map(|children| children.into_iter().reduce(|a, b| if stronger(a, b) { b } else { a }))
        .collect();
    let mut end = SegmentId(0);
    while let Some(next) = brightest.get(end.index()).copied().flatten() {
        end = next.id;
    }
    end
}

/// The branch with an address `SOURCE.RAY[@NM]:PATH`, as [`TracedRay::address`] writes it.
///
/// # Errors
/// The address has no colon, or its ray or its path does not exist; with the addresses that are close.
pub fn find<'a>(tree: &'a RayTree, address: &str) -> Result<(&'a TracedRay, SegmentId), UnknownAddress> {
    let unknown = |reason: String, close| UnknownAddress { address: address.into(), reason, close };
    let Some((name, path)) = address.split_once(':') else {
        let reason = "an address is SOURCE.RAY:PATH, or SOURCE.RAY@NM:PATH where the source has several lines";
        return Err(unknown(reason.into(), close_names(tree, address)));
    };
    let Some(ray) = tree.rays.iter().find(|ray| ray.name() == name) else {
        return Err(unknown(format!("the scene has no '{name}'"), close_names(tree, name)));
    };
    let children = ray.children();
    let mut end = SegmentId(0);
    for letter in path.chars() {
        let next = children.get(end.index()).map_or(&[][..], Vec::as_slice);
        let Some(taken) = next.iter().find(|next| next.via.letter() == Some(letter)) else {
            let last = ray.address(end);
            let close = next.iter().map(|next| ray.address(next.id)).chain([last.clone()]).collect();
            return Err(unknown(format!("no '{letter}' follows after '{last}'"), close));
        };
        end = taken.id;
    }
    Ok((ray, end))
}

/// The addresses of the rays with the names closest to one: first by SOURCE.RAY, then by the wavelength.
fn close_names(tree: &RayTree, name: &str) -> Vec<String> {
    let name: String = name.chars().take(LONGEST_NAME).collect();
    let (number, nm) = name.split_once('@').unwrap_or((&name, ""));
    let nm: Option<f64> = nm.parse().ok().filter(|nm: &f64| nm.is_finite());
    let distance = |ray: &TracedRay| {
        let letters = strsim::levenshtein(number, &format!("{}.{}", ray.source, ray.ray));
        (letters, nm.map_or(0.0, |nm| (ray.wavelength.nanometers() - nm).abs()))
    };
    let mut rays: Vec<_> = tree.rays.iter().map(|ray| (distance(ray), ray)).collect();
    rays.sort_by(|((a, nm_a), _), ((b, nm_b), _)| a.cmp(b).then(nm_a.total_cmp(nm_b)));
    rays.into_iter().take(SUGGESTIONS).map(|(_, ray)| format!("{}:", ray.name())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Scene, compile, trace};

    fn tree(fields: &str) -> RayTree {
        let scene = Scene::from_ron(&format!("({fields})")).unwrap();
        trace(&compile(&scene).unwrap().system).tree
    }

    fn brightest_addresses(fields: &str) -> Vec<String> {
        let tree = tree(fields);
        brightest(&tree).into_iter().map(|(ray, end)| ray.address(end)).collect()
    }

    #[test]
    fn the_brightest_path_goes_with_the_power() {
        let splitter = |reflect: f64| {
            brightest_addresses(&format!(
                "bodies: [(shape: Flat(from: (0, -9), to: (0, 9)), surface: BeamSplitter(reflect: {reflect}, transmit: 0.4))],
                sources: [(light: Beam(center: (-9, 1), direction: Angle(0), width: 2, rays: 3)),
                          (light: Point(at: (-5, 0), rays: 1))]"
            ))
        };
        assert_eq!(splitter(0.5), ["0.0:r", "1.0:r"]);
        assert_eq!(splitter(0.4), ["0.0:t", "1.0:t"], "transmitted of two equals");
        assert_eq!(splitter(0.3), ["0.0:t", "1.0:t"]);
    }

    #[test]
    fn a_tree_without_rays_has_no_brightest_path() {
        assert!(brightest(&RayTree::default()).is_empty());
    }

    #[test]
    fn every_address_leads_to_its_branch() {
        let tree = tree(
            "bodies: [(shape: Rectangle(9, 40), rotate: 20, medium: Index(1.5))],
            sources: [(light: Fan(from: (-30, 0), direction: Angle(0), spread: 9, rays: 3), spectrum: Lines([500, 600.5]))]",
        );
        for ray in &tree.rays {
            for segment in &ray.segments {
                let (found, end) = find(&tree, &ray.address(segment.id)).unwrap();
                assert_eq!((found.name(), end), (ray.name(), segment.id));
            }
        }
        assert_eq!(find(&tree, "0.2@600.50:t").unwrap_err().close[0], "0.2@600.5:");
        assert!(find(&tree, &"9".repeat(1_000_000)).is_err());
    }
}
