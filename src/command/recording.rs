//! The rows of a run on their way: into a file as they come, into memory for pictures, and into
//! the few numbers that sum each column up.

use std::io::{self, Write};
use std::ops::ControlFlow;

use flexure::runtime::simulate::{Heading, Recorder};
use indicatif::ProgressBar;

use super::csv;
use super::terminal::PROGRESS_STEPS;

/// Rows kept for pictures; beyond twice as many every second row is dropped.
const KEPT_ROWS: usize = 1 << 18;

/// Takes the rows of a run.
pub struct Recording<'w> {
    recorded: Recorded,
    table: Option<&'w mut dyn Write>,
    keep: bool,
    stride: usize,
    bar: ProgressBar,
    until: f64,
    line: String,
}

/// What is left of a run when its rows have gone their way.
#[derive(Debug, Default)]
pub struct Recorded {
    /// Headings of the columns.
    pub headings: Vec<Heading>,
    /// What sums up each column.
    pub sums: Vec<Sum>,
    /// The columns, thinned if long; empty unless asked for.
    pub columns: Vec<Vec<f64>>,
    /// Number of rows.
    pub rows: usize,
    /// What went wrong with the table.
    pub failure: Option<io::Error>,
}

impl Recorded {
    /// Time from the first row to the last, in s.
    pub fn span(&self) -> f64 {
        self.sums.first().map_or(0.0, |time| time.last - time.first)
    }
}

/// A column in a few numbers.
#[derive(Clone, Copy, Debug)]
pub struct Sum {
    /// Value in the first row.
    pub first: f64,
    /// Value in the last row.
    pub last: f64,
    /// Least value.
    pub least: f64,
    /// Greatest value.
    pub greatest: f64,
    integral: f64,
}

impl Sum {
    fn starting_at(value: f64) -> Self {
        Self {
            first: value,
            last: value,
            least: value,
            greatest: value,
            integral: 0.0,
        }
    }

    /// Mean over `span` seconds.
    pub fn mean(&self, span: f64) -> f64 {
        if span > 0.0 {
            self.integral / span
        } else {
            self.last
        }
    }
}

impl<'w> Recording<'w> {
    /// A recording of a run of `until` seconds: rows go to `table`, and into memory if `keep`.
    pub fn new(table: Option<&'w mut dyn Write>, keep: bool, bar: ProgressBar, until: f64) -> Self {
        Self {
            recorded: Recorded::default(),
            table,
            keep,
            stride: 1,
            bar,
            until,
            line: String::new(),
        }
    }

    /// What is left when the run has ended.
    pub fn finish(self) -> Recorded {
        self.bar.finish_and_clear();
        let mut recorded = self.recorded;
        if recorded.failure.is_none()
            && let Some(table) = self.table
        {
            recorded.failure = table.flush().err();
        }
        recorded
    }

    fn write(&mut self, write: impl Fn(&mut String)) -> ControlFlow<()> {
        let Some(table) = &mut self.table else {
            return ControlFlow::Continue(());
        };
        self.line.clear();
        write(&mut self.line);
        match table.write_all(self.line.as_bytes()) {
            Ok(()) => ControlFlow::Continue(()),
            Err(why) => {
                self.recorded.failure = Some(why);
                ControlFlow::Break(())
            }
        }
    }

    fn keep(&mut self, values: &[f64]) {
        if !self.recorded.rows.is_multiple_of(self.stride) {
            return;
        }
        let columns = &mut self.recorded.columns;
        for (column, value) in columns.iter_mut().zip(values) {
            column.push(*value);
        }
        if columns.first().is_some_and(|c| c.len() >= 2 * KEPT_ROWS) {
            for column in columns {
                let mut index = 0;
                column.retain(|_| {
                    index += 1;
                    index % 2 == 1
                });
            }
            self.stride *= 2;
        }
    }

    fn sum_up(&mut self, values: &[f64]) {
        let sums = &mut self.recorded.sums;
        if self.recorded.rows == 0 {
            sums.extend(values.iter().map(|&value| Sum::starting_at(value)));
        }
        let step = match (sums.first(), values.first()) {
            (Some(time), Some(now)) => now - time.last,
            _ => 0.0,
        };
        for (sum, &value) in sums.iter_mut().zip(values) {
            sum.integral += 0.5 * (sum.last + value) * step;
            sum.last = value;
            sum.least = sum.least.min(value);
            sum.greatest = sum.greatest.max(value);
        }
    }
}

impl Recorder for Recording<'_> {
    fn begin(&mut self, headings: &[Heading]) {
        self.recorded.headings = headings.to_vec();
        if self.keep {
            self.recorded.columns = vec![Vec::new(); headings.len()];
        }
        // A table that cannot be written to breaks the run off at its first row.
        let _ = self.write(|line| csv::push_header(line, headings.iter().map(|h| &*h.name)));
    }

    fn row(&mut self, values: &[f64]) -> ControlFlow<()> {
        if self.recorded.failure.is_some() {
            return ControlFlow::Break(());
        }
        self.sum_up(values);
        if self.keep {
            self.keep(values);
        }
        self.recorded.rows += 1;
        self.write(|line| csv::push_row(line, values))
    }

    fn progress(&mut self, time: f64) -> ControlFlow<()> {
        let share = (time / self.until).clamp(0.0, 1.0);
        self.bar
            .set_position((share * PROGRESS_STEPS as f64) as u64);
        ControlFlow::Continue(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn heading(name: &'static str) -> Heading {
        Heading {
            name: name.into(),
            unit: "1".into(),
            meaning: "".into(),
        }
    }

    #[test]
    fn a_long_run_is_thinned_in_memory_and_whole_in_its_sums() {
        let mut recording = Recording::new(None, true, ProgressBar::hidden(), 1.0);
        recording.begin(&[heading("t"), heading("a")]);
        let rows = 4 * KEPT_ROWS + 1;
        for k in 0..rows {
            let t = k as f64 / (rows - 1) as f64;
            assert!(recording.row(&[t, 2.0 * t]).is_continue());
        }
        let recorded = recording.finish();
        assert_eq!(recorded.rows, rows);
        assert!(recorded.columns[0].len() < 2 * KEPT_ROWS);
        let sum = recorded.sums[1];
        assert_eq!((sum.first, sum.last, sum.greatest), (0.0, 2.0, 2.0));
        assert!((sum.mean(recorded.span()) - 1.0).abs() < 1e-9);
    }

    #[test]
    fn a_table_that_cannot_be_written_ends_the_run() {
        let mut small = [0_u8; 10];
        let mut out = &mut small[..];
        let mut recording = Recording::new(Some(&mut out), false, ProgressBar::hidden(), 1.0);
        recording.begin(&[heading("t")]);
        assert!(recording.row(&[0.0]).is_break());
        assert!(recording.finish().failure.is_some());
    }
}
