use std::path::Path;

/// A table of cells as they are shown.
pub(crate) struct Table {
    pub(crate) name: String,
    columns: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    pub(crate) fn new(name: &str, columns: &[&str]) -> Self {
        Self { name: name.into(), columns: columns.iter().map(ToString::to_string).collect(), rows: Vec::new() }
    }

    pub(crate) fn row<const N: usize>(&mut self, cells: [String; N]) {
        assert_eq!(N, self.columns.len(), "{}: a cell for every column", self.name);
        self.rows.push(cells.into());
    }

    pub(crate) fn read(folder: &Path, name: &str) -> Option<Self> {
        let mut reader = csv::Reader::from_path(folder.join(name).with_extension("csv")).ok()?;
        let cells = |record: &csv::StringRecord| record.iter().map(str::to_owned).collect();
        let columns = cells(reader.headers().ok()?);
        Some(Self { name: name.into(), columns, rows: reader.records().flatten().map(|row| cells(&row)).collect() })
    }

    pub(crate) fn write(&self, folder: &Path) {
        let mut writer = csv::Writer::from_path(folder.join(&self.name).with_extension("csv")).unwrap();
        writer.write_record(&self.columns).unwrap();
        self.rows.iter().for_each(|row| writer.write_record(row).unwrap());
        writer.flush().unwrap();
    }

    /// Columns of numbers are aligned to the right.
    pub(crate) fn markdown(&self) -> String {
        let is_number = |k: usize| self.rows.iter().all(|row| row[k].is_empty() || row[k].parse::<f64>().is_ok());
        let rules = (0..self.columns.len()).map(|k| if is_number(k) { "--:" } else { ":--" });
        let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
        let rules: Vec<_> = rules.map(str::to_owned).collect();
        line(&self.columns) + &line(&rules) + &self.rows.iter().map(|row| line(row)).collect::<String>()
    }
}

/// A number with three significant digits.
pub(crate) fn digits(x: f64) -> String {
    let magnitude = x.abs();
    if magnitude != 0.0 && !(1e-3..1e6).contains(&magnitude) {
        let text = format!("{x:.2e}");
        let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{}e{exponent}", without_zeros(digits));
    }
    let places = [100.0, 10.0, 1.0, 0.1, 0.01].iter().filter(|step| magnitude < **step).count();
    let text = format!("{x:.places$}");
    if text.contains('.') { without_zeros(&text).to_owned() } else { text }
}

fn without_zeros(text: &str) -> &str {
    text.trim_end_matches('0').trim_end_matches('.')
}
