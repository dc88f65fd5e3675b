//! Files that snellius makes and the project keeps.

use std::fs;
use std::path::Path;

/// Fails where a kept file is not the text that it should be; with `INSTA_UPDATE=always` it is written anew.
#[track_caller]
pub fn is_recorded(path: &Path, text: &str) {
    if std::env::var("INSTA_UPDATE").is_ok_and(|update| update == "always") {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    let recorded = fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let recorded = recorded.replace("\r\n", "\n");
    if recorded == text {
        return;
    }
    let differ = recorded.lines().zip(text.lines()).position(|(old, new)| old != new);
    let at = differ.unwrap_or_else(|| recorded.lines().count().min(text.lines().count()));
    let [old, new] = [&recorded, text].map(|text| text.lines().nth(at).unwrap_or("nothing"));
    panic!("{}:{}: not as made now; INSTA_UPDATE=always makes it anew\n- {old}\n+ {new}", path.display(), at + 1);
}
