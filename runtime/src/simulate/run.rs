//! What a run leaves: its columns, how it ended, and what it cost.

use std::borrow::Cow;
use std::ops::ControlFlow;

use super::recorder::{Heading, Recorder};

/// Numbers that a table may hold: 1 GiB of them.
const LARGEST_TABLE: usize = 1 << 27;

/// A finished run, or as much of it as there is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Run {
    table: Table,
    summary: Summary,
}

/// How a run went.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    /// The time it came to, in s.
    pub end: f64,
    /// How it ended.
    pub ending: Ending,
    /// What it cost.
    pub statistics: Statistics,
    /// The first 100 000 events, in order of time.
    pub events: Vec<EventRecord>,
    /// The continuous state at the end.
    pub state: Vec<f64>,
    /// The discrete state at the end.
    pub discrete: Vec<f64>,
}

/// How a run ended.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Ending {
    /// At the time asked for.
    #[default]
    Complete,
    /// At an event that ends runs, for this reason.
    Stopped(Cow<'static, str>),
    /// The recorder broke it off.
    Interrupted,
    /// The motion could not be followed any further.
    Failed,
}

/// What a run cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Statistics {
    /// Steps that count.
    pub accepted: u64,
    /// Steps among them that ended outside of the interval of a table, where the right-hand side
    /// evaluates the closed form: none if there are no tables.
    pub outside_tables: u64,
    /// Those among them that the stiff method took.
    pub stiff: u64,
    /// Steps tried in vain: too inaccurate, a body turned too far, a loop that could not close.
    pub rejected: u64,
    /// Evaluations of the right-hand side.
    pub evaluations: u64,
    /// Kinks of drives passed.
    pub kinks: u64,
    /// Events that happened.
    pub events: u64,
}

/// An event that happened.
#[derive(Clone, Debug, PartialEq)]
pub struct EventRecord {
    /// When, in s.
    pub time: f64,
    /// Its position among the system's events.
    pub index: usize,
}

impl Statistics {
    /// How adaptive steps were taken, and why so.
    pub fn steps(&self) -> String {
        let Self {
            accepted, stiff, ..
        } = self;
        match stiff {
            0 => "explicit: stability did not limit them".to_owned(),
            _ if stiff == accepted => "stiff".to_owned(),
            _ => format!(
                "{accepted}, {stiff} of them stiff: stability would have limited explicit ones"
            ),
        }
    }
}

impl Run {
    pub(super) fn new(table: Table, summary: Summary) -> Self {
        Self { table, summary }
    }

    /// The headings of all columns: `t`, states, outputs, energies if asked for.
    pub fn headings(&self) -> &[Heading] {
        &self.table.headings
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.table.columns.first().map_or(0, Vec::len)
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The times of the rows, in s.
    pub fn times(&self) -> &[f64] {
        self.table.columns.first().map_or(&[], Vec::as_slice)
    }

    /// A column by name; `None` if there is none of that name.
    pub fn get(&self, name: &str) -> Option<Column<'_>> {
        let index = self.headings().iter().position(|h| h.name == name)?;
        Some(Column {
            heading: &self.table.headings[index],
            times: self.times(),
            values: &self.table.columns[index],
        })
    }

    /// A column by name.
    ///
    /// # Panics
    ///
    /// If there is none of that name, as an index out of range does; [`Self::get`] does not.
    pub fn column(&self, name: &str) -> Column<'_> {
        self.get(name).unwrap_or_else(|| {
            let names: Vec<&str> = self.headings().iter().map(|h| h.name.as_ref()).collect();
            panic!("no column `{name}`; there are {}", names.join(", "))
        })
    }

    /// How it went.
    pub fn summary(&self) -> &Summary {
        &self.summary
    }

    /// How it ended.
    pub fn ending(&self) -> &Ending {
        &self.summary.ending
    }

    /// What it cost.
    pub fn statistics(&self) -> Statistics {
        self.summary.statistics
    }
}

/// One quantity over a run, or over a part of it.
#[derive(Clone, Copy, Debug)]
pub struct Column<'r> {
    heading: &'r Heading,
    times: &'r [f64],
    values: &'r [f64],
}

impl<'r> Column<'r> {
    /// Name, unit and meaning.
    pub fn heading(&self) -> &'r Heading {
        self.heading
    }

    /// The values, row by row.
    pub fn values(&self) -> &'r [f64] {
        self.values
    }

    /// The times of the values, in s.
    pub fn times(&self) -> &'r [f64] {
        self.times
    }

    /// The rows with `from` ≤ t ≤ `to`, in s.
    pub fn between(&self, from: f64, to: f64) -> Column<'r> {
        let start = self.times.partition_point(|&t| t < from);
        let end = self.times.partition_point(|&t| t <= to).max(start);
        Column {
            heading: self.heading,
            times: &self.times[start..end],
            values: &self.values[start..end],
        }
    }

    /// The value at the start; NaN without rows, here and below.
    pub fn first(&self) -> f64 {
        self.values.first().copied().unwrap_or(f64::NAN)
    }

    /// The value at the end.
    pub fn last(&self) -> f64 {
        self.values.last().copied().unwrap_or(f64::NAN)
    }

    /// The smallest value.
    pub fn min(&self) -> f64 {
        self.values.iter().copied().fold(f64::NAN, f64::min)
    }

    /// The largest value.
    pub fn max(&self) -> f64 {
        self.values.iter().copied().fold(f64::NAN, f64::max)
    }

    /// The mean over time, by the trapezoidal rule between rows, however they are spaced.
    pub fn mean(&self) -> f64 {
        self.mean_of(|a, b| 0.5 * (a + b))
    }

    /// The root of the mean square over time, of the line through the rows.
    pub fn rms(&self) -> f64 {
        self.mean_of(|a, b| (a * a + a * b + b * b) / 3.0).sqrt()
    }

    /// The mean over time of what `of` makes of the values at both ends of an interval.
    fn mean_of(&self, of: impl Fn(f64, f64) -> f64) -> f64 {
        let (Some(from), Some(to)) = (self.times.first(), self.times.last()) else {
            return f64::NAN;
        };
        let span = to - from;
        if !(span > 0.0) {
            let sum: f64 = self.values.iter().map(|&value| of(value, value)).sum();
            return sum / self.values.len() as f64;
        }
        let times = self.times.windows(2);
        let values = self.values.windows(2);
        let sum: f64 = times
            .zip(values)
            .map(|(t, v)| (t[1] - t[0]) * of(v[0], v[1]))
            .sum();
        sum / span
    }
}

/// Rows kept in memory, column by column.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Table {
    headings: Vec<Heading>,
    columns: Vec<Vec<f64>>,
    is_full: bool,
}

impl Table {
    pub(super) fn is_full(&self) -> bool {
        self.is_full
    }
}

impl Recorder for Table {
    fn begin(&mut self, columns: &[Heading]) {
        self.headings = columns.to_vec();
        self.columns = vec![Vec::new(); columns.len()];
    }

    fn row(&mut self, values: &[f64]) -> ControlFlow<()> {
        if (self.columns[0].len() + 1) * self.columns.len() > LARGEST_TABLE {
            self.is_full = true;
            return ControlFlow::Break(());
        }
        for (column, &value) in self.columns.iter_mut().zip(values) {
            column.push(value);
        }
        ControlFlow::Continue(())
    }
}
