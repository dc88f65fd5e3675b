//! What the times were measured on.

use std::process::Command;
use std::time::SystemTime;

use crate::table::Table;

pub(crate) fn table() -> Table {
    let mut table = Table::new("machine", &["what", "value"]);
    let mut row = |what: &str, value: String| table.row([what.to_owned(), value]);
    row("date", today());
    row("processor", processor().unwrap_or_else(|| "unknown".into()));
    row("cores", std::thread::available_parallelism().map_or(0, usize::from).to_string());
    let compiler = compiler();
    let line = |start: &str| compiler.lines().find_map(|line| line.strip_prefix(start)).unwrap_or("unknown").to_owned();
    row("compiler", format!("rustc {}", line("release: ")));
    row("target", line("host: "));
    let has_fma = cfg!(target_feature = "fma") || cfg!(target_arch = "aarch64");
    row("fused multiply-add", if has_fma { "an instruction" } else { "a function call" }.into());
    row("profile", if cfg!(debug_assertions) { "with debug assertions" } else { "bench (as release)" }.into());
    table
}

fn processor() -> Option<String> {
    let info = std::fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = info.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(": ")?.1.to_owned())
}

/// What `rustc -vV` says; empty where there is none.
fn compiler() -> String {
    let run = Command::new("rustc").arg("-vV").output();
    run.map_or_else(|_| String::new(), |output| String::from_utf8_lossy(&output.stdout).into_owned())
}

/// The date in UTC.
fn today() -> String {
    let seconds = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).map_or(0, |since| since.as_secs());
    let (mut year, mut day) = (1970, seconds / 86_400);
    let is_leap = |year: u64| year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
    while day >= 365 + u64::from(is_leap(year)) {
        day -= 365 + u64::from(is_leap(year));
        year += 1;
    }
    let months = [31, 28 + u64::from(is_leap(year)), 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
    let mut month = 0;
    while day >= months[month] {
        day -= months[month];
        month += 1;
    }
    format!("{year}-{:02}-{:02}", month + 1, day + 1)
}
