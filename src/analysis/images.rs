//! Images of a source, element by element.

use crate::analysis::bundle::{Bundle, BundleRay, Focus};
use crate::light::Wavelength;
use crate::trace::{RayTree, Segment, TracedRay};

/// Where the rays of a source meet again, at one of its lines and behind the same hits.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Image {
    /// Vacuum wavelength.
    pub wavelength: Wavelength,
    /// The path that all rays share, in the letters of an address; not empty.
    pub path: String,
    /// Where they meet; what its spread is tells how sharp the image is.
    pub focus: Focus,
}

/// The images of a source, element by element: for each of its lines, of every path that the branches of all its rays share, where
/// these branches meet. Shorter paths come before those that go on from them, transmitted before reflected; paths behind which
/// the rays are parallel have no image and are left out.
#[must_use]
pub fn images(tree: &RayTree, source: usize) -> Vec<Image> {
    let rays: Vec<&TracedRay> = tree.rays.iter().filter(|ray| ray.source == source).collect();
    let mut lines: Vec<Wavelength> = Vec::new();
    for ray in &rays {
        if !lines.contains(&ray.wavelength) {
            lines.push(ray.wavelength);
        }
    }
    lines.into_iter().flat_map(|line| images_at(&rays, line)).collect()
}

fn images_at(rays: &[&TracedRay], wavelength: Wavelength) -> Vec<Image> {
    let rays: Vec<&TracedRay> = rays.iter().filter(|ray| ray.wavelength == wavelength).copied().collect();
    let children: Vec<Vec<Vec<&Segment>>> = rays.iter().map(|ray| ray.children()).collect();
    let starts: Option<Vec<&Segment>> = rays.iter().map(|ray| ray.segments.first()).collect();
    let mut waiting: Vec<(String, Vec<&Segment>)> = starts.map(|starts| (String::new(), starts)).into_iter().collect();
    let mut images = Vec::new();
    while let Some((path, segments)) = waiting.pop() {
        if !path.is_empty() {
            let all = rays.iter().zip(&segments).map(|(ray, segment)| BundleRay::new(ray, segment));
            let focus = Bundle { rays: all.collect() }.focus();
            images.extend(focus.map(|focus| Image { wavelength, path: path.clone(), focus }));
        }
        // The last in is the first out.
        for letter in ['i', 'r', 't'] {
            let next = children.iter().zip(&segments).map(|(children, segment)| {
                let children = children.get(segment.id.index())?;
                children.iter().find(|next| next.via.letter() == Some(letter)).copied()
            });
            let next: Option<Vec<&Segment>> = next.collect();
            waiting.extend(next.map(|next| (format!("{path}{letter}"), next)));
        }
    }
    images
}
