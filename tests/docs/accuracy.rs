//! The tables of docs/accuracy.md and docs/performance.md.

use std::fs;

use crate::filled_page::filled;
use crate::page::root;

#[test]
fn the_tables_are_those_of_their_files() {
    for name in ["accuracy", "performance"] {
        let folder = root().join("docs").join(name);
        let page = fs::read_to_string(folder.with_extension("md")).unwrap();
        assert_eq!(filled(&page, &folder), page);
    }
}

#[test]
fn no_recorded_figure_is_past_its_bound() {
    // docs/performance.md names these.
    let short = ["nearest_vs_parry2d_1e4", "tree_vs_stream"];
    let mut held = 0;
    for table in ["accuracy/figures", "accuracy/work_precision", "performance/throughput"] {
        let mut reader = csv::Reader::from_path(root().join(format!("docs/{table}.csv"))).unwrap();
        for row in reader.records().map(Result::unwrap) {
            let measured: f64 = row[1].parse().unwrap();
            let Some((sign, bound)) = row[2].split_once(' ') else { continue };
            let bound: f64 = bound.parse().unwrap();
            let is_met = if sign == "≤" { measured <= bound } else { measured >= bound };
            assert!(is_met || short.contains(&&row[0]), "{row:?}");
            held += 1;
        }
    }
    assert!(held > 40, "{held} figures with a bound");
}

#[test]
fn a_table_is_filled_in_and_one_without_a_file_stays() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("known.csv"), "what,value\nspeed,3e8\nindex,1.5\n").unwrap();
    let page = "a\n<!-- table: known -->\nold\n<!-- end -->\nb\n<!-- table: other -->\nold\n<!-- end -->\nc\n";
    let table = "| what | value |\n| :-- | --: |\n| speed | 3e8 |\n| index | 1.5 |\n";
    let expected =
        format!("a\n<!-- table: known -->\n\n{table}\n<!-- end -->\nb\n<!-- table: other -->\nold\n<!-- end -->\nc\n");
    assert_eq!(filled(page, folder.path()), expected);
    assert_eq!(filled(&expected, folder.path()), expected);
}
