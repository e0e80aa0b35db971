//! What a tolerance study says in the end: each measure's spread, and the share of designs that
//! keep the limits.

use std::fmt::Write;

use flexure::picture::{number, with_unit};
use flexure::study::{Limit, Measure, Row, Status, share_range};

/// Shares of draws below which quantiles lie.
const QUANTILES: [f64; 5] = [0.05, 0.25, 0.5, 0.75, 0.95];
const DIGITS: usize = 4;

/// Gathers the draws of one design point after the other.
pub struct Yields<'a> {
    measures: &'a [Measure],
    limits: &'a [Limit],
    /// Names and SI units of what is varied besides.
    varied: Vec<(String, String)>,
    draws: usize,
    /// Rows of the present point.
    rows: usize,
    values: Vec<Vec<f64>>,
    passed: Vec<usize>,
    passed_all: usize,
    text: String,
}

impl<'a> Yields<'a> {
    /// Nothing yet, of so many draws of each point.
    pub fn new(
        measures: &'a [Measure],
        limits: &'a [Limit],
        varied: Vec<(String, String)>,
        draws: usize,
    ) -> Self {
        Self {
            measures,
            limits,
            varied,
            draws,
            rows: 0,
            values: vec![Vec::new(); measures.len()],
            passed: vec![0; limits.len()],
            passed_all: 0,
            text: String::new(),
        }
    }

    /// Takes the next row.
    pub fn add(&mut self, row: &Row) {
        if row.status == Status::Done {
            for (values, &value) in self.values.iter_mut().zip(&row.measures) {
                values.push(value);
            }
        }
        let mut all = row.status == Status::Done;
        for (limit, passed) in self.limits.iter().zip(&mut self.passed) {
            let position = self.measures.iter().position(|m| *m == limit.measure);
            let value = position.and_then(|k| row.measures.get(k));
            let holds = value.is_some_and(|&value| limit.holds(value));
            *passed += usize::from(holds);
            all &= holds;
        }
        self.passed_all += usize::from(all);
        self.rows += 1;
        if self.rows == self.draws {
            self.close(row);
        }
    }

    /// The whole as text.
    pub fn text(&self) -> &str {
        &self.text
    }

    fn close(&mut self, row: &Row) {
        if !self.text.is_empty() {
            self.text.push('\n');
        }
        let named = self.varied.iter().zip(&row.point);
        let named: Vec<String> = named
            .map(|((name, unit), &value)| format!("{name} = {}", with_unit(value, unit, 6)))
            .collect();
        if !named.is_empty() {
            let _ = writeln!(self.text, "{}", named.join(", "));
        }
        let mut lines = vec![
            [
                "",
                "mean",
                "deviation",
                "5 %",
                "25 %",
                "50 %",
                "75 %",
                "95 %",
            ]
            .map(str::to_owned)
            .to_vec(),
        ];
        for (measure, values) in self.measures.iter().zip(&mut self.values) {
            values.retain(|value| value.is_finite());
            values.sort_by(f64::total_cmp);
            let mut line = vec![measure.name().to_owned()];
            if values.is_empty() {
                line.push("none".to_owned());
            } else {
                let shown = |value| with_unit(value, measure.unit(), DIGITS);
                let (mean, deviation) = moments(values);
                line.push(shown(mean));
                line.push(deviation.map_or_else(String::new, shown));
                line.extend(QUANTILES.map(|share| shown(quantile(values, share))));
            }
            lines.push(line);
        }
        push_aligned(&mut self.text, &lines, true);
        let share = |passed: usize| {
            let [low, high] = share_range(passed, self.draws);
            let percent = |share: f64| number(100.0 * share, DIGITS);
            format!(
                "{passed} of {} pass: {} % ({} to {} % with 95 % confidence)",
                self.draws,
                percent(passed as f64 / self.draws as f64),
                percent(low),
                percent(high)
            )
        };
        let mut lines: Vec<Vec<String>> = Vec::new();
        for (limit, &passed) in self.limits.iter().zip(&self.passed) {
            lines.push(vec![limit.written.clone(), share(passed)]);
        }
        if self.limits.len() > 1 {
            lines.push(vec!["all limits".to_owned(), share(self.passed_all)]);
        }
        push_aligned(&mut self.text, &lines, false);
        self.values.iter_mut().for_each(Vec::clear);
        self.passed.fill(0);
        (self.rows, self.passed_all) = (0, 0);
    }
}

/// Mean and standard deviation, the latter of two values at least.
fn moments(values: &[f64]) -> (f64, Option<f64>) {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    let deviation = (values.len() > 1).then(|| (squares / (count - 1.0)).sqrt());
    (mean, deviation)
}

/// A quantile of sorted values, linear between them: the first is at 0, the last at 1.
fn quantile(sorted: &[f64], share: f64) -> f64 {
    let place = share * (sorted.len() - 1) as f64;
    let (below, above) = (place.floor() as usize, place.ceil() as usize);
    sorted[below] + (sorted[above] - sorted[below]) * (place - place.floor())
}

/// Lines of cells, the first of each left-aligned, the others to the right if asked for.
fn push_aligned(text: &mut String, lines: &[Vec<String>], numbers: bool) {
    let columns = lines.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| {
        let cells = lines.iter().filter_map(|line| line.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    for line in lines {
        let mut row = String::new();
        for (column, cell) in line.iter().enumerate() {
            let pad = " ".repeat(widths[column] - cell.chars().count());
            let (before, behind) = match numbers && column > 0 {
                true => (pad.as_str(), ""),
                false => ("", pad.as_str()),
            };
            row.push_str(if column > 0 { "  " } else { "" });
            row.extend([before, cell, behind]);
        }
        let _ = writeln!(text, "{}", row.trim_end());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_and_moments_are_the_usual_ones() {
        let values = [1.0, 2.0, 4.0, 8.0];
        assert_eq!(quantile(&values, 0.0), 1.0);
        assert_eq!(quantile(&values, 0.5), 3.0);
        assert_eq!(quantile(&values, 1.0), 8.0);
        let (mean, deviation) = moments(&values);
        assert_eq!(mean, 3.75);
        assert!((deviation.unwrap() - 3.095_695_936_834_452).abs() < 1e-12);
        assert_eq!(moments(&[2.0]), (2.0, None));
    }
}
