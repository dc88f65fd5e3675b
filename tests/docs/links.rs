//! Links from page to page.

use std::fs;

use crate::page::{pages, root};

#[test]
fn links_between_pages_lead_somewhere() {
    for page in pages() {
        let here = root().join(&page.name);
        for target in page.targets().filter(|target| !target.contains("://")) {
            let (file, heading) = target.split_once('#').unwrap_or((target, ""));
            let file = if file.is_empty() { here.clone() } else { here.parent().unwrap().join(file) };
            assert!(file.exists(), "{}: {target}", page.name);
            if !heading.is_empty() {
                let text = fs::read_to_string(&file).unwrap();
                assert!(text.lines().any(|line| anchor(line) == Some(heading.into())), "{}: {target}", page.name);
            }
        }
    }
}

/// The anchor of a heading.
fn anchor(line: &str) -> Option<String> {
    let words = line.strip_prefix('#')?.trim_start_matches('#').trim().to_lowercase();
    let kept = words.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    Some(kept.map(|c| if c == ' ' { '-' } else { c }).collect())
}
