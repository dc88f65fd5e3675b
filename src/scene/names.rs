//! The cure for a misspelt name.

use crate::scene::problem::shortened;

/// What to write instead of `wrong`: the nearest of the valid names if one is near, and all of them.
pub(super) fn suggestion(wrong: &str, valid: &[&str]) -> String {
    let all = listed(valid);
    match nearest(wrong, valid) {
        Some(near) if valid.len() > 1 => format!("did you mean `{near}`? Valid here: {all}"),
        _ => format!("valid here: {all}"),
    }
}

/// The valid name that is most like `wrong`, if any is alike at all.
pub(crate) fn nearest<'a>(wrong: &str, valid: &[&'a str]) -> Option<&'a str> {
    let wrong = &shortened(wrong);
    let likeness = |name: &str| {
        let (wrong, name) = (wrong.to_lowercase(), name.to_lowercase());
        let shared =
            if !wrong.is_empty() && (name.starts_with(&wrong) || wrong.starts_with(&name)) { 0.2 } else { 0.0 };
        strsim::normalized_damerau_levenshtein(&wrong, &name) + shared
    };
    let scored = valid.iter().map(|name| (likeness(name), *name));
    scored.max_by(|a, b| a.0.total_cmp(&b.0)).filter(|(score, _)| *score >= 0.5).map(|(_, name)| name)
}

/// Names in backquotes, separated by commas.
pub(super) fn listed(names: &[&str]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_the_name_that_was_meant() {
        let valid = ["Polygon", "Rectangle", "Disk", "HalfDisk"];
        assert_eq!(nearest("polygone", &valid), Some("Polygon"));
        assert_eq!(nearest("Rect", &valid), Some("Rectangle"));
        assert_eq!(nearest("Torus", &valid), None);
    }
}
