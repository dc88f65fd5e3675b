//! Which branch of the tree is explained.

use std::fmt;

use crate::trace::{RayTree, Segment, SegmentId, TracedRay};

/// So many addresses are shown in place of a wrong one.
const SUGGESTIONS: usize = 5;
/// No name of a ray is longer; what is, is compared by its beginning.
const LONGEST_NAME: usize = 64;

/// Why an address leads to no branch.
#[derive(Clone, Debug, PartialEq, Eq)]
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
    let mut end = SegmentId(0);
    loop {
        let next = children(ray, end)
            .reduce(|first, second| if second.power.total() > first.power.total() { second } else { first });
        match next {
            Some(next) => end = next.id,
            None => return end,
        }
    }
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
    let mut end = SegmentId(0);
    for letter in path.chars() {
        let Some(next) = children(ray, end).find(|next| next.via.letter() == Some(letter)) else {
            let close = children(ray, end).map(|next| ray.address(next.id)).chain([ray.address(end)]).collect();
            let last = ray.address(end);
            return Err(unknown(format!("no '{letter}' follows after '{last}'"), close));
        };
        end = next.id;
    }
    Ok((ray, end))
}

/// The segments that begin where one ends.
pub(super) fn children(ray: &TracedRay, parent: SegmentId) -> impl Iterator<Item = &Segment> {
    // Depth-first: they come later in the list.
    ray.segments.iter().skip(parent.index() + 1).filter(move |segment| segment.parent == Some(parent))
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
