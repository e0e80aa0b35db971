//! The table: rows, their ratios, as text and as a file.

use std::fmt;
use std::path::{Path, PathBuf};

/// One measurement.
#[derive(Clone, Debug)]
pub struct Row {
    /// What was done.
    pub workload: String,
    /// What did it.
    pub implementation: String,
    /// On how many cores.
    pub cores: usize,
    /// How long it took; the shortest of all repetitions.
    pub seconds: f64,
    /// The baseline's seconds over these, where there is a baseline.
    pub ratio: Option<f64>,
    /// The same in the terms of the workload: `67.3 ns a right-hand side`.
    pub note: String,
}

/// All measurements, and what is to be said of them.
#[derive(Clone, Debug, Default)]
pub struct Table {
    lines: Vec<Line>,
}

#[derive(Clone, Debug)]
enum Line {
    Row(Row),
    Remark(String),
}

impl Table {
    /// Adds a row.
    pub fn row(&mut self, row: Row) {
        self.lines.push(Line::Row(row));
    }

    /// Adds a line of text.
    pub fn remark(&mut self, text: impl Into<String>) {
        self.lines.push(Line::Remark(text.into()));
    }

    fn rows(&self) -> impl Iterator<Item = &Row> {
        self.lines.iter().filter_map(|line| match line {
            Line::Row(row) => Some(row),
            Line::Remark(_) => None,
        })
    }

    /// Writes target/benchmarks.csv.
    pub fn write(&self) -> std::io::Result<PathBuf> {
        let path = target().join("benchmarks.csv");
        let mut text = String::from("workload,implementation,cores,seconds,ratio\n");
        for row in self.rows() {
            let ratio = row
                .ratio
                .map_or(String::new(), |ratio| format!("{ratio:.4}"));
            let implementation = quoted(&row.implementation);
            let workload = quoted(&row.workload);
            text.push_str(&format!(
                "{workload},{implementation},{},{:.9},{ratio}\n",
                row.cores, row.seconds
            ));
        }
        std::fs::write(&path, text)?;
        Ok(path)
    }
}

fn quoted(text: &str) -> String {
    if text.contains([',', '"']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = |of: fn(&Row) -> &str| self.rows().map(|row| of(row).chars().count()).max();
        let first = width(|row| &row.workload).unwrap_or(0).max(8);
        let second = width(|row| &row.implementation).unwrap_or(0).max(14);
        writeln!(
            f,
            "{:first$}  {:second$}  cores      seconds    ratio",
            "workload", "implementation"
        )?;
        for line in &self.lines {
            match line {
                Line::Row(row) => {
                    let ratio = row
                        .ratio
                        .map_or("—".to_owned(), |ratio| format!("{ratio:.3}"));
                    writeln!(
                        f,
                        "{:first$}  {:second$}  {:5}  {:11.6}  {ratio:>7}  {}",
                        row.workload, row.implementation, row.cores, row.seconds, row.note
                    )?;
                }
                Line::Remark(text) => writeln!(f, "  {text}")?,
            }
        }
        Ok(())
    }
}

/// The folder that cargo builds into, found from where this program lies in it.
pub fn target() -> PathBuf {
    let program = std::env::current_exe().unwrap_or_default();
    program
        .ancestors()
        .find(|folder| folder.join("CACHEDIR.TAG").exists())
        .map_or_else(
            || Path::new(env!("CARGO_MANIFEST_DIR")).join("target"),
            Path::to_path_buf,
        )
}
