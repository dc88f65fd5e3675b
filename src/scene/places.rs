use std::collections::HashMap;
use std::ops::Range;

use crate::scene::Problem;

/// Where every value of a scene file stands: from a path such as `bodies[2].shape.radii` to bytes of the text.
///
/// Values written without a name have one in paths: `Disk(4)` has a `radius`, `Polygon([…])` has `points`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Places {
    spans: HashMap<String, Range<usize>>,
}

impl Places {
    pub(super) fn insert(&mut self, path: &str, span: Range<usize>) {
        self.spans.insert(path.to_owned(), span);
    }

    /// The place of a value, or of the nearest value around it that the file has; `None` if the file has neither.
    #[must_use]
    pub fn span(&self, path: &str) -> Option<Range<usize>> {
        let mut path = path;
        loop {
            if let Some(span) = self.spans.get(path) {
                return Some(span.clone());
            }
            path = parent(path)?;
        }
    }

    /// The place of exactly this value.
    pub(super) fn exact(&self, path: &str) -> Option<Range<usize>> {
        self.spans.get(path).cloned()
    }

    /// Gives a problem that has none the place of its path.
    pub fn locate(&self, problem: &mut Problem) {
        if problem.span.is_none() {
            problem.span = self.span(&problem.path);
        }
    }
}

/// The path around a path; `None` for the scene itself.
pub(super) fn parent(path: &str) -> Option<&str> {
    if path.is_empty() {
        return None;
    }
    path.rfind(['.', '[']).map_or(Some(""), |end| path.get(..end))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_that_the_file_leaves_out_stands_where_its_parent_does() {
        let mut places = Places::default();
        places.insert("", 0..90);
        places.insert("bodies[2]", 10..20);
        assert_eq!(places.span("bodies[2].shape.radii"), Some(10..20));
        assert_eq!(places.span("sources"), Some(0..90));
    }
}
